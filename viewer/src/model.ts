// The room as three.js objects: the GLB read, and its nodes found again by the names in their extras.
//
// A glTF is right-handed and the layout left-handed: x changes sign between them, nothing else does.

import { Box3, type BufferGeometry, EdgesGeometry, Light, LineBasicMaterial, LineSegments, MathUtils, Matrix4, Mesh, type Object3D, PointLight, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import type { SceneData, SceneObject, Triple } from "./data.js";

/** What the exporter writes into `extras.scenelang` of a node. */
interface Tag {
  readonly id?: string;
  /** Of a movable part: its object, and the joint that moves it. */
  readonly of?: string;
  readonly joint?: string;
  readonly region?: string;
  readonly part?: "floor" | "wall" | "ceiling";
}

export interface Model {
  readonly root: Object3D;
  /** Root node of each object, by name. */
  readonly objects: ReadonlyMap<string, Object3D>;
  /** Nodes of movable parts, each below that of its object. */
  readonly parts: ReadonlyMap<Object3D, { readonly of: string; readonly joint: string }>;
  /** Nodes of the regions. */
  readonly floors: readonly RegionNode[];
  readonly walls: readonly RegionNode[];
  readonly ceilings: readonly RegionNode[];
  readonly triangles: number;
}

/** Degrees between two faces from which their common edge is drawn. */
const EDGE_ANGLE = 35;
/** A mesh of more triangles than this was modelled finely; its edges would be noise. */
const MOST_EDGED = 4000;

/** Of the candelas of a lamp so much beside the page's own sun and sky; and how many lamps are lit, as each costs time. */
const LAMP_BRIGHTNESS = 0.012;
const MOST_LAMPS = 12;

export interface RegionNode {
  readonly region: string;
  readonly node: Object3D;
}

export function toGl([x, y, z]: Triple): Vector3 {
  return new Vector3(-x, y, z);
}

/** From an object's own frame to the room's, both as glTF has them: turned about x, then z, then y. */
export function rigid(pos: Triple, rot: Triple): Matrix4 {
  const [x, y, z] = rot.map(MathUtils.degToRad) as [number, number, number];
  const turn = new Matrix4().makeRotationY(-y).multiply(new Matrix4().makeRotationZ(-z)).multiply(new Matrix4().makeRotationX(x));
  return turn.setPosition(toGl(pos));
}

/** Puts a node that stands where `object` says somewhere else, whatever its own transform is made of. */
export function place(node: Object3D, object: SceneObject, pos: Triple, rot: Triple): void {
  const by = rigid(pos, rot).multiply(rigid(object.pos, object.rot).invert());
  const parent = node.parent?.matrixWorld ?? new Matrix4();
  const local = parent.clone().invert().multiply(by).multiply(node.matrixWorld);
  local.decompose(node.position, node.quaternion, node.scale);
  node.updateMatrixWorld(true);
}

/** Whether an object stands where another one does, turned alike. */
export function samePlace(a: SceneObject, b: SceneObject): boolean {
  return [0, 1, 2].every((axis) => a.pos[axis] === b.pos[axis] && a.rot[axis] === b.rot[axis]);
}

/** Puts a node that stands unturned at the origin where the object is. */
export function putDown(object: SceneObject, node: Object3D | undefined): void {
  if (node !== undefined) place(node, { ...object, pos: [0, 0, 0], rot: [0, 0, 0] }, object.pos, object.rot);
}

export async function loadModel(base64: string): Promise<Model> {
  const { scene } = await new GLTFLoader().parseAsync(decoded(base64).buffer, "");
  const objects = new Map<string, Object3D>();
  const parts: Record<"floor" | "wall" | "ceiling", RegionNode[]> = { floor: [], wall: [], ceiling: [] };
  const movable = new Map<Object3D, { of: string; joint: string }>();
  const lights: Object3D[] = [];
  let triangles = 0;
  scene.updateMatrixWorld(true);
  scene.traverse((node) => {
    if (node instanceof Light) lights.push(node);
    const tag = node.userData["scenelang"] as Tag | undefined;
    if (tag?.id !== undefined && !objects.has(tag.id)) objects.set(tag.id, node);
    if (tag?.of !== undefined && tag.joint !== undefined) movable.set(node, { of: tag.of, joint: tag.joint });
    if (tag?.region !== undefined && tag.part !== undefined) parts[tag.part]?.push({ region: tag.region, node });
    if (node instanceof Mesh) {
      triangles += trianglesOf(node);
      node.receiveShadow = true;
    }
  });
  // The file is lit for viewers that have no light of their own; of its lights those of lamps stay.
  const lamps = lights.filter((light): light is PointLight => light instanceof PointLight && belongsTo(light, new Set(objects.values())));
  for (const light of lights) if (!lamps.slice(0, MOST_LAMPS).includes(light as PointLight)) light.removeFromParent();
  for (const light of lamps) light.intensity *= LAMP_BRIGHTNESS;
  const ink = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.22, depthWrite: false, toneMapped: false });
  const edges = new Map<BufferGeometry, EdgesGeometry>();
  for (const mesh of [...objects.values()].flatMap(meshesOf)) {
    // Only furniture throws shadows: the walls would put every room in the dark.
    mesh.castShadow = true;
    drawEdges(mesh, ink, edges);
  }
  return { root: scene, objects, parts: movable, floors: parts.floor, walls: parts.wall, ceilings: parts.ceiling, triangles };
}

