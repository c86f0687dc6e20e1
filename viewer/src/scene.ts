// The 3D view: light, ground, the room, and one frame drawn whenever something has changed. Nothing is drawn while
// nothing moves.

import {
  ACESFilmicToneMapping, Box3, Color, DirectionalLight, HemisphereLight, LineSegments, Mesh, PCFShadowMap, PlaneGeometry, Scene, ShaderMaterial, Sphere, Vector3, WebGLRenderer,
} from "three";
import { Cameras, type Mode } from "./camera.js";
import { Cutaway } from "./cutaway.js";
import type { SceneData } from "./data.js";
import { el } from "./dom.js";
import { Labels, type Tag } from "./labels.js";
import { aboutObject, formatPoint, formatSize } from "./list.js";
import { boundsOf, boundsOfAll, loadModel, type Model, toGl } from "./model.js";
import { Outline } from "./outline.js";
import { Picker } from "./pick.js";
import { edgesOf, lowestEdge } from "./walls.js";

/** How an emphasis is meant: neutral, or by the verdict of the constraint that was chosen. */
export type Tone = "selected" | "holds" | "fails" | "unknown";

export interface SceneEvents {
  /** An object was pressed; `null`: the empty room. */
  chosen(name: string | null): void;
}

interface Palette {
  readonly tones: Readonly<Record<Tone, string>>;
  readonly hover: string;
  readonly grid: string;
}

const LIGHT: Palette = { tones: { selected: "#2563eb", holds: "#0f9f6e", fails: "#e5343d", unknown: "#b7791f" }, hover: "#1e293b", grid: "#5b6472" };
const DARK: Palette = { tones: { selected: "#6ea8ff", holds: "#3ddc97", fails: "#ff5d62", unknown: "#f5b94a" }, hover: "#ffffff", grid: "#8b97a8" };

/** More names than this are a crowd. */
const MOST_TAGS = 10;

