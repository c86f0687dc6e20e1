// Layouts side by side, as small plans: the one that is pressed becomes the layout.

import { randomBytes } from "node:crypto";
import * as vscode from "vscode";
import { alternativesPage } from "./alternatives-page.js";
import type { Alternative } from "./protocol.js";

/** Shows layouts; `choose` is called with the one that is pressed. */
export function showAlternatives(title: string, all: readonly Alternative[], choose: (seed: number) => unknown): void {
  const panel = vscode.window.createWebviewPanel("scenelang.alternatives", title, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true }, { enableScripts: true, localResourceRoots: [] });
  panel.webview.html = alternativesPage(all, randomBytes(18).toString("base64url"));
  panel.webview.onDidReceiveMessage(({ seed }: { readonly seed?: unknown }) => {
    if (typeof seed !== "number" || !all.some((one) => one.seed === seed)) return;
    panel.dispose();
    void choose(seed);
  });
}
