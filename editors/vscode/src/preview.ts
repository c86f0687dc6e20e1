// The room beside the text: a panel for each program. It shows what the server says of it, what is pressed there is shown in
// the text, where the cursor is is emphasised there, and what is dragged there is an edit of the layout.

import { randomBytes } from "node:crypto";
import * as vscode from "vscode";
import { at, speaksOf } from "./groups.js";
import { page } from "./page.js";
import type { Confirmations } from "./confirm.js";
import type { Move, Provisional, Room, Shown } from "./protocol.js";
import { LANGUAGE, type Scenes } from "./scenes.js";
import type { Server } from "./server.js";
import { isRevealed, reveal } from "./tree.js";

const TYPE = "scenelang.preview";

/** What the page says; the other half of `viewer/src/source/webview.ts`. */
type Said =
  | { readonly type: "ready" }
  | ({ readonly type: "move"; readonly id: number } & Omit<Move, "uri">)
  | { readonly type: "reveal"; readonly object?: string; readonly row?: string };

export class Previews implements vscode.Disposable {
  private readonly panels = new Map<string, Preview>();
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly extension: vscode.Uri,
    private readonly scenes: Scenes,
    private readonly server: Server,
    confirmations: Confirmations,
  ) {
    this.subscriptions = [
      scenes.onUpdated((uri) => this.panels.get(uri)?.send()),
      confirmations.onAsked((shown) => {
        for (const [uri, preview] of this.panels) preview.ghost(shown !== null && vscode.Uri.parse(shown.uri).toString() === uri ? shown.moves : []);
      }),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, selections }) => {
        const selection = selections[0];
        if (textEditor.document.languageId !== LANGUAGE || selection === undefined) return;
        // What the page had shown in the text is selected in the page already, and often more closely: one chair of six.
        if (!isRevealed(textEditor.document.uri, selection)) this.follow(textEditor.document, selection.active);
      }),
      vscode.window.registerWebviewPanelSerializer(TYPE, {
        deserializeWebviewPanel: async (panel, state: { readonly uri?: unknown } | undefined) => {
          if (typeof state?.uri === "string") this.adopt(panel, state.uri);
          else panel.dispose();
        },
      }),
    ];
  }

  /** Opens the room of a program, and emphasises an object. */
  open(uri: vscode.Uri, object: string | null = null): void {
    let preview = this.panels.get(uri.toString());
    if (preview === undefined) {
      // The room is kept while the panel is hidden: to build it anew would lose where it was looked at from.
      const panel = vscode.window.createWebviewPanel(TYPE, "Preview", { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, { retainContextWhenHidden: true });
      preview = this.adopt(panel, uri.toString());
    } else preview.show();
    if (object !== null) preview.select(object);
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
    for (const preview of this.panels.values()) preview.dispose();
  }

  private adopt(panel: vscode.WebviewPanel, uri: string): Preview {
    const preview = new Preview(panel, this.extension, uri, this.scenes, this.server);
    this.panels.set(uri, preview);
    panel.onDidDispose(() => this.panels.delete(uri));
    return preview;
  }

  private follow(document: vscode.TextDocument, position: vscode.Position): void {
    const uri = document.uri.toString();
    const word = document.getWordRangeAtPosition(position, /[\p{L}_][\p{L}\p{N}_]*(\[\d+\])?/u);
    for (const [main, preview] of this.panels) {
      const scene = this.scenes.get(main);
      if (scene === null) continue;
      const meant = at(scene, main, uri, position.line, position.character, word === undefined ? "" : document.getText(word));
      if (meant !== null) preview.select(meant);
    }
  }
}