export class SceneView {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly sun = new DirectionalLight(0xfff1dd, 2.3);
  private readonly ground = groundGrid();
  private readonly cameras: Cameras;
  private readonly outline = new Outline();
  private readonly labels: Labels;
  private readonly picker: Picker;
  private readonly theme = matchMedia("(prefers-color-scheme: dark)");
  private room: { data: SceneData; model: Model; cutaway: Cutaway } | null = null;
  private highlighted: readonly string[] = [];
  private hovered: string | null = null;
  private tone: Tone = "selected";
  private alerts: ReadonlyMap<string, string> = new Map();
  private frame = 0;
  private before = 0;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly host: HTMLElement,
    events: SceneEvents,
  ) {
    this.canvas = el("canvas", { tabindex: "0", role: "application", "aria-label": "The room in 3D. Arrow keys move the view, with Shift they turn it; plus and minus zoom." });
    const context = this.canvas.getContext("webgl2", { antialias: true, alpha: true, powerPreference: "high-performance" });
    if (context === null) throw new Error("this browser offers no WebGL 2");
    this.renderer = new WebGLRenderer({ canvas: this.canvas, context, antialias: true, alpha: true });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.08;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    // The room stands still: one shadow map serves all frames.
    this.renderer.shadowMap.autoUpdate = false;
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.renderer.shadowMap.needsUpdate = true;
      this.invalidate();
    });
    host.append(this.canvas);

    this.cameras = new Cameras(this.canvas, () => this.invalidate());
    this.labels = new Labels(host, (name) => events.chosen(name));
    this.picker = new Picker(this.canvas, {
      solid: (mesh) => this.room?.cutaway.solid(mesh) ?? false,
      camera: () => this.cameras.active,
      hovered: (name, x, y) => this.hover(name, x, y),
      clicked: (name) => events.chosen(name),
      doubled: (name) => this.flyTo([name]),
    });
    this.light();
    this.theme.addEventListener("change", () => this.paint());
    this.paint();
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  /** A frame is due: the camera or a wall is on its way, or something has changed. */
  get moving(): boolean {
    return this.frame !== 0;
  }

  get mode(): Mode {
    return this.cameras.mode;
  }

  /** Takes a new room; the camera stays where it is unless this is the first. Rejects where the GLB cannot be read. */
  async load(data: SceneData): Promise<number> {
    const model = await loadModel(data.glb);
    this.unload();
    const cutaway = new Cutaway(data, model);
    this.room = { data, model, cutaway };
    this.scene.add(model.root);
    this.picker.setModel(model);
    const all = boundsOfAll(data, model);
    // What is tall belongs at the back: there it hides nothing, and usually faces the eye.
    const tall = data.objects.map((object) => {
      const box = boundsOf(object, model.objects.get(object.name));
      return box.getCenter(new Vector3()).sub(all.getCenter(new Vector3())).multiplyScalar((box.max.y - all.min.y) ** 2);
    });
    this.cameras.frame(all, (towardsEye) => -tall.reduce((sum, weighted) => sum + weighted.dot(towardsEye), 0));
    this.aim(all);
    cutaway.update(this.cameras.active, this.cameras.looking(), 1, new Set());
    this.highlight([], "selected");
    return model.triangles;
  }

  /** Emphasises objects and regions by name. */
  highlight(names: readonly string[], tone: Tone): void {
    this.highlighted = names;
    this.tone = tone;
    this.hovered = null;
    this.mark();
  }

  /** Objects that carry a mark, with what it says. */
  setAlerts(alerts: ReadonlyMap<string, string>): void {
    this.alerts = alerts;
    this.mark();
  }

  flyTo(names: readonly string[]): void {
    const box = new Box3();
    for (const object of this.room?.data.objects ?? []) if (names.includes(object.name)) box.union(boundsOf(object, this.room?.model.objects.get(object.name)));
    if (box.isEmpty()) this.cameras.reset();
    else this.cameras.flyTo(box);
  }

  show(mode: Mode): void {
    this.cameras.show(mode);
    this.mark();
  }

  reset(): void {
    this.cameras.reset();
  }

  /** Zooms by a step; > 0 nearer. */
  zoom(step: number): void {
    if (step > 0) this.cameras.controls.dollyIn(1.2);
    else this.cameras.controls.dollyOut(1.2);
    this.invalidate();
  }

  /** Draws a frame at once. */
  draw(now = performance.now()): void {
    this.frame = 0;
    const step = Math.min(1, (now - this.before) / 90);
    this.before = now;
    const camera = this.cameras.active;
    let more = this.cameras.update(now);
    const keep = new Set(this.highlighted);
    more = (this.room?.cutaway.update(this.cameras.active, this.cameras.looking(), step, keep) ?? false) || more;
    this.renderer.render(this.scene, this.cameras.active);
    this.outline.render(this.renderer, this.scene, this.cameras.active);
    this.labels.place(this.cameras.active);
    if (more || camera !== this.cameras.active) this.invalidate();
  }

  private invalidate(): void {
    if (this.frame !== 0) return;
    if (performance.now() - this.before > 200) this.before = performance.now() - 16;
    this.frame = requestAnimationFrame((now) => this.draw(now));
  }

  private hover(name: string | null, x: number, y: number): void {
    const object = this.room?.data.objects.find((o) => o.name === name);
    this.canvas.style.cursor = object === undefined ? "grab" : "pointer";
    this.labels.showTip(
      object === undefined
        ? null
        : {
            title: object.name,
            lines: [aboutObject(object).join(" · "), formatSize(object.scale), `at ${formatPoint(object.pos)}`].filter(Boolean),
          },
      x,
      y,
    );
    if (name === this.hovered) return;
    this.hovered = name;
    this.mark();
  }

  /** Brings outlines and tags in line with what is highlighted, hovered and alarming. */
  private mark(): void {
    const { room } = this;
    if (room === null) return;
    const { model, data } = room;
    const nodes = (names: readonly string[]) => names.flatMap((name) => model.objects.get(name) ?? []);
    this.outline.mark("selected", nodes(this.highlighted));
    this.outline.mark("hovered", this.hovered !== null && !this.highlighted.includes(this.hovered) ? nodes([this.hovered]) : []);
    this.outline.mark("region", model.floors.filter(({ region }) => this.highlighted.includes(region)).map(({ node }) => node));
    this.paint();
    this.labels.setTags(this.tags(data, model));
  }

  private tags(data: SceneData, model: Model): Tag[] {
    const above = (name: string) => {
      const object = data.objects.find((o) => o.name === name);
      if (object === undefined) return null;
      const box = boundsOf(object, model.objects.get(name));
      return box.getCenter(new Vector3()).setY(box.max.y);
    };
    const names = this.highlighted.slice(0, MOST_TAGS).flatMap((name): Tag[] => {
      const anchor = above(name);
      return anchor === null ? [] : [{ kind: "name", text: name, anchor }];
    });
    const alerts = [...this.alerts].flatMap(([name, title]): Tag[] => {
      const anchor = this.highlighted.includes(name) ? null : above(name);
      return anchor === null ? [] : [{ kind: "alert", text: "!", anchor, object: name, title }];
    });
    const regions = data.regions
      .filter(({ name }) => this.mode === "plan" || this.highlighted.includes(name))
      .flatMap((region): Tag[] => {
        // Inside its lowest side on the plan, where a name hides little.
        const low = lowestEdge(edgesOf(region));
        if (low === undefined) return [];
        const [x, z] = [(low.a[0] + low.b[0]) / 2 - low.out[0] * 0.25, (low.a[1] + low.b[1]) / 2 - low.out[1] * 0.25];
        return [{ kind: "region", text: region.name, anchor: toGl([x, region.floor, z]) }];
      });
    return [...regions, ...alerts, ...names];
  }

  private light(): void {
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 5;
    this.sun.shadow.normalBias = 0.02;
    this.sun.shadow.bias = -0.0004;
    const fill = new DirectionalLight(0xe6eeff, 0.7);
    fill.position.set(-2, 3, -5);
    this.scene.add(new HemisphereLight(0xffffff, 0xd8cfc4, 1.7), fill, this.sun, this.sun.target, this.ground);
  }

  /** Sun, shadow and ground to the size of the room. */
  private aim(all: Box3): void {
    const { center, radius } = all.getBoundingSphere(new Sphere());
    this.sun.target.position.copy(center);
    this.sun.position.copy(center).addScaledVector(new Vector3(-0.35, 0.95, -0.4).normalize(), radius * 2);
    const { camera } = this.sun.shadow;
    Object.assign(camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: radius * 0.2, far: radius * 4 });
    camera.updateProjectionMatrix();
    this.renderer.shadowMap.needsUpdate = true;
    this.ground.position.set(center.x, all.min.y - 0.02, center.z);
    this.ground.scale.setScalar(radius * 6);
    this.groundUniforms.radius.value = radius;
  }

  private paint(): void {
    const palette = this.theme.matches ? DARK : LIGHT;
    this.outline.setColours(palette.tones[this.tone], palette.hover);
    this.groundUniforms.colour.value.set(palette.grid).convertLinearToSRGB();
    this.invalidate();
  }

  private get groundUniforms(): GridUniforms {
    return this.ground.material.uniforms as unknown as GridUniforms;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.cameras.resize(clientWidth, clientHeight);
    this.draw();
  }

  private unload(): void {
    if (this.room === null) return;
    this.outline.clear();
    this.scene.remove(this.room.model.root);
    this.room.cutaway.dispose();
    this.room.model.root.traverse((node) => {
      if (!(node instanceof Mesh || node instanceof LineSegments)) return;
      node.geometry.dispose();
      for (const material of [node.material].flat()) material.dispose();
    });
    this.room = null;
  }
}

