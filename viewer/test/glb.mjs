// A GLB written by hand: boxes and cylinders, enough for a furnished room. Follows the layout of nodes that the
// exporter writes: x negated, winding reversed, names in `extras.scenelang`.

/** Collects meshes and nodes, then joins them into a file. */
export class Glb {
  chunks = [];
  length = 0;
  json = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [] }], nodes: [], meshes: [], materials: [], accessors: [], bufferViews: [], buffers: [] };
  materials = new Map();

  /** A node of several parts, in the left-handed frame: its place, its turn about y (degrees), its extras. */
  add(extras, pos, yaw, parts, hung = []) {
    const half = (-yaw * Math.PI) / 360;
    const primitives = parts.map((part) => this.primitive(part));
    this.json.meshes.push({ primitives });
    this.json.nodes.push({ mesh: this.json.meshes.length - 1, translation: [-pos[0], pos[1], pos[2]], rotation: [0, Math.sin(half), 0, Math.cos(half)], extras: { scenelang: extras } });
    const number = this.json.nodes.length - 1;
    this.json.scenes[0].nodes.push(number);
    // Movable parts are below, in the frame of their object.
    for (const { tag, parts } of hung) {
      this.json.meshes.push({ primitives: parts.map((part) => this.primitive(part)) });
      this.json.nodes.push({ mesh: this.json.meshes.length - 1, extras: { scenelang: tag } });
      (this.json.nodes[number].children ??= []).push(this.json.nodes.length - 1);
    }
  }

  primitive({ shape, pos, colour, roughness = 0.8, metallic = 0 }) {
    const { positions, normals } = shape;
    const moved = positions.map(([x, y, z]) => [-(x + pos[0]), y + pos[1], z + pos[2]]);
    const turned = normals.map(([x, y, z]) => [-x, y, z]);
    // The mirror turns every triangle inside out; swapping two corners turns it back.
    for (const list of [moved, turned]) for (let i = 0; i < list.length; i += 3) [list[i + 1], list[i + 2]] = [list[i + 2], list[i + 1]];
    return { attributes: { POSITION: this.accessor(moved, true), NORMAL: this.accessor(turned, false) }, material: this.material(colour, roughness, metallic) };
  }

  accessor(points, bounds) {
    const bytes = new Uint8Array(Float32Array.from(points.flat()).buffer);
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length, target: 34962 });
    this.chunks.push(bytes);
    this.length += bytes.length;
    const of = (f) => [0, 1, 2].map((k) => Math.fround(f(...points.map((p) => p[k]))));
    this.json.accessors.push({ bufferView: this.json.bufferViews.length - 1, componentType: 5126, count: points.length, type: "VEC3", ...(bounds ? { min: of(Math.min), max: of(Math.max) } : {}) });
    return this.json.accessors.length - 1;
  }

  material(colour, roughnessFactor, metallicFactor) {
    const key = JSON.stringify([colour, roughnessFactor, metallicFactor]);
    if (!this.materials.has(key)) {
      const linear = [1, 3, 5].map((i) => (parseInt(colour.slice(i, i + 2), 16) / 255) ** 2.2);
      this.json.materials.push({ pbrMetallicRoughness: { baseColorFactor: [...linear, 1], roughnessFactor, metallicFactor } });
      this.materials.set(key, this.json.materials.length - 1);
    }
    return this.materials.get(key);
  }

  /** The file as a Buffer. */
  finish() {
    this.json.buffers.push({ byteLength: this.length });
    let text = JSON.stringify(this.json);
    text += " ".repeat((4 - (text.length % 4)) % 4);
    const chunk = (type, body) => {
      const head = Buffer.alloc(8);
      head.writeUInt32LE(body.length, 0);
      head.writeUInt32LE(type, 4);
      return Buffer.concat([head, body]);
    };
    const body = Buffer.concat([chunk(0x4e4f534a, Buffer.from(text)), chunk(0x004e4942, Buffer.concat(this.chunks))]);
    const head = Buffer.alloc(12);
    [0x46546c67, 2, 12 + body.length].forEach((v, i) => head.writeUInt32LE(v, 4 * i));
    return Buffer.concat([head, body]);
  }
}

/** A box of w × h × d, centred on the origin; triangles wind outwards in the left-handed frame's mirror image. */
export function box([w, h, d]) {
  const positions = [];
  const normals = [];
  for (let axis = 0; axis < 3; axis += 1)
    for (const sign of [1, -1]) {
      const normal = [0, 0, 0];
      normal[axis] = sign;
      const corner = (u, v) => {
        const p = [0, 0, 0];
        p[axis] = sign;
        p[(axis + 1) % 3] = u * sign;
        p[(axis + 2) % 3] = v;
        return [(p[0] * w) / 2, (p[1] * h) / 2, (p[2] * d) / 2];
      };
      for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
        positions.push(corner(u, v));
        normals.push(normal);
      }
    }
  return { positions, normals };
}

/** An upright cylinder or cone stump, centred on the origin. */
export function cylinder(radius, height, top = radius, sides = 32) {
  const positions = [];
  const normals = [];
  const ring = (i, r, y) => [r * Math.cos((2 * Math.PI * i) / sides), y, r * Math.sin((2 * Math.PI * i) / sides)];
  for (let i = 0; i < sides; i += 1) {
    const [a, b, c, d] = [ring(i, radius, -height / 2), ring(i + 1, radius, -height / 2), ring(i + 1, top, height / 2), ring(i, top, height / 2)];
    const [n, m] = [ring(i, 1, 0), ring(i + 1, 1, 0)];
    positions.push(a, c, b, a, d, c);
    normals.push(n, m, m, n, n, m);
    positions.push([0, height / 2, 0], c, d, [0, -height / 2, 0], a, b);
    normals.push([0, 1, 0], [0, 1, 0], [0, 1, 0], [0, -1, 0], [0, -1, 0], [0, -1, 0]);
  }
  return { positions, normals };
}
