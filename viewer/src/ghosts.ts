// Where objects would be: see-through copies of them, shown before a repair is chosen.

import { Group, LineSegments, MeshBasicMaterial, type Object3D } from "three";
import type { SceneObject, Triple } from "./data.js";
import { meshesOf, place } from "./model.js";

/** Where an object would be. */
export interface Ghost {
  readonly object: string;
  readonly pos: Triple;
  readonly rot: Triple;
}

export class Ghosts {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial({ transparent: true, opacity: 0.45, depthWrite: false, toneMapped: false });

  /** Shows these, and no others. What the room does not have is left out. */
  show(ghosts: readonly Ghost[], places: ReadonlyMap<string, SceneObject>, nodes: ReadonlyMap<string, Object3D>, colour: string): void {
    this.clear();
    this.material.color.set(colour);
    for (const { object, pos, rot } of ghosts) {
      const [now, node] = [places.get(object), nodes.get(object)];
      if (now === undefined || node === undefined) continue;
      const copy = node.clone(true);
      copy.name = object;
      const edges: Object3D[] = [];
      copy.traverse((part) => {
        if (part instanceof LineSegments) edges.push(part);
      });
      for (const line of edges) line.removeFromParent();
      for (const mesh of meshesOf(copy)) {
        mesh.material = this.material;
        mesh.castShadow = mesh.receiveShadow = false;
      }
      this.group.add(copy);
      node.matrixWorld.decompose(copy.position, copy.quaternion, copy.scale);
      copy.updateMatrixWorld(true);
      place(copy, now, pos, rot);
    }
  }

  /** Geometry belongs to the objects themselves, and stays. */
  clear(): void {
    this.group.clear();
  }

  /** What is shown. */
  names(): string[] {
    return this.group.children.map(({ name }) => name);
  }
}
