// The constraints of the program that is worked on, as a tree: by what became of them, or by object.

import * as vscode from "vscode";
import { type Group, type Grouping, groups, margin } from "./groups.js";
import type { Locks } from "./locks.js";
import type { Constraint, Range, State } from "./protocol.js";
import type { Scenes } from "./scenes.js";

type Node = { readonly group: Group } | { readonly constraint: Constraint };

const ICONS: Readonly<Record<State, vscode.ThemeIcon>> = {
  holds: new vscode.ThemeIcon("pass", new vscode.ThemeColor("testing.iconPassed")),
  fails: new vscode.ThemeIcon("error", new vscode.ThemeColor("testing.iconFailed")),
  unknown: new vscode.ThemeIcon("question", new vscode.ThemeColor("testing.iconQueued")),
};

export class Tree implements vscode.TreeDataProvider<Node>, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<void>();
  readonly onDidChangeTreeData = this.changed.event;
  private by: Grouping;
  private readonly view: vscode.TreeView<Node>;
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly scenes: Scenes,
    private readonly memory: vscode.Memento,
    private readonly locks: Locks,
  ) {
    this.by = memory.get<Grouping>("tree") ?? "state";
    this.view = vscode.window.createTreeView("scenelang.constraints", { treeDataProvider: this, showCollapseAll: true });
    this.subscriptions = [
      this.view,
      scenes.onFocused(() => this.changed.fire()),
      locks.onChanged(() => this.changed.fire()),
      scenes.onUpdated((uri) => uri === scenes.current?.toString() && this.changed.fire()),
      vscode.commands.registerCommand("scenelang.treeByObject", () => this.group("object")),
      vscode.commands.registerCommand("scenelang.treeByState", () => this.group("state")),
      vscode.commands.registerCommand("scenelang.goTo", (target: Node | Target) => this.go(target)),
      vscode.commands.registerCommand("scenelang.showInPreview", (node: Node) => {
        if ("group" in node) void vscode.commands.executeCommand("scenelang.show", { uri: scenes.current?.toString(), object: node.group.name });
      }),
    ];
    this.group(this.by);
  }

  getChildren(node?: Node): Node[] {
    if (node === undefined) {
      const scene = this.scene();
      return scene === null ? [] : groups(scene, this.by).map((group) => ({ group }));
    }
    return "group" in node ? node.group.constraints.map((constraint) => ({ constraint })) : [];
  }

  getTreeItem(node: Node): vscode.TreeItem {
    if ("group" in node) {
      const { name, state, object, constraints } = node.group;
      const item = new vscode.TreeItem(name, state === "holds" ? vscode.TreeItemCollapsibleState.Collapsed : vscode.TreeItemCollapsibleState.Expanded);
      const held = constraints.filter((c) => c.state === "holds").length;
      item.description = this.by === "object" ? `${held}/${constraints.length}` : String(constraints.length);
      item.iconPath = ICONS[state];
      item.id = `${this.by} ${name}`;
      if (object) {
        const locked = this.locks.of(this.scenes.current?.toString() ?? "").includes(name);
        item.contextValue = locked ? "object locked" : "object";
        if (locked) item.description = `${item.description} · locked`;
      }
      return item;
    }
    const { constraint } = node;
    // The margin first: a long text is cut.
    const item = new vscode.TreeItem([margin(constraint), constraint.text].filter(Boolean).join("  "));
    item.iconPath = ICONS[constraint.state];
    item.tooltip = new vscode.MarkdownString().appendCodeblock(constraint.text, "scenelang").appendText([margin(constraint), constraint.objects.join(", ")].filter(Boolean).join(" · "));
    item.command = { command: "scenelang.goTo", title: "Go to Source", arguments: [{ uri: constraint.uri, range: constraint.range } satisfies Target] };
    return item;
  }

  dispose(): void {
    for (const subscription of this.subscriptions) subscription.dispose();
  }

  private scene() {
    const { current } = this.scenes;
    return current === null ? null : this.scenes.get(current.toString());
  }

  private group(by: Grouping): void {
    this.by = by;
    void this.memory.update("tree", by);
    void vscode.commands.executeCommand("setContext", "scenelang.tree", by);
    this.changed.fire();
  }

  private async go(target: Node | Target): Promise<void> {
    if ("uri" in target) return reveal(target);
    const uri = this.scenes.current?.toString();
    const object = "group" in target ? this.scene()?.objects.find(({ name }) => name === target.group.name) : undefined;
    if (object !== undefined && uri !== undefined) await reveal({ uri, range: object.range });
  }
}

/** A place in a text. */
export interface Target {
  readonly uri: string;
  readonly range: Range;
}

/** What was shown last, as long as nobody selects anything else. */
let revealed: { readonly uri: string; readonly selection: vscode.Selection } | null = null;

/** Whether a selection is the one that was made to show something. */
export function isRevealed(uri: vscode.Uri, selection: vscode.Selection): boolean {
  if (revealed?.uri === uri.toString() && revealed.selection.isEqual(selection)) return true;
  revealed = null;
  return false;
}

/** Shows a place, in the editor that has the text already if there is one. */
export async function reveal({ uri, range: { start, end } }: Target, preserveFocus = false): Promise<void> {
  const document = await vscode.workspace.openTextDocument(vscode.Uri.parse(uri));
  const open = vscode.window.visibleTextEditors.find((editor) => editor.document === document);
  const selection = new vscode.Selection(start.line, start.character, end.line, end.character);
  if (preserveFocus) revealed = { uri: document.uri.toString(), selection };
  const column = open?.viewColumn ?? vscode.ViewColumn.One;
  await vscode.window.showTextDocument(document, { viewColumn: column, selection, preserveFocus });
}
