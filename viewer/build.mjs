// Bundles the viewer into one classic script, dist/viewer.js, which a page may carry inline: no module
// loading, so it works from file://, in a webview and from a server alike.
import { build } from "esbuild";
import { gzipSync } from "node:zlib";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const outfile = here("dist/viewer.js");

await build({
  entryPoints: [here("src/main.ts")],
  outfile,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  // ASCII only: the script is right whatever charset the page around it declares.
  charset: "ascii",
  loader: { ".css": "text" },
  legalComments: "eof",
  logLevel: "warning",
});

const bytes = readFileSync(outfile);
console.log(`dist/viewer.js ${(bytes.length / 1024).toFixed(0)} KiB, ${(gzipSync(bytes).length / 1024).toFixed(0)} KiB gzipped`);
