// What the panel says, as values: verdicts, figures, the summary, and which rows a filter leaves. No DOM here.

import type { Constraint, Report, SceneData, SceneObject, SummaryKey, Triple } from "./data.js";

export type Verdict = "holds" | "fails" | "unknown";

export const FILTERS = ["all", "violated", "assert", "prefer", "physical", "pins"] as const;
export type Filter = (typeof FILTERS)[number];

export function verdict(row: Constraint): Verdict {
  return row.satisfied === null ? "unknown" : row.satisfied ? "holds" : "fails";
}

/** Which chip a row belongs to: its kind, with the physical rules taken together. */
export function group(row: Constraint): Filter {
  switch (row.kind) {
    case "assert":
      return "assert";
    case "prefer":
      return "prefer";
    case "pin":
      return "pins";
    default:
      return "physical";
  }
}

export interface Query {
  readonly filter: Filter;
  /** Words that must all occur, in any case. */
  readonly words: string;
  /** An object whose constraints alone are wanted. */
  readonly object: SceneObject | null;
}

/** Indexes of the rows that a query leaves: what fails first, otherwise in the order of the report. */
export function matching(data: SceneData, query: Query): number[] {
  const words = query.words.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = data.report.constraints
    .map((row, index) => ({ row, index }))
    .filter(({ row, index }) => passes(row, query.filter) && belongs(row, index, query.object) && words.every((word) => haystack(row).includes(word)));
  const rank = { fails: 0, unknown: 1, holds: 2 };
  rows.sort((a, b) => rank[verdict(a.row)] - rank[verdict(b.row)] || a.index - b.index);
  return rows.map(({ index }) => index);
}

/** How many rows each chip would leave, whatever the words. */
export function counts(report: Report): Record<Filter, number> {
  const found: Record<Filter, number> = { all: 0, violated: 0, assert: 0, prefer: 0, physical: 0, pins: 0 };
  for (const row of report.constraints) for (const filter of FILTERS) if (passes(row, filter)) found[filter] += 1;
  return found;
}

/** A row's own margin with sign and unit: `+0.12 m`, `−3.0 mm`, `+1.5°`; nothing for discrete facts. */
export function formatMargin(margin: number | null, unit: string | null): string {
  if (margin === null) return "";
  const sign = margin < 0 ? "−" : "+";
  const size = Math.abs(margin);
  if (unit === "deg") return `${sign}${size.toFixed(1)}°`;
  if (unit !== "m") return `${sign}${trim(size, 3)}${unit === null ? "" : ` ${unit}`}`;
  if (size < 0.01) return `${sign}${(size * 1000).toFixed(1)} mm`;
  return `${sign}${size.toFixed(size < 100 ? 2 : 0)} m`;
}

/** `1.80 × 0.74 × 0.90 m` */
export function formatSize(scale: Triple): string {
  return `${scale.map((v) => v.toFixed(2)).join(" × ")} m`;
}

/** `(1.20, 0.00, −2.00)` */
export function formatPoint(point: Triple): string {
  return `(${point.map((v) => (Math.abs(v) < 0.005 ? 0 : v).toFixed(2).replace("-", "−")).join(", ")})`;
}

export interface Headline {
  /** "12 of 12 assertions hold" */
  readonly text: string;
  /** "all preferences, 45 of 45 physical rules, …": the rest, each a phrase. */
  readonly details: readonly string[];
  readonly state: Verdict;
}

const NOUNS: Record<SummaryKey, readonly [string, string]> = {
  assertions: ["assertion", "assertions"],
  preferences: ["preference", "preferences"],
  physical: ["physical rule", "physical rules"],
  pins: ["pin", "pins"],
};

/** What the report says in a line. Preferences may fail without making it red. */
export function headline(report: Report): Headline {
  const { assertions } = report.summary;
  const phrase = (key: SummaryKey) => {
    const { total, satisfied } = report.summary[key];
    return `${satisfied} of ${total} ${NOUNS[key][total === 1 ? 0 : 1]}`;
  };
  const unknown = report.constraints.filter((row) => row.satisfied === null).length;
  const details = (["preferences", "physical", "pins"] as const).filter((key) => report.summary[key].total > 0).map(phrase);
  if (unknown > 0) details.push(`${unknown} not checked`);
  const fails = report.constraints.some((row) => row.satisfied === false && row.kind !== "prefer");
  return {
    text: assertions.total === 0 ? "No assertions" : `${phrase("assertions")} ${assertions.total === 1 ? "holds" : "hold"}`,
    details,
    state: fails ? "fails" : unknown > 0 || !report.ok ? "unknown" : "holds",
  };
}

/** What an object is called besides its name, which the constraints use: its label and its category, if they say more. */
export function aboutObject({ name, label, category }: SceneObject): string[] {
  return [...new Set([label, category])].filter((word) => word !== "" && word !== name);
}

/** Whether two rows are listed alike. */
export function sameRow(a: Constraint | undefined, b: Constraint | undefined): boolean {
  if (a === undefined || b === undefined) return a === b;
  const { objects, ...rest } = a;
  const same = objects.length === b.objects.length && objects.every((name, index) => name === b.objects[index]);
  return same && (Object.keys(rest) as (keyof typeof rest)[]).every((key) => a[key] === b[key]);
}

/** How many of an object's rows fail. */
export function failures(data: SceneData, object: SceneObject): number {
  return object.constraints.filter((row) => data.report.constraints[row]?.satisfied === false).length;
}

function passes(row: Constraint, filter: Filter): boolean {
  if (filter === "all") return true;
  return filter === "violated" ? row.satisfied === false : group(row) === filter;
}

function belongs(row: Constraint, index: number, object: SceneObject | null): boolean {
  return object === null || object.constraints.includes(index) || row.objects.includes(object.name);
}

function haystack(row: Constraint): string {
  return [row.text, row.message, row.kind, row.rule, row.code, row.place, ...row.objects].join(" ").toLowerCase();
}

function trim(value: number, digits: number): string {
  return String(Number(value.toFixed(digits)));
}
