// Objects that stay where they are when a program is solved or repaired: chosen in the tree and in the preview, kept with the
// workspace.

import * as vscode from "vscode";

const MEMORY = "locks";

export class Locks {
  private readonly changed = new vscode.EventEmitter<string>();
  /** Of a program others are locked. */
  readonly onChanged = this.changed.event;

  constructor(private readonly memory: vscode.Memento) {}

  /** The locked objects of a program. */
  of(uri: string): readonly string[] {
    return this.all()[uri] ?? [];
  }

  set(uri: string, object: string, locked: boolean): void {
    const others = this.of(uri).filter((name) => name !== object);
    const { [uri]: _, ...rest } = this.all();
    const now = locked ? [...others, object].sort() : others;
    void this.memory.update(MEMORY, now.length > 0 ? { ...rest, [uri]: now } : rest);
    this.changed.fire(uri);
  }

  /** The programs that have any. */
  programs(): readonly string[] {
    return Object.keys(this.all());
  }

  private all(): Readonly<Record<string, readonly string[]>> {
    return this.memory.get(MEMORY) ?? {};
  }
}
