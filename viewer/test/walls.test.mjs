// Which walls are cut away, for which eye.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { cutEdges, distanceTo, edgesOf, lowestEdge, nearestEdge, sharesWall } = await load("walls.ts");

const region = (name, vertices) => ({ name, vertices, floor: 0, ceiling: 2.5 });
const rectangle = (name, x0, z0, x1, z1) => region(name, [[x0, z0], [x1, z0], [x1, z1], [x0, z1]]);
const SIDES = ["south", "east", "north", "west"];
const cut = (edges, eye) => cutEdges(edges, eye).flatMap((is, i) => (is ? [`${edges[i].region} ${SIDES[i % 4]}`] : []));

test("normals point out of the room, whichever way its polygon winds", () => {
  const outs = (vertices) => edgesOf(region("r", vertices)).map(({ out }) => out.map((v) => v + 0));
  assert.deepEqual(outs([[0, 0], [4, 0], [4, 3], [0, 3]]), [[0, -1], [1, 0], [0, 1], [-1, 0]]);
  assert.deepEqual(outs([[0, 3], [4, 3], [4, 0], [0, 0]]), [[0, 1], [1, 0], [0, -1], [-1, 0]]);
});

test("a vertex repeated at the end makes no edge", () => assert.equal(edgesOf(region("r", [[0, 0], [4, 0], [4, 3], [0, 0]])).length, 3));

const one = edgesOf(rectangle("a", 0, 0, 4, 3));
const EYES = [
  ["in front", [2, -5], ["a south"]],
  ["at the front left", [-5, -5], ["a south", "a west"]],
  ["behind on the right", [9, 9], ["a east", "a north"]],
  ["within", [2, 1], []],
];
for (const [name, eye, walls] of EYES) test(`one room, seen from ${name}`, () => assert.deepEqual(cut(one, eye), walls));

test("a wall between two rooms goes with both its faces", () => {
  const two = [...edgesOf(rectangle("a", 0, 0, 4, 3)), ...edgesOf(rectangle("b", 4.06, 0, 8, 3))];
  assert.deepEqual(cut(two, [-5, 1.5]), ["a east", "a west", "b west"]);
  assert.deepEqual(cut(two, [12, 1.5]), ["a east", "b east", "b west"]);
});

test("a neighbour along a small part of a long wall does not take it down", () => {
  const [, east] = edgesOf(rectangle("hall", 0, 0, 2, 10));
  const [, , , west] = edgesOf(rectangle("closet", 2.06, 0, 3, 2));
  assert.equal(sharesWall(east, west), false);
  assert.equal(sharesWall(west, east), true);
});

test("walls far apart, or of one room, are not shared", () => {
  const [, east] = edgesOf(rectangle("a", 0, 0, 4, 3));
  const [, , , far] = edgesOf(rectangle("b", 5, 0, 8, 3));
  const [, , , own] = edgesOf(rectangle("a", 0, 0, 4, 3));
  assert.equal(sharesWall(east, far), false);
  assert.equal(sharesWall(east, own), false);
});

test("distances and the nearest edge", () => {
  assert.equal(distanceTo(one[0], [2, 0.5]), 0.5);
  assert.equal(distanceTo(one[0], [-3, -4]), 5);
  assert.equal(nearestEdge(one, [3.8, 1.5]), 1);
  assert.equal(nearestEdge([], [0, 0]), -1);
});

test("the lowest edge of an L", () => {
  const low = lowestEdge(edgesOf(region("l", [[0, 1], [2, 1], [2, 0], [4, 0], [4, 3], [0, 3]])));
  assert.deepEqual([low.a, low.b], [[2, 0], [4, 0]]);
  assert.equal(lowestEdge([]), undefined);
});
