// Whether motion is taken for smooth.
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./load.mjs";

const { Pace } = await load("pace.ts");

/** Frames of one motion, so many milliseconds apart; the last one comes to rest. */
function motion(pace, start, ...steps) {
  pace.frame(start, true);
  steps.forEach((step, i) => pace.frame((start += step), i + 1 < steps.length));
}

test("three late frames in a row make motion slow, for good", () => {
  const pace = new Pace();
  motion(pace, 1000, 16, 90, 90, 16, 90, 90, 16);
  assert.equal(pace.slow, false);
  motion(pace, 3000, 16, 90, 90, 90);
  assert.equal(pace.slow, true);
  motion(pace, 5000, 16, 16, 16, 16);
  assert.equal(pace.slow, true);
});

test("time at rest is not counted", () => {
  const pace = new Pace();
  for (let now = 0; now < 10_000; now += 1000) pace.frame(now, false);
  for (let start = 20_000; start < 40_000; start += 1000) motion(pace, start, 16, 16);
  assert.equal(pace.slow, false);
});
