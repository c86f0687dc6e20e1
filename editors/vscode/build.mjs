// Bundles the extension into dist/: its own script, the viewer's, the schema of layouts, and the examples.
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

rmSync(here("dist"), { recursive: true, force: true });
mkdirSync(here("dist"));
const { metafile } = await build({
  absWorkingDir: here("."),
  entryPoints: [here("src/extension.ts")],
  outfile: here("dist/extension.js"),
  bundle: true,
  minify: true,
  platform: "node",
  format: "cjs",
  target: "node18",
  external: ["vscode"],
  legalComments: "eof",
  logLevel: "warning",
  metafile: true,
});

// What is bundled keeps its licence; three.js is in the viewer's script.
const bundled = new Set(Object.keys(metafile.inputs).flatMap((path) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path) ?? []));
bundled.add("../../viewer/node_modules/three");
const licences = [...bundled].sort().map((folder) => {
  const { name, version } = JSON.parse(readFileSync(here(`${folder}/package.json`), "utf8"));
  const file = readdirSync(here(folder)).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} has no licence`);
  return `${name} ${version}\n\n${readFileSync(here(`${folder}/${file}`), "utf8").trim()}\n`;
});
writeFileSync(here("dist/THIRD-PARTY.txt"), licences.join(`\n${"-".repeat(80)}\n\n`));

const copies = [["../../viewer/dist/viewer.js", "dist/viewer.js"], ["../../crates/verify/schemas/layout.json", "dist/layout.schema.json"]];
for (const [from, to] of copies) {
  if (!existsSync(here(from))) throw new Error(`${from} is missing; the viewer is built by: cd viewer && npm ci && npm run build`);
  copyFileSync(here(from), here(to));
}
mkdirSync(here("dist/examples"));
for (const name of readdirSync(here("../../examples")).filter((name) => name.endsWith(".scene"))) copyFileSync(here(`../../examples/${name}`), here(`dist/examples/${name}`));
console.log(`dist/extension.js ${(statSync(here("dist/extension.js")).size / 1024).toFixed(0)} KiB`);
