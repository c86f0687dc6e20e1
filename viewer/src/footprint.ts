// Boxes as a plan sees them: a convex outline on the floor, and the heights between. Plain geometry in the layout's frame
// (left-handed, y up; metres, degrees); knows nothing of three.js.

import type { SceneObject, Triple } from "./data.js";
import type { Point } from "./walls.js";

export interface Footprint {
  /** Convex, counterclockwise in (x, z). */
  readonly outline: readonly Point[];
  /** Heights of the bottom and the top. */
  readonly low: number;
  readonly high: number;
}

/** The outline of an object's box, wherever it is turned to. */
export function footprint({ pos, rot, scale: [w, h, d] }: Pick<SceneObject, "pos" | "rot" | "scale">): Footprint {
  const corners = [-w / 2, w / 2].flatMap((x) => [0, h].flatMap((y) => [-d / 2, d / 2].map((z) => turned([x, y, z], rot))));
  const heights = corners.map(([, y]) => pos[1] + y);
  return { outline: hull(corners.map(([x, , z]) => [pos[0] + x, pos[2] + z])), low: Math.min(...heights), high: Math.max(...heights) };
}

/** Turned about x, then z, then y, about fixed axes. */
function turned([x, y, z]: Triple, rot: Triple): Triple {
  const [rx, ry, rz] = rot.map((degrees) => (degrees * Math.PI) / 180) as [number, number, number];
  const [y1, z1] = [y * Math.cos(rx) - z * Math.sin(rx), y * Math.sin(rx) + z * Math.cos(rx)];
  const [x2, y2] = [x * Math.cos(rz) - y1 * Math.sin(rz), x * Math.sin(rz) + y1 * Math.cos(rz)];
  return [x2 * Math.cos(ry) + z1 * Math.sin(ry), y2, z1 * Math.cos(ry) - x2 * Math.sin(ry)];
}

function cross(o: Point, a: Point, b: Point): number {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

function hull(points: Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: readonly Point[]) => {
    const chain: Point[] = [];
    for (const point of list) {
      for (let [a, b] = chain.slice(-2); a !== undefined && b !== undefined && cross(a, b, point) <= 1e-12; [a, b] = chain.slice(-2)) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** What two convex outlines share; empty where they do not overlap. */
export function shared(a: readonly Point[], b: readonly Point[]): Point[] {
  let rest = [...a];
  b.forEach((from, i) => {
    const to = b[(i + 1) % b.length] ?? from;
    const cut: Point[] = [];
    rest.forEach((p, j) => {
      const q = rest[(j + 1) % rest.length] ?? p;
      const [s, t] = [cross(from, to, p), cross(from, to, q)];
      if (s >= 0) cut.push(p);
      if (s >= 0 !== t >= 0) cut.push(between(p, q, s / (s - t)));
    });
    rest = cut;
  });
  return area(rest) > 1e-9 ? rest : [];
}

function between(p: Point, q: Point, t: number): Point {
  return [p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t];
}

function area(outline: readonly Point[]): number {
  return outline.reduce((sum, [x, z], i) => {
    const [nx, nz] = outline[(i + 1) % outline.length] ?? [x, z];
    return sum + (x * nz - nx * z) / 2;
  }, 0);
}

export function centre(outline: readonly Point[]): Point {
  const sum = outline.reduce(([sx, sz], [x, z]) => [sx + x, sz + z], [0, 0]);
  return [sum[0] / outline.length, sum[1] / outline.length];
}

/** The point of an outline's sides that is nearest to a point. */
export function nearestOn(outline: readonly Point[], point: Point): Point {
  let [best, least] = [point, Infinity];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] ?? a;
    const along = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2;
    const t = along === 0 ? 0 : ((point[0] - a[0]) * (b[0] - a[0]) + (point[1] - a[1]) * (b[1] - a[1])) / along;
    const on = between(a, b, Math.min(1, Math.max(0, t)));
    if (distance(on, point) < least) [best, least] = [on, distance(on, point)];
  });
  return best;
}

/** Where two outlines that do not overlap come nearest: a point of each. */
export function nearestPair(a: readonly Point[], b: readonly Point[]): Pair {
  return shortest([...a.map((p): Pair => [p, nearestOn(b, p)]), ...b.map((q): Pair => [nearestOn(a, q), q])]);
}

export type Pair = readonly [Point, Point];

export function distance(p: Point, q: Point): number {
  return Math.hypot(p[0] - q[0], p[1] - q[1]);
}

/** The shortest of some connections; the middle of them where sides face each other and many are as short. There must be one. */
export function shortest(pairs: readonly Pair[]): Pair {
  const least = Math.min(...pairs.map(([p, q]) => distance(p, q)));
  const ties = pairs.filter(([p, q]) => distance(p, q) < least + 1e-6);
  return [centre(ties.map(([p]) => p)), centre(ties.map(([, q]) => q))];
}

/** Whether a point is inside a simple polygon of either winding. */
export function contains(polygon: readonly Point[], [x, z]: Point): boolean {
  let inside = false;
  polygon.forEach(([ax, az], i) => {
    const [bx, bz] = polygon[(i + 1) % polygon.length] ?? [ax, az];
    if (az > z !== bz > z && x < ax + ((z - az) / (bz - az)) * (bx - ax)) inside = !inside;
  });
  return inside;
}
