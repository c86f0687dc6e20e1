// What a page carries: the data contract `scenelang.preview/1`, read and checked. Knows nothing of the DOM or of three.js.
//
// Unknown members are passed over, so that an older viewer opens a newer page; a wrong type in a member that
// is used is an error that names the member.

import { At, DataError } from "./at.js";

export { DataError };

/** Three numbers in the layout's frame: left-handed, y up; metres, or degrees for `rot`. */
export type Triple = readonly [number, number, number];

/** One row of the report. */
export interface Constraint {
  readonly id: string;
  readonly kind: string;
  readonly rule: string | null;
  readonly code: string | null;
  /** `null`: it could not be judged. */
  readonly satisfied: boolean | null;
  /** Signed, in `unit`; `null` for discrete facts. */
  readonly margin: number | null;
  readonly unit: string | null;
  /** Names of the objects (or regions) of the deciding instance. */
  readonly objects: readonly string[];
  readonly text: string;
  readonly message: string;
  /** `file:line` of the statement, where it has one. */
  readonly place: string | null;
}

export interface Tally {
  readonly total: number;
  readonly satisfied: number;
}

export interface Note {
  readonly code: string;
  readonly severity: string;
  readonly message: string;
}

export interface Report {
  readonly ok: boolean;
  readonly file: string;
  readonly summary: Readonly<Record<SummaryKey, Tally>>;
  readonly constraints: readonly Constraint[];
  readonly diagnostics: readonly Note[];
}

export const SUMMARY_KEYS = ["assertions", "preferences", "physical", "pins"] as const;
export type SummaryKey = (typeof SUMMARY_KEYS)[number];

/** A door, a drawer or a lid; lengths, points and directions are in the frame of its object. */
export interface Joint {
  readonly name: string;
  readonly motion: "hinge" | "slide";
  readonly axis: Triple;
  readonly anchor: Triple;
  /** How far it is opened (degrees or metres). */
  readonly amount: number;
  /** P-OPEN is violated for it. */
  readonly blocked: boolean;
  /** Outline of what it sweeps, [x, z]; empty: it is not drawn. */
  readonly swept: readonly (readonly [number, number])[];
}

export interface SceneObject {
  readonly name: string;
  readonly label: string;
  readonly category: string;
  /** Centre of the bottom face of its box (metres). */
  readonly pos: Triple;
  /** Degrees. */
  readonly rot: Triple;
  /** Full extents w, h, d (metres). */
  readonly scale: Triple;
  /** Indexes into `report.constraints`. */
  readonly constraints: readonly number[];
  readonly joints: readonly Joint[];
}

export interface Region {
  readonly name: string;
  /** Floor polygon, [x, z] (metres), simple, either winding. */
  readonly vertices: readonly (readonly [number, number])[];
  /** Heights (metres). */
  readonly floor: number;
  readonly ceiling: number;
}

export interface SceneData {
  readonly name: string;
  /** A binary glTF in base64; empty: there is only the plan. */
  readonly glb: string;
  /**
   * Names the geometry where the room comes again after each change: then all objects stand unturned at the origin in it, and
   * rooms of the same shape differ in where things are only. Empty: they stand in it where they belong.
   */
  readonly shape: string;
  /** An SVG document; empty: there is none. */
  readonly plan: string;
  readonly report: Report;
  readonly objects: readonly SceneObject[];
  readonly regions: readonly Region[];
}

