// What the extension is made of, put together.

import * as vscode from "vscode";
import { Commands } from "./commands.js";
import { Confirmations } from "./confirm.js";
import { Forms } from "./forms.js";
import { Keys } from "./keys.js";
import { Locks } from "./locks.js";
import { Previews } from "./preview.js";
import { Requests } from "./request.js";
import { LANGUAGE, Scenes } from "./scenes.js";
import { Server } from "./server.js";
import { Start } from "./start.js";
import { Status } from "./status.js";
import { Tasks } from "./tasks.js";
import { Tree } from "./tree.js";

let server: Server | null = null;

export function activate(context: vscode.ExtensionContext): void {
  const keys = new Keys(context.secrets);
  const confirmations = new Confirmations();
  const locks = new Locks(context.workspaceState);
  server = new Server(context, keys, confirmations, locks);
  const running = server;
  const scenes = new Scenes(running);
  const previews = new Previews(context.extensionUri, scenes, running, confirmations);
  const forms = new Forms(running);
  const commands = new Commands(running, scenes, locks);
  const requests = new Requests();
  const start = new Start(context, running, commands, previews, requests);

  const on = (name: string, act: (...args: never[]) => unknown) => vscode.commands.registerCommand(`scenelang.${name}`, act);
  context.subscriptions.push(
    scenes,
    confirmations,
    previews,
    forms,
    requests,
    new Tree(scenes, context.workspaceState, locks),
    new Status(scenes, running),
    vscode.tasks.registerTaskProvider(LANGUAGE, new Tasks(running)),
    on("openPreview", (uri?: vscode.Uri) => {
      const target = commands.target(uri);
      if (target !== null) previews.open(target);
    }),
    // What the server's code lenses call.
    on("show", ({ uri, object }: { uri: string; object?: string }) => previews.open(vscode.Uri.parse(uri), object ?? null)),
    on("checkScene", (uri?: vscode.Uri) => commands.serve("scenelang.check", uri)),
    on("solveScene", (uri?: vscode.Uri) => commands.serve("scenelang.solve", uri)),
    on("solveSceneAnew", (uri?: vscode.Uri) => commands.serve("scenelang.solveAnew", uri)),
    on("solveSceneSeed", (uri?: vscode.Uri) => commands.solveSeed(uri)),
    on("showAlternatives", (uri?: vscode.Uri) => commands.alternatives(uri)),
    on("lockObject", (chosen: Chosen) => chosenObject(chosen, (object, uri) => commands.setLock(object, true, uri))),
    on("unlockObject", (chosen: Chosen) => chosenObject(chosen, (object, uri) => commands.setLock(object, false, uri))),
    on("solveObject", (chosen: Chosen) => chosenObject(chosen, (object, uri) => commands.serve("scenelang.solve", uri, { only: [object] }))),
    on("newScene", () => start.create()),
    on("describeScene", () => start.describe()),
    on("openExample", () => start.example()),
    on("repairScene", () => commands.repair()),
    on("synthScene", (uri?: vscode.Uri) => commands.synth(uri)),
    on("exportScene", (uri?: vscode.Uri) => commands.export(uri)),
    on("showForms", async (uri?: vscode.Uri) => {
      const target = commands.target(uri);
      if (target !== null) await forms.show(target);
    }),
    on("restartServer", () => running.restart()),
    on("showOutput", () => running.output.show()),
    on("setKey", () => keys.set()),
    on("forgetKey", () => keys.forget()),
  );
  void running.restart();
}

/** An object that was chosen: in the tree, or in the menu of the preview, which says what the pointer is on. */
type Chosen = { readonly group: { readonly name: string } } | { readonly object: string; readonly uri?: string } | undefined;

function chosenObject(chosen: Chosen, act: (object: string, uri?: string) => unknown): unknown {
  if (chosen === undefined) return undefined;
  return "group" in chosen ? act(chosen.group.name) : act(chosen.object, chosen.uri);
}

export async function deactivate(): Promise<void> {
  await server?.dispose();
  server = null;
}
