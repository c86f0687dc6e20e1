// API keys of language models: kept in the editor's secret storage, handed to the server in its environment when it starts.
// They are never written to a setting, a file or the output.

import * as vscode from "vscode";
import { refusal } from "./environment.js";

/** The key of who is not in the list of providers. */
const ANOTHER = "SCENELANG_API_KEY";

/** Providers and the variable by which the server knows the key of each. */
const PROVIDERS: readonly (readonly [name: string, variable: string])[] = [
  ["OpenAI", "OPENAI_API_KEY"],
  ["Anthropic", "ANTHROPIC_API_KEY"],
  ["Gemini", "GEMINI_API_KEY"],
  ["DeepSeek", "DEEPSEEK_API_KEY"],
  ["Another that speaks like OpenAI", ANOTHER],
];

export class Keys {
  constructor(private readonly secrets: vscode.SecretStorage) {}

  /** What the environment of the server is to have. */
  async environment(): Promise<Record<string, string>> {
    const found: Record<string, string> = {};
    for (const [, variable] of PROVIDERS) {
      const key = await this.secrets.get(variable);
      if (key !== undefined) found[variable] = key;
    }
    return found;
  }

  /** Asks for a key and keeps it; returns whether there is a new one. */
  async set(): Promise<boolean> {
    const variable = await this.choose(PROVIDERS.map(([, variable]) => variable), "Whose key?");
    if (variable === undefined || (variable === ANOTHER && !(await this.reach()))) return false;
    const key = await vscode.window.showInputBox({ title: "API key", prompt: "It is kept in the editor's secret storage.", password: true, ignoreFocusOut: true });
    if (key === undefined || key.trim() === "") return false;
    await this.secrets.store(variable, key.trim());
    return true;
  }

  /** Asks where the other model is and what it is called, where the settings do not say; returns whether that is known. */
  private async reach(): Promise<boolean> {
    const settings = vscode.workspace.getConfiguration("scenelang");
    const boxes = [
      { name: "model.baseUrl", title: "Where is the model?", placeHolder: "https://models.example/v1", validateInput: refusal, written: (text: string) => text },
      { name: "model.name", title: "What is the model called there?", placeHolder: "qwen3-32b", validateInput: (text: string) => (text.trim() === "" ? "A name is needed." : null), written: (text: string) => `compatible:${text.replace(/^compatible:/, "")}` },
    ];
    for (const { name, written, ...box } of boxes) {
      if (settings.get<string>(name, "").trim() !== "") continue;
      const text = await vscode.window.showInputBox({ ...box, prompt: `It is kept as the setting scenelang.${name}.`, ignoreFocusOut: true });
      if (text === undefined) return false;
      await settings.update(name, written(text.trim()), vscode.ConfigurationTarget.Global);
    }
    return true;
  }

  /** Forgets a key; returns whether there was one. */
  async forget(): Promise<boolean> {
    const kept = Object.keys(await this.environment());
    if (kept.length === 0) {
      void vscode.window.showInformationMessage("No API key is kept.");
      return false;
    }
    const variable = await this.choose(kept, "Which key is to be forgotten?");
    if (variable === undefined) return false;
    await this.secrets.delete(variable);
    return true;
  }

  private async choose(variables: readonly string[], placeHolder: string): Promise<string | undefined> {
    const items = PROVIDERS.filter(([, variable]) => variables.includes(variable)).map(([label, variable]) => ({ label, description: variable }));
    return (await vscode.window.showQuickPick(items, { placeHolder }))?.description;
  }
}
