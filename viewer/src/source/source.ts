// Where a room comes from, and what may be asked of whoever sends it: the page itself, an editor, or a local server.

import type { Ghost } from "../ghosts.js";
import type { Move, Verdicts } from "../live.js";

/** What a source tells the page. */
export interface Sink {
  /** A room, in place of the one before; `read` throws where the data does not keep the contract. */
  load(data: unknown): void;
  /** The room as JSON text. */
  loadText(text: string): void;
  /** No room yet, and what is waited for. */
  wait(why: string): void;
  /** What is shown is the last that could be shown; `null`: it is right again. */
  stale(why: string | null): void;
  /** What is shown is in no layout file yet. */
  provisional(): void;
  /** Emphasises an object, by name, or a row of the report, by id. */
  select(what: string): void;
  /** Shows where objects would be; none: as they are. */
  ghost(ghosts: readonly Ghost[]): void;
}

/** What the user pointed at: an object by name, or a row of the report by id. */
export type Pointed = { readonly object: string } | { readonly row: string };

export interface Source {
  start(sink: Sink): void;
  /** Judges a move, or makes it; `null`: here nothing can be moved. */
  readonly move: ((move: Move) => Promise<Verdicts>) | null;
  /** The pointer is on an object of the picture, or on none: an editor has a menu for objects. */
  point?(picture: HTMLElement, object: string | null): void;
  /** Shows the text that speaks of it, where there is an editor. */
  reveal(pointed: Pointed): void;
}
