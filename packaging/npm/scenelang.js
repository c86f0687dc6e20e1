#!/usr/bin/env node
// Runs the scenelang of this platform, which npm has installed as an optional dependency.
"use strict";
const { spawnSync } = require("node:child_process");
const { constants } = require("node:os");

const name = `@scenelang/${process.platform}-${process.arch}`;
const file = process.platform === "win32" ? "scenelang.exe" : "scenelang";
let binary;
try {
  binary = process.env.SCENELANG_BINARY || require.resolve(`${name}/bin/${file}`);
} catch {
  console.error(
    `error: the package ${name} is not installed. Either scenelang is not built for this platform, or npm was told to leave ` +
      "optional dependencies out: install again with `npm install --include=optional scenelang`",
  );
  process.exit(2);
}
const ended = spawnSync(binary, process.argv.slice(2), { stdio: "inherit" });
if (ended.error) {
  console.error(`error: cannot run ${binary}: ${ended.error.message}`);
  process.exit(2);
}
// As shells have it.
process.exit(ended.signal ? 128 + (constants.signals[ended.signal] || 0) : ended.status);
