// What happens: an edit is checked at once, its room shown, and a layout looked for where the one that is shown does not
// do any more. Two workers: one answers the editor; one does what takes long, and is ended when nobody wants its answer.

import examples from "virtual:examples";
import { App, type Hook } from "../../viewer/src/app.js";
import type { Move } from "../../viewer/src/live.js";
import type { File, Hover, Mark, Marks, Proposals, Solved, Written } from "./answers.js";
import { CalledOff, Client } from "./client.js";
import { Editor } from "./editor.js";
import { decode, encode } from "./link.js";
import { Page } from "./page.js";
import { Room } from "./room.js";
import { pointedAt } from "./places.js";

/** Milliseconds without an edit after which a layout is looked for, and proofs. */
const IDLE = 350;
/** Milliseconds after which the editor's worker is given up. */
const PATIENCE = 20_000;

/** What tests may look at, as `window.playground`. */
export interface Hooked {
  /** Milliseconds from edits to their rooms, the last ones. */
  readonly latencies: number[];
  /** How many rooms were shown. */
  shown: number;
  /** Whether nothing is under way. */
  idle(): boolean;
  text(): string;
  layout(): string | null;
  open(name: string, text: string, layout: string | null): Promise<void>;
  replace(from: number, to: number, text: string): void;
  file(format: "glb" | "layout" | "report"): Promise<File>;
}

declare global {
  interface Window {
    scenelang: Hook;
    playground: Hooked;
  }
}

export class Playground {
  private readonly page: Page;
  private readonly editor: Editor;
  private readonly room: Room;
  private app: App | null = null;
  private readonly quick: Client;
  private readonly slow: Client;
  private name = "room.scene";
  private layout: string | null = null;
  /** Counts texts, so that what is said of an older one is not shown. */
  private generation = 0;
  private checking = false;
  /** What is to be asked first, because another program was opened. */
  private opening: (() => Promise<Marks>) | null = null;
  private edited = false;
  private marks: Marks | null = null;
  private proofs: readonly Mark[] = [];
  private idle: ReturnType<typeof setTimeout> | undefined;
  private began = 0;
  /** How much that takes long is under way. */
  private tasks = 0;
  /** Counts searches for a layout. */
  private searches = 0;

  constructor(
    root: HTMLElement,
    private readonly module: Promise<WebAssembly.Module>,
  ) {
    this.quick = new Client(module);
    this.slow = new Client(module);
    this.page = new Page(root, examples.map(({ name }) => name), {
      example: (name) => void this.example(name),
      describe: (request) => void this.describe(request),
      solve: () => void this.solve(null),
      stop: () => this.stop(),
      share: () => void this.share(),
      format: () => void this.format(),
      download: (what) => void this.download(what),
      problem: ({ range }) => range !== null && this.editor.select(...range),
    });
    this.editor = new Editor(this.page.editor, {
      changed: () => this.changed(),
      complete: async (at, asked) => (await this.current(), this.quick.ask<Proposals>({ method: "complete", at, asked })),
      describe: (about) => this.quick.ask<string | null>({ method: "describe", about }),
      hover: async (at) => (await this.current(), this.quick.ask<Hover | null>({ method: "hover", at })),
      solve: () => void this.solve(null),
    });
    this.room = new Room({
      move: (move) => this.move(move),
      reveal: (pointed) => {
        const range = pointedAt(this.editor.text, this.name, pointed);
        if (range !== null) this.editor.select(...range);
      },
    });
    window.playground = this.hook;
  }

  readonly hook: Hooked = {
    latencies: [],
    shown: 0,
    idle: () => !this.checking && !this.edited && this.tasks === 0 && this.idle === undefined,
    text: () => this.editor.text,
    layout: () => this.layout,
    open: (name, text, layout) => this.open(name, text, layout),
    replace: (from, to, text) => this.editor.replace(from, to, text),
    file: (format) => this.quick.ask({ method: "export", format }),
  };

  /** Opens what the link has, or the first example. */
  async begin(): Promise<void> {
    await this.follow();
    window.addEventListener("hashchange", () => void this.follow());
  }

  private async follow(): Promise<void> {
    try {
      const shared = await decode(location.hash);
      if (shared !== null) return await this.open(shared.name, shared.text, null);
    } catch (why) {
      this.page.say("This link cannot be opened", why instanceof Error ? why.message : String(why));
    }
    const first = examples.find(({ name }) => name === "meeting-room") ?? examples[0];
    if (first !== undefined && this.generation === 0) await this.example(first.name);
  }

  private async example(name: string): Promise<void> {
    const example = examples.find((e) => e.name === name);
    if (example === undefined) return;
    await this.open(`${name}.scene`, example.text, example.layout);
    this.page.chosen(name);
  }

