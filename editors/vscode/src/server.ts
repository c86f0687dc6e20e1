// The server: found, started with what it may know, and started again when that changes.

import { existsSync, statSync } from "node:fs";
import * as vscode from "vscode";
import { type CodeActionMiddleware, LanguageClient, type LanguageClientOptions, type Middleware, RevealOutputChannelOn, type ServerOptions, State } from "vscode-languageclient/node";
import type { Confirmations } from "./confirm.js";
import { type Choice, choice, environment } from "./environment.js";
import type { Keys } from "./keys.js";
import { type Located, locate } from "./locate.js";
import type { Locks } from "./locks.js";
import { askEditor } from "./model.js";
import type { Changed, Done, Proposal, Question, Shown } from "./protocol.js";

/** Commands whose change is shown before it is made. */
const REPAIRS = ["scenelang.repair", "scenelang.repairAll"];
/** Which of the settings the server is started with; of the others it is told while it runs. */
const AT_START = ["scenelang.server.path", "scenelang.languageModel", "scenelang.model.name", "scenelang.model.baseUrl"];

/** Which model is meant by `configured`: as `--model` and `--base-url` of the command line; empty: what scenelang.toml names. */
export interface Named {
  readonly name: string;
  readonly baseUrl: string;
}

export class Server implements vscode.Disposable {
  readonly output = vscode.window.createOutputChannel("ScenethesisLang", { log: true });
  private readonly changed = new vscode.EventEmitter<Changed>();
  /** A program was judged anew. */
  readonly onChanged = this.changed.event;
  private readonly turned = new vscode.EventEmitter<boolean>();
  /** It runs, or it no longer does. */
  readonly onTurned = this.turned.event;
  /** Edits of actions that are in a menu. */
  private readonly held = new WeakMap<vscode.CodeAction, vscode.WorkspaceEdit>();
  private client: LanguageClient | null = null;
  /** Starts and stops, one after the other. */
  private queue: Promise<void> = Promise.resolve();
  private readonly subscriptions: vscode.Disposable[];

  constructor(
    private readonly context: vscode.ExtensionContext,
    private readonly keys: Keys,
    private readonly confirmations: Confirmations,
    private readonly locks: Locks,
  ) {
    this.subscriptions = [
      locks.onChanged((program) => this.tellLocks(program)),
      vscode.workspace.onDidChangeConfiguration((e) => AT_START.some((name) => e.affectsConfiguration(name)) && void this.restart()),
      // What a folder may say, and what may be told to it, depends on trust.
      vscode.workspace.onDidGrantWorkspaceTrust(() => void this.restart()),
      context.secrets.onDidChange(() => void this.restart()),
    ];
  }

  get running(): boolean {
    // One that has crashed too often is not started again, and nobody but the client says so.
    return this.client?.isRunning() ?? false;
  }

  /** The program, for commands that run it themselves. */
  locate(): Located {
    const set = vscode.workspace.getConfiguration("scenelang").inspect<string>("server.path");
    return locate({
      settings: { user: set?.globalValue ?? null, workspace: set?.workspaceFolderValue ?? set?.workspaceValue ?? null },
      trusted: vscode.workspace.isTrusted,
      workspace: vscode.workspace.workspaceFolders?.[0]?.uri.fsPath ?? null,
      extension: this.context.extensionPath,
      path: process.env["PATH"] ?? "",
      windows: process.platform === "win32",
      runs: (file) => existsSync(file) && statSync(file).isFile(),
    });
  }

  /** Which language model the user wants asked. The setting is the user's alone: no folder can make it. */
  model(): Choice {
    return choice(vscode.workspace.getConfiguration("scenelang").get("languageModel"), vscode.workspace.isTrusted);
  }

  /** The model that the user's settings name, if they do. */
  named(): Named {
    const settings = vscode.workspace.getConfiguration("scenelang");
    const text = (name: string) => settings.get<string>(name, "").trim();
    return { name: text("model.name"), baseUrl: text("model.baseUrl") };
  }

