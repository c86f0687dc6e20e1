// What the panel says: figures, the headline, and which rows a filter leaves.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fixtureData } from "./fixture.mjs";
import { load } from "./load.mjs";

const { aboutObject, counts, failures, formatMargin, formatPoint, formatSize, headline, matching, sameRow } = await load("list.ts");
const { readData } = await load("data.ts");
const data = readData(fixtureData());
const object = (name) => data.objects.find((o) => o.name === name);

const MARGINS = [
  [0.12, "m", "+0.12 m"],
  [-0.12, "m", "−0.12 m"],
  [0.001, "m", "+1.0 mm"],
  [-0.0035, "m", "−3.5 mm"],
  [0, "m", "+0.0 mm"],
  [1234.5, "m", "+1235 m"],
  [-12.44, "deg", "−12.4°"],
  [3, null, "+3"],
  [0.25, "m2", "+0.25 m2"],
  [null, null, ""],
];
for (const [margin, unit, text] of MARGINS) test(`a margin of ${margin} ${unit}`, () => assert.equal(formatMargin(margin, unit), text));

test("sizes and places", () => {
  assert.equal(formatSize([1.8, 0.74, 0.9]), "1.80 × 0.74 × 0.90 m");
  assert.equal(formatPoint([1.2, -0.001, -2]), "(1.20, 0.00, −2.00)");
});

test("an object is not called twice what it is", () => {
  assert.deepEqual(aboutObject({ name: "lamp", label: "lamp", category: "lamp" }), []);
  assert.deepEqual(aboutObject({ name: "l1", label: "Reading lamp", category: "lamp" }), ["Reading lamp", "lamp"]);
  assert.deepEqual(aboutObject({ name: "lamp", label: "Reading lamp", category: "lamp" }), ["Reading lamp"]);
});

test("chips count their rows", () => assert.deepEqual(counts(data.report), { all: 13, violated: 3, assert: 8, prefer: 2, physical: 2, pins: 1 }));

const QUERIES = [
  ["what fails comes first, then what was not judged", { filter: "all" }, [5, 8, 11, 7, 0, 1, 2, 3, 4, 6, 9, 10, 12]],
  ["violated", { filter: "violated" }, [5, 8, 11]],
  ["physical", { filter: "physical" }, [11, 12]],
  ["pins", { filter: "pins" }, [10]],
  ["words in any case and order, in text, names and places", { words: "TABLE gap" }, [1]],
  ["a word of the message", { words: "overlap" }, [11]],
  ["a rule", { words: "p-support" }, [12]],
  ["an object's rows", { object: "lamp" }, [5]],
  ["an object's rows that hold a word", { object: "plant", words: "inCorner" }, [9]],
  ["nothing", { words: "unicorn" }, []],
];
for (const [name, { filter = "all", words = "", object: of }, rows] of QUERIES)
  test(`rows: ${name}`, () => assert.deepEqual(matching(data, { filter, words, object: of === undefined ? null : object(of) }), rows));

test("failures of an object", () => {
  assert.equal(failures(data, object("plant")), 2);
  assert.equal(failures(data, object("table")), 0);
});

test("rows that are listed alike", () => {
  const [row] = data.report.constraints;
  assert.ok(sameRow(row, structuredClone(row)));
  assert.ok(sameRow(undefined, undefined));
  for (const other of [undefined, { ...row, margin: 0.123 }, { ...row, place: "room.scene:99" }, { ...row, satisfied: null }, { ...row, objects: [...row.objects, "more"] }, { ...row, objects: row.objects.map(() => "other") }])
    assert.ok(!sameRow(row, other), JSON.stringify(other));
});

/** A report of given rows, [kind, satisfied]. */
function report(assertions, rows, ok = true) {
  const none = { total: 0, satisfied: 0 };
  return { ok, file: "", summary: { assertions, preferences: none, physical: { total: 3, satisfied: 3 }, pins: { total: 1, satisfied: 1 } }, constraints: rows.map(([kind, satisfied]) => ({ kind, satisfied })), diagnostics: [] };
}
const HEADLINES = [
  ["all hold", report({ total: 2, satisfied: 2 }, [["assert", true]]), "2 of 2 assertions hold", "holds"],
  ["one of one", report({ total: 1, satisfied: 1 }, [["assert", true]]), "1 of 1 assertion holds", "holds"],
  ["an assertion fails", report({ total: 2, satisfied: 1 }, [["assert", false]], false), "1 of 2 assertions hold", "fails"],
  ["a physical rule fails", report({ total: 2, satisfied: 2 }, [["collision", false]], false), "2 of 2 assertions hold", "fails"],
  ["only a preference fails", report({ total: 2, satisfied: 2 }, [["prefer", false]]), "2 of 2 assertions hold", "holds"],
  ["one could not be judged", report({ total: 2, satisfied: 1 }, [["assert", null]], false), "1 of 2 assertions hold", "unknown"],
  ["none stated", report({ total: 0, satisfied: 0 }, []), "No assertions", "holds"],
];
for (const [name, given, text, state] of HEADLINES)
  test(`headline: ${name}`, () => {
    const found = headline(given);
    assert.deepEqual([found.text, found.state], [text, state]);
    assert.deepEqual(found.details.slice(0, 2), ["3 of 3 physical rules", "1 of 1 pin"]);
  });
