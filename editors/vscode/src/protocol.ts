// What the server offers beyond the protocol of language servers. Positions are the protocol's: lines and UTF-16 units from 0.

import type { WorkspaceEdit } from "vscode-languageclient";

export interface Position {
  readonly line: number;
  readonly character: number;
}

export interface Range {
  readonly start: Position;
  readonly end: Position;
}

export type State = "holds" | "fails" | "unknown";

export interface Constraint {
  readonly id: string;
  readonly text: string;
  readonly uri: string;
  readonly range: Range;
  readonly state: State;
  readonly margin: number | null;
  readonly unit: string | null;
  readonly objects: readonly string[];
}

export interface SceneObject {
  readonly name: string;
  readonly range: Range;
}

/** What a page shows, and checks; only this is looked at on the way. */
export interface Room {
  /** Names the geometry. */
  readonly shape?: string;
  /** Left out (`null`) where whoever asked knows the shape. */
  readonly glb: string | null;
}

/** `scenelang/scene` {uri, known}: a program as its layout has it; `known` is a shape. */
export interface Scene {
  readonly layout: string | null;
  /** `null`: there is no room to show. */
  readonly data: Room | null;
  readonly holds: number;
  readonly total: number;
  readonly constraints: readonly Constraint[];
  readonly objects: readonly SceneObject[];
}

/** `scenelang/provisional` {uri, known}: a room for a program without a layout, which is solved for it and not written. */
export type Provisional = Pick<Scene, "data" | "holds" | "total" | "constraints">;

/** `scenelang/changed`: a program was judged anew. */
export interface Changed {
  readonly uri: string;
  readonly holds: number;
  readonly total: number;
  readonly layout: string | null;
}

/** `scenelang/move`: an object elsewhere, judged, or with `commit` written to the layout. */
export interface Move {
  readonly uri: string;
  readonly object: string;
  readonly pos: readonly number[];
  readonly rot?: readonly number[];
  readonly commit: boolean;
}

/** `scenelang/forms` {uri, form} -> {text}. */
export const FORMS = ["syntax", "hir", "constraints"] as const;
export type Form = (typeof FORMS)[number];

/** What `scenelang.check`, `.solve` and `.repairAll` answer. */
export interface Done {
  readonly message: string;
  readonly holds: number;
  readonly total: number;
}

/** `scenelang/lock` {uri, objects}, a notification: all that stays where it is in a program, from now on. */

/** What `scenelang.repair` and `.repairAll` answer with `propose`: a repair that is not made yet. */
export interface Proposal extends Done, Shown {
  readonly edit: WorkspaceEdit | null;
}

/** `scenelang/languageModel`, asked by the server. */
export interface Question {
  readonly messages: readonly { readonly role: string; readonly text: string }[];
  readonly schema?: unknown;
}

/** In the `data` of a code action: where it would put objects. */
export interface Shown {
  readonly uri: string;
  readonly moves: readonly { readonly object: string; readonly pos: readonly number[]; readonly rot: readonly number[] }[];
  /** Which margins it would change, in words; none as long as that has not been worked out. */
  readonly margins?: readonly string[];
}

/** One of what `scenelang.alternatives` answers: a layout that its seed makes again. */
export interface Alternative {
  readonly seed: number;
  readonly holds: number;
  readonly total: number;
  /** SVG; `null`: it cannot be drawn. */
  readonly plan: string | null;
}