/** The bytes of a text in base64. */
function decoded(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  // A loop: what calls a function for each of millions of bytes takes ten times as long.
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at += 1) bytes[at] = text.charCodeAt(at);
  return bytes;
}

/** Draws the edges of a mesh as a draughtsman would; seen from above, faces of one colour run into each other else. */
function drawEdges(mesh: Mesh, ink: LineBasicMaterial, known: Map<BufferGeometry, EdgesGeometry>): void {
  if (trianglesOf(mesh) > MOST_EDGED) return;
  const edges = known.get(mesh.geometry) ?? new EdgesGeometry(mesh.geometry, EDGE_ANGLE);
  known.set(mesh.geometry, edges);
  mesh.add(new LineSegments(edges, ink));
}

function belongsTo(node: Object3D, owners: ReadonlySet<Object3D>): boolean {
  for (let at: Object3D | null = node; at !== null; at = at.parent) if (owners.has(at)) return true;
  return false;
}

function trianglesOf({ geometry }: Mesh): number {
  return (geometry.index?.count ?? geometry.getAttribute("position").count) / 3;
}

export function meshesOf(node: Object3D): Mesh[] {
  const found: Mesh[] = [];
  node.traverse((child) => {
    if (child instanceof Mesh) found.push(child);
  });
  return found;
}

/** World-axis box of an object: of its meshes, or of the box that the layout gives it where the GLB has none. */
export function boundsOf(object: SceneObject, node: Object3D | undefined): Box3 {
  const box = node === undefined ? new Box3() : new Box3().setFromObject(node);
  if (!box.isEmpty()) return box;
  const [w, h, d] = object.scale;
  const reach = Math.hypot(w, d) / 2;
  const base = toGl(object.pos);
  return new Box3(base.clone().sub(new Vector3(reach, 0, reach)), base.clone().add(new Vector3(reach, h, reach)));
}

/** World-axis box of everything: what a view of the whole must show. */
export function boundsOfAll(data: SceneData, model: Model): Box3 {
  const box = new Box3();
  for (const region of data.regions)
    for (const [x, z] of region.vertices) for (const y of [region.floor, region.ceiling]) box.expandByPoint(toGl([x, y, z]));
  for (const object of data.objects) box.union(boundsOf(object, model.objects.get(object.name)));
  return box.isEmpty() ? new Box3(new Vector3(-2, 0, -2), new Vector3(2, 2, 2)) : box;
}
