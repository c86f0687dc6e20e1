// Doors, drawers and lids: which are open, their way there, and the floor that those of the selected objects sweep.

import { BufferGeometry, DoubleSide, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop, MathUtils, Mesh, MeshBasicMaterial, type Object3D, Quaternion, ShapeUtils, Vector2, Vector3 } from "three";
import type { Joint, SceneData, SceneObject, Triple } from "./data.js";
import { contains } from "./footprint.js";
import { type Model, rigid, toGl } from "./model.js";

/** Milliseconds from closed to open. */
const DURATION = 350;
/** Metres above the floor, so that what is swept is not in one plane with it. */
const LIFT = 0.012;

interface Part {
  readonly name: string;
  readonly node: Object3D;
  readonly joint: Joint;
  /** From 0, closed, to 1. */
  share: number;
  goal: number;
}

/** Where a part stands that is opened by a share of what is shown, in the frame of its object as glTF has it. */
export function pose(joint: Joint, share: number): { position: Vector3; quaternion: Quaternion } {
  const amount = joint.amount * share;
  const axis = toGl(joint.axis);
  if (joint.motion === "slide") return { position: axis.multiplyScalar(amount), quaternion: new Quaternion() };
  // In a mirror the sense of turning is the other one.
  const quaternion = new Quaternion().setFromAxisAngle(axis.negate().normalize(), MathUtils.degToRad(amount));
  const anchor = toGl(joint.anchor);
  return { position: anchor.clone().sub(anchor.clone().applyQuaternion(quaternion)), quaternion };
}

/** What a joint sweeps of an object that stands there, in the room: x, z of the layout. */
export function sweptOn(object: SceneObject, joint: Joint): [number, number][] {
  const to = rigid(object.pos, object.rot);
  return joint.swept.map(([x, z]) => {
    const at = toGl([x, 0, z]).applyMatrix4(to);
    return [-at.x, at.z];
  });
}

export class Openings {
  /** What the selected objects sweep. */
  readonly group = new Group();
  private parts: Part[] = [];
  private before: number | null = null;

  setModel(data: SceneData, model: Model): void {
    this.parts = [...model.parts].flatMap(([node, { of, joint: name }]): Part[] => {
      const joint = data.objects.find((o) => o.name === of)?.joints.find((j) => j.name === name);
      return joint === undefined ? [] : [{ name: `${of}/${name}`, node, joint, share: 0, goal: 0 }];
    });
    this.before = null;
  }

  /** Names of the parts that are open, or on their way. */
  opened(): string[] {
    return this.parts.filter(({ goal }) => goal === 1).map(({ name }) => name);
  }

  /** Opens what is closed, and closes what is open. */
  toggle(node: Object3D): void {
    const part = this.parts.find((p) => p.node === node);
    if (part === undefined) return;
    part.goal = 1 - part.goal;
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    part.share = part.goal;
    stand(part);
  }

  /** Goes on to the time of a frame; returns whether anything moved. */
  update(now: number): boolean {
    const moving = this.parts.filter(({ share, goal }) => share !== goal);
    const step = this.before === null ? 0 : Math.min(1, (now - this.before) / DURATION);
    this.before = moving.length > 0 ? now : null;
    for (const part of moving) {
      part.share = part.goal > part.share ? Math.min(part.goal, part.share + step) : Math.max(part.goal, part.share - step);
      stand(part);
    }
    return moving.length > 0;
  }

  /** Draws what these objects sweep. */
  show(objects: readonly SceneObject[], data: SceneData, colours: { readonly free: string; readonly blocked: string }): void {
    this.clear();
    for (const object of objects)
      for (const joint of object.joints) {
        const outline = sweptOn(object, joint);
        if (outline.length < 3) continue;
        const [x, , z] = object.pos;
        const floors = data.regions.filter(({ vertices, floor }) => floor <= object.pos[1] + 1e-3 && contains(vertices, [x, z])).map(({ floor }) => floor);
        const y = floors.length > 0 ? Math.max(...floors) : object.pos[1];
        this.draw(outline.map(([x, z]): Triple => [x, y + LIFT, z]), joint.blocked ? colours.blocked : colours.free);
      }
  }

  clear(): void {
    for (const child of this.group.children)
      if (child instanceof Mesh || child instanceof LineLoop) {
        child.geometry.dispose();
        for (const material of [child.material].flat()) material.dispose();
      }
    this.group.clear();
  }

  private draw(outline: readonly Triple[], color: string): void {
    const points = outline.map(toGl);
    const corners = ShapeUtils.triangulateShape(points.map(({ x, z }) => new Vector2(x, z)), []).flat();
    const flat = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points.flatMap((p) => p.toArray()), 3));
    flat.setIndex(corners);
    const look = { color, transparent: true, depthWrite: false, toneMapped: false };
    const area = new Mesh(flat, new MeshBasicMaterial({ ...look, opacity: 0.22, side: DoubleSide }));
    const rim = new LineLoop(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({ ...look, opacity: 0.9 }));
    area.renderOrder = rim.renderOrder = 5;
    this.group.add(area, rim);
  }
}

function stand({ node, joint, share }: Part): void {
  // Slow at both ends.
  const { position, quaternion } = pose(joint, share * share * (3 - 2 * share));
  node.position.copy(position);
  node.quaternion.copy(quaternion);
  node.updateMatrixWorld(true);
}
