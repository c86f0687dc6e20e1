// What a program becomes on its way: tree, names and types, formulas; shown beside it, and shown anew when it changes.

import * as vscode from "vscode";
import { type Form, FORMS } from "./protocol.js";
import type { Server } from "./server.js";

const SCHEME = "scenelang-form";
const WHAT: Readonly<Record<Form, string>> = {
  syntax: "the tree: every byte in one leaf",
  hir: "what names and expressions mean",
  constraints: "objects, regions and formulas",
};

export class Forms implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.changed.event;
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly server: Server) {
    this.subscriptions = [
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      server.onChanged(({ uri }) => {
        for (const { uri: form } of vscode.workspace.textDocuments) if (form.scheme === SCHEME && form.query === uri) this.changed.fire(form);
      }),
    ];
  }

  /** Asks which, and shows it. */
  async show(uri: vscode.Uri): Promise<void> {
    const chosen = await vscode.window.showQuickPick(FORMS.map((label) => ({ label, description: WHAT[label] })), { placeHolder: "Which form?" });
    if (chosen === undefined) return;
    const form = vscode.Uri.from({ scheme: SCHEME, path: `${uri.path}.${chosen.label}`, query: uri.toString() });
    await vscode.window.showTextDocument(form, { viewColumn: vscode.ViewColumn.Beside, preview: true });
  }

  async provideTextDocumentContent(form: vscode.Uri): Promise<string> {
    const name = FORMS.find((f) => form.path.endsWith(`.${f}`)) ?? "syntax";
    return (await this.server.ask<{ text: string }>("scenelang/forms", { uri: form.query, form: name })).text;
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }
}
