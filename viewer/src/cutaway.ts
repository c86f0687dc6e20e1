// Near walls and ceilings out of the way. A wall that stands between the eye and a room sinks to a low kerb, so
// that the room's outline stays readable; what hangs in it turns to glass; a ceiling shows only from below.

import { BufferGeometry, Float32BufferAttribute, Mesh, type Camera, type Material, type Object3D, Vector3 } from "three";
import type { SceneData } from "./data.js";
import { meshesOf, type Model } from "./model.js";
import { cutEdges, distanceTo, edgesOf, nearestEdge, type Edge, type Point } from "./walls.js";

/** Metres that are left of a wall that is cut. */
const KERB = 0.07;
/** An object whose centre is this near to a wall's line (metres) hangs in or on it. */
const IN_WALL = 0.12;
const GLASS = 0.16;
/** From nearly straight above, no wall stands in the way (cosine of the angle to the vertical). */
const STEEP = 0.97;

interface Wall {
  readonly mesh: Mesh;
  readonly edge: number;
  /** Of the room (metres). */
  readonly height: number;
}

interface Hung {
  readonly name: string;
  readonly meshes: readonly Mesh[];
  readonly edge: number;
}

export class Cutaway {
  private readonly edges: Edge[];
  private readonly walls: Wall[] = [];
  private readonly hung: Hung[] = [];
  private readonly ceilings: { node: Object3D; height: number }[];
  /** 1: the wall stands; 0: it is down. One for each edge. */
  private readonly standing: number[];
  private readonly glass = new Map<Material, Material>();

  constructor(
    data: SceneData,
    private readonly model: Model,
  ) {
    const walled = new Set(model.walls.map(({ region }) => region));
    this.edges = data.regions.filter(({ name }) => walled.has(name)).flatMap(edgesOf);
    this.standing = this.edges.map(() => 1);
    for (const { region, node } of model.walls) {
      const { floor, ceiling } = data.regions.find((r) => r.name === region) ?? { floor: 0, ceiling: 1 };
      const own = this.edges.flatMap((edge, i) => (edge.region === region ? [i] : []));
      if (own.length === 0) continue;
      for (const mesh of meshesOf(node)) this.split(mesh, own, floor, ceiling - floor);
    }
    for (const object of data.objects) {
      const node = model.objects.get(object.name);
      const centre: Point = [object.pos[0], object.pos[2]];
      const edge = nearestEdge(this.edges, centre);
      const near = this.edges[edge];
      if (node === undefined || near === undefined || distanceTo(near, centre) > IN_WALL) continue;
      const meshes = meshesOf(node);
      // Glass throws no shadow, nor does a wall; so neither does what hangs in one.
      for (const mesh of meshes) mesh.castShadow = false;
      this.hung.push({ name: object.name, meshes, edge });
    }
    this.ceilings = model.ceilings.map(({ region, node }) => ({ node, height: data.regions.find((r) => r.name === region)?.ceiling ?? Infinity }));
  }

  /**
   * Moves walls towards where the camera wants them; `step` is the share of the way to go (1: at once). Objects in
   * `keep` stay solid. Returns whether there is way left.
   */
  update(camera: Camera, looking: Vector3, step: number, keep: ReadonlySet<string>): boolean {
    const eye = camera.position;
    const steep = -looking.y > STEEP;
    const cut = steep ? this.edges.map(() => false) : cutEdges(this.edges, [-eye.x, eye.z]);
    let moving = false;
    this.standing.forEach((now, i) => {
      const goal = cut[i] ? 0 : 1;
      const next = Math.abs(goal - now) < 0.01 ? goal : now + (goal - now) * step;
      moving ||= next !== goal;
      this.standing[i] = next;
    });
    for (const wall of this.walls) {
      const up = this.standing[wall.edge] ?? 1;
      wall.mesh.scale.y = up + (1 - up) * Math.min(1, KERB / wall.height);
    }
    for (const { name, meshes, edge } of this.hung) {
      const solid = keep.has(name) || (this.standing[edge] ?? 1) > 0.5;
      for (const mesh of meshes) this.setGlass(mesh, !solid);
    }
    for (const { node, height } of this.ceilings) node.visible = eye.y < height && !steep;
    return moving;
  }

