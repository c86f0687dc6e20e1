// Ambient occlusion: what stands on a floor or meets in a corner takes the light of the sky from its surroundings. Found from
// the depths of the picture at half its fineness, and looked up by the materials of the room themselves, which take it off
// the light of the sky alone. So nothing else in the picture knows of it: lines, marks, outlines, ground, background.

import {
  type Camera, DepthTexture, Matrix4, Mesh, MeshStandardMaterial, NearestFilter, NoBlending, type Object3D, Scene, ShaderMaterial, UnsignedIntType,
  Vector2, type WebGLRenderer, WebGLRenderTarget,
} from "three";
import { FullScreenQuad } from "three/addons/postprocessing/Pass.js";
import { APPLY, LOOKUP, OPENNESS, SCREEN, SEEN, SMOOTH } from "./occlusion.glsl.js";

/** Pixels of the picture for one of these, along each side. */
const COARSE = 2;

export class Occlusion {
  /** Whether it is wanted at all. */
  enabled = true;
  private readonly seen = target(new DepthTexture(1, 1, UnsignedIntType));
  private readonly raw = target();
  private readonly smooth = target();
  private readonly view = {
    normals: { value: this.seen.texture },
    depths: { value: this.seen.depthTexture },
    projection: { value: new Matrix4() },
    unprojection: { value: new Matrix4() },
  };
  private readonly lookup = { openness: { value: this.smooth.texture }, picture: { value: new Vector2() }, occlusion: { value: 0 } };
  /** The room by itself, drawn in places and directions. */
  private readonly bare = new Scene();
  private readonly openness = screen(OPENNESS, this.view);
  private readonly smoothing = screen(SMOOTH, { ...this.view, raw: { value: this.raw.texture } });
  /** What the last one was found for; see `lookOf`. */
  private known: readonly number[] = [];

  /** `layer` of three.js that is its own. */
  constructor(private readonly layer: number) {
    this.bare.overrideMaterial = new ShaderMaterial({ vertexShader: SEEN.vertex, fragmentShader: SEEN.fragment, blending: NoBlending });
  }

  /** Lets the materials of a room look it up, before they are first used. */
  join(room: Object3D): void {
    room.traverse((node) => {
      if (!(node instanceof Mesh)) return;
      for (const material of [node.material].flat()) if (material instanceof MeshStandardMaterial) material.onBeforeCompile = this.extend;
    });
  }

  /** Finds it for a frame that is about to be drawn, unless it is known; one in a hurry goes without. */
  update(renderer: WebGLRenderer, room: Object3D, camera: Camera, hurry: boolean): void {
    const shown = this.enabled && !hurry;
    this.lookup.occlusion.value = shown ? 1 : 0;
    if (!shown) return;
    const size = renderer.getDrawingBufferSize(this.lookup.picture.value);
    room.updateMatrixWorld();
    camera.updateMatrixWorld();
    const look = this.lookOf(room, camera, size);
    if (look.length === this.known.length && look.every((value, i) => value === this.known[i])) return;
    this.known = look;
    this.find(renderer, room, camera, size);
  }

  /** Forgets what is known, when the graphics card has. */
  forget(): void {
    this.known = [];
  }

  private find(renderer: WebGLRenderer, room: Object3D, camera: Camera, size: Vector2): void {
    for (const to of [this.seen, this.raw, this.smooth]) to.setSize(Math.ceil(size.x / COARSE), Math.ceil(size.y / COARSE));
    this.view.projection.value.copy(camera.projectionMatrix);
    this.view.unprojection.value.copy(camera.projectionMatrixInverse);
    const { mask } = camera.layers;
    camera.layers.set(this.layer);
    // Not added, which would take it out of its own scene.
    this.bare.children = [room];
    renderer.setRenderTarget(this.seen);
    renderer.render(this.bare, camera);
    this.bare.children = [];
    camera.layers.mask = mask;
    for (const [to, pass] of [[this.raw, this.openness], [this.smooth, this.smoothing]] as const) {
      renderer.setRenderTarget(to);
      pass.render(renderer);
    }
    renderer.setRenderTarget(null);
  }

  /** All that it depends on, as numbers: the picture's size, the camera, and what stands where; puts that into the layer. */
  private lookOf(room: Object3D, camera: Camera, size: Vector2): number[] {
    const look = [size.x, size.y, ...camera.matrixWorld.elements, ...camera.projectionMatrix.elements];
    room.traverseVisible((node) => {
      if (!(node instanceof Mesh)) return;
      // What is seen through takes no light away.
      const solid = [node.material].flat().every(({ transparent }) => !transparent);
      if (!solid) return node.layers.disable(this.layer);
      node.layers.enable(this.layer);
      look.push(node.id, ...node.matrixWorld.elements);
    });
    return look;
  }

  private readonly extend: MeshStandardMaterial["onBeforeCompile"] = (shader) => {
    Object.assign(shader.uniforms, this.lookup);
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", `#include <common>\n${LOOKUP}`)
      .replace("#include <aomap_fragment>", `#include <aomap_fragment>\n${APPLY}`);
  };
}

function target(depthTexture?: DepthTexture): WebGLRenderTarget {
  const nearest = { minFilter: NearestFilter, magFilter: NearestFilter };
  return depthTexture === undefined ? new WebGLRenderTarget(1, 1, { ...nearest, depthBuffer: false }) : new WebGLRenderTarget(1, 1, { ...nearest, depthTexture });
}

function screen(fragmentShader: string, uniforms: ShaderMaterial["uniforms"]): FullScreenQuad {
  // The fourth channel is no opacity.
  return new FullScreenQuad(new ShaderMaterial({ vertexShader: SCREEN, fragmentShader, uniforms, blending: NoBlending, depthTest: false, depthWrite: false }));
}
