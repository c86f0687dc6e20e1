// Verdicts that come while something is dragged, and how moves wait for each other.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fixtureData } from "./fixture.mjs";
import { load } from "./load.mjs";

const { readData } = await load("data.ts");
const { judged, readVerdicts } = await load("live.ts");
const { Moves } = await load("moves.ts");

const room = () => readData(fixtureData());
const move = (object, pos = [1, 0, 1], commit = false) => ({ object, pos, rot: [0, 0, 0], commit });
const COLLISION = 11;

test("a move changes the rows it speaks of, the tallies, and where the object is", () => {
  const before = room();
  const id = (row) => before.report.constraints[row].id;
  const { data, changed } = judged(before, move("lamp"), readVerdicts({
    constraints: [{ id: id(5), state: "holds", margin: 0.5 }, { id: id(0), state: "fails", margin: -1 }, { id: id(1), state: "holds", margin: 0.35 }, { id: "gone", state: "fails", margin: -1 }],
    physical: [{ id: "P-COLLIDE:plant:screen", margin: -0.1, message: "deeper" }, { id: "P-COLLIDE:lamp:sofa", margin: -0.2, objects: ["lamp", "sofa"] }, { id: "P-SUPPORT:lamp", state: "holds" }],
  }));
  const rows = data.report.constraints;
  assert.deepEqual([...changed].sort((a, b) => a - b), [0, 5, COLLISION, before.report.constraints.length]);
  assert.deepEqual([rows[5].satisfied, rows[5].margin, rows[5].message], [true, 0.5, ""]);
  assert.deepEqual([rows[COLLISION].margin, rows[COLLISION].message], [-0.1, "deeper"]);
  const { rule, kind, text } = rows.at(-1);
  assert.deepEqual([rule, kind, text], ["P-COLLIDE", "collision", "`lamp` and `sofa` do not collide"]);
  assert.deepEqual(data.report.summary.assertions, { total: 8, satisfied: 6 });
  assert.deepEqual(data.report.summary.physical, { total: 31, satisfied: 29 });
  const lamp = data.objects.find(({ name }) => name === "lamp");
  assert.deepEqual(lamp.pos, [1, 0, 1]);
  assert.ok(lamp.constraints.includes(rows.length - 1));
  assert.deepEqual(room(), before, "what came before is left alone");
});

test("a rule that is no longer named holds again", () => {
  const { data, changed } = judged(room(), move("plant"), readVerdicts({ constraints: [], physical: [] }));
  assert.deepEqual([...changed], [COLLISION]);
  assert.equal(data.report.constraints[COLLISION].satisfied, true);
  assert.deepEqual(data.report.summary.physical, { total: 31, satisfied: 31 });
});

test("an answer that breaks the contract is named", () => {
  assert.throws(() => readVerdicts({ constraints: [{ id: "a", state: "maybe" }] }), /constraints\[0\]\.state: expected holds, fails or unknown/);
  assert.throws(() => readVerdicts({}), /constraints: expected a list/);
});

/** A server that answers when told to. */
function slow() {
  const asked = [];
  const answers = [];
  const ask = (move) => new Promise((done, failed) => (asked.push(move), answers.push({ done, failed })));
  return { ask, asked, answer: async (i, why) => (why === undefined ? answers[i].done({ constraints: [], physical: [] }) : answers[i].failed(why), new Promise((done) => setTimeout(done))) };
}
const place = (x) => ({ pos: [x, 0, 0], rot: [0, 0, 0] });

test("while one question is open the newest waits, and what was made is never dropped", async () => {
  const server = slow();
  const moves = new Moves(server.ask, { placed() {}, judged() {}, refused: assert.fail });
  for (const x of [1, 2, 3]) moves.consider("a", place(x));
  moves.make("a", place(0), place(3));
  for (const x of [4, 5]) moves.consider("b", place(x));
  for (let i = 0; i < server.asked.length; i += 1) await server.answer(i);
  assert.deepEqual(server.asked.map(({ object, pos, commit }) => [object, pos[0], commit]), [["a", 1, false], ["a", 3, true], ["b", 5, false]]);
});

test("moves are taken back and made again; what was refused cannot be", async () => {
  const server = slow();
  const placed = [];
  const refused = [];
  const moves = new Moves(server.ask, { placed: (object, { pos }) => placed.push([object, pos[0]]), judged() {}, refused: (_, why) => refused.push(why) });
  let answered = 0;
  const flush = async (why) => {
    while (answered < server.asked.length) await server.answer(answered++, why);
  };
  moves.undo();
  moves.make("a", place(0), place(1));
  moves.make("b", place(5), place(6));
  await flush();
  for (const step of ["undo", "undo", "undo", "redo"]) moves[step]();
  await flush();
  assert.deepEqual(placed, [["b", 5], ["a", 0], ["a", 1]]);
  assert.deepEqual(server.asked.slice(2).map(({ pos, commit }) => [pos[0], commit]), [[5, true], [0, true], [1, true]]);
  moves.make("a", place(1), place(2));
  await flush("no");
  assert.deepEqual(refused, ["no"]);
  moves.undo();
  assert.equal(server.asked.length, answered, "nothing is left to take back");
});
