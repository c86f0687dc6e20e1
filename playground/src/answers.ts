// What the module answers, as `crates/playground/src` has it. Offsets are those of JavaScript.

export interface Mark {
  readonly range: readonly [number, number] | null;
  readonly severity: "error" | "warning";
  readonly code: string;
  readonly message: string;
  readonly unused: boolean;
  readonly related: readonly { readonly range: readonly [number, number]; readonly message: string }[];
}

export interface Marks {
  readonly marks: readonly Mark[];
  /** Four numbers each: from, to, the number of its type, modifiers. */
  readonly tokens: readonly number[];
  readonly types: readonly string[];
  /** Whether the program has no error. */
  readonly complete: boolean;
  readonly objects: number;
  /** Whether the layout has a place for everything, and for nothing else. */
  readonly placed: boolean;
  /** How many rows hold, how many there are, how many fail that must hold; `null`: there is no layout. */
  readonly count: readonly [number, number, number] | null;
}

export interface Proposals {
  readonly from: number;
  readonly to: number;
  readonly list: readonly {
    readonly label: string;
    readonly sort: string;
    readonly detail: string;
    readonly snippet: string | null;
    readonly rank: number;
    readonly about: string | null;
  }[];
}

export interface Hover {
  readonly range: readonly [number, number];
  readonly text: string;
}

export interface Solved {
  readonly layout: string | null;
  readonly end: string;
  readonly converged?: boolean;
  readonly in_the_way?: readonly { readonly id: string; readonly text: string }[];
  readonly said: readonly string[];
}

export interface Written {
  readonly name: string;
  readonly program: string;
  readonly clauses: number;
  readonly understood: number;
  readonly notes: readonly { readonly text: string; readonly reason: string }[];
  readonly unused: readonly string[];
  readonly solved: Solved | null;
  readonly overfull: string | null;
}

export interface File {
  readonly name: string;
  readonly text?: string;
  readonly base64?: string;
}