interface GridUniforms {
  readonly colour: { value: Color };
  readonly radius: { value: number };
}

/** Lines one metre apart that fade with the distance from the room: a scale, not a floor. */
function groundGrid(): Mesh<PlaneGeometry, ShaderMaterial> {
  const uniforms: GridUniforms = { colour: { value: new Color() }, radius: { value: 1 } };
  const material = new ShaderMaterial({
    uniforms: { ...uniforms },
    transparent: true,
    depthWrite: false,
    toneMapped: false,
    vertexShader: /* glsl */ `
      varying vec3 world;
      varying vec2 from;
      void main() {
        vec4 at = modelMatrix * vec4(position, 1.0);
        world = at.xyz;
        from = at.xz - modelMatrix[3].xz;
        gl_Position = projectionMatrix * viewMatrix * at;
      }
    `,
    fragmentShader: /* glsl */ `
      uniform vec3 colour;
      uniform float radius;
      varying vec3 world;
      varying vec2 from;
      void main() {
        vec2 width = fwidth(world.xz);
        vec2 line = 1.0 - smoothstep(width * 0.2, width * 1.0, abs(fract(world.xz - 0.5) - 0.5));
        float fade = 1.0 - smoothstep(radius * 0.7, radius * 2.4, length(from));
        gl_FragColor = vec4(colour, max(line.x, line.y) * fade * 0.22);
      }
    `,
  });
  const ground = new Mesh(new PlaneGeometry(1, 1).rotateX(-Math.PI / 2), material);
  ground.renderOrder = -1;
  return ground;
}
