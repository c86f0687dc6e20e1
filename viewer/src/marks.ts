// What is wrong, drawn into the room in red: a line along each gap, and what two things share. Seen through everything, since
// what is wrong is often hidden.

import { BufferGeometry, CylinderGeometry, DoubleSide, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3 } from "three";
import type { Triple } from "./data.js";
import type { Gap } from "./gaps.js";
import { toGl } from "./model.js";
import type { Point } from "./walls.js";

/** Metres. */
const THICKNESS = 0.014;
const END = 0.032;
const UP = new Vector3(0, 1, 0);

export class Marks {
  readonly group = new Group();
  private readonly line = this.material(0.95);
  private readonly body = this.material(0.35);
  private readonly rod = new CylinderGeometry(THICKNESS, THICKNESS, 1, 8);
  private readonly ball = new SphereGeometry(END, 12, 8);

  constructor() {
    // After everything else, whose depth does not count.
    this.group.renderOrder = 10;
  }

  setColour(colour: string): void {
    for (const material of [this.line, this.body]) material.color.set(colour);
  }

  show(gaps: readonly Gap[]): void {
    this.clear();
    for (const gap of gaps) {
      if (gap.common !== null) this.group.add(new Mesh(prism(gap.common), this.body));
      else this.segment(gap.from, gap.to);
    }
    for (const child of this.group.children) child.renderOrder = 10;
  }

  clear(): void {
    for (const child of this.group.children) if (child instanceof Mesh && child.material === this.body) child.geometry.dispose();
    this.group.clear();
  }

  private segment(from: Triple, to: Triple): void {
    const [a, b] = [toGl(from), toGl(to)];
    const length = a.distanceTo(b);
    const rod = new Mesh(this.rod, this.line);
    rod.position.copy(a).lerp(b, 0.5);
    rod.scale.y = Math.max(length, 1e-6);
    if (length > 1e-6) rod.quaternion.setFromUnitVectors(UP, b.clone().sub(a).divideScalar(length));
    const ends = [a, b].map((at) => {
      const ball = new Mesh(this.ball, this.line);
      ball.position.copy(at);
      return ball;
    });
    this.group.add(rod, ...ends);
  }

  private material(opacity: number): MeshBasicMaterial {
    return new MeshBasicMaterial({ transparent: true, opacity, depthTest: false, depthWrite: false, toneMapped: false, side: DoubleSide });
  }
}

/** A convex outline drawn out from one height to another. */
function prism({ outline, low, high }: { readonly outline: readonly Point[]; readonly low: number; readonly high: number }): BufferGeometry {
  const at = ([x, z]: Point, y: number): Triple => [-x, y, z];
  const corners: Triple[] = [];
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length] ?? p;
    const [a, b, c, d] = [at(p, low), at(q, low), at(q, high), at(p, high)];
    corners.push(a, b, c, a, c, d);
    const first = outline[0] ?? p;
    for (const y of [low, high]) corners.push(at(first, y), at(p, y), at(q, y));
  });
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners.flat(), 3));
}
