// What the programs that the extension starts may know of keys: nothing, unless the user wants the configured language model
// asked, in a workspace that is trusted. Knows nothing of the editor.

/** Which language model may be asked, as the setting says it. */
export type Choice = "none" | "editor" | "configured";

/** Variables in which the command line looks for keys. */
export const KEYS = ["OPENAI_API_KEY", "ANTHROPIC_API_KEY", "GEMINI_API_KEY", "GOOGLE_API_KEY", "DEEPSEEK_API_KEY", "SCENELANG_API_KEY"] as const;

/** The choice that counts: none where the workspace is not trusted, or the setting is something else. */
export function choice(setting: unknown, trusted: boolean): Choice {
  return trusted && (setting === "editor" || setting === "configured") ? setting : "none";
}

/** The environment of a program: with the kept keys for whoever may use them, else without any, those of the shell included. */
export function environment(own: NodeJS.ProcessEnv, chosen: Choice, kept: Record<string, string>): NodeJS.ProcessEnv {
  if (chosen === "configured") return { ...own, ...kept };
  // Windows does not tell the case of names apart.
  return Object.fromEntries(Object.entries(own).filter(([name]) => !KEYS.some((key) => key === name.toUpperCase())));
}

/** Why a text is no address of a model; `null`: it is one. A key travels there, so it must not be read on the way. */
export function refusal(text: string): string | null {
  const url = URL.canParse(text.trim()) ? new URL(text.trim()) : null;
  if (url === null) return "An address is needed, such as https://models.example/v1.";
  const own = ["localhost", "127.0.0.1", "[::1]"].includes(url.hostname);
  return url.protocol === "https:" || (url.protocol === "http:" && own) ? null : "It must begin with https://, unless the model is on this machine.";
}