  private async open(name: string, text: string, layout: string | null): Promise<void> {
    this.stop();
    this.page.chosen(null);
    this.name = name;
    this.layout = layout;
    this.proofs = [];
    this.editor.open(text);
    this.room.wait("");
    this.edited = true;
    this.generation += 1;
    this.opening = () => this.quick.ask<Marks>({ method: "open", name, text: this.editor.text, layout });
    await this.check();
  }

  private changed(): void {
    this.began = performance.now();
    this.generation += 1;
    this.edited = true;
    this.slow.callOff();
    void this.check();
  }

  /** Waits until the module has the text of the editor. */
  private async current(): Promise<void> {
    while (this.edited || this.checking) await new Promise((done) => setTimeout(done, 5));
  }

  /** Tells the module of the text, and shows what it says of it; once more if the text has changed by then. */
  private async check(): Promise<void> {
    if (this.checking) return;
    this.checking = true;
    // How long that takes is up to the network.
    await this.module;
    const timer = setTimeout(() => this.quick.end(new Error("it takes too long to be checked here")), PATIENCE);
    try {
      while (this.edited) {
        this.edited = false;
        const { generation, began } = this;
        const ask = this.opening ?? (() => this.quick.ask<Marks>({ method: "edit", text: this.editor.text }));
        this.opening = null;
        const asked = ask();
        // The worker goes on with the room while the page shows what is marked.
        const room = this.layout === null ? null : this.ask();
        for (const answer of [asked, room]) answer?.catch(() => {});
        if (this.app === null) {
          // The worker has been asked after this, and starts while the viewer does, which takes as long.
          await new Promise((done) => setTimeout(done));
          this.viewer();
        }
        const marks = await asked;
        if (generation !== this.generation) continue;
        await this.show(marks, room);
        if (began > 0 && generation === this.generation) {
          this.hook.latencies.push(performance.now() - began);
          this.hook.latencies.splice(0, this.hook.latencies.length - 100);
        }
      }
      this.later();
    } catch (why) {
      this.failed(why);
    } finally {
      clearTimeout(timer);
      this.checking = false;
    }
    if (this.edited) void this.check();
  }

  /** The worker has been ended, by itself or by us: another one gets the program with the next edit. */
  private failed(why: unknown): void {
    const { name } = this;
    this.page.tell(`This program cannot be checked: ${why instanceof Error ? why.message : String(why)}`, "bad");
    this.quick.end(new Error("the program could not be checked"));
    void this.quick.ask({ method: "open", name, text: "", layout: null }).catch(() => {});
  }

  /** The viewer; started when it is first wanted. */
  private viewer(): App {
    if (this.app === null) {
      this.app = new App(this.page.viewer, this.room);
      window.scenelang = this.app.hook;
      this.room.start(this.app);
    }
    return this.app;
  }

  private async show(marks: Marks, room: Promise<unknown> | null = null): Promise<void> {
    this.marks = marks;
    this.present();
    if (this.layout === null) return;
    if (!(await this.draw(room ?? this.ask()))) this.room.stale("The program has changed; it is shown again when there is a layout");
    this.hook.shown += 1;
  }

  /** Asks for the room as the module has it now; `null`: it has none. The plan is for where there is no 3D. */
  private ask(): Promise<unknown> {
    return this.quick.ask({ method: "room", known: this.room.known, plan: this.app?.in3d === false });
  }

  /** Shows a room; `false`: there is none. */
  private async draw(room: Promise<unknown>): Promise<boolean> {
    const data = this.room.whole(await room);
    if (data === null) return false;
    const viewer = this.viewer();
    await viewer.hook.load(data);
    // Without 3D, which may have been given up with this room, it comes again with its plan.
    const { plan } = data as { readonly plan: string };
    return viewer.in3d || plan !== "" ? true : this.draw(this.ask());
  }

  private present(): void {
    const { marks } = this;
    if (marks === null) return;
    const all = [...marks.marks, ...this.proofs];
    const { doc } = this.editor.view.state;
    this.editor.mark(marks, all);
    this.page.list(all, (offset) => doc.lineAt(Math.min(offset, doc.length)).number);
    const errors = marks.marks.filter(({ severity, range }) => severity === "error" && range !== null).length;
    if (!marks.complete) this.page.tell(errors === 1 ? "1 error" : `${errors} errors`, "bad");
    else if (marks.count === null || !marks.placed) this.page.tell("no layout yet", "plain");
    else {
      const [holds, total, failing] = marks.count;
      this.page.tell(`${holds} of ${total} hold`, failing === 0 ? "good" : "bad");
    }
  }

  /** After a while without edits: a layout if one is needed, and what can be proved. */
  private later(): void {
    clearTimeout(this.idle);
    this.idle = setTimeout(() => {
      this.idle = undefined;
      const { marks } = this;
      if (marks === null || !marks.complete || this.edited || this.checking) return;
      const needed = !marks.placed || (marks.count?.[2] ?? 1) > 0;
      if (needed && this.page.live.checked && marks.objects > 0) void this.solve(this.layout);
      else void this.prove();
    }, IDLE);
  }

