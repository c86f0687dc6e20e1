// Names of new programs, and what a program says of itself. Knows nothing of the editor.

/** A name as a file. */
export function named(name: string): string {
  return name.trim().endsWith(".scene") ? name.trim() : `${name.trim()}.scene`;
}

/** Why a name is none for a new program; `null`: it is. */
export function refusal(name: string, taken: (file: string) => boolean): string | null {
  if (/^\s*(\.scene)?\s*$/.test(name)) return "A name is needed.";
  if (/[\\/:*?"<>|]/.test(name)) return "A name has none of \\ / : * ? \" < > |";
  return taken(named(name)) ? `${named(name)} is there already.` : null;
}

/** The first sentence of the first comment of a program. */
export function firstComment(text: string): string {
  const lines = text.split("\n");
  const end = lines.findIndex((line) => !line.startsWith("//"));
  const words = lines.slice(0, end < 0 ? lines.length : end).map((line) => line.replace(/^\/+ ?/, "").trim());
  return words.join(" ").replace(/^[-=─═ ]+|[-=─═ ]+$/g, "").replace(/(?<=\.) .*$/, "");
}
