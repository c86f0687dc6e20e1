// What is drawn where a constraint fails: places in the layout's frame.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { gapsOf } = await load("gaps.ts");
const { footprint, shared, nearestPair, contains } = await load("footprint.ts");

const object = (name, pos, scale = [1, 1, 1], rot = [0, 0, 0]) => ({ name, label: name, category: "", pos, rot, scale, constraints: [] });
const row = (kind, objects, more = {}) => ({ id: "r", kind, rule: null, code: null, satisfied: false, margin: -0.25, unit: "m", objects, text: "", message: "", place: null, ...more });
const ROOM = { name: "room", vertices: [[0, 0], [6, 0], [6, 4], [0, 4]], floor: 0, ceiling: 2.5 };
const scene = (objects, constraints, regions = [ROOM]) => ({ name: "n", glb: "", plan: "", objects, regions, report: { ok: false, file: "", summary: {}, constraints, diagnostics: [] } });
const near = (found, wanted) => found.forEach((v, i) => assert.ok(Math.abs(v - wanted[i]) < 1e-9, `${found} is not ${wanted}`));

test("a footprint turns with its object, about x, then z, then y", () => {
  for (const [rot, size] of [[[0, 0, 0], [2, 1, 0.5]], [[0, 90, 0], [0.5, 1, 2]], [[90, 0, 0], [2, 0.5, 1]], [[0, 0, 90], [1, 2, 0.5]], [[90, 90, 0], [1, 0.5, 2]]]) {
    const { outline, low, high } = footprint(object("a", [0, 0, 0], [2, 1, 0.5], rot));
    const span = (k) => Math.max(...outline.map((p) => p[k])) - Math.min(...outline.map((p) => p[k]));
    near([span(0), high - low, span(1)], size);
  }
  // Front, +z, turns towards right, +x.
  const { outline } = footprint(object("a", [0, 0, 0], [0, 0, 2], [0, 30, 0]));
  near(outline.reduce((most, p) => (p[1] > most[1] ? p : most)), [0.5, Math.sqrt(3) / 2]);
});

test("outlines share what they share, and come nearest where they do", () => {
  const square = (x, z) => [[x, z], [x + 1, z], [x + 1, z + 1], [x, z + 1]];
  const common = shared(square(0, 0), square(0.75, 0.5));
  assert.deepEqual(common.map((p) => p.join(" ")).sort(), ["0.75 0.5", "0.75 1", "1 0.5", "1 1"]);
  assert.deepEqual(shared(square(0, 0), square(1, 0)), [], "touching is not overlapping");
  near(nearestPair(square(0, 0), square(3, 0.25)).flat(), [1, 0.625, 3, 0.625]);
  near(nearestPair(square(0, 0), square(3, 2)).flat(), [1, 1, 3, 2]);
  assert.ok(contains(ROOM.vertices, [1, 1]) && !contains(ROOM.vertices, [7, 1]));
  assert.ok(contains([...ROOM.vertices].reverse(), [1, 1]), "of either winding");
});

const CASES = [
  ["side by side: a level line between them", [object("a", [1, 0, 1]), object("b", [3, 0, 1])], row("assert", ["a", "b"]), { from: [1.5, 0.5, 1], to: [2.5, 0.5, 1] }],
  ["one over the other: straight up", [object("a", [1, 2, 1]), object("b", [1, 0, 1])], row("assert", ["a", "b"]), { from: [1, 2, 1], to: [1, 1, 1] }],
  ["apart in every way: from height to height", [object("a", [1, 0, 1]), object("b", [3, 3, 1])], row("assert", ["a", "b"]), { from: [1.5, 1, 1], to: [2.5, 3, 1] }],
  ["sticks out of the room: from its deepest side", [object("a", [0.2, 0, 2])], row("bounds", ["a"]), { from: [-0.3, 0.5, 2], to: [0, 0.5, 2] }],
  ["away from the room it is to touch", [object("a", [1, 0, 2])], row("assert", ["a", "room"]), { from: [0.5, 0.5, 2], to: [0, 0.5, 2] }],
  ["hovers over the floor", [object("a", [1, 0.8, 1])], row("support", ["a"]), { from: [1, 0.8, 1], to: [1, 0, 1] }],
  ["hovers over a table", [object("a", [1, 1.2, 1]), object("t", [1.2, 0, 1])], row("support", ["a"]), { from: [1, 1.2, 1], to: [1, 1, 1] }],
];
for (const [name, objects, constraint, { from, to }] of CASES)
  test(name, () => {
    const [gap, ...others] = gapsOf(scene(objects, [constraint]), null);
    assert.deepEqual(others, []);
    near(gap.from, from);
    near(gap.to, to);
    assert.equal(gap.text, "−0.25 m");
    assert.equal(gap.common, null);
  });

test("what overlaps shares a body", () => {
  const [gap] = gapsOf(scene([object("a", [1, 0, 1]), object("b", [1.75, 0.5, 1])], [row("collision", ["a", "b"])]), null);
  assert.deepEqual([gap.common.low, gap.common.high], [0.5, 1]);
  near([Math.min(...gap.common.outline.map(([x]) => x)), Math.max(...gap.common.outline.map(([x]) => x))], [1.25, 1.5]);
});

test("nothing is drawn for what holds, cannot be checked, is of one thing alone, or is but a preference", () => {
  const objects = [object("a", [1, 0, 1]), object("b", [3, 0, 1])];
  const rows = [row("assert", ["a", "b"], { satisfied: true }), row("assert", ["a", "b"], { satisfied: null }), row("assert", ["a"]), row("assert", ["nobody"]), row("prefer", ["a", "b"])];
  assert.deepEqual(gapsOf(scene(objects, rows), null), []);
  assert.deepEqual(gapsOf(scene(objects, rows), 4).map((gap) => gap.row), [4], "unless the preference is chosen");
});
