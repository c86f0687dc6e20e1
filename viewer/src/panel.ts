// The panel beside the picture: what holds, and every constraint. Shows what it is told is selected and reports what
// is pressed; it decides nothing.

import type { Constraint, SceneData, SceneObject } from "./data.js";
import { el, icon, ICONS } from "./dom.js";
import { aboutObject, counts, failures, type Filter, FILTERS, formatMargin, formatSize, headline, matching, sameRow, type Verdict, verdict } from "./list.js";

export interface Selection {
  /** A row of the report. */
  readonly row: number | null;
  /** An object whose constraints are listed. */
  readonly object: string | null;
}

export interface PanelEvents {
  row(index: number): void;
  object(name: string | null): void;
}

type Tab = "constraints" | "objects";

const CHIP_NAMES: Record<Filter, string> = { all: "All", violated: "Violated", assert: "Assert", prefer: "Prefer", physical: "Physical", pins: "Pins" };
const SPOKEN: Record<Verdict, string> = { holds: "Holds", fails: "Violated", unknown: "Not checked" };

export class Panel {
  readonly element = el("aside.panel", { "aria-label": "Constraints" });
  private readonly title = el("h1");
  private readonly verdict = el("div.headline", { role: "status" });
  private readonly meter = el("div.meter", { "aria-hidden": "true" });
  private readonly details = el("p.details");
  private readonly tabs: Record<Tab, HTMLButtonElement>;
  private readonly search = el("input.search", { type: "search", placeholder: "Filter", "aria-label": "Filter", autocomplete: "off", spellcheck: "false" });
  private readonly chips = el("div.chips", { role: "group", "aria-label": "Show" });
  private readonly scope = el("div.scope");
  private readonly list = el("ul.rows");
  private readonly notes = el("details.notes");
  private data: SceneData | null = null;
  private selection: Selection = { row: null, object: null };
  private filter: Filter = "all";
  private tab: Tab = "constraints";
  /** List items of rows, by index, made when first listed: a long report is filtered, or comes again, without being built anew. */
  private readonly items = new Map<number, HTMLElement>();

  constructor(private readonly events: PanelEvents) {
    const tab = (name: Tab, text: string) => {
      const button = el("button.tab", { type: "button" }, text);
      button.addEventListener("click", () => this.open(name));
      return button;
    };
    this.tabs = { constraints: tab("constraints", "Constraints"), objects: tab("objects", "Objects") };
    this.search.addEventListener("input", () => this.renderList());
    this.element.append(
      el("header", {}, this.title, this.verdict, this.meter, this.details),
      el("div.tabs", { role: "group", "aria-label": "List" }, this.tabs.constraints, this.tabs.objects),
      el("div.tools", {}, el("label.field", {}, icon(ICONS.search), this.search, el("kbd", { "aria-hidden": "true" }, "/")), this.chips, this.scope),
      this.list,
      this.notes,
    );
    this.element.addEventListener("keydown", (e) => this.move(e));
  }

  setData(data: SceneData): void {
    const before = this.data?.report.constraints;
    for (const index of this.items.keys()) if (!sameRow(before?.[index], data.report.constraints[index])) this.items.delete(index);
    this.data = data;
    this.renderHead(data);
    this.renderNotes(data);
    this.render();
  }

  /** The same rows judged anew, and perhaps some more: only those that changed are made again. */
  judge(data: SceneData, changed: ReadonlySet<number>): void {
    this.data = data;
    for (const index of changed) this.items.delete(index);
    this.renderHead(data);
    this.render();
  }

  setSelection(selection: Selection): void {
    const scoped = selection.object !== this.selection.object;
    this.selection = selection;
    // To press an object in the picture is to ask for its constraints.
    if (scoped && selection.object !== null) this.tab = "constraints";
    if (scoped) {
      this.render();
      this.list.scrollTop = 0;
    } else this.markCurrent();
    this.list.querySelector("[aria-current]")?.scrollIntoView({ block: "nearest" });
  }

  focusSearch(): void {
    this.search.focus();
    this.search.select();
  }

