// The 3D view: the room in its surroundings, and one frame drawn whenever something has changed. Nothing is drawn while
// nothing moves.

import { ACESFilmicToneMapping, Box3, LineSegments, Mesh, PCFShadowMap, Scene, Vector3, WebGLRenderer } from "three";
import { Cameras, type Mode } from "./camera.js";
import { Cutaway } from "./cutaway.js";
import type { SceneData, SceneObject, Triple } from "./data.js";
import { el } from "./dom.js";
import { Drag } from "./drag.js";
import type { Gap } from "./gaps.js";
import { type Ghost, Ghosts } from "./ghosts.js";
import { Labels, type Tag } from "./labels.js";
import { aboutObject, formatPoint, formatSize } from "./list.js";
import { Marks } from "./marks.js";
import { boundsOf, boundsOfAll, loadModel, type Model, place, putDown, samePlace, toGl } from "./model.js";
import { Occlusion } from "./occlusion.js";
import { Openings } from "./openings.js";
import { Outline } from "./outline.js";
import { Pace } from "./pace.js";
import { Picker } from "./pick.js";
import { Surroundings } from "./surroundings.js";
import type { Theme } from "./theme.js";
import { edgesOf, lowestEdge } from "./walls.js";

/** How an emphasis is meant: neutral, or by the verdict of the constraint that was chosen. */
export type Tone = "selected" | "holds" | "fails" | "unknown";

export interface SceneEvents {
  /** An object was pressed; `null`: the empty room. */
  chosen(name: string | null): void;
  /** The pointer is on an object; `null`: on none. */
  pointed(name: string | null): void;
  /** Whether objects may be dragged. */
  readonly movable: boolean;
  /** An object is on its way over the floor. */
  dragged(name: string, pos: Triple): void;
  /** It was let go, for good or, called off, where it came from. */
  dropped(name: string, pos: Triple, calledOff: boolean): void;
}

interface Palette {
  readonly tones: Readonly<Record<Tone, string>>;
  readonly hover: string;
  readonly grid: string;
}

const LIGHT: Palette = { tones: { selected: "#2563eb", holds: "#0f9f6e", fails: "#e5343d", unknown: "#b7791f" }, hover: "#1e293b", grid: "#5b6472" };
const DARK: Palette = { tones: { selected: "#6ea8ff", holds: "#3ddc97", fails: "#ff5d62", unknown: "#f5b94a" }, hover: "#ffffff", grid: "#8b97a8" };

interface Room {
  data: SceneData;
  readonly model: Model;
  readonly cutaway: Cutaway;
}

/** More names than this are a crowd. */
const MOST_TAGS = 10;

export class SceneView {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly surroundings = new Surroundings();
  private readonly cameras: Cameras;
  private readonly outline = new Outline(1);
  /** Around what is part of a failing constraint. */
  private readonly alarm = new Outline(4);
  private readonly occlusion = new Occlusion(7);
  private readonly pace = new Pace();
  private readonly marks = new Marks();
  private readonly openings = new Openings();
  private readonly ghosts = new Ghosts();
  private readonly labels: Labels;
  private readonly picker: Picker;
  private readonly drag: Drag | null;
  private room: Room | null = null;
  /** Where the nodes stand, which while something is dragged is not where the data has them. */
  private readonly places = new Map<string, SceneObject>();
  /** Of the picture; to ask the page for it would make it lay everything out. */
  private size: readonly [number, number] = [0, 0];
  private highlighted: readonly string[] = [];
  private hovered: string | null = null;
  private tone: Tone = "selected";
  private alerts: ReadonlyMap<string, string> = new Map();
  private gaps: readonly Gap[] = [];
  private frame = 0;
  private before = 0;

