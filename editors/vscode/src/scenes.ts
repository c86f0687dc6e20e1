// What the server says of the programs that someone looks at: one question at a time for each, and again after each change.

import * as vscode from "vscode";
import type { Scene } from "./protocol.js";
import type { Server } from "./server.js";

export const LANGUAGE = "scenelang";

interface Entry {
  scene: Scene | null;
  /** Why there is none, or no newer one. */
  why: string | null;
  /** A question is open; `stale`: and its answer will be old. */
  asking: boolean;
  stale: boolean;
}

export class Scenes implements vscode.Disposable {
  private readonly entries = new Map<string, Entry>();
  private readonly updated = new vscode.EventEmitter<string>();
  /** There is news of the program of this URI. */
  readonly onUpdated = this.updated.event;
  private readonly focused = new vscode.EventEmitter<void>();
  /** Another program is the one that is worked on. */
  readonly onFocused = this.focused.event;
  /** The program that is worked on: the last that had the focus and is still open. */
  current: vscode.Uri | null = null;
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly server: Server) {
    this.subscriptions = [
      server.onChanged(({ uri }) => this.refresh(uri)),
      server.onTurned((running) => {
        for (const uri of this.entries.keys()) {
          if (running) this.refresh(uri);
          else this.put(uri, { scene: null, why: "there is no server", asking: false, stale: false });
        }
      }),
      vscode.window.onDidChangeActiveTextEditor((editor) => this.follow(editor?.document)),
      vscode.workspace.onDidCloseTextDocument((document) => {
        if (document.languageId === LANGUAGE && document.uri.toString() === this.current?.toString()) this.focus(null);
      }),
    ];
    this.follow(vscode.window.activeTextEditor?.document);
  }

  /** What is known of a program; asks where nothing is. */
  get(uri: string): Scene | null {
    if (!this.entries.has(uri)) {
      this.entries.set(uri, { scene: null, why: null, asking: false, stale: false });
      this.refresh(uri);
    }
    return this.entries.get(uri)?.scene ?? null;
  }

  /** Why there is no scene, or no newer one. */
  why(uri: string): string | null {
    return this.entries.get(uri)?.why ?? null;
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }

  private follow(document: vscode.TextDocument | undefined): void {
    if (document?.languageId === LANGUAGE && document.uri.toString() !== this.current?.toString()) this.focus(document.uri);
  }

  private focus(uri: vscode.Uri | null): void {
    this.current = uri;
    void vscode.commands.executeCommand("setContext", "scenelang.active", uri !== null);
    this.focused.fire();
  }

  private refresh(uri: string): void {
    const entry = this.entries.get(uri);
    if (entry === undefined) return;
    entry.stale = true;
    if (!entry.asking) void this.ask(uri, entry);
  }

  private async ask(uri: string, entry: Entry): Promise<void> {
    entry.asking = true;
    while (entry.stale) {
      entry.stale = false;
      try {
        const known = entry.scene?.data ?? null;
        const scene = await this.server.ask<Scene>("scenelang/scene", { uri, known: known?.shape });
        // Geometry does not change when things are only moved, and is not sent again.
        entry.scene = scene.data?.glb === null && known !== null ? { ...scene, data: { ...scene.data, glb: known.glb } } : scene;
        entry.why = null;
      } catch (error) {
        entry.why = error instanceof Error ? error.message : String(error);
      }
    }
    entry.asking = false;
    this.updated.fire(uri);
  }

  private put(uri: string, entry: Entry): void {
    this.entries.set(uri, entry);
    this.updated.fire(uri);
  }
}