  /** Empties the filter; returns whether there was any. */
  clearFilter(): boolean {
    const had = this.search.value !== "" || this.filter !== "all";
    this.search.value = "";
    this.filter = "all";
    this.render();
    return had;
  }

  private open(tab: Tab): void {
    this.tab = tab;
    this.render();
    this.list.scrollTop = 0;
  }

  private renderHead(data: SceneData): void {
    const { text, details, state } = headline(data.report);
    const { total, satisfied } = data.report.summary.assertions;
    this.title.textContent = data.name;
    this.verdict.className = `headline ${state}`;
    this.verdict.replaceChildren(icon(ICONS[state]), text);
    this.details.replaceChildren(...details.flatMap((phrase, i) => [i > 0 ? " · " : "", el("span", {}, phrase)]));
    const bar = el("span", { class: state });
    bar.style.width = total === 0 ? "100%" : `${(100 * satisfied) / total}%`;
    this.meter.replaceChildren(bar);
  }

  private renderNotes(data: SceneData): void {
    const { diagnostics } = data.report;
    this.notes.hidden = diagnostics.length === 0;
    const count = `${diagnostics.length} ${diagnostics.length === 1 ? "diagnostic" : "diagnostics"}`;
    const items = diagnostics.map((note) => el("li", { class: note.severity }, el("code", {}, note.code || note.severity), " ", ...prose(note.message)));
    this.notes.replaceChildren(el("summary", {}, count), el("ul", {}, ...items));
  }

  private render(): void {
    const { data } = this;
    if (data === null) return;
    const sizes: Record<Tab, number> = { constraints: data.report.constraints.length, objects: data.objects.length };
    for (const [name, button] of Object.entries(this.tabs) as [Tab, HTMLButtonElement][]) {
      button.setAttribute("aria-pressed", String(name === this.tab));
      button.replaceChildren(name === "constraints" ? "Constraints" : "Objects", el("span.count", {}, String(sizes[name])));
    }
    this.renderChips(data);
    this.renderScope(data);
    this.renderList();
  }

  private renderChips(data: SceneData): void {
    this.chips.hidden = this.tab !== "constraints";
    const found = counts(data.report);
    const shown = FILTERS.filter((name) => name === "all" || name === "violated" || name === this.filter || found[name] > 0);
    this.chips.replaceChildren(
      ...shown.map((name) => {
        const pressed = this.filter === name;
        const chip = el(`button.chip`, { type: "button", "aria-pressed": String(pressed), "data-filter": name }, CHIP_NAMES[name], el("span.count", {}, String(found[name])));
        if (name === "violated" && found.violated > 0) chip.classList.add("alarm");
        chip.addEventListener("click", () => {
          this.filter = name;
          this.render();
          this.chips.querySelector<HTMLElement>(`[data-filter="${name}"]`)?.focus();
        });
        return chip;
      }),
    );
  }

  private renderScope(data: SceneData): void {
    const object = this.scopeObject(data);
    this.scope.hidden = object === null || this.tab !== "constraints";
    if (object === null) return;
    const close = el("button.close", { type: "button", "aria-label": `Show the constraints of all objects, not only of ${object.name}` }, icon(ICONS.close));
    close.addEventListener("click", () => this.events.object(null));
    const facts = [...aboutObject(object), formatSize(object.scale)].join(" · ");
    this.scope.replaceChildren(el("span.scope-name", {}, object.name), el("span.scope-facts", {}, facts), close);
  }

  private renderList(): void {
    const { data } = this;
    if (data === null) return;
    const focused = this.list.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset["key"] : undefined;
    const items = this.tab === "constraints" ? this.constraintItems(data) : this.objectItems(data);
    const shown = items.length > 0 ? items : [el("li.empty", {}, this.emptyText(data))];
    this.put(shown);
    this.markCurrent();
    if (focused !== undefined) this.list.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus({ preventScroll: true });
  }

  /** Lists items. Those that stay are not touched, where no other moves: the page need not lay them out again. */
  private put(shown: readonly HTMLElement[]): void {
    const there = [...this.list.children];
    const fresh = shown.flatMap((item, index) => (item === there[index] ? [] : [{ item, old: there[index] }]));
    if (shown.length !== there.length || fresh.some(({ item }) => item.parentNode === this.list)) this.list.replaceChildren(...shown);
    else for (const { item, old } of fresh) old?.replaceWith(item);
  }