  /** Throws where the browser has no WebGL 2. */
  constructor(
    private readonly host: HTMLElement,
    private readonly theme: Theme,
    private readonly events: SceneEvents,
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
      this.occlusion.forget();
      this.invalidate();
    });
    host.append(this.canvas);

    this.cameras = new Cameras(this.canvas, () => this.invalidate());
    this.labels = new Labels(host, (name) => events.chosen(name));
    this.picker = new Picker(this.canvas, {
      solid: (mesh) => this.room?.cutaway.solid(mesh) ?? false,
      camera: () => this.cameras.active,
      hovered: (name, x, y) => this.hover(name, x, y),
      clicked: (name, part) => {
        if (part !== null) this.openings.toggle(part);
        this.renderer.shadowMap.needsUpdate = true;
        this.invalidate();
        events.chosen(name);
      },
      doubled: (name) => this.flyTo([name]),
    });
    this.drag = events.movable ? this.dragging(host) : null;
    this.scene.add(this.surroundings.group, this.marks.group, this.openings.group, this.ghosts.group);
    theme.watch(() => this.paint());
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
    if (this.room !== null && data.shape !== "" && data.shape === this.room.data.shape) return this.rearrange(this.room, data);
    const model = await loadModel(data.glb);
    this.unload();
    if (data.shape !== "") for (const object of data.objects) putDown(object, model.objects.get(object.name));
    const cutaway = new Cutaway(data, model);
    this.room = { data, model, cutaway };
    for (const object of data.objects) this.places.set(object.name, object);
    this.occlusion.join(model.root);
    this.scene.add(model.root);
    this.picker.setModel(model);
    this.openings.setModel(data, model);
    const all = boundsOfAll(data, model);
    // What is tall belongs at the back: there it hides nothing, and usually faces the eye.
    const tall = data.objects.map((object) => {
      const box = boundsOf(object, model.objects.get(object.name));
      return box.getCenter(new Vector3()).sub(all.getCenter(new Vector3())).multiplyScalar((box.max.y - all.min.y) ** 2);
    });
    this.cameras.frame(all, (towardsEye) => -tall.reduce((sum, weighted) => sum + weighted.dot(towardsEye), 0));
    this.surroundings.aim(all);
    this.renderer.shadowMap.needsUpdate = true;
    cutaway.update(this.cameras.active, this.cameras.looking(), 1, new Set());
    this.highlight([], "selected");
    return model.triangles;
  }

  /** The same things in other places: nothing has to be built anew. */
  private rearrange(room: Room, data: SceneData): number {
    let moved = false;
    for (const object of data.objects) {
      const [now, node] = [this.places.get(object.name), room.model.objects.get(object.name)];
      this.places.set(object.name, object);
      if (now === undefined || node === undefined || samePlace(now, object)) continue;
      place(node, now, object.pos, object.rot);
      moved = true;
    }
    room.data = data;
    this.ghosts.clear();
    if (moved) {
      this.surroundings.aim(boundsOfAll(data, room.model));
      this.renderer.shadowMap.needsUpdate = true;
    }
    this.highlight([], "selected");
    return room.model.triangles;
  }

  /** Emphasises objects and regions by name. */
  highlight(names: readonly string[], tone: Tone): void {
    this.highlighted = names;
    this.tone = tone;
    this.hovered = null;
    this.mark();
  }

  /** Objects that carry a mark, with what it says; and what is wrong between them. */
  setAlerts(alerts: ReadonlyMap<string, string>, gaps: readonly Gap[]): void {
    this.alerts = alerts;
    this.gaps = gaps;
    this.marks.show(gaps);
    this.mark();
  }

  /** Movable parts that are open: `wardrobe/door`. */
  opened(): string[] {
    return this.openings.opened();
  }

  /** Shows where objects would be; nothing: as they are. */
  showGhosts(ghosts: readonly Ghost[]): void {
    const { tones } = this.theme.dark ? DARK : LIGHT;
    this.ghosts.show(ghosts, this.places, this.room?.model.objects ?? new Map(), tones.holds);
    this.invalidate();
  }

  /** Objects that are shown where they would be. */
  ghostly(): string[] {
    return this.ghosts.names();
  }

  /** What is dragged at the moment. */
  get dragged(): string | null {
    return this.drag?.moving ?? null;
  }

  /** Puts what is dragged back; returns whether anything was. */
  callOff(): boolean {
    return this.drag?.cancel() ?? false;
  }

  /** Shows an object elsewhere than its data has it. */
  place(name: string, pos: Triple, rot: Triple): void {
    const [now, node] = [this.places.get(name), this.room?.model.objects.get(name)];
    if (now === undefined || node === undefined) return;
    place(node, now, pos, rot);
    this.places.set(name, { ...now, pos, rot });
    this.renderer.shadowMap.needsUpdate = true;
    this.mark();
  }

  /** Which of the layout's axes is to the right, and which is away from the eye: for keys that push an object. */
  axes(): { right: Triple; away: Triple } {
    const looking = this.cameras.looking();
    // Straight from above, away is up the page.
    const [x, z] = this.mode === "plan" ? [0, 1] : [-looking.x, looking.z];
    const away: Triple = Math.abs(x) > Math.abs(z) ? [Math.sign(x), 0, 0] : [0, 0, Math.sign(z) || 1];
    return { away, right: [away[2], 0, -away[0]] };
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
    // The distance to what is looked at is multiplied by it.
    if (step > 0) this.cameras.controls.dollyIn(1 / 1.2);
    else this.cameras.controls.dollyOut(1 / 1.2);
    this.invalidate();
  }

  /** Turns ambient occlusion on or off. */
  setOcclusion(on: boolean): void {
    this.occlusion.enabled = on;
    this.invalidate();
  }

  /** Draws a frame at once. */
  draw(now = performance.now()): void {
    // A frame that is due is this one.
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const step = Math.min(1, (now - this.before) / 90);
    this.before = now;
    const camera = this.cameras.active;
    let more = this.cameras.update(now);
    const keep = new Set(this.highlighted);
    more = (this.room?.cutaway.update(this.cameras.active, this.cameras.looking(), step, keep) ?? false) || more;
    if (this.openings.update(now)) more = this.renderer.shadowMap.needsUpdate = true;
    this.pace.frame(now, more);
    const hurry = this.pace.slow && (more || this.dragged !== null);
    if (this.room !== null) this.occlusion.update(this.renderer, this.room.model.root, this.cameras.active, hurry);
    this.renderer.render(this.scene, this.cameras.active);
    for (const outline of [this.alarm, this.outline]) outline.render(this.renderer, this.scene, this.cameras.active);
    this.labels.place(this.cameras.active, this.size);
    if (more || camera !== this.cameras.active) this.invalidate();
  }

  private invalidate(): void {
    if (this.frame !== 0) return;
    if (performance.now() - this.before > 200) this.before = performance.now() - 16;
    this.frame = requestAnimationFrame((now) => this.draw(now));
  }

  private dragging(host: HTMLElement): Drag {
    return new Drag(host, this.canvas, {
      camera: () => this.cameras.active,
      grab: (x, y) => {
        const hit = this.picker.hit(x, y);
        const object = hit === null ? undefined : this.places.get(hit.name);
        return hit === null || object === undefined ? null : { name: hit.name, pos: object.pos, point: hit.point };
      },
      held: (held) => {
        this.cameras.controls.enabled = !held;
      },
      moved: (name, pos) => {
        this.place(name, pos, this.places.get(name)?.rot ?? [0, 0, 0]);
        this.canvas.style.cursor = "grabbing";
        this.events.dragged(name, pos);
      },
      dropped: (name, pos, calledOff) => {
        if (calledOff) this.place(name, pos, this.places.get(name)?.rot ?? [0, 0, 0]);
        this.canvas.style.cursor = "";
        // At rest it may look better than on its way.
        this.invalidate();
        this.events.dropped(name, pos, calledOff);
      },
    });
  }

  private hover(name: string | null, x: number, y: number): void {
    const object = this.places.get(name ?? "");
    this.events.pointed(object?.name ?? null);
    if (this.dragged === null) this.canvas.style.cursor = object === undefined ? "grab" : this.events.movable ? "move" : "pointer";
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
    this.alarm.mark("selected", nodes([...this.alerts.keys()].filter((name) => !this.highlighted.includes(name))));
    this.outline.mark("region", model.floors.filter(({ region }) => this.highlighted.includes(region)).map(({ node }) => node));
    const palette = this.theme.dark ? DARK : LIGHT;
    const swept = this.highlighted.flatMap((name) => this.places.get(name) ?? []);
    this.openings.show(swept, data, { free: palette.tones.selected, blocked: palette.tones.fails });
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
    const gaps = this.gaps.filter(({ text }) => text !== "").map(({ text, from, to }): Tag => ({ kind: "gap", text, anchor: toGl(from).lerp(toGl(to), 0.5) }));
    const regions = data.regions
      .filter(({ name }) => this.mode === "plan" || this.highlighted.includes(name))
      .flatMap((region): Tag[] => {
        // Inside its lowest side on the plan, where a name hides little.
        const low = lowestEdge(edgesOf(region));
        if (low === undefined) return [];
        const [x, z] = [(low.a[0] + low.b[0]) / 2 - low.out[0] * 0.25, (low.a[1] + low.b[1]) / 2 - low.out[1] * 0.25];
        return [{ kind: "region", text: region.name, anchor: toGl([x, region.floor, z]) }];
      });
    return [...regions, ...gaps, ...alerts, ...names];
  }

  private paint(): void {
    const palette = this.theme.dark ? DARK : LIGHT;
    this.outline.setColours(palette.tones[this.tone], palette.hover);
    this.alarm.setColours(palette.tones.fails, palette.hover);
    this.marks.setColour(palette.tones.fails);
    this.surroundings.setColour(palette.grid);
    this.invalidate();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.size = [clientWidth, clientHeight];
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.cameras.resize(clientWidth, clientHeight);
    this.draw();
  }

  private unload(): void {
    if (this.room === null) return;
    for (const outline of [this.alarm, this.outline]) outline.clear();
    this.marks.clear();
    this.openings.clear();
    this.ghosts.clear();
    this.places.clear();
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
