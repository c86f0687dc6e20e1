// Outlines and a light tint over what is selected, under the pointer, or a region: silhouettes are drawn into a mask,
// and one full-screen triangle draws their rims over the picture. No material of the room is touched.

import {
  AddEquation, type Camera, Color, CustomBlending, DoubleSide, GLSL3, Mesh, MeshBasicMaterial, type Object3D, OneFactor,
  OneMinusSrcAlphaFactor, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, Vector2, type WebGLRenderer, WebGLRenderTarget,
} from "three";
import { meshesOf } from "./model.js";

/** A channel of the mask, and a layer of three.js, counted from an outline's first. */
const CHANNELS = { selected: { layer: 0, mask: 0xff0000 }, hovered: { layer: 1, mask: 0x00ff00 }, region: { layer: 2, mask: 0x0000ff } } as const;
export type Channel = keyof typeof CHANNELS;

const FRAGMENT = /* glsl */ `
  uniform sampler2D mask;
  uniform vec2 reach;
  uniform vec3 selected;
  uniform vec3 hovered;
  in vec2 at;
  out vec4 colour;

  void over(inout vec4 below, vec3 tint, float amount) {
    below = vec4(tint * amount, amount) + below * (1.0 - amount);
  }

  void main() {
    vec3 here = texture(mask, at).rgb;
    vec3 most = here;
    for (int i = 0; i < 16; i++) {
      float angle = float(i) * 0.39269908;
      most = max(most, texture(mask, at + vec2(cos(angle), sin(angle)) * reach).rgb);
    }
    vec3 rim = most * (1.0 - here);
    colour = vec4(0.0);
    over(colour, selected, rim.b * 0.9);
    over(colour, hovered, here.g * 0.10);
    over(colour, hovered, rim.g * 0.85);
    over(colour, selected, here.r * 0.15);
    over(colour, selected, rim.r);
  }
`;

const VERTEX = /* glsl */ `
  out vec2 at;
  void main() {
    at = uv;
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }
`;

export class Outline {
  private readonly target = new WebGLRenderTarget(1, 1, { samples: 4, depthBuffer: false });
  private readonly silhouette = new MeshBasicMaterial({ side: DoubleSide, depthTest: false, depthWrite: false, toneMapped: false });
  private readonly uniforms = {
    mask: { value: this.target.texture },
    reach: { value: new Vector2() },
    selected: { value: new Color() },
    hovered: { value: new Color() },
  };
  private readonly overlay = new Scene();
  private readonly flat = new OrthographicCamera();
  private readonly marked: Record<Channel, Mesh[]> = { selected: [], hovered: [], region: [] };

  /** `first` of three layers of three.js that are its own. */
  constructor(private readonly first: number) {
    // One colour of a channel is added to another: an object may be selected and under the pointer.
    this.silhouette.blending = CustomBlending;
    this.silhouette.blendEquation = AddEquation;
    this.silhouette.blendSrc = OneFactor;
    this.silhouette.blendDst = OneFactor;
    const material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms, depthTest: false, depthWrite: false,
      transparent: true, blending: CustomBlending, blendEquation: AddEquation, blendSrc: OneFactor, blendDst: OneMinusSrcAlphaFactor, toneMapped: false,
    });
    const triangle = new Mesh(new PlaneGeometry(2, 2), material);
    triangle.frustumCulled = false;
    this.overlay.add(triangle);
  }

  /** CSS colours; written to the screen as they are. */
  setColours(selected: string, hovered: string): void {
    this.uniforms.selected.value.set(selected).convertLinearToSRGB();
    this.uniforms.hovered.value.set(hovered).convertLinearToSRGB();
  }

  mark(channel: Channel, nodes: readonly Object3D[]): void {
    const layer = this.first + CHANNELS[channel].layer;
    for (const mesh of this.marked[channel]) mesh.layers.disable(layer);
    this.marked[channel] = nodes.flatMap(meshesOf);
    for (const mesh of this.marked[channel]) mesh.layers.enable(layer);
  }

  /** Forgets all meshes, before their room is replaced. */
  clear(): void {
    for (const channel of Object.keys(CHANNELS) as Channel[]) this.mark(channel, []);
  }

  /** Draws over what is on the screen. */
  render(renderer: WebGLRenderer, scene: Scene, camera: Camera): void {
    const channels = (Object.keys(CHANNELS) as Channel[]).filter((channel) => this.marked[channel].length > 0);
    if (channels.length === 0) return;
    const size = renderer.getDrawingBufferSize(new Vector2());
    this.target.setSize(size.x, size.y);
    const ratio = renderer.getPixelRatio();
    this.uniforms.reach.value.set((2.2 * ratio) / size.x, (2.2 * ratio) / size.y);

    const { mask: layers } = camera.layers;
    renderer.autoClear = false;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    scene.overrideMaterial = this.silhouette;
    for (const channel of channels) {
      camera.layers.set(this.first + CHANNELS[channel].layer);
      this.silhouette.color.set(CHANNELS[channel].mask);
      renderer.render(scene, camera);
    }
    scene.overrideMaterial = null;
    camera.layers.mask = layers;
    renderer.setRenderTarget(null);
    renderer.render(this.overlay, this.flat);
    renderer.autoClear = true;
  }
}
