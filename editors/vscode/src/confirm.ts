// Repairs are shown before they are made: the difference of the texts beside them, where objects would be in the preview, and a
// question.

import * as vscode from "vscode";
import type { Shown } from "./protocol.js";

const SCHEME = "scenelang-repaired";
const COMMAND = "scenelang.confirmRepair";

/** A change that waits for its confirmation. */
export interface Waiting {
  readonly title: string;
  /** Which margins it changes, in words. */
  readonly margins: readonly string[];
  readonly edit: vscode.WorkspaceEdit;
  readonly shown: Shown | null;
}

export class Confirmations implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly asked = new vscode.EventEmitter<Shown | null>();
  /** Where a change would put objects, as long as somebody is asked whether to make it; `null`: that is over. */
  readonly onAsked = this.asked.event;
  private readonly texts = new Map<string, string>();
  private readonly waiting = new Map<number, Waiting>();
  private last = 0;
  private readonly subscriptions = [
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
    vscode.commands.registerCommand(COMMAND, (id: number) => this.run(id)),
  ];

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.texts.get(uri.toString()) ?? "";
  }

  /** The command that asks, and then makes the change. */
  command(waiting: Waiting): vscode.Command {
    // Of a menu that was closed nothing is ever asked; a few are enough.
    for (const old of [...this.waiting.keys()].slice(0, -20)) this.waiting.delete(old);
    this.waiting.set(++this.last, waiting);
    return { command: COMMAND, title: waiting.title, arguments: [this.last] };
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }

  private async run(id: number): Promise<void> {
    const waiting = this.waiting.get(id);
    if (waiting === undefined) return;
    this.waiting.delete(id);
    await this.ask(waiting);
  }

  /** Shows a change, and makes it if it is wanted. */
  async ask({ title, margins, edit, shown }: Waiting): Promise<void> {
    const id = ++this.last;
    const documents = await Promise.all(edit.entries().map(([uri]) => vscode.workspace.openTextDocument(uri)));
    const versions = documents.map(({ version }) => version);
    const differences = edit.entries().map(([uri, edits], i) => {
      const after = uri.with({ scheme: SCHEME, query: String(id) });
      this.texts.set(after.toString(), edited(documents[i]?.getText() ?? "", documents[i], edits));
      return { uri, after };
    });
    this.asked.fire(shown);
    for (const { uri, after } of differences) {
      await vscode.commands.executeCommand("vscode.diff", uri, after, `${title}: ${uri.path.split("/").at(-1) ?? ""}`, { preview: true, preserveFocus: true, viewColumn: vscode.ViewColumn.One });
    }
    // A notification would go away by itself.
    const chosen = await vscode.window.showQuickPick([{ label: "Apply", description: title, detail: margins.join(" · ") }, { label: "Cancel" }], { title: `${title}?`, placeHolder: "The difference is shown below", ignoreFocusOut: true });
    const ours = ({ input }: vscode.Tab) => input instanceof vscode.TabInputTextDiff && differences.some(({ after }) => input.modified.toString() === after.toString());
    await vscode.window.tabGroups.close(vscode.window.tabGroups.all.flatMap(({ tabs }) => tabs.filter(ours)));
    for (const { after } of differences) this.texts.delete(after.toString());
    this.asked.fire(null);
    if (chosen?.label !== "Apply") return;
    if (documents.some(({ version }, i) => version !== versions[i])) {
      void vscode.window.showWarningMessage(`${title}: the text was changed meanwhile; nothing was done`);
      return;
    }
    // A new one, in which nothing has to be confirmed any more.
    const plain = new vscode.WorkspaceEdit();
    for (const [uri, edits] of edit.entries()) plain.set(uri, edits);
    await vscode.workspace.applyEdit(plain);
  }
}

/** A text after edits that do not overlap. */
function edited(text: string, document: vscode.TextDocument | undefined, edits: readonly vscode.TextEdit[]): string {
  if (document === undefined) return text;
  const at = (position: vscode.Position) => document.offsetAt(position);
  const sorted = [...edits].sort((a, b) => at(b.range.start) - at(a.range.start));
  return sorted.reduce((now, { range, newText }) => now.slice(0, at(range.start)) + newText + now.slice(at(range.end)), text);
}