  /** The options of the command line for the model that may be asked. */
  modelOptions(): string[] {
    if (this.model() !== "configured") return ["--model", "none"];
    const { name, baseUrl } = this.named();
    // An address is that of the model beside it, and of no other: a key is sent there.
    return name === "" ? ["--model", "configured"] : ["--model", name, ...(baseUrl === "" ? [] : ["--base-url", baseUrl])];
  }

  /** The environment of the server and of the command line. Keys are not even read where nobody may use them. */
  async environment(): Promise<NodeJS.ProcessEnv> {
    const chosen = this.model();
    return environment(process.env, chosen, chosen === "configured" ? await this.keys.environment() : {});
  }

  restart(): Promise<void> {
    this.queue = this.queue.then(() => this.stop()).then(() => this.start());
    return this.queue;
  }

  /** Asks the server; rejects where there is none. */
  async ask<T>(method: string, params: unknown): Promise<T> {
    await this.queue;
    if (this.client === null) throw new Error("there is no server");
    return this.client.sendRequest<T>(method, params);
  }

  /** Asks for a repair, shows it, and makes it if it is wanted. */
  async repair(command: string, target: { readonly uri?: string }): Promise<void> {
    const found = await this.ask<Proposal>("workspace/executeCommand", { command, arguments: [{ ...target, propose: true }] });
    const edit = found.edit === null ? undefined : await this.client?.protocol2CodeConverter.asWorkspaceEdit(found.edit);
    const [title = "", ...margins] = found.message.split("\n");
    if (edit === undefined) return say(found.holds === found.total, title);
    await this.confirmations.ask({ title: title.charAt(0).toUpperCase() + title.slice(1), margins, edit, shown: found });
  }

  /** The program, or nothing, in which case the user has been told. */
  program(): string | null {
    const located = this.locate();
    if ("command" in located) return located.command;
    this.tellMissing(located.missing);
    return null;
  }

  async dispose(): Promise<void> {
    for (const subscription of this.subscriptions) subscription.dispose();
    await this.queue.then(() => this.stop());
    this.output.dispose();
  }

  private async start(): Promise<void> {
    const located = this.locate();
    if ("missing" in located) {
      this.tellMissing(located.missing);
      this.turned.fire(false);
      return;
    }
    this.output.info(`the server is ${located.command}, from the ${located.from === "PATH" ? "PATH" : located.from}`);
    const model = this.model();
    const env = await this.environment();
    const server: ServerOptions = { command: located.command, args: ["lsp"], options: { env } };
    const options: LanguageClientOptions = {
      documentSelector: [{ scheme: "file", language: "scenelang" }, { scheme: "untitled", language: "scenelang" }, { scheme: "file", pattern: "**/*.layout.json" }],
      // "Show" of a code lens is a command of this extension.
      initializationOptions: { languageModel: model === "editor" ? "client" : model, model: this.named(), commands: ["scenelang.show"], pictures: true },
      middleware: this.middleware(),
      outputChannel: this.output,
      revealOutputChannelOn: RevealOutputChannelOn.Never,
    };
    const client = new LanguageClient("scenelang", "ScenethesisLang", server, options);
    client.onNotification("scenelang/changed", (changed: Changed) => this.changed.fire(changed));
    client.onRequest("scenelang/languageModel", (question: Question, token: vscode.CancellationToken) => askEditor(question, token));
    client.onDidChangeState(({ newState }) => {
      // A server that has crashed is started again by the client, up to five times.
      if (this.client !== client || newState === State.Starting) return;
      if (newState === State.Running) this.locks.programs().forEach((program) => this.tellLocks(program));
      this.turned.fire(newState === State.Running);
    });
    try {
      await client.start();
      this.client = client;
      this.locks.programs().forEach((program) => this.tellLocks(program));
      this.turned.fire(true);
    } catch (error) {
      this.turned.fire(false);
      void this.offer(`The server ${located.command} does not start: ${reason(error)}`, ["Show Output", () => this.output.show()]);
    }
  }

