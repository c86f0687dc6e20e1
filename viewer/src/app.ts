// What happens on the page: picture and panel side by side, what is selected the same in both, what is dragged judged on
// its way.

import { parseData, readData, rowObjects, type SceneData, type Triple } from "./data.js";
import { el, typing } from "./dom.js";
import { gapsOf } from "./gaps.js";
import type { Ghost } from "./ghosts.js";
import { verdict } from "./list.js";
import { judged, type Move, type Verdicts } from "./live.js";
import { Moves, type Place } from "./moves.js";
import { Panel, type Selection } from "./panel.js";
import { SceneView, type Tone } from "./scene.js";
import type { Sink, Source } from "./source/source.js";
import { Theme } from "./theme.js";
import { Toolbar } from "./toolbar.js";

/** What tests and a page around the viewer may call, as `window.scenelang`. */
export interface Hook {
  /** The first frame of the current data has been drawn (or its plan shown, where there is no 3D). */
  ready: boolean;
  /** Selects an object or a row (by index or id) as a press would; `null` selects nothing. */
  select(what: string | number | null): void;
  /** Names that are highlighted. */
  selected(): string[];
  /** Movable parts that are open: `wardrobe/door`. */
  opened(): string[];
  /** Objects that are shown where a repair would put them. */
  ghosts(): string[];
  /** The picture is still on its way to what was asked for. */
  moving(): boolean;
  /** Turns ambient occlusion on or off, to tell what it does. */
  occlusion(on: boolean): void;
  /** Replaces the data. */
  load(data: unknown): Promise<void>;
}

export class App implements Sink {
  private readonly stage = el("section.stage", { "aria-label": "Room" });
  private readonly panel = new Panel({ row: (index) => this.chooseRow(index), object: (name) => this.pressObject(name) });
  private readonly toolbar = new Toolbar({ show: (mode) => this.show(mode), reset: () => this.view?.reset() });
  private readonly notice = el("div.notice", { role: "alert" });
  private readonly moves: Moves | null;
  private view: SceneView | null = null;
  /** The room as it came, and as it is judged while something is dragged. */
  private loaded: SceneData | null = null;
  private data: SceneData | null = null;
  /** A room that came while something was dragged. */
  private late: (() => SceneData) | null = null;
  private selection: Selection = { row: null, object: null };
  /** An array whose objects are emphasised, where none of them is selected. */
  private array: string | null = null;
  /** Counts loads, so that a slow one does not overwrite a newer one. */
  private generation = 0;

  constructor(
    private readonly root: HTMLElement,
    private readonly source: Source,
  ) {
    this.root.replaceChildren(this.stage, this.panel.element);
    this.stage.append(this.notice);
    this.notice.hidden = true;
    const { move } = source;
    this.moves =
      move === null
        ? null
        : new Moves(move, {
            placed: (object, { pos, rot }) => this.view?.place(object, pos, rot),
            judged: (asked, verdicts) => this.judge(asked, verdicts),
            refused: (asked, why) => this.refuse(asked, why),
          });
    const theme = new Theme();
    try {
      this.view = new SceneView(this.stage, theme, {
        movable: this.moves !== null,
        chosen: (name) => this.pressObject(name),
        pointed: (name) => this.source.point?.(this.view?.canvas ?? this.stage, name),
        dragged: (name, pos) => this.moves?.consider(name, { pos, rot: this.placeOf(name).rot }),
        dropped: (name, pos, calledOff) => this.drop(name, pos, calledOff),
      });
      const turn = this.moves === null ? "Drag to turn" : "Drag an object to move it, the room to turn it";
      const hint = el("p.hint", {}, `${turn} · scroll to zoom · click an object for its constraints, a door or drawer to open it`);
      this.stage.append(this.toolbar.element, hint);
      this.view.canvas.addEventListener("pointerdown", () => hint.remove(), { once: true });
    } catch (error) {
      this.flat(error);
    }
    // Before the controls of the camera, which use the arrows too.
    document.addEventListener("keydown", (e) => this.push(e), { capture: true });
    document.addEventListener("keydown", (e) => this.key(e));
  }

  readonly hook: Hook = {
    ready: false,
    select: (what) => this.pick(what),
    selected: () => [...this.highlighted()],
    opened: () => this.view?.opened() ?? [],
    ghosts: () => this.view?.ghostly() ?? [],
    moving: () => this.view?.moving ?? false,
    occlusion: (on) => this.view?.setOcclusion(on),
    load: (data) => this.take(() => readData(data)),
  };

  /** Whether rooms are shown in 3D, and not as their plan. */
  get in3d(): boolean {
    return this.view !== null;
  }

  load(data: unknown): void {
    void this.take(() => readData(data));
  }

  loadText(text: string): void {
    void this.take(() => parseData(text));
  }