  private constraintItems(data: SceneData): HTMLElement[] {
    return matching(data, { filter: this.filter, words: this.search.value, object: this.scopeObject(data) }).flatMap((index) => {
      const row = data.report.constraints[index];
      if (row === undefined) return [];
      const made = this.items.get(index) ?? this.constraintItem(row, index);
      this.items.set(index, made);
      return [made];
    });
  }

  private constraintItem(row: Constraint, index: number): HTMLElement {
    const state = verdict(row);
    const margin = formatMargin(row.margin, row.unit);
    const about = [row.rule ?? row.kind, row.place].filter(Boolean).join(" · ");
    const button = el(
      `button.row.${state}`,
      { type: "button", "data-row": String(index), "data-key": `row ${index}` },
      el("span.mark", { title: SPOKEN[state] }, icon(ICONS[state]), el("span.spoken", {}, `${SPOKEN[state]}: `)),
      el("span.text", {}, row.text),
      el("span.margin", margin === "" ? {} : { title: `margin ${row.margin} ${row.unit ?? ""}`.trim() }, margin),
      ...(row.message !== "" ? [el("span.message", {}, ...prose(row.message))] : []),
      el("span.about", {}, about),
    );
    button.addEventListener("click", () => this.events.row(index));
    return el("li", {}, button);
  }

  private markCurrent(): void {
    const { row, object } = this.selection;
    for (const button of this.list.querySelectorAll("[aria-current]")) button.removeAttribute("aria-current");
    const key = this.tab === "objects" ? `object ${object}` : `row ${row}`;
    this.list.querySelector(`[data-key="${CSS.escape(key)}"]`)?.setAttribute("aria-current", "true");
  }

  private objectItems(data: SceneData): HTMLElement[] {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    return data.objects
      .filter((o) => words.every((word) => `${o.name} ${o.label} ${o.category}`.toLowerCase().includes(word)))
      .map((object) => {
        const failing = failures(data, object);
        const button = el(
          `button.row.object`,
          { type: "button", "data-object": object.name, "data-key": `object ${object.name}` },
          el("span.text", {}, object.name),
          el("span.margin", {}, failing > 0 ? `${failing} violated` : `${object.constraints.length}`),
          el("span.about", {}, [...aboutObject(object), formatSize(object.scale)].join(" · ")),
        );
        if (failing > 0) button.classList.add("fails");
        button.addEventListener("click", () => this.events.object(object.name));
        return el("li", {}, button);
      });
  }

  private emptyText(data: SceneData): string {
    if (this.tab === "objects") return "No object of that name.";
    if (this.filter === "violated" && this.search.value === "") return "Nothing is violated.";
    return data.report.constraints.length === 0 ? "This scene states no constraints." : "No constraint matches.";
  }

  private scopeObject(data: SceneData): SceneObject | null {
    return data.objects.find((o) => o.name === this.selection.object) ?? null;
  }

  private buttons(): NodeListOf<HTMLElement> {
    return this.list.querySelectorAll<HTMLElement>("button.row");
  }

  /** Up and down, Home and End walk the list, from the filter box too. */
  private move(e: KeyboardEvent): void {
    const step = { ArrowDown: 1, ArrowUp: -1, Home: -Infinity, End: Infinity }[e.key];
    const typing = document.activeElement === this.search;
    if (step === undefined || (typing && e.key !== "ArrowDown")) return;
    const rows = [...this.buttons()];
    const at = rows.indexOf(document.activeElement as HTMLElement);
    if (at < 0 && !typing) return;
    e.preventDefault();
    rows[Math.min(rows.length - 1, Math.max(0, at + step))]?.focus();
  }
}

/** A message with its `quoted` names set as code. */
function prose(text: string): (Node | string)[] {
  return text.split("`").map((piece, i) => (i % 2 === 1 ? el("code", {}, piece) : piece));
}