  /** Whether a mesh is in the way of the pointer: walls that are down and hidden ceilings are not. */
  solid(mesh: Mesh): boolean {
    if (!mesh.visible || this.ceilings.some(({ node }) => !node.visible && isUnder(mesh, node))) return false;
    const wall = this.walls.find((w) => w.mesh === mesh);
    return wall === undefined || (this.standing[wall.edge] ?? 1) > 0.5;
  }

  dispose(): void {
    for (const { meshes } of this.hung) for (const mesh of meshes) this.setGlass(mesh, false);
    for (const material of this.glass.values()) material.dispose();
  }

  /**
   * Replaces a wall mesh by one mesh for each side of the room it spans, in world axes with the floor at y = 0, so
   * that sinking it is a scale.
   */
  private split(mesh: Mesh, own: readonly number[], floor: number, height: number): void {
    const flat = mesh.geometry.index === null ? mesh.geometry : mesh.geometry.toNonIndexed();
    const world = flat.clone().applyMatrix4(mesh.matrixWorld);
    const position = world.getAttribute("position");
    const normal = world.getAttribute("normal");
    const candidates = own.flatMap((i) => this.edges[i] ?? []);
    const side = (from: number, to: number): number => {
      let [x, z] = [0, 0];
      for (let i = from; i < to; i += 1) [x, z] = [x - position.getX(i), z + position.getZ(i)];
      return own[nearestEdge(candidates, [x / (to - from), z / (to - from)])] ?? 0;
    };
    // A slab along one side goes whole, its end faces too; only a mesh of several sides is taken apart.
    const whole = side(0, position.count);
    const edge = this.edges[whole];
    const slab = edge !== undefined && everyVertex(position.count, (i) => distanceTo(edge, [-position.getX(i), position.getZ(i)]) < 0.25);
    const groups = new Map<number, number[]>();
    for (let i = 0; i + 2 < position.count; i += 3) {
      const key = slab ? whole : side(i, i + 3);
      const list = groups.get(key);
      if (list === undefined) groups.set(key, [i, i + 1, i + 2]);
      else list.push(i, i + 1, i + 2);
    }
    for (const [key, indices] of groups) {
      const geometry = new BufferGeometry();
      const pick = (attribute: typeof position, dy: number) =>
        new Float32BufferAttribute(indices.flatMap((i) => [attribute.getX(i), attribute.getY(i) - dy, attribute.getZ(i)]), 3);
      geometry.setAttribute("position", pick(position, floor));
      if (normal !== undefined) geometry.setAttribute("normal", pick(normal, 0));
      else geometry.computeVertexNormals();
      const part = new Mesh(geometry, mesh.material);
      part.position.y = floor;
      part.receiveShadow = true;
      part.userData = mesh.userData;
      this.model.root.add(part);
      this.walls.push({ mesh: part, edge: key, height });
    }
    mesh.removeFromParent();
    world.dispose();
  }

  private setGlass(mesh: Mesh, glass: boolean): void {
    if (mesh.userData["glass"] === glass || Array.isArray(mesh.material)) return;
    if (glass) {
      mesh.userData["opaque"] = mesh.material;
      mesh.material = this.glassOf(mesh.material);
    } else if (mesh.userData["opaque"] !== undefined) mesh.material = mesh.userData["opaque"] as Material;
    mesh.userData["glass"] = glass;
  }

  private glassOf(material: Material): Material {
    const known = this.glass.get(material);
    if (known !== undefined) return known;
    const copy = material.clone();
    copy.transparent = true;
    copy.opacity *= GLASS;
    copy.depthWrite = false;
    this.glass.set(material, copy);
    return copy;
  }
}

function everyVertex(count: number, holds: (i: number) => boolean): boolean {
  for (let i = 0; i < count; i += 1) if (!holds(i)) return false;
  return true;
}

function isUnder(node: Object3D, root: Object3D): boolean {
  for (let at: Object3D | null = node; at !== null; at = at.parent) if (at === root) return true;
  return false;
}