class Preview {
  /** What to emphasise once there is something to emphasise. */
  private wanted: string | null = null;
  private ready = false;
  /** The geometry that the page has. */
  private shape = "";
  private shown = false;
  private ghosts = false;
  /** Counts what was sent: an answer to an older question is not shown. */
  private turn = 0;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    extension: vscode.Uri,
    private readonly uri: string,
    private readonly scenes: Scenes,
    private readonly server: Server,
  ) {
    const dist = vscode.Uri.joinPath(extension, "dist");
    panel.title = `Preview ${vscode.Uri.parse(uri).path.split("/").at(-1) ?? ""}`;
    panel.iconPath = vscode.Uri.joinPath(extension, "media", "file-light.svg");
    panel.webview.options = { enableScripts: true, localResourceRoots: [dist] };
    panel.webview.onDidReceiveMessage((said: Said) => void this.hear(said));
    const script = panel.webview.asWebviewUri(vscode.Uri.joinPath(dist, "viewer.js")).toString();
    panel.webview.html = page({ script, nonce: randomBytes(18).toString("base64url") });
  }

  show(): void {
    this.panel.reveal(undefined, true);
  }

  dispose(): void {
    this.panel.dispose();
  }

  select(what: string): void {
    if (this.shown) void this.post({ type: "select", what });
    else this.wanted = what;
  }

  /** Shows where objects would be; none: as they are. */
  ghost(ghosts: Shown["moves"]): void {
    if (this.shown && (ghosts.length > 0 || this.ghosts)) void this.post({ type: "ghost", ghosts });
    this.ghosts = ghosts.length > 0;
  }

  /** Sends the room as it is now, or why there is none. */
  send(): void {
    if (!this.ready) return;
    const scene = this.scenes.get(this.uri);
    const why = this.scenes.why(this.uri);
    this.turn += 1;
    if (scene?.data == null) {
      const unplaced = scene !== null && why === null && scene.layout === null && scene.objects.length > 0;
      if (unplaced) void this.provisional(this.turn);
      else void this.post({ type: "stale", why: why ?? "the program has no layout yet, or does not compile" });
      return;
    }
    this.put(scene.data);
    if (why !== null) void this.post({ type: "stale", why });
  }

  /** Shows a room for a program without a layout, unless there is news before it is found. */
  private async provisional(turn: number): Promise<void> {
    void this.post({ type: "wait", why: "Finding a room for the program" });
    try {
      const known = this.shape === "" ? {} : { known: this.shape };
      const { data } = await this.server.ask<Provisional>("scenelang/provisional", { uri: this.uri, ...known });
      if (turn !== this.turn || data === null) return;
      this.put(data);
      void this.post({ type: "provisional" });
    } catch (error) {
      if (turn === this.turn) void this.post({ type: "stale", why: error instanceof Error ? error.message : String(error) });
    }
  }

  private put(room: Room): void {
    const { shape = "" } = room;
    const known = shape !== "" && shape === this.shape;
    this.shape = shape;
    void this.post({ type: "scenelang-data", data: known ? { ...room, glb: null } : room, uri: this.uri });
    this.shown = true;
    if (this.wanted !== null) void this.post({ type: "select", what: this.wanted });
    this.wanted = null;
  }

  private async hear(said: Said): Promise<void> {
    switch (said.type) {
      case "ready":
        this.ready = true;
        this.shape = "";
        this.scenes.get(this.uri);
        return this.send();
      case "reveal":
        return this.reveal(said);
      case "move": {
        const { id, object, pos, rot, commit } = said;
        try {
          const move: Move = { uri: this.uri, object, pos, ...(rot === undefined ? {} : { rot }), commit };
          await this.post({ type: "moved", id, verdicts: await this.server.ask("scenelang/move", move) });
        } catch (error) {
          await this.post({ type: "moved", id, error: error instanceof Error ? error.message : String(error) });
        }
      }
    }
  }

  private async reveal({ object, row }: { readonly object?: string; readonly row?: string }): Promise<void> {
    const scene = this.scenes.get(this.uri);
    const declared = object === undefined ? undefined : scene?.objects.find(({ name }) => speaksOf(object, name));
    const stated = scene?.constraints.find(({ id }) => id === row);
    if (declared !== undefined) await reveal({ uri: this.uri, range: declared.range }, true);
    else if (stated !== undefined) await reveal(stated, true);
  }

  private async post(message: unknown): Promise<void> {
    await this.panel.webview.postMessage(message);
  }
}
