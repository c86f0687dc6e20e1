// The page: reads its data, puts picture and panel side by side, and keeps what is selected the same in both.
//
// Data comes from `<script type="application/json" id="scenelang-data">`, or later as a message
// `{type: "scenelang-data", data}` from the page's own server or the editor around it; a new message replaces
// the room and leaves the camera alone.

import { type SceneData, parseData, readData, rowObjects } from "./data.js";
import { el } from "./dom.js";
import { verdict } from "./list.js";
import { Panel, type Selection } from "./panel.js";
import { SceneView, type Tone } from "./scene.js";
import css from "./style.css";
import { Toolbar } from "./toolbar.js";

/** What tests and a page around the viewer may call, as `window.scenelang`. */
export interface Hook {
  /** The first frame of the current data has been drawn (or its plan shown, where there is no 3D). */
  ready: boolean;
  /** Selects an object or a row (by index or id) as a press would; `null` selects nothing. */
  select(what: string | number | null): void;
  /** Names that are highlighted. */
  selected(): string[];
  /** The picture is still on its way to what was asked for. */
  moving(): boolean;
  /** Replaces the data. */
  load(data: unknown): Promise<void>;
}

declare global {
  interface Window {
    scenelang: Hook;
  }
}

class App {
  private readonly stage = el("section.stage", { "aria-label": "Room" });
  private readonly panel = new Panel({ row: (index) => this.chooseRow(index), object: (name) => this.chooseObject(name) });
  private readonly toolbar = new Toolbar({ show: (mode) => this.show(mode), reset: () => this.view?.reset() });
  private readonly notice = el("div.notice", { role: "alert" });
  private view: SceneView | null = null;
  private data: SceneData | null = null;
  private selection: Selection = { row: null, object: null };
  /** Counts loads, so that a slow one does not overwrite a newer one. */
  private generation = 0;

  constructor(private readonly root: HTMLElement) {
    this.root.replaceChildren(this.stage, this.panel.element);
    this.stage.append(this.notice);
    this.notice.hidden = true;
    try {
      this.view = new SceneView(this.stage, { chosen: (name) => this.chooseObject(name) });
      const hint = el("p.hint", {}, "Drag to turn · scroll to zoom · click an object for its constraints");
      this.stage.append(this.toolbar.element, hint);
      this.view.canvas.addEventListener("pointerdown", () => hint.remove(), { once: true });
    } catch (error) {
      this.flat(error);
    }
    document.addEventListener("keydown", (e) => this.key(e));
  }

  readonly hook: Hook = {
    ready: false,
    select: (what) => this.select(what),
    selected: () => [...this.highlighted()],
    moving: () => this.view?.moving ?? false,
    load: (data) => this.load(() => readData(data)),
  };

  async load(read: () => SceneData): Promise<void> {
    const generation = ++this.generation;
    this.hook.ready = false;
    try {
      this.data = read();
    } catch (error) {
      this.fail(error);
      return;
    }
    const { data } = this;
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
    this.view?.setAlerts(alertsOf(data));
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

  /** Says why data cannot be shown; a room that is shown already stays. */
  fail(error: unknown): void {
    this.root.dataset["state"] = this.data === null ? "error" : "ready";
    this.say("This room cannot be shown", error);
  }

  /** Says that data is awaited. */
  wait(): void {
    this.root.dataset["state"] = "waiting";
    this.say("Waiting for a room …", "");
  }

  private select(what: string | number | null): void {
    const row = typeof what === "number" ? what : (this.data?.report.constraints.findIndex(({ id }) => id === what) ?? -1);
    if (typeof what === "string" && this.data?.objects.some(({ name }) => name === what)) this.chooseObject(what);
    else if (row >= 0) this.setSelection({ ...this.selection, row });
    else this.setSelection({ row: null, object: null });
  }

  private chooseRow(row: number): void {
    const again = row === this.selection.row;
    this.setSelection({ ...this.selection, row: again ? null : row });
    if (!again) this.view?.flyTo(this.highlighted());
  }

  private chooseObject(object: string | null): void {
    this.setSelection({ row: null, object });
  }

  private setSelection(selection: Selection): void {
    this.selection = selection;
    this.panel.setSelection(selection);
    const row = selection.row === null ? undefined : this.data?.report.constraints[selection.row];
    const tone: Tone = row === undefined ? "selected" : verdict(row);
    this.view?.highlight(this.highlighted(), tone);
  }

  private highlighted(): string[] {
    const { row, object } = this.selection;
    if (this.data === null) return [];
    if (row !== null) return rowObjects(this.data, row);
    return object === null ? [] : [object];
  }

  private show(mode: "perspective" | "plan"): void {
    this.view?.show(mode);
    this.toolbar.setMode(mode);
  }

  private key(e: KeyboardEvent): void {
    if (e.key === "Escape") {
      if (this.selection.row !== null) this.setSelection({ ...this.selection, row: null });
      else if (this.selection.object !== null) this.chooseObject(null);
      else this.panel.clearFilter();
      return;
    }
    if (e.target instanceof HTMLInputElement || e.ctrlKey || e.metaKey || e.altKey) return;
    const { view } = this;
    const actions: Record<string, () => void> = {
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

function start(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  document.getElementById("fallback")?.remove();
  let root = document.getElementById("scenelang");
  if (root === null) {
    root = el("main", { id: "scenelang" });
    document.body.append(root);
  }
  const app = new App(root);
  window.scenelang = app.hook;
  window.addEventListener("message", (e: MessageEvent<{ type?: unknown; data?: unknown } | null>) => {
    // Only this page itself and the one it is framed in may say what to show.
    if (e.source !== window && e.source !== window.parent) return;
    if (e.data?.type === "scenelang-data") void app.hook.load(e.data.data);
  });
  const text = document.getElementById("scenelang-data")?.textContent?.trim();
  if (text === undefined || text === "") app.wait();
  else void app.load(() => parseData(text));
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
