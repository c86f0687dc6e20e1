// A panel of VS Code. The extension sends rooms and answers; the page sends what is dragged and pointed at.
//
//   to the page:    {type: "scenelang-data", data, uri} (without the geometry where it was sent before)  {type: "moved", id, verdicts | error}  {type: "select", what}
//                   {type: "ghost", ghosts}  {type: "wait", why}  {type: "provisional"}  {type: "stale", why | null}
//   from the page:  {type: "ready"}  {type: "move", id, object, pos, rot, commit}  {type: "reveal", object | row}

import type { Ghost } from "../ghosts.js";
import { type Move, readVerdicts, type Verdicts } from "../live.js";
import { Shapes } from "./shapes.js";
import type { Pointed, Sink, Source } from "./source.js";

/** What the editor puts into the page. */
export interface EditorApi {
  postMessage(message: unknown): void;
  setState(state: unknown): void;
}

declare global {
  var acquireVsCodeApi: (() => EditorApi) | undefined;
}

type Message =
  | { readonly type: "scenelang-data"; readonly data: unknown; readonly uri: string }
  | { readonly type: "moved"; readonly id: number; readonly verdicts?: unknown; readonly error?: string }
  | { readonly type: "select"; readonly what: string }
  | { readonly type: "ghost"; readonly ghosts: readonly Ghost[] }
  | { readonly type: "wait"; readonly why: string }
  | { readonly type: "provisional" }
  | { readonly type: "stale"; readonly why: string | null };

export class Webview implements Source {
  private readonly asked = new Map<number, { done(verdicts: Verdicts): void; failed(why: unknown): void }>();
  private last = 0;
  private uri = "";
  private readonly shapes = new Shapes();

  /** What the pointer is on. */
  private pointed: string | null = null;
  private readonly listens = new WeakSet<HTMLElement>();

  constructor(private readonly editor: EditorApi) {}

  start(sink: Sink): void {
    window.addEventListener("message", (e: MessageEvent<Message>) => {
      // The editor's frame around the page is of the same origin; it hides itself from `window.parent`.
      if (e.origin === window.origin) this.hear(e.data, sink);
    });
    sink.wait("");
    this.editor.postMessage({ type: "ready" });
  }

  readonly move = (move: Move): Promise<Verdicts> =>
    new Promise((done, failed) => {
      const id = ++this.last;
      this.asked.set(id, { done, failed });
      this.editor.postMessage({ type: "move", id, ...move });
    });

  /** The menu of the editor is told by this attribute what it is for. */
  point(picture: HTMLElement, object: string | null): void {
    const around = picture.parentElement ?? picture;
    const about = object === null ? {} : { webviewSection: "object", object };
    around.dataset["vscodeContext"] = JSON.stringify({ uri: this.uri, ...about, preventDefaultContextMenuItems: true });
    this.pointed = object;
    if (this.listens.has(picture)) return;
    this.listens.add(picture);
    // The right button moves the camera, whose controls call the menu off; the editor then shows none. On an object it is asked
    // for anew, where the controls do not hear of it.
    const menu = (e: MouseEvent) => {
      if (this.pointed === null) return;
      e.preventDefault();
      e.stopImmediatePropagation();
      around.dispatchEvent(new MouseEvent("contextmenu", { bubbles: true, cancelable: true, clientX: e.clientX, clientY: e.clientY }));
    };
    picture.addEventListener("contextmenu", menu, { capture: true });
  }

  reveal(pointed: Pointed): void {
    this.editor.postMessage({ type: "reveal", ...pointed });
  }

  private hear(message: Message, sink: Sink): void {
    switch (message.type) {
      case "scenelang-data":
        // By this the editor finds the room again after it was closed.
        this.uri = message.uri;
        this.editor.setState({ uri: message.uri });
        return sink.load(this.shapes.whole(message.data));
      case "select":
        return sink.select(message.what);
      case "ghost":
        return sink.ghost(message.ghosts);
      case "wait":
        return sink.wait(message.why);
      case "provisional":
        return sink.provisional();
      case "stale":
        return sink.stale(message.why);
      case "moved":
        return this.answer(message.id, message);
    }
  }

  private answer(id: number, { verdicts, error }: { readonly verdicts?: unknown; readonly error?: string }): void {
    const waiting = this.asked.get(id);
    this.asked.delete(id);
    if (waiting === undefined) return;
    try {
      if (error !== undefined) throw new Error(error);
      waiting.done(readVerdicts(verdicts));
    } catch (why) {
      waiting.failed(why);
    }
  }
}
