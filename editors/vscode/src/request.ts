// The request that a program was written from, below the program: each phrase marked by what became of it.

import * as vscode from "vscode";
import { type Fate, type Marked, type Outcome, marked } from "./request-text.js";

const SCHEME = "scenelang-request";

export class Requests implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly known = new Map<string, Marked>();
  private readonly kinds: Readonly<Record<Fate, vscode.TextEditorDecorationType>> = {
    became: vscode.window.createTextEditorDecorationType({ backgroundColor: new vscode.ThemeColor("diffEditor.insertedTextBackground") }),
    lost: vscode.window.createTextEditorDecorationType({ backgroundColor: new vscode.ThemeColor("diffEditor.removedTextBackground"), textDecoration: "line-through" }),
    noted: vscode.window.createTextEditorDecorationType({ textDecoration: "underline dotted" }),
  };
  private readonly subscriptions: vscode.Disposable[];

  constructor() {
    this.subscriptions = [
      ...Object.values(this.kinds),
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.window.onDidChangeVisibleTextEditors(() => this.decorate()),
    ];
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.known.get(uri.toString())?.text ?? "The request is no longer known.";
  }

  /** Shows the request of a program below it. */
  async show(program: vscode.Uri, request: string, outcome: Outcome): Promise<void> {
    const uri = vscode.Uri.from({ scheme: SCHEME, path: `${program.path.replace(/\.scene$/, "")} (request)` });
    this.known.set(uri.toString(), marked(request, outcome));
    const first = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === program.toString());
    await vscode.window.showTextDocument(uri, { viewColumn: first?.viewColumn ?? vscode.ViewColumn.One, preview: false });
    await vscode.commands.executeCommand("workbench.action.moveEditorToBelowGroup");
    this.decorate();
    const again = vscode.window.visibleTextEditors.find(({ document }) => document.uri.toString() === program.toString());
    await vscode.window.showTextDocument(program, { viewColumn: again?.viewColumn ?? vscode.ViewColumn.One, preview: false });
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }

  private decorate(): void {
    for (const editor of vscode.window.visibleTextEditors) {
      const { document } = editor;
      const found = this.known.get(document.uri.toString());
      if (found === undefined) continue;
      for (const fate of ["became", "lost", "noted"] as const) {
        const marks = found.marks.filter((mark) => mark.fate === fate);
        const options = marks.map(({ start, end, said, lines }) => {
          const hoverMessage = new vscode.MarkdownString().appendText(said);
          if (lines.length > 0) hoverMessage.appendCodeblock(lines.join("\n"), "scenelang");
          return { range: new vscode.Range(document.positionAt(start), document.positionAt(end)), hoverMessage };
        });
        editor.setDecorations(this.kinds[fate], options);
      }
    }
  }
}
