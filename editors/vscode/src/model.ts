// The editor's own language model, lent to the server: it asks, VS Code's language model API answers, with the user's consent.

import * as vscode from "vscode";
import type { Question } from "./protocol.js";

/** What an answer may have at most (characters). */
const MOST = 1 << 20;

/** Rejects where there is no model, it is not allowed, or it does not answer; the message is for people. */
export async function askEditor({ messages, schema }: Question, token: vscode.CancellationToken): Promise<{ text: string }> {
  const [model] = await vscode.lm.selectChatModels();
  if (model === undefined) throw new Error("this editor offers no language model");
  const said = messages.map(({ role, text }) => (role === "assistant" ? vscode.LanguageModelChatMessage.Assistant(text) : vscode.LanguageModelChatMessage.User(text)));
  if (schema !== undefined && schema !== null) {
    // The API has no schemas of answers; the server checks what comes.
    said.push(vscode.LanguageModelChatMessage.User(`Answer with one JSON object and nothing else. It must fit this JSON Schema:\n${JSON.stringify(schema)}`));
  }
  const answer = await model.sendRequest(said, { justification: "to propose a repair, which is verified before it is offered" }, token);
  let text = "";
  for await (const piece of answer.text) {
    text += piece;
    if (text.length > MOST) throw new Error("the language model does not stop talking");
  }
  return { text: bare(text) };
}

/** Models like to put JSON into a fence. */
export function bare(text: string): string {
  return /^\s*```(?:json)?\s*\n([^]*?)\n\s*```\s*$/.exec(text)?.[1] ?? text;
}
