// Taking an object by the pointer and moving it over the floor: at its own height, so that it stays under the pointer.
// Elsewhere the pointer turns the view, and with a key held down it does so everywhere.

import { type Camera, Plane, Raycaster, Vector2, Vector3 } from "three";
import type { Triple } from "./data.js";

/** A press that moves further than this (CSS pixels) is a drag. */
const DRAG = 5;
/** Nothing is dragged further than this from where it was (metres): near the horizon a pixel is a mile. */
const FARTHEST = 50;
/** Metres; what finer steps would say, nobody can see. */
const STEP = 0.001;

export interface DragEvents {
  camera(): Camera;
  /** What may be moved from a place of the window: its name, where it is, and the point of it that is held. */
  grab(clientX: number, clientY: number): { name: string; pos: Triple; point: Vector3 } | null;
  /** While something is held, the pointer does not turn the view. */
  held(held: boolean): void;
  moved(name: string, pos: Triple): void;
  /** Let go: there for good, or, called off, back where it was. */
  dropped(name: string, pos: Triple, calledOff: boolean): void;
}

interface Hold {
  readonly name: string;
  readonly from: Triple;
  readonly point: Vector3;
  readonly x: number;
  readonly y: number;
  readonly pointer: number;
  pos: Triple;
  moving: boolean;
}

export class Drag {
  private readonly ray = new Raycaster();
  private hold: Hold | null = null;
  private frame = 0;

  /** `host` contains the canvas: it hears of a press before the controls of the camera do. */
  constructor(
    host: HTMLElement,
    private readonly canvas: HTMLElement,
    private readonly events: DragEvents,
  ) {
    host.addEventListener("pointerdown", (e) => this.press(e), { capture: true });
    canvas.addEventListener("pointermove", (e) => this.move(e));
    canvas.addEventListener("pointerup", (e) => e.pointerId === this.hold?.pointer && this.release(false));
    canvas.addEventListener("pointercancel", () => this.release(true));
  }

  /** What is on its way. */
  get moving(): string | null {
    return this.hold?.moving === true ? this.hold.name : null;
  }

  /** Puts what is held back; returns whether anything was. */
  cancel(): boolean {
    const had = this.moving !== null;
    this.release(true);
    return had;
  }

  private press(e: PointerEvent): void {
    if (e.target !== this.canvas || e.button !== 0 || e.pointerType === "touch" || e.shiftKey || e.ctrlKey || e.metaKey || e.altKey) return;
    const grabbed = this.events.grab(e.clientX, e.clientY);
    if (grabbed === null) return;
    this.hold = { ...grabbed, from: grabbed.pos, x: e.clientX, y: e.clientY, pointer: e.pointerId, moving: false };
    this.canvas.setPointerCapture(e.pointerId);
    this.events.held(true);
  }

  private move(e: PointerEvent): void {
    const { hold } = this;
    if (hold === null) return;
    hold.moving ||= Math.hypot(e.clientX - hold.x, e.clientY - hold.y) > DRAG;
    if (!hold.moving) return;
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => {
      const at = this.under(e.clientX, e.clientY, hold.point.y);
      if (at === null || this.hold !== hold) return;
      // The picture is right-handed, the layout left-handed: x changes sign.
      const [dx, dz] = [hold.point.x - at.x, at.z - hold.point.z];
      if (Math.hypot(dx, dz) > FARTHEST) return;
      hold.pos = [round(hold.from[0] + dx), hold.from[1], round(hold.from[2] + dz)];
      this.events.moved(hold.name, hold.pos);
    });
  }

  private release(calledOff: boolean): void {
    const { hold } = this;
    this.hold = null;
    if (hold === null) return;
    cancelAnimationFrame(this.frame);
    this.events.held(false);
    if (hold.moving) this.events.dropped(hold.name, calledOff ? hold.from : hold.pos, calledOff);
  }

  /** Where the pointer meets a level plane. */
  private under(clientX: number, clientY: number, y: number): Vector3 | null {
    const area = this.canvas.getBoundingClientRect();
    const at = new Vector2(((clientX - area.left) / area.width) * 2 - 1, 1 - ((clientY - area.top) / area.height) * 2);
    this.ray.setFromCamera(at, this.events.camera());
    return this.ray.ray.intersectPlane(new Plane(new Vector3(0, 1, 0), -y), new Vector3());
  }
}

function round(metres: number): number {
  return Number((Math.round(metres / STEP) * STEP).toFixed(3));
}
