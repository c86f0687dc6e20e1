// Two ways of looking at a room: in perspective, or straight down as on a plan; and flights between views.

import { type Box3, MathUtils, MOUSE, OrthographicCamera, PerspectiveCamera, Spherical, TOUCH, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export type Mode = "perspective" | "plan";

/** Degrees; narrow, so that uprights stay nearly upright. */
const FIELD_OF_VIEW = 30;
/** How steeply the first look falls into the room, as into a doll's house: radians from the vertical. */
const HOME_PHI = MathUtils.degToRad(48);
/**
 * Directions (degrees about y from glTF's +z) from which that look may come: the corners, from the front first, each from
 * nearer one side so that no wall is seen edge on.
 */
const CORNERS = [145, 215, 35, 325, 125, 235, 55, 305];
/** Straight down with the layout's x to the right and its z up the page. Not quite 0, where "up" has no meaning. */
const DOWN: Direction = { phi: 1e-3, theta: Math.PI };
const FLIGHT_MS = 650;

/** A direction to look from: radians from the vertical, and about it from glTF's +z. */
interface Direction {
  readonly phi: number;
  readonly theta: number;
}

/** No flight ends nearer to its target than this (metres). */
const CLOSEST = 0.8;

/** Where to look, and from where around it. */
interface Pose {
  readonly target: Vector3;
  readonly around: Spherical;
}

export class Cameras {
  readonly controls: OrbitControls;
  mode: Mode = "perspective";
  private readonly perspective = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 500);
  private readonly orthographic = new OrthographicCamera(-0.5, 0.5, 0.5, -0.5, -500, 1000);
  private flight: { from: Pose; to: Pose; start: number } | null = null;
  private home: Box3 | null = null;
  private front: Direction = { phi: HOME_PHI, theta: 0 };
  /** Nobody has looked elsewhere yet. */
  private untouched = true;
  private aspect = 1;

  /** `changed` asks for another frame. */
  constructor(
    canvas: HTMLElement,
    private readonly changed: () => void,
  ) {
    this.controls = new OrbitControls(this.perspective, canvas);
    Object.assign(this.controls, { enableDamping: true, dampingFactor: 0.12, zoomToCursor: true, maxPolarAngle: Math.PI * 0.495, minDistance: 0.3 });
    this.controls.listenToKeyEvents(canvas);
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => {
      this.untouched = false;
      this.interrupt();
    });
  }

  get active(): PerspectiveCamera | OrthographicCamera {
    return this.controls.object as PerspectiveCamera | OrthographicCamera;
  }

  /** Unit vector along the view. */
  looking(): Vector3 {
    return this.active.getWorldDirection(new Vector3());
  }

  resize(width: number, height: number): void {
    this.aspect = width / Math.max(1, height);
    this.perspective.aspect = this.aspect;
    this.orthographic.left = -this.aspect / 2;
    this.orthographic.right = this.aspect / 2;
    this.perspective.updateProjectionMatrix();
    this.orthographic.updateProjectionMatrix();
    if (this.untouched && this.home !== null) this.land(this.poseOf(this.mode === "plan" ? DOWN : this.front));
  }

  /**
   * Sets what a view of the whole shows, and from which corner: the one that `worth` finds best for the direction towards
   * the eye. Moves the camera there at once if it has not been placed yet.
   */
  frame(all: Box3, worth: (towardsEye: Vector3) => number): void {
    const first = this.home === null;
    this.home = all;
    const directions = CORNERS.map((degrees) => ({ phi: HOME_PHI, theta: MathUtils.degToRad(degrees) }));
    // Of those from which it fits the window well: a long room is not looked at along its length.
    const closest = Math.min(...directions.map((direction) => this.fit(all, direction).around.radius));
    const corners = directions.filter((direction) => this.fit(all, direction).around.radius <= closest * 1.08);
    const value = ({ phi, theta }: Direction) => worth(new Vector3().setFromSphericalCoords(1, phi, theta));
    this.front = corners.reduce((best, next) => (value(next) > value(best) + 1e-6 ? next : best));
    this.controls.maxDistance = this.fit(all, this.front).around.radius * 4;
    if (first) this.land(this.poseOf(this.mode === "plan" ? DOWN : this.front));
  }

  reset(): void {
    this.fly(this.poseOf(this.mode === "plan" ? DOWN : this.front));
  }

  show(mode: Mode): void {
    if (mode === this.mode) return;
    this.mode = mode;
    this.reset();
  }

  /** Flies until a box fills a good part of the view, keeping the direction of looking where that shows it. */
  flyTo(box: Box3): void {
    const plan = this.mode === "plan";
    const now = this.pose().around;
    const direction = plan ? DOWN : { phi: MathUtils.clamp(now.phi, MathUtils.degToRad(30), MathUtils.degToRad(62)), theta: now.theta };
    const whole = this.home === null ? Infinity : this.fit(this.home, direction).around.radius;
    // Near enough to see it well, never so near that its surroundings are lost.
    const radius = Math.min(whole, Math.max(this.fit(box, direction).around.radius * 1.7, whole * 0.6));
    const target = box.getCenter(new Vector3());
    this.fly({ target, around: new Spherical(radius, direction.phi, direction.theta) });
  }

  /** Advances to time `now` (ms). Returns whether another frame is needed. */
  update(now: number): boolean {
    const { flight } = this;
    if (flight === null) return this.controls.update();
    // A frame may bear a time before that of the press that asked for it.
    const t = MathUtils.clamp((now - flight.start) / FLIGHT_MS, 0, 1);
    const ease = t * t * t * (t * (6 * t - 15) + 10);
    this.place({
      target: flight.from.target.clone().lerp(flight.to.target, ease),
      around: new Spherical(
        Math.exp(MathUtils.lerp(Math.log(flight.from.around.radius), Math.log(flight.to.around.radius), ease)),
        MathUtils.lerp(flight.from.around.phi, flight.to.around.phi, ease),
        MathUtils.lerp(flight.from.around.theta, flight.to.around.theta, ease),
      ),
    });
    if (t === 1) this.land(flight.to);
    return true;
  }

  /** Metres that the height of the view spans at its target. */
  private span(radius: number): number {
    return 2 * radius * Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2));
  }

  private fly(to: Pose): void {
    this.untouched = false;
    this.toPerspective();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.land(to);
      return;
    }
    const from = this.pose();
    // The short way round.
    const turns = Math.round((from.around.theta - to.around.theta) / (2 * Math.PI));
    const around = new Spherical(to.around.radius, to.around.phi, to.around.theta + turns * 2 * Math.PI);
    this.flight = { from, to: { target: to.target, around }, start: performance.now() };
    this.changed();
  }

  private land(pose: Pose): void {
    this.flight = null;
    this.place(pose);
    if (this.mode === "plan") this.toOrthographic();
    this.controls.update();
    this.changed();
  }

  /** The user takes over: a flight stops where it is, but a plan has no half-way. */
  private interrupt(): void {
    if (this.flight !== null && this.mode === "plan") this.land(this.flight.to);
    this.flight = null;
  }

  private place({ target, around }: Pose): void {
    this.controls.target.copy(target);
    this.active.position.setFromSpherical(around).add(target);
    this.active.lookAt(target);
  }

  private pose(): Pose {
    const { target } = this.controls;
    return { target: target.clone(), around: new Spherical().setFromVector3(this.active.position.clone().sub(target)) };
  }

  private poseOf(direction: Direction): Pose {
    return this.home === null ? this.pose() : this.fit(this.home, direction);
  }

  /** The pose from which a box just fits into the view and is in its middle, with a margin around. */
  private fit(box: Box3, { phi, theta }: Direction): Pose {
    const back = new Vector3().setFromSphericalCoords(1, phi, theta);
    const right = new Vector3(Math.cos(theta), 0, -Math.sin(theta));
    const up = back.clone().cross(right);
    const slope = Math.tan(MathUtils.degToRad(FIELD_OF_VIEW / 2)) * 0.9;
    const target = box.getCenter(new Vector3());
    const corners = [...Array(8).keys()].map((i) => new Vector3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z));
    let radius = CLOSEST;
    // What is in the middle depends on the distance, and that on what is in the middle: a few rounds settle it.
    for (let round = 0; round < 6; round += 1) {
      const seen = corners.map((corner) => corner.clone().sub(target)).map((p) => ({ x: p.dot(right), y: p.dot(up), z: p.dot(back) }));
      radius = Math.max(CLOSEST, ...seen.map(({ x, y, z }) => z + Math.max(Math.abs(y), Math.abs(x) / this.aspect) / slope));
      const middle = (slopes: number[]) => ((Math.min(...slopes) + Math.max(...slopes)) / 2) * radius;
      target.addScaledVector(right, middle(seen.map(({ x, z }) => x / (radius - z))));
      target.addScaledVector(up, middle(seen.map(({ y, z }) => y / (radius - z))));
    }
    return { target, around: new Spherical(radius, phi, theta) };
  }

  private toOrthographic(): void {
    const { around } = this.pose();
    this.orthographic.position.copy(this.perspective.position);
    this.orthographic.quaternion.copy(this.perspective.quaternion);
    this.orthographic.zoom = 1 / this.span(around.radius);
    this.orthographic.updateProjectionMatrix();
    this.take(this.orthographic);
  }

  private toPerspective(): void {
    if (this.active === this.perspective) return;
    const { target } = this.pose();
    const radius = 1 / this.orthographic.zoom / this.span(1);
    this.take(this.perspective);
    this.place({ target, around: new Spherical(radius, DOWN.phi, DOWN.theta) });
  }

  /** Gives a camera to the controls: a plan is moved where a room is turned. */
  private take(camera: PerspectiveCamera | OrthographicCamera): void {
    const turns = camera === this.perspective;
    this.controls.object = camera;
    this.controls.enableRotate = turns;
    this.controls.mouseButtons.LEFT = turns ? MOUSE.ROTATE : MOUSE.PAN;
    this.controls.touches.ONE = turns ? TOUCH.ROTATE : TOUCH.PAN;
    this.changed();
  }
}
