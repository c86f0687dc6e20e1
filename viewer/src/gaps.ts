// Where a constraint fails, as something to draw: how far apart two things are, or what they share, how far one sticks
// out of a room, or hovers. Plain geometry in the layout's frame.
//
// It shows the boxes, as a plan would; how much is missing is the margin, which the verifier has measured on the parts.

import { type Constraint, type SceneData, type Triple, rowObjects } from "./data.js";
import { centre, contains, distance, type Footprint, footprint, nearestOn, nearestPair, type Pair, shared, shortest } from "./footprint.js";
import { formatMargin } from "./list.js";
import type { Point } from "./walls.js";

export interface Gap {
  /** Index into the report's rows. */
  readonly row: number;
  /** What is missing, with its unit; empty for discrete facts. */
  readonly text: string;
  /** The ends of a line; the same point twice where things overlap. */
  readonly from: Triple;
  readonly to: Triple;
  /** What two boxes share, on the plan. */
  readonly common: { readonly outline: readonly Point[]; readonly low: number; readonly high: number } | null;
}

/** More are a thicket. */
const MOST = 40;
/** Of a row that speaks of many objects, those that decide it stand first. */
const MOST_OBJECTS = 3;

/** The gaps of all hard constraints that fail, and of the chosen row if it fails. */
export function gapsOf(data: SceneData, chosen: number | null): Gap[] {
  const found: Gap[] = [];
  data.report.constraints.forEach((row, index) => {
    if (row.satisfied === false && (row.kind !== "prefer" || index === chosen) && found.length < MOST) found.push(...gapsOfRow(data, row, index));
  });
  return found;
}

function gapsOfRow(data: SceneData, row: Constraint, index: number): Gap[] {
  const names = rowObjects(data, index);
  const things = names.flatMap((name) => data.objects.find((o) => o.name === name) ?? []).slice(0, MOST_OBJECTS).map(footprint);
  const text = formatMargin(row.margin, row.unit);
  const [first, ...others] = things;
  if (first === undefined) return [];
  const drawn = (gap: Omit<Gap, "row" | "text">): Gap => ({ row: index, text, ...gap });
  if (row.kind === "support") return [drawn(drop(data, first))];
  if (others.length > 0) return others.map((other) => drawn(apart(first, other)));
  const region = data.regions.find(({ name }) => names.includes(name));
  if (region !== undefined) return [drawn(toRegion(first, [region.vertices]))];
  return row.kind === "bounds" && data.regions.length > 0 ? [drawn(toRegion(first, data.regions.map(({ vertices }) => vertices)))] : [];
}

/** Between two boxes: what they share, else the shortest line. */
function apart(a: Footprint, b: Footprint): Omit<Gap, "row" | "text"> {
  const outline = shared(a.outline, b.outline);
  const [low, high] = [Math.max(a.low, b.low), Math.min(a.high, b.high)];
  if (outline.length === 0) {
    const [p, q] = nearestPair(a.outline, b.outline);
    // Level where they are beside each other, else from one to the height of the other.
    const middle = (low + high) / 2;
    const [from, to] = low <= high ? [middle, middle] : a.low > b.high ? [a.low, b.high] : [a.high, b.low];
    return { from: [p[0], from, p[1]], to: [q[0], to, q[1]], common: null };
  }
  const [x, z] = centre(outline);
  if (low < high) return { from: [x, high, z], to: [x, high, z], common: { outline, low, high } };
  return { from: [x, low, z], to: [x, high, z], common: null };
}

/** From where a box is deepest in a wall, or else nearest to one, to the nearest of some rooms. */
function toRegion({ outline, low, high }: Footprint, rooms: readonly (readonly Point[])[]): Omit<Gap, "row" | "text"> {
  const y = (low + high) / 2;
  const worst = (room: readonly Point[]): Pair => {
    const corners = outline.map((p): Pair => [p, nearestOn(room, p)]);
    const outside = corners.filter(([p]) => !contains(room, p));
    const most = Math.max(...outside.map(([p, q]) => distance(p, q)));
    return shortest(outside.length > 0 ? outside.filter(([p, q]) => distance(p, q) > most - 1e-6) : corners);
  };
  const [p, q] = rooms.map(worst).reduce((best, next) => (distance(...next) < distance(...best) ? next : best));
  return { from: [p[0], y, p[1]], to: [q[0], y, q[1]], common: null };
}

/** From below a box that hovers straight down to what is under it. */
function drop(data: SceneData, thing: Footprint): Omit<Gap, "row" | "text"> {
  const [x, z] = centre(thing.outline);
  const tops = data.objects.map(footprint).filter((other) => other.high <= thing.low + 1e-6 && shared(other.outline, thing.outline).length > 0).map(({ high }) => high);
  const floors = data.regions.filter(({ vertices, floor }) => floor <= thing.low && contains(vertices, [x, z])).map(({ floor }) => floor);
  return { from: [x, thing.low, z], to: [x, Math.max(...tops, ...floors, Math.min(0, thing.low)), z], common: null };
}