  private async prove(): Promise<void> {
    const { generation, name } = this;
    this.tasks += 1;
    try {
      await this.slow.ask({ method: "open", name, text: this.editor.text, layout: null });
      const proofs = await this.slow.ask<Mark[]>({ method: "proofs" });
      if (generation !== this.generation) return;
      this.proofs = proofs;
      this.present();
    } catch {
      // Called off, or too much: then nothing is proved.
    } finally {
      this.tasks -= 1;
    }
  }

  /** Looks for a layout, from the one that is shown or from nothing. */
  private async solve(start: string | null): Promise<void> {
    this.stop();
    const { generation, name } = this;
    const search = ++this.searches;
    this.tasks += 1;
    this.page.busy(true);
    this.page.tell("looking for a layout …", "busy");
    try {
      await this.current();
      const solved = await this.slow.ask<Solved>({ method: "solve", name, text: this.editor.text, start, seed: 0 });
      if (generation === this.generation) await this.take(solved);
    } catch (why) {
      if (!(why instanceof CalledOff)) this.page.say("No layout was found", why instanceof Error ? why.message : String(why));
      this.present();
    } finally {
      this.tasks -= 1;
      // Another search may have begun in place of this one.
      if (search === this.searches) this.page.busy(false);
    }
  }

  private async take({ layout, end, said, in_the_way: blamed = [], converged }: Solved): Promise<void> {
    if (layout === null) {
      this.page.tell(end === "contradiction" ? "no layout can exist" : "no layout", "bad");
      if (end === "contradiction") this.page.say("No layout can satisfy this program", ...said);
      void this.prove();
      return;
    }
    this.layout = layout;
    const marks = await this.quick.ask<Marks>({ method: "layout", text: layout });
    await this.show(marks);
    if (converged === false) this.page.say("No layout was found in which everything holds", ...blamed.map(({ text }) => `in the way: ${text}`));
    else void this.prove();
  }

  private stop(): void {
    clearTimeout(this.idle);
    this.idle = undefined;
    this.slow.callOff();
    this.page.busy(false);
  }

  private async describe(request: string): Promise<void> {
    this.stop();
    this.tasks += 1;
    this.page.busy(true);
    this.page.tell("reading …", "busy");
    try {
      const written = await this.slow.ask<Written>({ method: "write", text: request });
      this.page.busy(false);
      await this.open(written.name, written.program, written.solved?.layout ?? null);
      const notes = written.notes.map(({ text, reason }) => `“${text}”: ${reason}`);
      if (written.unused.length > 0) notes.unshift(`not understood: ${written.unused.join(", ")}`);
      if (written.overfull !== null) notes.unshift(written.overfull);
      if (notes.length > 0) this.page.say(`Understood ${written.understood} of ${written.clauses} parts of the request`, ...notes.slice(0, 8));
      else this.page.say(null);
    } catch (why) {
      this.page.busy(false);
      this.present();
      if (!(why instanceof CalledOff)) this.page.say("This request cannot be read", why instanceof Error ? why.message : String(why));
    } finally {
      this.tasks -= 1;
    }
  }

  private async move(move: Move): Promise<unknown> {
    const { object, pos, rot, commit } = move;
    const answer = await this.quick.ask<{ readonly layout?: string }>({ method: "move", object, pos, rot, commit });
    if (commit && answer.layout !== undefined) {
      this.layout = answer.layout;
      this.slow.callOff();
      const shown = this.quick.ask<Marks>({ method: "layout", text: answer.layout }).then((marks) => this.show(marks));
      shown.catch((why: unknown) => this.failed(why));
    }
    return answer;
  }

  private async share(): Promise<void> {
    try {
      const fragment = await encode({ name: this.name, text: this.editor.text });
      history.replaceState(null, "", fragment);
      await navigator.clipboard?.writeText(location.href).catch(() => {});
      this.page.say("The link is in the address bar and in the clipboard", "It contains the program itself. No server has a copy.");
    } catch (why) {
      this.page.say("There is no link", why instanceof Error ? why.message : String(why));
    }
  }

  private async format(): Promise<void> {
    await this.current();
    const found = await this.quick.ask<{ readonly range: readonly [number, number]; readonly text: string } | null>({ method: "format" });
    if (found !== null) this.editor.replace(found.range[0], found.range[1], found.text);
  }

  private async download(what: "program" | "glb" | "layout" | "report"): Promise<void> {
    try {
      await this.current();
      const file: File = what === "program" ? { name: this.name, text: this.editor.text } : await this.hook.file(what);
      const bytes = file.base64 === undefined ? [file.text ?? ""] : [Uint8Array.from(atob(file.base64), (c) => c.charCodeAt(0))];
      const address = URL.createObjectURL(new Blob(bytes, { type: "application/octet-stream" }));
      const link = document.createElement("a");
      link.href = address;
      link.download = file.name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(address), 10_000);
    } catch (why) {
      this.page.say("It could not be written", why instanceof Error ? why.message : String(why));
    }
  }
}
