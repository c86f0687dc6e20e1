// Which object is under the pointer, and what was meant by pressing there: a click, a double click, or only a drag.

import { type Camera, Mesh, type Object3D, Raycaster, Vector2, type Vector3 } from "three";
import type { Model } from "./model.js";

/** A press that moves further than this (CSS pixels) turns the view. */
const DRAG = 5;

export interface PickEvents {
  /** What may be hit; asked anew for every pick. */
  solid(mesh: Mesh): boolean;
  camera(): Camera;
  hovered(name: string | null, x: number, y: number): void;
  /** An object and, where that was hit, a movable part of it. */
  clicked(name: string | null, part: Object3D | null): void;
  doubled(name: string): void;
}

export class Picker {
  private readonly ray = new Raycaster();
  private model: Model | null = null;
  private names = new Map<Object3D, string>();
  private press: { x: number; y: number } | null = null;
  private pending = 0;

  constructor(
    private readonly canvas: HTMLElement,
    private readonly events: PickEvents,
  ) {
    canvas.addEventListener("pointerdown", (e) => (this.press = { x: e.clientX, y: e.clientY }));
    canvas.addEventListener("pointerup", (e) => this.release(e));
    canvas.addEventListener("dblclick", (e) => {
      const name = this.at(e.clientX, e.clientY);
      if (name !== null) events.doubled(name);
    });
    canvas.addEventListener("pointermove", (e) => this.move(e));
    canvas.addEventListener("pointerleave", () => this.leave());
  }

  setModel(model: Model): void {
    this.model = model;
    this.names = new Map([...model.objects].map(([name, node]) => [node, name]));
  }

  /** The object at a place of the window, if nothing stands before it. */
  at(clientX: number, clientY: number): string | null {
    return this.hit(clientX, clientY)?.name ?? null;
  }

  /** The object at a place of the window, and the point of it that is seen there. */
  hit(clientX: number, clientY: number): { name: string; point: Vector3; part: Object3D | null } | null {
    if (this.model === null) return null;
    const area = this.canvas.getBoundingClientRect();
    const x = ((clientX - area.left) / area.width) * 2 - 1;
    const y = 1 - ((clientY - area.top) / area.height) * 2;
    this.ray.setFromCamera(new Vector2(x, y), this.events.camera());
    const hit = this.ray.intersectObject(this.model.root, true).find(({ object }) => object instanceof Mesh && this.events.solid(object));
    let part: Object3D | null = null;
    for (let node: Object3D | null = hit?.object ?? null; node !== null; node = node.parent) {
      if (this.model.parts.has(node)) part = node;
      const name = this.names.get(node);
      if (name !== undefined && hit !== undefined) return { name, point: hit.point, part };
    }
    return null;
  }

  private release(e: PointerEvent): void {
    const { press } = this;
    this.press = null;
    if (press === null || e.button !== 0 || Math.hypot(e.clientX - press.x, e.clientY - press.y) > DRAG) return;
    const hit = this.hit(e.clientX, e.clientY);
    this.events.clicked(hit?.name ?? null, hit?.part ?? null);
  }

  /** Nothing is under the pointer, also not what a pick that still waits for its frame would find. */
  private leave(): void {
    cancelAnimationFrame(this.pending);
    this.events.hovered(null, 0, 0);
  }

  /** At most one pick a frame, and none while a button turns the view. */
  private move(e: PointerEvent): void {
    if (e.buttons !== 0) {
      this.leave();
      return;
    }
    if (e.pointerType === "touch") return;
    cancelAnimationFrame(this.pending);
    this.pending = requestAnimationFrame(() => this.events.hovered(this.at(e.clientX, e.clientY), e.clientX, e.clientY));
  }
}
