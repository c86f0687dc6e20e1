// A request in plain words with what became of each of its phrases, as text with marks. Knows nothing of the editor.

/** What `scenelang formalize --format json` says. Bytes are those of the request in UTF-8. */
export interface Outcome {
  readonly understood: number;
  readonly clauses: number;
  readonly words: { readonly used: number; readonly all: number; readonly unused: readonly Piece[] };
  readonly preferences: number;
  readonly read: readonly (Piece & { readonly understood: boolean; readonly became: readonly string[] })[];
  readonly notes: readonly (Piece & { readonly reason: string })[];
  readonly absent: readonly string[];
  readonly inferred: readonly string[];
}

interface Piece {
  readonly bytes: readonly [number, number];
  readonly text: string;
}

export type Fate = "became" | "lost" | "noted";

/** A part of the text: from and to (UTF-16 units), what became of it, in words. */
export interface Mark {
  readonly start: number;
  readonly end: number;
  readonly fate: Fate;
  readonly said: string;
  /** Statements that it became. */
  readonly lines: readonly string[];
}

export interface Marked {
  readonly text: string;
  readonly marks: readonly Mark[];
}

/** A longer sentence is shown in parts. */
const LONG = 60;

/** The request, a sentence a line, and below it what was added that it does not say. */
export function marked(request: string, outcome: Outcome): Marked {
  const bytes = Buffer.from(request, "utf8");
  const at = (offset: number) => bytes.subarray(0, offset).toString("utf8").length;
  const mark = ({ bytes: [from, to] }: Piece, fate: Fate, said: string, lines: readonly string[] = []): Mark => ({ start: at(from), end: at(to), fate, said, lines });
  const marks = [
    ...outcome.read.map((clause) => mark(clause, clause.understood ? "became" : "lost", clause.understood ? "This became:" : "This was not understood.", clause.became)),
    ...outcome.words.unused.map((word) => mark(word, "lost", `“${word.text}” was not used.`)),
    ...outcome.notes.map((note) => mark(note, "noted", note.reason)),
  ];
  // A blank becomes the end of a line, so that places stay what they are.
  const sentences = request.replace(/(?<=[.!?;]) (?=\S)/g, "\n").split("\n");
  const lines = sentences.map((sentence) => (sentence.length > LONG ? sentence.replace(/(?<=,) (?=\S)/g, "\n") : sentence)).join("\n");
  const added = outcome.inferred.length === 0 ? "" : `\n\nAdded, though not said:\n${outcome.inferred.map((line) => `  ${line}\n`).join("")}`;
  return { text: `${lines}${added}`, marks };
}

/** How much was understood, in a sentence or two. */
export function summary({ understood, clauses, words, preferences }: Outcome): string {
  const lost = words.unused.map(({ text }) => `“${text}”`);
  const parts = [`understood ${understood} of ${clauses} ${clauses === 1 ? "clause" : "clauses"}`];
  if (lost.length > 0) parts.push(`not used: ${lost.slice(0, 6).join(", ")}${lost.length > 6 ? ` and ${lost.length - 6} more` : ""}`);
  if (preferences > 0) parts.push(`${preferences} ${preferences === 1 ? "statement" : "statements"} became ${preferences === 1 ? "a preference" : "preferences"}, since not all can hold together`);
  return `${parts.join("; ")}.`;
}
