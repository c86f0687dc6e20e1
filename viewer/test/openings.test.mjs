// Movable parts: where they stand when they are open, and what they sweep in the room.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { pose, sweptOn } = await load("openings.ts");
const near = (found, wanted) => found.forEach((x, i) => assert.ok(Math.abs(x - wanted[i]) < 1e-9, `${found} is not ${wanted}`));
// Hung on its left edge (x = −0.4), with the axis pointing down, as the exporter writes a leaf that opens to the front.
const leaf = { name: "door", motion: "hinge", axis: [0, -1, 0], anchor: [-0.4, 0, 0.2], amount: 90, blocked: false, swept: [[-0.4, 0.2], [0.4, 0.2], [-0.4, 1]] };
const drawer = { name: "drawer", motion: "slide", axis: [0, 0, 1], anchor: [0, 0, 0], amount: 0.3, blocked: false, swept: [] };

/** A point of the object's frame after the part is opened, in the layout's frame. */
async function moved(joint, share, [x, y, z]) {
  const { position, quaternion } = pose(joint, share);
  const { x: qx, y: qy, z: qz, w } = quaternion;
  // v + 2w(q×v) + 2q×(q×v)
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const [q, v] = [[qx, qy, qz], [-x, y, z]];
  const once = cross(q, v);
  const twice = cross(q, once);
  const at = v.map((c, i) => c + 2 * w * once[i] + 2 * twice[i] + position.toArray()[i]);
  return [-at[0], at[1], at[2]];
}

test("a leaf turns about its hinge to the front, and a drawer slides out", async () => {
  near(await moved(leaf, 0, [0.4, 1, 0.2]), [0.4, 1, 0.2]);
  near(await moved(leaf, 1, [0.4, 1, 0.2]), [-0.4, 1, 1]);
  near(await moved(leaf, 0.5, [-0.4, 1, 0.2]), [-0.4, 1, 0.2]);
  near(await moved(drawer, 0.5, [0.1, 0.2, 0.3]), [0.1, 0.2, 0.45]);
});

test("what is swept turns and moves with its object", () => {
  const object = { pos: [2, 0, 1], rot: [0, 90, 0] };
  // The front of what is turned by 90° looks along +x.
  const [hinge, latch, open] = sweptOn(object, leaf);
  near(hinge, [2.2, 1.4]);
  near(latch, [2.2, 0.6]);
  near(open, [3, 1.4]);
});