  private async stop(): Promise<void> {
    const { client } = this;
    this.client = null;
    // One that has crashed cannot be stopped.
    await client?.dispose().catch((error: unknown) => this.output.warn(String(error)));
  }

  /** What the client itself would keep to its log: that something which the user chose could not be done, and what was done. */
  private middleware(): Middleware & CodeActionMiddleware {
    return {
      // The edit of what is offered comes when it is chosen, and then asks first.
      provideCodeActions: async (document, range, context, token, next) => {
        const actions = (await next(document, range, context, token)) ?? [];
        for (const action of actions) {
          if (!(action instanceof vscode.CodeAction) || action.edit === undefined || shownOf(action) === null) continue;
          this.held.set(action, action.edit);
          delete action.edit;
        }
        return actions;
      },
      resolveCodeAction: async (action, token, next) => {
        const ask = (edit: vscode.WorkspaceEdit, title: string, found: vscode.CodeAction) => {
          const shown = shownOf(found);
          delete action.edit;
          action.command = this.confirmations.command({ title, margins: shown?.margins ?? [], edit, shown });
          return action;
        };
        const held = this.held.get(action);
        if (held !== undefined) {
          // Which margins it changes is worked out when it is chosen; without them it is asked about all the same.
          const judged = await Promise.resolve(next(action, token)).catch(() => null);
          return ask(held, action.title, judged ?? action);
        }
        try {
          const repair = isRepair(action);
          const found = await next(action, token);
          // Its title now says what the repair is, and whose idea.
          return repair && found?.edit !== undefined ? ask(found.edit, found.title, found) : found;
        } catch (error) {
          if (!isCancelled(error)) void vscode.window.showWarningMessage(`${action.title}: ${reason(error)}`);
          return action;
        }
      },
      executeCommand: async (command, args, next) => {
        try {
          if (REPAIRS.includes(command)) {
            await this.repair(command, args[0]);
            return null;
          }
          const done: Done | null = await next(command, args);
          if (done !== null) say(done.holds === done.total, done.message);
          return done;
        } catch (error) {
          if (!isCancelled(error)) say(false, reason(error));
          return null;
        }
      },
    };
  }

  private tellLocks(uri: string): void {
    void this.client?.sendNotification("scenelang/lock", { uri, objects: this.locks.of(uri) });
  }

  private tellMissing(why: string): void {
    this.output.error(why);
    void this.offer(
      `ScenethesisLang has no server: ${why}.`,
      ["Open Setting", () => vscode.commands.executeCommand("workbench.action.openSettings", "scenelang.server.path")],
      ["Show Output", () => this.output.show()],
    );
  }

  private async offer(message: string, ...buttons: readonly (readonly [string, () => unknown])[]): Promise<void> {
    const pressed = await vscode.window.showErrorMessage(message, ...buttons.map(([title]) => title));
    await buttons.find(([title]) => title === pressed)?.[1]();
  }
}

/** Where an action would put objects; `null`: it moves none, or that is not known yet. */
function shownOf(action: vscode.CodeAction): Shown | null {
  const data = (action as { readonly data?: Partial<Shown> }).data;
  return typeof data?.uri === "string" && Array.isArray(data.moves) ? { uri: data.uri, moves: data.moves, margins: data.margins ?? [] } : null;
}

/** Whether an action is a repair that the server works out when it is chosen. */
function isRepair(action: vscode.CodeAction): boolean {
  const data = (action as { readonly data?: { readonly line?: unknown } }).data;
  return typeof data?.line === "number";
}

export function say(good: boolean, message: string): void {
  void (good ? vscode.window.showInformationMessage(message) : vscode.window.showWarningMessage(message));
}

export function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/** The codes by which the protocol calls off. */
export function isCancelled(error: unknown): boolean {
  const code = (error as { readonly code?: unknown } | null)?.code;
  return code === -32800 || code === -32802 || error instanceof vscode.CancellationError;
}
