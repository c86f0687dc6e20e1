// What is around the editor and the room: buttons, the list of problems, the line between the two.

import { el } from "../../viewer/src/dom.js";
import type { Mark } from "./answers.js";

export interface Pressed {
  example(name: string): void;
  describe(request: string): void;
  solve(): void;
  stop(): void;
  share(): void;
  format(): void;
  download(what: "program" | "glb" | "layout" | "report"): void;
  problem(mark: Mark): void;
}

const DOWNLOADS = { program: "Program (.scene)", glb: "Room (.glb)", layout: "Layout (.json)", report: "Report (.json)" } as const;

export class Page {
  readonly editor = el("section.editor", { "aria-label": "Program" });
  readonly room = el("section.room", { "aria-label": "Room and constraints" });
  /** The viewer fills it. */
  readonly viewer = el("main", { id: "scenelang" });
  readonly live: HTMLInputElement;
  private readonly examples = el("select", { id: "examples", "aria-label": "Examples" });
  private readonly request = el("input", { id: "request", type: "text", maxlength: "2000", placeholder: "Describe a room: a study with a desk by the window …", "aria-label": "Describe a room in plain English" });
  private readonly status = el("output.status", { id: "status" });
  private readonly problems = el("ol.problems", { id: "problems", "aria-label": "Problems" });
  private readonly notice = el("div.message", { id: "message", role: "alert" });
  private readonly solve: HTMLButtonElement;
  private readonly stop: HTMLButtonElement;

  constructor(root: HTMLElement, examples: readonly string[], pressed: Pressed) {
    const button = (id: string, text: string, title: string, press: () => void) => {
      const made = el("button", { type: "button", id, title }, text);
      made.addEventListener("click", press);
      return made;
    };
    this.examples.append(el("option", { value: "" }, "Examples …"), ...examples.map((name) => el("option", { value: name }, name)));
    this.examples.addEventListener("change", () => this.examples.value !== "" && pressed.example(this.examples.value));
    const form = el("form.describe", {}, this.request, el("button", { type: "submit", id: "describe", title: "Write a program for this room and solve it" }, "Write"));
    form.addEventListener("submit", (e) => {
      e.preventDefault();
      if (this.request.value.trim() !== "") pressed.describe(this.request.value);
    });
    this.solve = button("solve", "Solve", "Find a layout from scratch (Ctrl+Enter)", () => pressed.solve());
    this.stop = button("stop", "Stop", "Stop looking for a layout", () => pressed.stop());
    this.stop.hidden = true;
    this.live = el("input", { id: "live", type: "checkbox", checked: true });
    const live = el("label.live", { title: "Find a new layout when the current one no longer satisfies the program" }, this.live, "as I type");
    const downloads = el("select", { id: "download", "aria-label": "Download" }, el("option", { value: "" }, "Download …"));
    for (const [what, text] of Object.entries(DOWNLOADS)) downloads.append(el("option", { value: what }, text));
    downloads.addEventListener("change", () => {
      const what = downloads.value;
      downloads.value = "";
      if (what in DOWNLOADS) pressed.download(what as keyof typeof DOWNLOADS);
    });
    const bar = el(
      "header.bar",
      {},
      el("strong.brand", {}, "scenelang"),
      this.examples,
      form,
      el("div.group", {}, this.solve, this.stop, live),
      el("div.group", {}, button("format", "Format", "Format the program", () => pressed.format()), button("share", "Share", "Copy a link that contains the program", () => pressed.share()), downloads),
    );
    this.problems.addEventListener("click", (e) => {
      const item = e.target instanceof Element ? e.target.closest("li") : null;
      const mark = item === null ? undefined : this.marks[[...this.problems.children].indexOf(item)];
      if (mark !== undefined) pressed.problem(mark);
    });
    this.notice.hidden = true;
    this.notice.addEventListener("click", (e) => e.target instanceof HTMLButtonElement && this.say(null));
    const below = el("footer.below", {}, this.status, this.problems);
    const left = el("div.left", {}, this.editor, below);
    const line = el("div.line", { role: "separator", "aria-orientation": "vertical", "aria-label": "Width of the editor", tabindex: "0" });
    this.room.append(this.viewer);
    const both = el("div.both", {}, left, line, this.room);
    divide(both, line);
    root.replaceChildren(bar, this.notice, both);
  }

  private marks: readonly Mark[] = [];
  /** What the list of problems says. */
  private listed = "[]";

  /** Lists what is wrong. Only so much of it is shown that the page stays quick. */
  list(marks: readonly Mark[], lineOf: (offset: number) => number): void {
    const MOST = 200;
    this.marks = marks.slice(0, MOST);
    const placed = this.marks.map(({ severity, code, message, range }) => ({ severity, code, message, place: range === null ? "layout" : `line ${lineOf(range[0])}` }));
    const listed = JSON.stringify(placed);
    if (listed === this.listed) return;
    this.listed = listed;
    const items = placed.map(({ severity, code, message, place }) => el(`li.${severity}`, {}, el("button", { type: "button" }, el("code", {}, code), el("span.text", {}, message), el("span.place", {}, place))));
    this.problems.replaceChildren(...items);
  }

  tell(status: string, state: "good" | "bad" | "busy" | "plain" = "plain"): void {
    this.status.textContent = status;
    this.status.dataset["state"] = state;
  }

  /** Whether a layout is looked for. */
  busy(busy: boolean): void {
    this.stop.hidden = !busy;
    this.solve.disabled = busy;
  }

  /** A message over the page, until it is dismissed; `null`: none. */
  say(headline: string | null, ...lines: string[]): void {
    this.notice.hidden = headline === null;
    const close = el("button", { type: "button", "aria-label": "Dismiss" }, "✕");
    this.notice.replaceChildren(el("strong", {}, headline ?? ""), ...lines.map((line) => el("p", {}, line)), close);
  }

  /** What is in the menu of examples. */
  chosen(example: string | null): void {
    this.examples.value = example ?? "";
  }
}

/** Lets the line between two columns be moved, by pointer and by arrows. */
function divide(both: HTMLElement, line: HTMLElement): void {
  let share = 0.42;
  const put = (wanted: number) => {
    share = Math.min(0.75, Math.max(0.2, wanted));
    both.style.setProperty("--share", `${(share * 100).toFixed(2)}%`);
    line.setAttribute("aria-valuenow", (share * 100).toFixed(0));
  };
  put(share);
  line.addEventListener("pointerdown", (e) => {
    line.setPointerCapture(e.pointerId);
    e.preventDefault();
  });
  line.addEventListener("pointermove", (e) => {
    if (!line.hasPointerCapture(e.pointerId)) return;
    const { left, width } = both.getBoundingClientRect();
    put((e.clientX - left) / width);
  });
  line.addEventListener("keydown", (e) => {
    const by = { ArrowLeft: -0.02, ArrowRight: 0.02 }[e.key];
    if (by === undefined) return;
    e.preventDefault();
    e.stopPropagation();
    put(share + by);
  });
}
