// What is pressed in the room, found in the text.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { pointedAt } = await load("places.ts");
const TEXT = "region room;\nobject desk;\n  object chair[4];\nobject desk2;\nassert near(desk, room);\n";
const slice = (pointed) => {
  const range = pointedAt(TEXT, "a.scene", pointed);
  return range && TEXT.slice(...range);
};

test("objects are found where they are declared", () => {
  assert.equal(slice({ object: "desk" }), "desk");
  assert.equal(pointedAt(TEXT, "a.scene", { object: "desk" })[0], TEXT.indexOf("desk;"));
  assert.equal(slice({ object: "chair[2]" }), "chair");
  assert.equal(slice({ object: "lamp" }), null);
  assert.equal(slice({ object: "(" }), null);
});

test("rows of the report are found by their line", () => {
  assert.equal(slice({ row: "a.scene:5:1" }), "assert near(desk, room);");
  assert.equal(slice({ row: "a.scene:99:1" }), null);
  assert.equal(slice({ row: "other.scene:5:1" }), null);
  assert.equal(slice({ row: "P-COLLIDE:desk:chair[0]" }), null);
});