  /** Says that data is awaited. */
  wait(why: string): void {
    if (this.data !== null) return;
    this.root.dataset["state"] = "waiting";
    this.say("Waiting for a room …", why);
  }

  stale(why: string | null): void {
    if (why === null) this.notice.hidden = true;
    else if (this.data === null) this.wait(why);
    else this.say("This is the last room that could be shown", why);
  }

  provisional(): void {
    this.say("This room is provisional", "There is no layout file yet. Solve writes one.");
  }

  select(what: string): void {
    const { object, row } = this.selection;
    const known = row === null ? object : this.data?.report.constraints[row]?.id;
    if (what !== known && this.view?.dragged == null) this.pick(what);
  }

  ghost(ghosts: readonly Ghost[]): void {
    this.view?.showGhosts(ghosts);
  }

  private async take(read: () => SceneData): Promise<void> {
    if (this.view?.dragged != null) {
      this.late = read;
      return;
    }
    this.late = null;
    const generation = ++this.generation;
    this.hook.ready = false;
    let data: SceneData;
    try {
      data = read();
    } catch (error) {
      // A room that is shown already stays.
      this.root.dataset["state"] = this.data === null ? "error" : "ready";
      this.say("This room cannot be shown", error);
      return;
    }
    this.loaded = this.data = data;
    document.title = data.name;
    this.root.dataset["state"] = "loading";
    this.notice.hidden = true;
    this.panel.setData(data);
    let triangles = 0;
    if (this.view !== null) {
      try {
        triangles = await this.view.load(data);
      } catch (error) {
        this.flat(error);
      }
      if (generation !== this.generation) return;
    }
    if (this.view === null) this.showPlan(data);
    const { object, row } = this.selection;
    this.setSelection({
      object: data.objects.some((o) => o.name === object) ? object : null,
      row: row !== null && row < data.report.constraints.length ? row : null,
    });
    this.view?.draw();
    document.title = `${data.name} — READY ${triangles}`;
    this.root.dataset["state"] = "ready";
    this.hook.ready = true;
  }

  private pick(what: string | number | null): void {
    const row = typeof what === "number" ? what : (this.data?.report.constraints.findIndex(({ id }) => id === what) ?? -1);
    if (typeof what === "string" && this.data?.objects.some(({ name }) => name === what)) this.setSelection({ row: null, object: what });
    else if (row >= 0) this.setSelection({ ...this.selection, row });
    else this.setSelection({ row: null, object: null }, typeof what === "string" ? what : null);
  }

  private chooseRow(row: number): void {
    const again = row === this.selection.row;
    this.setSelection({ ...this.selection, row: again ? null : row });
    if (again) return;
    this.view?.flyTo(this.highlighted());
    const id = this.data?.report.constraints[row]?.id;
    if (id !== undefined) this.source.reveal({ row: id });
  }

  private pressObject(object: string | null): void {
    this.setSelection({ row: null, object });
    if (object !== null) this.source.reveal({ object });
  }

  private setSelection(selection: Selection, array: string | null = null): void {
    this.selection = selection;
    this.array = array;
    this.panel.setSelection(selection);
    this.emphasise();
  }

  /** Brings the picture in line with what is selected and what fails. */
  private emphasise(): void {
    const { data, view } = this;
    if (data === null || view === null) return;
    const row = this.selection.row === null ? undefined : data.report.constraints[this.selection.row];
    const tone: Tone = row === undefined ? "selected" : verdict(row);
    view.highlight(this.highlighted(), tone);
    view.setAlerts(alertsOf(data), gapsOf(data, this.selection.row));
  }

  private highlighted(): string[] {
    const { row, object } = this.selection;
    if (this.data === null) return [];
    if (row !== null) return rowObjects(this.data, row);
    if (object !== null) return [object];
    const { array } = this;
    return array === null ? [] : this.data.objects.map(({ name }) => name).filter((name) => name.startsWith(`${array}[`));
  }

  private placeOf(name: string): Place {
    return this.data?.objects.find((object) => object.name === name) ?? { pos: [0, 0, 0], rot: [0, 0, 0] };
  }

  /** An object was let go. */
  private drop(name: string, pos: Triple, calledOff: boolean): void {
    const from = this.loaded?.objects.find((object) => object.name === name);
    if (calledOff || from === undefined || this.moves === null) {
      this.settle();
      return;
    }
    const rot = this.placeOf(name).rot;
    this.moves.make(name, { pos: from.pos, rot: from.rot }, { pos, rot });
  }

  /** The verdicts of a move, on its way or made. */
  private judge(move: Move, verdicts: Verdicts): void {
    const { loaded } = this;
    // It may have been called off since.
    if (loaded === null || (!move.commit && this.view?.dragged !== move.object)) return;
    const { data, changed } = judged(loaded, move, verdicts);
    this.data = data;
    if (move.commit) this.loaded = data;
    this.panel.judge(data, changed);
    this.emphasise();
    if (move.commit && this.late !== null) void this.take(this.late);
  }

