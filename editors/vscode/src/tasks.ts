// Tasks: the command line on a file or the whole folder, its findings read into the Problems panel.

import * as vscode from "vscode";
import { LANGUAGE } from "./scenes.js";
import type { Server } from "./server.js";

interface Definition extends vscode.TaskDefinition {
  readonly command: "check" | "solve" | "synth";
  readonly file?: string;
  readonly args?: readonly string[];
}

export class Tasks implements vscode.TaskProvider {
  constructor(private readonly server: Server) {}

  provideTasks(): vscode.Task[] {
    return (vscode.workspace.workspaceFolders ?? []).flatMap((folder) => {
      const document = vscode.window.activeTextEditor?.document;
      const own = document?.languageId === LANGUAGE && vscode.workspace.getWorkspaceFolder(document.uri) === folder ? vscode.workspace.asRelativePath(document.uri, false) : null;
      const definitions: Definition[] = [{ type: LANGUAGE, command: "check" }];
      if (own !== null) definitions.push(...(["check", "solve", "synth"] as const).map((command) => ({ type: LANGUAGE, command, file: own })));
      return definitions.flatMap((definition) => this.task(definition, folder) ?? []);
    });
  }

  resolveTask(task: vscode.Task): vscode.Task | undefined {
    const folder = typeof task.scope === "object" ? task.scope : vscode.workspace.workspaceFolders?.[0];
    // The definition must stay the very same, or the task is another.
    return folder === undefined ? undefined : this.task(task.definition as Definition, folder);
  }

  private task(definition: Definition, folder: vscode.WorkspaceFolder): vscode.Task | undefined {
    const located = this.server.locate();
    if (!("command" in located)) return undefined;
    const { command, file, args = [] } = definition;
    const compact = command === "check" ? ["--verbosity", "compact"] : [];
    const execution = new vscode.ProcessExecution(located.command, [command, file ?? ".", ...compact, ...args], { cwd: folder.uri.fsPath });
    const task = new vscode.Task(definition, folder, [command, file].filter(Boolean).join(" "), LANGUAGE, execution, "$scenelang");
    task.group = command === "check" ? vscode.TaskGroup.Test : vscode.TaskGroup.Build;
    return task;
  }
}
