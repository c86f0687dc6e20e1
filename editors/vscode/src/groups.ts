// The constraints of a program in groups, as values: by what became of them, or by the objects they speak of. Knows nothing
// of the editor.

import type { Constraint, Scene, State } from "./protocol.js";

export type Grouping = "state" | "object";

export interface Group {
  readonly name: string;
  /** The worst of what is in it. */
  readonly state: State;
  readonly object: boolean;
  readonly constraints: readonly Constraint[];
}

const ORDER: readonly State[] = ["fails", "unknown", "holds"];
const TITLES: Readonly<Record<State, string>> = { fails: "Fails", unknown: "Not checked", holds: "Holds" };

export function groups(scene: Scene, by: Grouping): Group[] {
  return by === "state" ? byState(scene) : byObject(scene);
}

function byState({ constraints }: Scene): Group[] {
  return ORDER.map((state) => ({ name: TITLES[state], state, object: false, constraints: constraints.filter((c) => c.state === state) })).filter((group) => group.constraints.length > 0);
}

function byObject({ constraints, objects }: Scene): Group[] {
  const grouped = objects.map(({ name }): Group => group(name, true, constraints.filter((c) => c.objects.some((object) => speaksOf(object, name)))));
  const others = constraints.filter((c) => !objects.some(({ name }) => c.objects.some((object) => speaksOf(object, name))));
  const all = others.length > 0 ? [...grouped, group("Other", false, others)] : grouped;
  return all.filter((g) => g.constraints.length > 0);
}

function group(name: string, object: boolean, constraints: readonly Constraint[]): Group {
  const sorted = [...constraints].sort((a, b) => ORDER.indexOf(a.state) - ORDER.indexOf(b.state));
  return { name, object, state: sorted[0]?.state ?? "holds", constraints: sorted };
}

/** `chair` is declared, `chair[2]` is what a constraint speaks of; and the other way round. */
export function speaksOf(named: string, object: string): boolean {
  return named === object || named.startsWith(`${object}[`) || object.startsWith(`${named}[`);
}

/** `+0.12 m`, `−3.0 mm`, `+1.5°`; nothing for what is only true or false. */
export function margin({ margin, unit }: Pick<Constraint, "margin" | "unit">): string {
  if (margin === null || margin === undefined) return "";
  const sign = margin < 0 ? "−" : "+";
  const size = Math.abs(margin);
  if (unit === "deg") return `${sign}${size.toFixed(1)}°`;
  if (unit !== "m") return `${sign}${Number(size.toFixed(3))}${unit == null ? "" : ` ${unit}`}`;
  return size < 0.01 ? `${sign}${(size * 1000).toFixed(1)} mm` : `${sign}${size.toFixed(size < 100 ? 2 : 0)} m`;
}

/**
 * What a place in the text speaks of, for the preview: the name of an object or an array, an element, or the id of a constraint.
 * `main` is the program that the scene is of: its objects are declared there.
 */
export function at(scene: Scene, main: string, uri: string, line: number, character: number, word: string): string | null {
  const inside = ({ range: { start, end } }: { range: Constraint["range"] }) =>
    (line > start.line || (line === start.line && character >= start.character)) && (line < end.line || (line === end.line && character <= end.character));
  const named = scene.objects.find(({ name }) => word === name || word.startsWith(`${name}[`));
  // `desk[6]` declares six, of which none is called so; elsewhere it is the seventh.
  if (named !== undefined) return uri === main && inside(named) ? named.name : word;
  return scene.constraints.find((c) => c.uri === uri && inside(c))?.id ?? (uri === main ? (scene.objects.find(inside)?.name ?? null) : null);
}
