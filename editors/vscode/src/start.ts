// How a scene begins: a small program, one written from a description, or an example; with the room beside it.

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import * as vscode from "vscode";
import type { Commands } from "./commands.js";
import { firstComment, named, refusal } from "./names.js";
import type { Previews } from "./preview.js";
import type { Requests } from "./request.js";
import { type Outcome, summary } from "./request-text.js";
import { run } from "./run.js";
import { type Server, reason, say } from "./server.js";

export class Start {
  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly server: Server,
    private readonly commands: Commands,
    private readonly previews: Previews,
    private readonly requests: Requests,
  ) {}

  /** A small commented program in a new file. */
  async create(): Promise<void> {
    const file = await this.file("room", true);
    if (file === null) return;
    const made = await this.command("Writing a program", ["new", file.fsPath], file);
    if (made !== null) await this.show(file);
  }

  /** A program written from a sentence, with what became of each of its phrases. */
  async describe(): Promise<void> {
    if (!vscode.workspace.isTrusted) return say(false, "This is done in trusted workspaces only.");
    const request = await vscode.window.showInputBox({
      title: "New Scene from a Description",
      prompt: "What is in the room, and where?",
      placeHolder: "a study with a desk against the wall, a chair at the desk and two bookshelves",
      ignoreFocusOut: true,
    });
    if (request === undefined || request.trim() === "") return;
    const file = await this.file("room", false);
    if (file === null) return;
    const said = await this.command("Writing a program", ["formalize", "-o", file.fsPath, "--format", "json", ...this.server.modelOptions(), "--", request], file);
    if (said === null) return;
    let outcome: Outcome;
    try {
      outcome = JSON.parse(said) as Outcome;
    } catch (error) {
      return say(false, `What was understood cannot be read: ${reason(error)}`);
    }
    await this.show(file);
    await this.requests.show(file, request, outcome);
    say(outcome.words.unused.length === 0, summary(outcome));
  }

  /** One of the examples that come with the extension, as a copy of one's own. */
  async example(): Promise<void> {
    const folder = join(this.context.extensionPath, "dist", "examples");
    const names = readdirSync(folder).filter((name) => name.endsWith(".scene")).sort();
    const items = names.map((name) => ({ label: name.replace(/\.scene$/, ""), description: firstComment(readFileSync(join(folder, name), "utf8")), name }));
    const chosen = await vscode.window.showQuickPick(items, { placeHolder: "Which example?" });
    if (chosen === undefined) return;
    const own = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? join(this.context.globalStorageUri.fsPath, "examples");
    const file = vscode.Uri.file(free(own, chosen.label));
    try {
      mkdirSync(own, { recursive: true });
      writeFileSync(file.fsPath, readFileSync(join(folder, chosen.name)), { flag: "wx" });
    } catch (error) {
      return say(false, `The example cannot be copied: ${reason(error)}`);
    }
    await this.show(file);
  }

  /** The program, the room beside it, and a first layout. */
  private async show(file: vscode.Uri): Promise<void> {
    await vscode.window.showTextDocument(file, { viewColumn: vscode.ViewColumn.One, preview: false });
    this.previews.open(file);
    await this.commands.serve("scenelang.solve", file);
  }

  /** A file that is not there yet, in the folder that is open or where the user says. */
  private async file(stem: string, asked: boolean): Promise<vscode.Uri | null> {
    const folder = vscode.workspace.workspaceFolders?.[0]?.uri;
    if (folder?.scheme !== "file") {
      const chosen = await vscode.window.showSaveDialog({ title: "Where is the program to be?", defaultUri: vscode.Uri.file(free(this.context.globalStorageUri.fsPath, stem)), filters: { Programs: ["scene"] } });
      if (chosen === undefined) return null;
      const file = chosen.with({ path: named(chosen.path) });
      mkdirSync(dirname(file.fsPath), { recursive: true });
      return file;
    }
    const usual = free(folder.fsPath, stem);
    if (!asked) return vscode.Uri.file(usual);
    const name = await vscode.window.showInputBox({
      title: "New Scene",
      prompt: `The name of the program, in ${basename(folder.fsPath)}`,
      value: basename(usual),
      valueSelection: [0, basename(usual, ".scene").length],
      validateInput: (text) => refusal(text, (file) => existsSync(join(folder.fsPath, file))),
    });
    return name === undefined ? null : vscode.Uri.file(join(folder.fsPath, named(name)));
  }

  /** Runs the command line; what it said, or `null` where it was called off or could not do it, which the user is told. */
  private async command(title: string, args: readonly string[], file: vscode.Uri): Promise<string | null> {
    const program = this.server.program();
    if (program === null) return null;
    const env = await this.server.environment();
    const ended = await vscode.window.withProgress({ location: vscode.ProgressLocation.Notification, title, cancellable: true }, async (_, token) => {
      const abort = new AbortController();
      token.onCancellationRequested(() => abort.abort());
      const result = await run(program, args, dirname(file.fsPath), abort.signal, env).catch((error: unknown) => ({ code: 2, stdout: "", stderr: reason(error) }));
      return abort.signal.aborted ? null : result;
    });
    if (ended === null) return null;
    this.server.output.info(`${program} ${args[0]}\n${ended.stderr}`);
    // 1: nothing was understood, of which there is more to say than that.
    if (ended.code === 0 || (ended.code === 1 && existsSync(file.fsPath))) return ended.stdout;
    say(false, ended.stderr.trim().split("\n").at(-1) ?? "It could not be done.");
    return null;
  }
}

/** A file of this name that is not there yet: `room.scene`, `room-2.scene` and so on. */
function free(folder: string, stem: string): string {
  for (let n = 1; ; n += 1) {
    const file = join(folder, n === 1 ? `${stem}.scene` : `${stem}-${n}.scene`);
    if (!existsSync(file) && !existsSync(file.replace(/\.scene$/, ".layout.json"))) return file;
  }
}
