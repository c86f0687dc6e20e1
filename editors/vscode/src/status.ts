// The status bar: how many of the constraints hold.

import * as vscode from "vscode";
import type { Scenes } from "./scenes.js";
import type { Server } from "./server.js";

export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem("scenelang.status", vscode.StatusBarAlignment.Left, 10);
  private readonly subscriptions: vscode.Disposable[];
  /** What the server last said, which comes before the scene does. */
  private tally: { readonly uri: string; readonly holds: number; readonly total: number } | null = null;

  constructor(
    private readonly scenes: Scenes,
    private readonly server: Server,
  ) {
    this.item.name = "ScenethesisLang";
    this.subscriptions = [
      this.item,
      server.onTurned(() => this.show()),
      server.onChanged((changed) => {
        if (changed.uri === this.scenes.current?.toString()) this.tally = changed;
        this.show();
      }),
      scenes.onFocused(() => this.show()),
      scenes.onUpdated((uri) => {
        const scene = uri === this.scenes.current?.toString() ? this.scenes.get(uri) : null;
        if (scene !== null) this.tally = { uri, holds: scene.holds, total: scene.total };
        this.show();
      }),
    ];
    this.show();
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }

  private show(): void {
    const uri = this.scenes.current?.toString();
    if (uri === undefined) {
      this.item.hide();
      return;
    }
    const tally = this.tally?.uri === uri ? this.tally : null;
    this.item.backgroundColor = undefined;
    if (!this.server.running) {
      this.put("$(warning) no server", "ScenethesisLang has no server; press to start it", "scenelang.restartServer");
      this.item.backgroundColor = new vscode.ThemeColor("statusBarItem.warningBackground");
    } else if (tally === null || tally.total === 0) this.put("$(circle-outline) not judged", "There is nothing to judge: no layout, or the program does not compile", "scenelang.constraints.focus");
    else {
      const all = tally.holds === tally.total;
      this.put(`$(${all ? "pass" : "error"}) ${tally.holds}/${tally.total} hold`, "Constraints that hold; press to see all", "scenelang.constraints.focus");
    }
    this.item.show();
  }

  private put(text: string, tooltip: string, command: string): void {
    Object.assign(this.item, { text, tooltip, command });
  }
}
