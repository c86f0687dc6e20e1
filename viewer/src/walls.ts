// Which walls stand between the eye and a room, seen from above. Plain geometry in the layout's frame
// (x, z; metres); knows nothing of three.js.

import type { Region } from "./data.js";

export type Point = readonly [number, number];

/** One side of a region's floor polygon. */
export interface Edge {
  readonly region: string;
  readonly a: Point;
  readonly b: Point;
  /** Unit normal, pointing out of the region. */
  readonly out: Point;
}

/** Walls of neighbouring rooms stand twice their thickness apart; anything nearer than this is one wall to the eye. */
const SHARED_WALL = 0.3;

export function edgesOf(region: Region): Edge[] {
  const turn = Math.sign(signedArea(region.vertices));
  return region.vertices.flatMap((a, i) => {
    const b = region.vertices[(i + 1) % region.vertices.length] ?? a;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 1e-9) return [];
    return [{ region: region.name, a, b, out: [((b[1] - a[1]) / length) * turn, (-(b[0] - a[0]) / length) * turn] as const }];
  });
}

/** Metres from a point to an edge. */
export function distanceTo(edge: Edge, point: Point): number {
  const t = Math.min(1, Math.max(0, along(edge, point)));
  return Math.hypot(edge.a[0] + (edge.b[0] - edge.a[0]) * t - point[0], edge.a[1] + (edge.b[1] - edge.a[1]) * t - point[1]);
}

/** The edge nearest to a point, by index. */
export function nearestEdge(edges: readonly Edge[], point: Point): number {
  let best = -1;
  let least = Infinity;
  edges.forEach((edge, i) => {
    const distance = distanceTo(edge, point);
    if (distance < least) [best, least] = [i, distance];
  });
  return best;
}

/** The edge of least mean z. */
export function lowestEdge(edges: readonly Edge[]): Edge | undefined {
  const height = ({ a, b }: Edge) => a[1] + b[1];
  return edges.reduce<Edge | undefined>((low, edge) => (low === undefined || height(edge) < height(low) ? edge : low), undefined);
}

/**
 * For each edge, whether it hides a room from an eye at `eye`: the eye sees it from outside, or it is the other
 * face of a wall that does.
 */
export function cutEdges(edges: readonly Edge[], eye: Point): boolean[] {
  const outside = edges.map((edge) => beyond(edge, eye) > 0);
  return edges.map((edge, i) => (outside[i] ?? false) || edges.some((other, j) => (outside[j] ?? false) && sharesWall(edge, other)));
}

/** Two rooms' faces of one wall: they look at each other across its thickness, over at least half of `edge`. */
export function sharesWall(edge: Edge, other: Edge): boolean {
  if (edge.region === other.region || edge.out[0] * other.out[0] + edge.out[1] * other.out[1] > -0.99) return false;
  if (Math.abs(beyond(edge, other.a)) > SHARED_WALL) return false;
  const [s, t] = [along(edge, other.a), along(edge, other.b)];
  return Math.min(1, Math.max(s, t)) - Math.max(0, Math.min(s, t)) >= 0.5;
}

/** Signed metres of a point beyond the edge's line, on the outer side. */
function beyond(edge: Edge, point: Point): number {
  return (point[0] - edge.a[0]) * edge.out[0] + (point[1] - edge.a[1]) * edge.out[1];
}

/** Where a point projects onto the edge: 0 at a, 1 at b. */
function along(edge: Edge, point: Point): number {
  const [dx, dz] = [edge.b[0] - edge.a[0], edge.b[1] - edge.a[1]];
  return ((point[0] - edge.a[0]) * dx + (point[1] - edge.a[1]) * dz) / (dx * dx + dz * dz);
}

function signedArea(vertices: readonly Point[]): number {
  return vertices.reduce((sum, [x, z], i) => {
    const [nx, nz] = vertices[(i + 1) % vertices.length] ?? [x, z];
    return sum + (x * nz - nx * z) / 2;
  }, 0);
}