  private refuse(move: Move, why: unknown): void {
    if (move.commit) this.settle();
    this.say(move.commit ? "It was not moved" : "It cannot be checked", why);
  }

  /** Everything back as the last room that came has it. */
  private settle(): void {
    const { loaded } = this;
    if (loaded !== null) void this.take(this.late ?? (() => loaded));
  }

  private show(mode: "perspective" | "plan"): void {
    this.view?.show(mode);
    this.toolbar.setMode(mode);
  }

  /** Alt and an arrow push what is selected by 5 cm, `[` and `]` turn it by 15°. */
  private push(e: KeyboardEvent): void {
    const { view, moves } = this;
    const { object } = this.selection;
    if (view === null || moves === null || object === null || typing(e) || e.ctrlKey || e.metaKey) return;
    const { right, away } = view.axes();
    const by = (axis: Triple, metres: number): Triple => [axis[0] * metres, 0, axis[2] * metres];
    const pushes: Record<string, Triple> = { ArrowRight: by(right, 0.05), ArrowLeft: by(right, -0.05), ArrowUp: by(away, 0.05), ArrowDown: by(away, -0.05) };
    const turns: Record<string, number> = { "[": -15, "]": 15 };
    const [push, turn] = e.altKey ? [pushes[e.key], undefined] : [undefined, turns[e.key]];
    if (push === undefined && turn === undefined) return;
    e.preventDefault();
    e.stopPropagation();
    const { pos, rot } = this.placeOf(object);
    const moved = pos.map((v, i) => Number((v + (push?.[i] ?? 0)).toFixed(3))) as [number, number, number];
    const turned: Triple = [rot[0], ((rot[1] + (turn ?? 0) + 540) % 360) - 180, rot[2]];
    view.place(object, moved, turned);
    moves.make(object, { pos, rot }, { pos: moved, rot: turned });
    if (this.data !== null) this.data = { ...this.data, objects: this.data.objects.map((o) => (o.name === object ? { ...o, pos: moved, rot: turned } : o)) };
  }

  private key(e: KeyboardEvent): void {
    // An editor beside the room has keys of its own; in our own field only Escape is ours.
    if (typing(e) && (e.key !== "Escape" || !this.root.contains(e.target as Node))) return;
    if (e.key === "Escape") {
      if (this.view?.callOff() === true) return;
      if (this.selection.row !== null) this.setSelection({ ...this.selection, row: null });
      else if (this.selection.object !== null) this.pressObject(null);
      else this.panel.clearFilter();
      return;
    }
    if (e.altKey) return;
    const { view } = this;
    const actions: Record<string, () => void> =
      e.ctrlKey || e.metaKey
        ? { z: () => this.moves?.undo(), Z: () => this.moves?.redo(), y: () => this.moves?.redo() }
        : {
            "/": () => this.panel.focusSearch(),
            p: () => view !== null && this.show(view.mode === "plan" ? "perspective" : "plan"),
            r: () => view?.reset(),
            "+": () => view?.zoom(1),
            "=": () => view?.zoom(1),
            "-": () => view?.zoom(-1),
          };
    const action = actions[e.key];
    if (action === undefined) return;
    e.preventDefault();
    action();
  }

  /** Gives 3D up for good; the plan and the list remain. */
  private flat(error: unknown): void {
    this.view = null;
    this.stage.querySelector("canvas")?.remove();
    this.stage.querySelector(".labels")?.remove();
    this.stage.querySelector(".hint")?.remove();
    this.toolbar.element.remove();
    this.say("No 3D view here; this is the plan", error);
  }

  private showPlan(data: SceneData): void {
    this.notice.hidden = false;
    this.stage.querySelector(".flat")?.remove();
    // As an image it is inert: whatever the document holds, nothing in it runs.
    if (data.plan !== "") this.stage.append(el("img.flat", { src: `data:image/svg+xml;charset=utf-8,${encodeURIComponent(data.plan)}`, alt: `Plan of ${data.name}` }));
  }

  private say(headline: string, why: unknown): void {
    const text = why instanceof Error ? why.message : String(why);
    this.notice.replaceChildren(el("strong", {}, headline), ...(text === "" ? [] : [el("span", {}, text)]));
    this.notice.hidden = false;
  }
}

/** Objects of hard constraints that fail, with what to say of them. */
function alertsOf(data: SceneData): Map<string, string> {
  const alerts = new Map<string, string>();
  data.report.constraints.forEach((row, index) => {
    if (row.satisfied !== false || row.kind === "prefer") return;
    for (const name of rowObjects(data, index)) alerts.set(name, [alerts.get(name), row.text].filter(Boolean).join("\n"));
  });
  return alerts;
}
