// The data contract: what is accepted, and how what is not is named.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fixtureData } from "./fixture.mjs";
import { load } from "./load.mjs";

const { DataError, parseData, readData, rowObjects } = await load("data.ts");
const { Shapes } = await load("source/shapes.ts");

/** A copy of the fixture with one change. */
function changed(change) {
  const data = fixtureData();
  change(data);
  return data;
}

test("a page's data is read whole", () => {
  const data = parseData(JSON.stringify(fixtureData()));
  assert.equal(data.name, "meeting");
  assert.equal(data.objects.length, 15);
  assert.deepEqual(data.regions.map(({ name }) => name), ["meeting", "lounge"]);
  assert.deepEqual(data.report.summary.assertions, { total: 8, satisfied: 6 });
  assert.equal(data.report.constraints[5].margin, -0.12);
  assert.equal(data.report.constraints[5].place, "meeting.scene:25");
  assert.equal(data.report.constraints[7].satisfied, null);
  assert.equal(data.report.constraints[11].place, null);
  assert.equal(data.report.diagnostics[0].code, "W0301");
});

test("geometry that was sent before is put in again", () => {
  const shapes = new Shapes();
  const [one, other] = [{ shape: "a", glb: "AA", n: 1 }, { shape: "b", glb: "BB", n: 2 }];
  assert.equal(shapes.known, "");
  assert.deepEqual(shapes.whole({ glb: "CC" }), { glb: "CC" }, "a source that names no shapes");
  assert.deepEqual(shapes.whole(one), one);
  assert.equal(shapes.known, "a");
  assert.deepEqual(shapes.whole({ ...one, glb: null, n: 3 }), { ...one, n: 3 });
  assert.deepEqual(shapes.whole(other), other);
  assert.deepEqual(shapes.whole({ ...one, glb: null }), { ...one, glb: null }, "what is not known is not made up");
  for (const strange of [null, 5, "x", [], { shape: 5, glb: null }]) assert.deepEqual(shapes.whole(strange), strange);
});

const OPTIONAL = [
  ["an unknown member", (d) => (d.later = 1)],
  ["no label", (d) => delete d.objects[0].label],
  ["no category", (d) => delete d.objects[0].category],
  ["a summary without pins", (d) => delete d.report.summary.pins],
  ["no diagnostics", (d) => delete d.report.diagnostics],
  ["a margin that is null", (d) => (d.report.constraints[0].margin = null)],
  ["no plan", (d) => (d.plan = "")],
  ["no objects and no regions", (d) => Object.assign(d, { objects: [], regions: [] })],
];
for (const [name, change] of OPTIONAL) test(`accepted: ${name}`, () => assert.doesNotThrow(() => readData(changed(change))));

const WRONG = [
  ["another format", (d) => (d.format = "scenelang.preview/2"), 'format: expected "scenelang.preview/1", found "scenelang.preview/2"'],
  ["no name", (d) => delete d.name, "name: expected a string, found nothing"],
  ["no report", (d) => (d.report = null), "report: expected an object, found null"],
  ["a margin in words", (d) => (d.report.constraints[3].margin = "much"), "report.constraints[3].margin: expected a finite number, found string"],
  ["a verdict that is a number", (d) => (d.report.constraints[0].satisfied = 1), "report.constraints[0].satisfied: expected true or false, found number"],
  ["a summary without a total", (d) => delete d.report.summary.physical.total, "report.summary.physical.total: expected a finite number, found nothing"],
  ["a place of two numbers", (d) => (d.objects[2].pos = [1, 2]), "objects[2].pos: expected three numbers, found a list of 2"],
  ["a place with a null", (d) => (d.objects[2].pos[1] = null), "objects[2].pos[1]: expected a finite number, found null"],
  ["a row that is not there", (d) => (d.objects[0].constraints = [0, 99]), "objects[0].constraints[1]: there is no row 99 in the report, which has 13"],
  ["a row that is no index", (d) => (d.objects[0].constraints = [0.5]), "objects[0].constraints[0]: there is no row 0.5 in the report, which has 13"],
  ["a polygon of two vertices", (d) => d.regions[0].vertices.splice(2), "regions[0].vertices: a polygon needs three vertices, found 2"],
  ["objects by name", (d) => (d.objects = {}), "objects: expected a list, found object"],
];
for (const [name, change, message] of WRONG)
  test(`refused: ${name}`, () => assert.throws(() => readData(changed(change)), (error) => error instanceof DataError && (assert.equal(error.message, message), true)));

test("refused: what is no object, and no JSON", () => {
  for (const value of [null, 3, "text", []]) assert.throws(() => readData(value), DataError);
  assert.throws(() => parseData("{"), /^DataError: the data is not JSON/);
});

test("a row's names: regions count, arrays stand for their elements, sets fall back on the objects", () => {
  const data = readData(
    changed((d) => {
      d.report.constraints[0].objects = ["table", "meeting", "nobody"];
      d.report.constraints[1].objects = ["chair"];
      d.report.constraints[2].objects = [];
      d.objects.find(({ name }) => name === "sofa").constraints = [2];
      for (const object of d.objects) if (object.name !== "sofa") object.constraints = [];
    }),
  );
  assert.deepEqual(rowObjects(data, 0), ["table", "meeting"]);
  assert.deepEqual(rowObjects(data, 1), [0, 1, 2, 3, 4, 5].map((i) => `chair[${i}]`));
  assert.deepEqual(rowObjects(data, 2), ["sofa"]);
  assert.deepEqual(rowObjects(data, 99), []);
});
