// Verdicts that come while something is dragged: the report with them in it. Pure.
//
// Only what changes comes: a state and a margin for each row that a move concerns, and the physical rules that now fail.
// A whole new room follows when the move is done.

import { At } from "./at.js";
import type { Constraint, Report, SceneData, SceneObject, Tally, Triple } from "./data.js";

/** What is asked for while an object is dragged, and when it is let go. */
export interface Move {
  readonly object: string;
  /** Centre of the bottom face (metres), in the layout's frame. */
  readonly pos: Triple;
  /** Degrees. */
  readonly rot: Triple;
  /** Whether the layout is to be changed, or only judged as if it were. */
  readonly commit: boolean;
}

export interface Judged {
  readonly id: string;
  readonly satisfied: boolean | null;
  readonly margin: number | null;
}

/** What a move does to the constraints. */
export interface Verdicts {
  readonly constraints: readonly Judged[];
  /** The rows of physical rules that fail: all of them, and no others. */
  readonly physical: readonly Constraint[];
}

const STATED = ["assert", "prefer", "pin"];
const STATES: Readonly<Record<string, boolean | null>> = { holds: true, fails: false, unknown: null };

/** What rows of the physical rules are called, as the report has it. */
const RULES: Readonly<Record<string, { readonly kind: string; readonly says: (a: string, b: string) => string }>> = {
  "P-COLLIDE": { kind: "collision", says: (a, b) => `\`${a}\` and \`${b}\` do not collide` },
  "P-BOUNDS": { kind: "bounds", says: (a) => `\`${a}\` is inside a region` },
  "P-SUPPORT": { kind: "support", says: (a) => `\`${a}\` is supported` },
  "P-OPEN": { kind: "open", says: (a) => `what of \`${a}\` has to open does` },
};

/** Checks an answer to a move. */
export function readVerdicts(value: unknown): Verdicts {
  const root = At.root(value);
  const physical = root.optional("physical")?.list((at) => (at.optional("state")?.string() === "holds" ? [] : [readRow(at)])) ?? [];
  return { constraints: root.member("constraints").list(readJudged), physical: physical.flat() };
}

function readJudged(at: At): Judged {
  const state = at.member("state");
  const satisfied = STATES[state.string()];
  if (satisfied === undefined) throw state.error("expected holds, fails or unknown");
  return { id: at.member("id").string(), satisfied, margin: at.optional("margin")?.number() ?? null };
}

/** A row in short: what it is called and concerns; the rest may be left out. */
function readRow(at: At): Constraint {
  const id = at.member("id").string();
  const rule = at.optional("rule")?.string() ?? id.split(":", 1)[0] ?? id;
  const message = at.optional("message")?.string() ?? "";
  const objects = at.optional("objects")?.list((item) => item.string()) ?? [];
  const known = RULES[rule];
  return {
    id,
    kind: at.optional("kind")?.string() ?? known?.kind ?? "physical",
    rule,
    code: at.optional("code")?.string() ?? null,
    satisfied: false,
    margin: at.optional("margin")?.number() ?? null,
    unit: at.optional("unit")?.string() ?? "m",
    objects,
    text: at.optional("text")?.string() ?? known?.says(objects[0] ?? "", objects[1] ?? "") ?? id,
    message,
    place: null,
  };
}

/** A room in which an object stands elsewhere, and is judged anew; and the rows that are not what they were. */
export function judged(data: SceneData, move: Move, verdicts: Verdicts): { data: SceneData; changed: ReadonlySet<number> } {
  const news = new Map(verdicts.constraints.map((row) => [row.id, row]));
  const failing = new Map(verdicts.physical.map((row) => [row.id, row]));
  const changed = new Set<number>();
  const rows = data.report.constraints.map((row, index) => {
    const next = STATED.includes(row.kind) ? stated(row, news.get(row.id)) : ruled(row, failing.get(row.id));
    failing.delete(row.id);
    if (next !== row) changed.add(index);
    return next;
  });
  const known = rows.length;
  rows.push(...failing.values());
  for (let index = known; index < rows.length; index += 1) changed.add(index);
  const objects = data.objects.map((object): SceneObject => {
    const own = rows.flatMap((row, index) => (index >= known && row.objects.includes(object.name) ? [index] : []));
    const placed = object.name === move.object ? { ...object, pos: move.pos, rot: move.rot } : object;
    return own.length === 0 ? placed : { ...placed, constraints: [...placed.constraints, ...own] };
  });
  return { data: { ...data, objects, report: { ...data.report, constraints: rows, summary: summary(data.report, rows) } }, changed };
}

function stated(row: Constraint, news: Judged | undefined): Constraint {
  if (news === undefined || (news.satisfied === row.satisfied && news.margin === row.margin)) return row;
  // What was said of the old place is not true of the new one.
  return { ...row, satisfied: news.satisfied, margin: news.margin, message: "" };
}

function ruled(row: Constraint, failing: Constraint | undefined): Constraint {
  if (failing !== undefined) return failing.margin === row.margin && row.satisfied === false ? row : { ...row, satisfied: false, margin: failing.margin, message: failing.message };
  return row.satisfied === false ? { ...row, satisfied: true, margin: null, message: "" } : row;
}

/** The tallies, kept by what became of each row: of physical rules the report lists only a part. */
function summary(before: Report, rows: readonly Constraint[]): Report["summary"] {
  const count = (list: readonly Constraint[], kind: string) => list.filter((row) => row.kind === kind && row.satisfied === true).length;
  const moved = (tally: Tally, kind: string): Tally => ({ total: tally.total, satisfied: tally.satisfied + count(rows, kind) - count(before.constraints, kind) });
  const failing = rows.filter((row) => !STATED.includes(row.kind) && row.satisfied === false).length;
  const { assertions, preferences, physical, pins } = before.summary;
  return {
    assertions: moved(assertions, "assert"),
    preferences: moved(preferences, "prefer"),
    physical: { total: Math.max(physical.total, failing), satisfied: Math.max(physical.total, failing) - failing },
    pins: moved(pins, "pin"),
  };
}
