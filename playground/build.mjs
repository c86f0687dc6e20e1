// Builds the page into a folder, without anything of an earlier build: `node build.mjs [--engine FILE.wasm] [--to FOLDER]`. With a module, examples get their
// layouts from it, and both its sizes are told; without one, only the scripts are made and checked.
import { build } from "esbuild";
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const { values: given } = parseArgs({ options: { engine: { type: "string" }, to: { type: "string", default: here("dist") } } });
rmSync(given.to, { recursive: true, force: true });
mkdirSync(given.to, { recursive: true });

const common = { bundle: true, minify: true, format: "iife", target: "es2022", charset: "ascii", legalComments: "eof", logLevel: "warning" };

/** The module as Node runs it, by the code of the page's worker. */
async function engine(bytes) {
  const made = await build({ ...common, format: "esm", entryPoints: [here("src/engine.ts")], write: false });
  const { read, start } = await import(`data:text/javascript;base64,${Buffer.from(made.outputFiles[0].contents).toString("base64")}`);
  const ask = await start(await WebAssembly.compile(bytes));
  return (request) => read(ask(request));
}

const folder = here("../examples");
const examples = readdirSync(folder).filter((file) => file.endsWith(".scene")).sort();
const module = given.engine === undefined ? undefined : readFileSync(given.engine);
const ask = module && (await engine(module));
const told = examples.map((file) => {
  const text = readFileSync(join(folder, file), "utf8");
  const solved = ask?.({ method: "solve", name: file, text, start: null, seed: 0 });
  if (solved && !solved.converged) throw new Error(`${file}: no layout was found`);
  return { name: basename(file, ".scene"), text, layout: solved?.layout ?? null };
});

const worker = await build({ ...common, entryPoints: [here("src/worker.ts")], write: false });
const virtual = {
  name: "virtual",
  setup(build) {
    build.onResolve({ filter: /^virtual:/ }, ({ path }) => ({ path, namespace: "virtual" }));
    build.onLoad({ filter: /./, namespace: "virtual" }, ({ path }) => {
      const value = path === "virtual:worker" ? worker.outputFiles[0].text : told;
      return { contents: `export default ${JSON.stringify(value)}`, loader: "js" };
    });
  },
};
const { metafile } = await build({ ...common, absWorkingDir: here("."), metafile: true, entryPoints: [here("src/main.ts")], outfile: join(given.to, "playground.js"), loader: { ".css": "text" }, plugins: [virtual] });
await build({ ...common, entryPoints: [here("src/embed.ts")], outfile: join(given.to, "embed.js") });
copyFileSync(here("index.html"), join(given.to, "index.html"));

// What is bundled keeps its licence.
const bundled = new Set(Object.keys(metafile.inputs).flatMap((path) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path) ?? []));
const licences = [...bundled].sort().map((module_) => {
  const { name, version } = JSON.parse(readFileSync(here(`${module_}/package.json`), "utf8"));
  const file = readdirSync(here(module_)).find((entry) => /^licen[cs]e/i.test(entry));
  if (file === undefined) throw new Error(`${name} has no licence`);
  return `${name} ${version}\n\n${readFileSync(here(`${module_}/${file}`), "utf8").trim()}\n`;
});
writeFileSync(join(given.to, "THIRD-PARTY.txt"), licences.join(`\n${"-".repeat(80)}\n\n`));

const script = readFileSync(join(given.to, "playground.js"));
const mib = (bytes) => `${(bytes / 2 ** 20).toFixed(2)} MiB`;
const gzip = (bytes) => gzipSync(bytes, { level: 9 });
const brotli = (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 9, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } });
const tell = (name, bytes) => console.log(`${name}: ${mib(bytes.length)}, gzip ${mib(gzip(bytes).length)}, brotli ${mib(brotli(bytes).length)}`);
tell("playground.js", script);
if (module !== undefined) {
  // Packed here, so that it is small on any server; a name that ends in .gz would make some of them unpack it.
  writeFileSync(join(given.to, "engine.bin"), gzip(module));
  tell("engine", module);
}
