// The status bar: how many of the constraints hold.

import * as vscode from "vscode";
import type { Scenes } from "./scenes.js";
import type { Server } from "./server.js";

export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem("scenelang.status", vscode.StatusBarAlignment.Left, 10);
  private readonly subscriptions: vscode.Disposable[];
  /** What the server last said of each program, the one that is worked on or not: it says so once. */
  private readonly tallies = new Map<string, { readonly holds: number; readonly total: number }>();

  constructor(
    private readonly scenes: Scenes,
    private readonly server: Server,
  ) {
    this.item.name = "ScenethesisLang";
    this.subscriptions = [
      this.item,
      server.onTurned((running) => {
        // Another server says all of it again.
        if (!running) this.tallies.clear();
        this.show();
      }),
      server.onChanged((changed) => this.put(changed.uri, changed)),
      scenes.onFocused(() => this.show()),
      scenes.onUpdated((uri) => {
        const scene = scenes.get(uri);
        if (scene !== null) this.put(uri, scene);
      }),
      vscode.workspace.onDidCloseTextDocument(({ uri }) => this.tallies.delete(uri.toString())),
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
    const tally = this.tallies.get(uri) ?? null;
    this.item.backgroundColor = undefined;
    if (!this.server.running) {
      this.say("$(warning) no server", "ScenethesisLang has no server; press to start it", "scenelang.restartServer");
      this.item.backgroundColor = new vscode.ThemeColor("statusBarItem.warningBackground");
    } else if (tally === null || tally.total === 0) this.say("$(circle-outline) not checked", "There is nothing to check: there is no layout, or the program does not compile", "scenelang.constraints.focus");
    else {
      const all = tally.holds === tally.total;
      this.say(`$(${all ? "pass" : "error"}) ${tally.holds}/${tally.total} hold`, "Constraints that hold; press to see all", "scenelang.constraints.focus");
    }
    this.item.show();
  }

  private put(uri: string, { holds, total }: { readonly holds: number; readonly total: number }): void {
    this.tallies.set(uri, { holds, total });
    this.show();
  }

  private say(text: string, tooltip: string, command: string): void {
    Object.assign(this.item, { text, tooltip, command });
  }
}