/** Reads the JSON text of a page. */
export function parseData(text: string): SceneData {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    throw new DataError(`the data is not JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
  return readData(value);
}

/** Checks a value that came by JSON or by message. */
export function readData(value: unknown): SceneData {
  const root = At.root(value);
  const format = root.member("format").string();
  if (format !== "scenelang.preview/1") throw new DataError(`format: expected "scenelang.preview/1", found ${JSON.stringify(format)}`);
  const report = readReport(root.member("report"));
  return {
    name: root.member("name").string(),
    glb: root.member("glb").string(),
    shape: root.optional("shape")?.string() ?? "",
    plan: root.member("plan").string(),
    report,
    objects: root.member("objects").list((at) => readObject(at, report.constraints.length)),
    regions: root.member("regions").list(readRegion),
  };
}

/**
 * The names to highlight for a row. A bare array name stands for its elements; a row that names nothing (a
 * count over a whole set, say) falls back on the objects that list it as theirs.
 */
export function rowObjects(data: SceneData, row: number): string[] {
  const found: string[] = [];
  const add = (name: string) => {
    if (!found.includes(name)) found.push(name);
  };
  for (const name of data.report.constraints[row]?.objects ?? []) {
    if (data.objects.some((o) => o.name === name) || data.regions.some((r) => r.name === name)) add(name);
    else for (const o of data.objects) if (o.name.startsWith(`${name}[`)) add(o.name);
  }
  if (found.length === 0) for (const o of data.objects) if (o.constraints.includes(row)) add(o.name);
  return found;
}

function readReport(at: At): Report {
  const summary = at.member("summary");
  const tally = (key: SummaryKey): Tally => {
    const entry = summary.optional(key);
    return entry === null ? { total: 0, satisfied: 0 } : { total: entry.member("total").number(), satisfied: entry.member("satisfied").number() };
  };
  return {
    ok: at.member("ok").boolean(),
    file: at.optional("file")?.string() ?? "",
    summary: { assertions: tally("assertions"), preferences: tally("preferences"), physical: tally("physical"), pins: tally("pins") },
    constraints: at.member("constraints").list(readConstraint),
    diagnostics: at.optional("diagnostics")?.list(readNote) ?? [],
  };
}

function readConstraint(at: At): Constraint {
  return {
    id: at.member("id").string(),
    kind: at.member("kind").string(),
    rule: at.optional("rule")?.string() ?? null,
    code: at.optional("code")?.string() ?? null,
    satisfied: at.optional("satisfied")?.boolean() ?? null,
    margin: at.optional("margin")?.number() ?? null,
    unit: at.optional("unit")?.string() ?? null,
    objects: at.member("objects").list((item) => item.string()),
    text: at.member("text").string(),
    message: at.optional("message")?.string() ?? "",
    place: readPlace(at.optional("span")),
  };
}

function readPlace(span: At | null): string | null {
  const start = span?.optional("start") ?? null;
  if (span === null || start === null) return null;
  const line = start.list((item) => item.number())[0];
  return line === undefined ? null : `${span.member("file").string()}:${line}`;
}

function readNote(at: At): Note {
  return {
    code: at.optional("code")?.string() ?? "",
    severity: at.member("severity").string(),
    message: at.member("message").string(),
  };
}

function readObject(at: At, rows: number): SceneObject {
  const name = at.member("name").string();
  return {
    name,
    label: at.optional("label")?.string() ?? name,
    category: at.optional("category")?.string() ?? "",
    pos: at.member("pos").triple(),
    rot: at.member("rot").triple(),
    scale: at.member("scale").triple(),
    constraints: at.member("constraints").list((item) => {
      const row = item.number();
      if (!Number.isInteger(row) || row < 0 || row >= rows) throw item.error(`there is no row ${row} in the report, which has ${rows}`);
      return row;
    }),
    joints: at.optional("joints")?.list(readJoint) ?? [],
  };
}

function readJoint(at: At): Joint {
  const motion = at.member("motion").string();
  if (motion !== "hinge" && motion !== "slide") throw at.member("motion").error(`expected "hinge" or "slide", found ${JSON.stringify(motion)}`);
  return {
    name: at.member("name").string(),
    motion,
    axis: at.member("axis").triple(),
    anchor: at.member("anchor").triple(),
    amount: at.member("amount").number(),
    blocked: at.optional("blocked")?.boolean() ?? false,
    swept: at.optional("swept")?.list((item) => item.pair()) ?? [],
  };
}

function readRegion(at: At): Region {
  const vertices = at.member("vertices");
  const points = vertices.list((item) => item.pair());
  if (points.length < 3) throw vertices.error(`a polygon needs three vertices, found ${points.length}`);
  return { name: at.member("name").string(), vertices: points, floor: at.member("floor").number(), ceiling: at.member("ceiling").number() };
}
