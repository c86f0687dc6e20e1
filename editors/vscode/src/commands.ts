// The commands of the palette. Judging, solving and repairing are the server's, which knows what is in the editor but not yet on
// disk; building and exporting files is the command line's.

import { existsSync, readdirSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import * as vscode from "vscode";
import { showAlternatives } from "./alternatives.js";
import type { Locks } from "./locks.js";
import type { Alternative, Done } from "./protocol.js";
import { type Result, results } from "./results.js";
import { run } from "./run.js";
import { LANGUAGE, type Scenes } from "./scenes.js";
import { type Server, isCancelled, reason, say } from "./server.js";

export class Commands {
  constructor(
    private readonly server: Server,
    private readonly scenes: Scenes,
    private readonly locks: Locks,
  ) {}

  /** The program that a command is for: the one it is given, else the one that is worked on. */
  target(given?: vscode.Uri | string | { readonly uri?: unknown }): vscode.Uri | null {
    if (given instanceof vscode.Uri) return given;
    // The menu of the preview says what it is for.
    const uri = typeof given === "string" ? given : given?.uri;
    if (typeof uri === "string") return vscode.Uri.parse(uri);
    const document = vscode.window.activeTextEditor?.document;
    const found = document?.languageId === LANGUAGE ? document.uri : this.scenes.current;
    if (found === null) void vscode.window.showInformationMessage("Open a program (.scene) first.");
    return found;
  }

  /** A command of the server, which shows its own progress. */
  async serve(command: string, uri?: vscode.Uri | string, more: { readonly seed?: number; readonly only?: readonly string[]; readonly object?: string } = {}): Promise<void> {
    const target = this.target(uri);
    if (target === null) return;
    try {
      const done = await this.server.ask<Done | null>("workspace/executeCommand", { command, arguments: [{ uri: target.toString(), ...more }] });
      if (done !== null) say(done.holds === done.total, done.message);
    } catch (error) {
      if (!isCancelled(error)) say(false, reason(error));
    }
  }

  /** Repairs whatever fails, once it was shown. */
  async repair(): Promise<void> {
    const target = this.target();
    if (target === null) return;
    try {
      await this.server.repair("scenelang.repairAll", { uri: target.toString() });
    } catch (error) {
      if (!isCancelled(error)) say(false, reason(error));
    }
  }

  /** Solves anew with a number that the user gives: the same number makes the same room. */
  async solveSeed(uri?: vscode.Uri): Promise<void> {
    const target = this.target(uri);
    if (target === null) return;
    const whole = (text: string) => (/^\d{1,15}$/.test(text.trim()) ? null : "A whole number, 0 or more");
    const text = await vscode.window.showInputBox({ title: "Solve Anew with a Seed", prompt: "The same seed makes the same layout.", value: "1", validateInput: whole });
    if (text !== undefined) await this.serve("scenelang.solveAnew", target, { seed: Number(text.trim()) });
  }

  /** Shows several layouts side by side, to choose one. */
  async alternatives(uri?: vscode.Uri): Promise<void> {
    const target = this.target(uri);
    if (target === null) return;
    try {
      const { alternatives } = await this.server.ask<{ alternatives: readonly Alternative[] }>("workspace/executeCommand", { command: "scenelang.alternatives", arguments: [{ uri: target.toString() }] });
      showAlternatives(`Alternatives ${basename(target.path)}`, alternatives, (seed) => this.serve("scenelang.solveAnew", target, { seed }));
    } catch (error) {
      if (!isCancelled(error)) say(false, reason(error));
    }
  }

  /** Keeps an object where it is when the program is solved, or no longer does. */
  setLock(object: string, locked: boolean, uri?: string): void {
    const target = this.target(uri);
    if (target !== null) this.locks.set(target.toString(), object, locked);
  }

  /** Solves and builds everything into a folder. */
  async synth(uri?: vscode.Uri): Promise<void> {
    const target = await this.saved(uri);
    if (target === null) return;
    const folder = await this.folder(target);
    if (folder === null) return;
    await this.build(`Building ${basename(target.fsPath)}`, ["synth", target.fsPath, "-o", folder, ...this.server.modelOptions()], target, folder);
  }

  /** Writes the layout as it is into the formats of others. */
  async export(uri?: vscode.Uri): Promise<void> {
    const target = await this.saved(uri);
    if (target === null) return;
    const layout = this.scenes.get(target.toString())?.layout ?? null;
    if (layout === null) return say(false, "There is no layout to export yet: solve the program first.");
    const chosen = await vscode.window.showQuickPick(EXPORTS, { placeHolder: "Which formats?", canPickMany: true });
    if (chosen === undefined || chosen.length === 0) return;
    const folder = await this.folder(target);
    if (folder === null) return;
    const file = vscode.Uri.parse(layout);
    await (await vscode.workspace.openTextDocument(file)).save();
    await this.build(`Exporting ${basename(file.fsPath)}`, ["export", file.fsPath, "-o", folder, "--only", chosen.map(({ label }) => label).join(",")], target, folder);
  }

  private async build(title: string, args: readonly string[], target: vscode.Uri, folder: string): Promise<void> {
    const program = this.server.program();
    if (program === null) return;
    const env = await this.server.environment();
    const ended = await vscode.window.withProgress({ location: vscode.ProgressLocation.Notification, title, cancellable: true }, async (_, token) => {
      const abort = new AbortController();
      token.onCancellationRequested(() => abort.abort());
      const result = await run(program, args, dirname(target.fsPath), abort.signal, env).catch((error: unknown) => ({ code: 2, stdout: "", stderr: String(error) }));
      return abort.signal.aborted ? null : result;
    });
    if (ended === null) return;
    this.server.output.info(`${program} ${args.join(" ")}\n${ended.stdout}${ended.stderr}`);
    const good = ended.code === 0;
    const message = good ? `Written to ${folder}` : ended.code === 1 ? `Written to ${folder}, but not all constraints hold` : `It could not be done: ${lastLine(ended.stderr)}`;
    const written = ended.code === 0 || ended.code === 1;
    const found = written && existsSync(folder) ? results(readdirSync(folder)) : [];
    const buttons = [...(found.length > 0 ? ["Open…"] : []), ...(written ? ["Reveal"] : []), "Show Output"];
    const pressed = await (good ? vscode.window.showInformationMessage : vscode.window.showWarningMessage)(message, ...buttons);
    if (pressed === "Open…") await this.open(folder, found);
    if (pressed === "Reveal") await vscode.commands.executeCommand("revealFileInOS", vscode.Uri.file(folder));
    if (pressed === "Show Output") this.server.output.show();
  }

  /** Opens one of several results. */
  private async open(folder: string, found: readonly Result[]): Promise<void> {
    const items = found.map((result) => ({ label: result.label, description: result.file, result }));
    const chosen = await vscode.window.showQuickPick(items, { placeHolder: "Open what?" });
    if (chosen === undefined) return;
    const file = vscode.Uri.file(join(folder, chosen.result.file));
    if (chosen.result.where === "editor") await vscode.commands.executeCommand("vscode.open", file);
    else if (chosen.result.where === "outside") await vscode.env.openExternal(file);
    else await vscode.commands.executeCommand("revealFileInOS", file);
  }

  /** The program on disk, as the command line will read it. */
  private async saved(uri?: vscode.Uri): Promise<vscode.Uri | null> {
    const target = this.target(uri);
    if (target === null) return null;
    if (!vscode.workspace.isTrusted) return say(false, "This is done in trusted workspaces only."), null;
    const document = await vscode.workspace.openTextDocument(target);
    if (document.isUntitled || !(await document.save())) return say(false, "The program must be saved first."), null;
    return document.uri;
  }

  private async folder(target: vscode.Uri): Promise<string | null> {
    const stem = basename(target.fsPath).replace(/\.scene$/, "");
    const usual = join(vscode.workspace.getWorkspaceFolder(target)?.uri.fsPath ?? dirname(target.fsPath), "out", stem);
    const chosen = await vscode.window.showQuickPick([{ label: usual }, { label: "Another folder…", other: true }], { placeHolder: "Where to?" });
    if (chosen === undefined) return null;
    if (!("other" in chosen)) return usual;
    const [folder] = (await vscode.window.showOpenDialog({ canSelectFolders: true, canSelectFiles: false, openLabel: "Write Here" })) ?? [];
    return folder?.fsPath ?? null;
  }
}

/** The exporters of `scenelang export --only`. */
const EXPORTS: readonly vscode.QuickPickItem[] = [
  { label: "glb", description: "glTF, one binary file", picked: true },
  { label: "unity", description: "a Unity project", picked: true },
  { label: "plan", description: "a floor plan, SVG and PNG" },
  { label: "picture", description: "a picture, PNG", picked: true },
  { label: "preview", description: "a page with the room and every constraint" },
  { label: "mjcf", description: "MuJoCo" },
  { label: "sdf", description: "Gazebo" },
  { label: "usd", description: "OpenUSD, as text" },
  { label: "usdz", description: "OpenUSD, one file" },
  { label: "obj", description: "Wavefront OBJ" },
];

function lastLine(text: string): string {
  return text.trim().split("\n").at(-1) ?? "";
}
