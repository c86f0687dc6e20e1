// What of the extension needs no editor: finding the server, grouping, the page's policy, running programs, packing; and that
// the manifest and the code speak of the same things.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { zip } from "../zip.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const folder = mkdtempSync(join(tmpdir(), "scenelang-extension-"));
after(() => rmSync(folder, { recursive: true, force: true }));

async function load(name) {
  const { outputFiles } = await build({ entryPoints: [here(`../src/${name}`)], bundle: true, write: false, format: "esm", platform: "node", external: ["vscode"], logLevel: "warning" });
  const file = join(folder, name.replace(".ts", ".mjs"));
  writeFileSync(file, outputFiles[0].contents);
  return import(file);
}
const { locate } = await load("locate.ts");
const { at, groups, margin } = await load("groups.ts");
const { page } = await load("page.ts");
const { alternativesPage } = await load("alternatives-page.ts");
const { results } = await load("results.ts");
const { run } = await load("run.ts");
const { KEYS, choice, environment, refusal } = await load("environment.ts");
const names = await load("names.ts");
const { marked, summary } = await load("request-text.ts");
const manifest = JSON.parse(readFileSync(here("../package.json"), "utf8"));

const PLACES = { settings: { user: null, workspace: null }, trusted: true, workspace: "/ws", extension: "/ext", path: "/usr/bin:/opt/bin", windows: false };
const LOCATED = [
  ["the one that comes with the extension, before all others", { settings: { user: "/own/scenelang", workspace: null } }, ["/own/scenelang", "/ext/server/scenelang", "/usr/bin/scenelang"], { command: "/ext/server/scenelang", from: "extension" }],
  ["the setting, before the PATH", { settings: { user: "/own/scenelang", workspace: null } }, ["/own/scenelang", "/usr/bin/scenelang"], { command: "/own/scenelang", from: "setting" }],
  ["the setting, relative to the workspace", { settings: { user: "bin/scenelang", workspace: null } }, ["/ws/bin/scenelang"], { command: "/ws/bin/scenelang", from: "setting" }],
  ["the one that comes with the extension", {}, ["/ext/server/scenelang", "/usr/bin/scenelang"], { command: "/ext/server/scenelang", from: "extension" }],
  ["the first on the PATH", {}, ["/opt/bin/scenelang"], { command: "/opt/bin/scenelang", from: "PATH" }],
  ["with the name of the system", { windows: true }, ["/ext/server/scenelang.exe", "/ext/server/scenelang"], { command: "/ext/server/scenelang.exe", from: "extension" }],
  ["never a relative entry of the PATH", { path: ".:bin" }, ["bin/scenelang", "scenelang", "/ws/scenelang"], { missing: "there is no scenelang in the extension or on the PATH, and the setting scenelang.server.path names none" }],
  ["a setting that names nothing is not passed over", { settings: { user: "/gone", workspace: null } }, ["/usr/bin/scenelang"], { missing: "the setting scenelang.server.path names /gone, which is no program" }],
  ["a relative setting without a folder", { settings: { user: "bin/x", workspace: null }, workspace: null }, ["bin/x"], { missing: 'the setting scenelang.server.path is "bin/x", which is relative, and no folder is open' }],
  ["the workspace's setting, before the user's", { settings: { user: "/own/scenelang", workspace: "bin/scenelang" } }, ["/own/scenelang", "/ws/bin/scenelang"], { command: "/ws/bin/scenelang", from: "setting" }],
  ["a workspace that asks for the PATH", { settings: { user: "/own/scenelang", workspace: " " } }, ["/own/scenelang", "/opt/bin/scenelang"], { command: "/opt/bin/scenelang", from: "PATH" }],
  ["not trusted: the user's setting, not the workspace's", { trusted: false, settings: { user: "/own/scenelang", workspace: "/ws/evil" } }, ["/own/scenelang", "/ws/evil"], { command: "/own/scenelang", from: "setting" }],
  ["not trusted: the PATH, not the workspace's setting", { trusted: false, settings: { user: null, workspace: "/ws/evil" } }, ["/ws/evil", "/usr/bin/scenelang"], { command: "/usr/bin/scenelang", from: "PATH" }],
  ["not trusted: none, rather than the workspace's", { trusted: false, settings: { user: null, workspace: "evil" } }, ["/ws/evil"], { missing: "there is no scenelang in the extension or on the PATH, and the setting scenelang.server.path names none" }],
  ["not trusted: no file of the workspace, though the user's setting would find one", { trusted: false, settings: { user: "bin/scenelang", workspace: null } }, ["/ws/bin/scenelang", "bin/scenelang"], { missing: 'the setting scenelang.server.path is "bin/scenelang", which is relative, and the folder is not trusted' }],
  ["not trusted: the one that comes with the extension", { trusted: false, settings: { user: null, workspace: "/ws/evil" } }, ["/ws/evil", "/ext/server/scenelang"], { command: "/ext/server/scenelang", from: "extension" }],
];
for (const [name, places, there, found] of LOCATED) test(`the server: ${name}`, () => assert.deepEqual(locate({ ...PLACES, ...places, runs: (file) => there.includes(file) }), found));

test("layouts side by side are images in a page that runs nothing else", () => {
  const text = alternativesPage([{ seed: 7, holds: 3, total: 3, plan: "<svg onload=alert(1)></svg>" }, { seed: 8, holds: 1, total: 3, plan: null }], "abc");
  assert.match(text, /default-src 'none'; img-src data:; style-src 'nonce-abc'; script-src 'nonce-abc'/);
  assert.ok(!text.includes("onload"), "a plan is data");
  assert.deepEqual([...text.matchAll(/data-seed="(\d+)"/g)].map(([, seed]) => seed), ["7", "8"]);
  assert.ok(text.includes("Everything holds") && text.includes("1 of 3 hold") && text.includes("has no plan"));
});

test("a language model is the user's choice, and nobody's where the folder is not trusted", () => {
  for (const [setting, trusted, wanted] of [
    ["none", true, "none"], ["editor", true, "editor"], ["configured", true, "configured"],
    ["editor", false, "none"], ["configured", false, "none"], [undefined, true, "none"], [null, true, "none"], ["openai:m", true, "none"], [true, true, "none"],
  ]) assert.equal(choice(setting, trusted), wanted, `${setting} ${trusted}`);
});

test("keys reach a program only for the configured model", () => {
  const shell = { PATH: "/bin", Gemini_Api_Key: "c", ...Object.fromEntries(KEYS.map((key) => [key, "a"])) };
  const kept = { OPENAI_API_KEY: "b" };
  assert.deepEqual(environment(shell, "none", kept), { PATH: "/bin" });
  assert.deepEqual(environment(shell, "editor", kept), { PATH: "/bin" });
  assert.deepEqual(environment(shell, "configured", kept), { ...shell, OPENAI_API_KEY: "b" });
});

test("the variables of keys are those of the command line, and no folder turns a model on", () => {
  const table = readFileSync(here("../../../crates/llm/src/provider/mod.rs"), "utf8");
  assert.deepEqual([...new Set(table.match(/"[A-Z]+_API_KEY"/g))].sort(), KEYS.map((key) => `"${key}"`).sort());
  assert.equal(manifest.contributes.configuration.properties["scenelang.languageModel"].scope, "machine");
});

const range = (line, from = 0, to = 80) => ({ start: { line, character: from }, end: { line, character: to } });
const row = (id, state, objects, line = 0) => ({ id, text: id, uri: "file:///a.scene", range: range(line), state, margin: 0.1, unit: "m", objects });
const MAIN = "file:///a.scene";
const SCENE = {
  layout: null, data: null, holds: 1, total: 4,
  objects: [{ name: "lamp", range: range(1) }, { name: "chair[0]", range: range(2) }, { name: "chair[1]", range: range(2) }, { name: "rug", range: range(3) }],
  constraints: [row("a", "holds", ["lamp"], 5), row("b", "fails", ["lamp", "chair[1]"], 6), row("c", "unknown", [], 7), row("d", "holds", ["chair"], 8)],
};
const shape = (list) => list.map(({ name, state, constraints }) => [name, state, constraints.map(({ id }) => id).join("")]);

test("constraints by state, the worst first, and no empty groups", () => {
  assert.deepEqual(shape(groups(SCENE, "state")), [["Fails", "fails", "b"], ["Not checked", "unknown", "c"], ["Holds", "holds", "ad"]]);
  assert.deepEqual(groups({ ...SCENE, constraints: [] }, "state"), []);
});

test("constraints by object: an array's are those of its elements, what names none is listed too", () => {
  assert.deepEqual(shape(groups(SCENE, "object")), [["lamp", "fails", "ba"], ["chair[0]", "holds", "d"], ["chair[1]", "fails", "bd"], ["Other", "unknown", "c"]]);
});

test("a place in the text is an object, a constraint, or nothing", () => {
  const cases = [[6, 3, "lamp", "lamp"], [6, 3, "assert", "b"], [1, 0, "", "lamp"], [5, 0, "chairs", "a"], [20, 0, "chair[1]", "chair[1]"], [20, 0, "", null]];
  for (const [line, character, word, meant] of cases) assert.equal(at(SCENE, MAIN, MAIN, line, character, word), meant, `${line} ${word}`);
  assert.equal(at(SCENE, MAIN, "file:///other.scene", 6, 3, ""), null, "a constraint of another file");
});

test("`object desk[6]` declares all six, and is none of them", () => {
  const range = { start: { line: 2, character: 7 }, end: { line: 2, character: 11 } };
  const scene = { ...SCENE, objects: [{ name: "desk", range }] };
  for (const character of [7, 9, 11]) assert.equal(at(scene, MAIN, MAIN, 2, character, "desk[6]"), "desk");
  assert.equal(at(scene, MAIN, MAIN, 30, 9, "desk[5]"), "desk[5]", "elsewhere it is one of them");
  assert.equal(at(scene, MAIN, "file:///other.scene", 2, 9, "desk[5]"), "desk[5]", "another file declares something else there");
});

test("an address of a model is one that a key may travel to", () => {
  for (const good of ["https://models.example/v1", " https://x ", "http://localhost:8080/v1", "http://127.0.0.1/", "http://[::1]:1/"]) assert.equal(refusal(good), null, good);
  for (const [bad, why] of [["", /address/], ["models.example", /address/], ["http://models.example", /https/], ["file:///etc/passwd", /https/], ["javascript:1", /https/]]) assert.match(refusal(bad), why, bad);
});

test("a new program has a name that nothing has, and no folder in it", () => {
  const taken = (file) => file === "room.scene";
  for (const [name, why] of [["study", null], ["my room.scene", null], ["room", /there already/], ["room.scene", /there already/], [" ", /needed/], [".scene", /needed/], ["../x", /has none/], ["a\\b", /has none/]]) {
    const said = names.refusal(name, taken);
    if (why === null) assert.equal(said, null, name);
    else assert.match(said, why, name);
  }
  assert.deepEqual(["a", "a.scene", " b "].map(names.named), ["a.scene", "a.scene", "b.scene"]);
});

test("each example says in a sentence what it is", () => {
  for (const name of readdirSync(here("../../../examples")).filter((name) => name.endsWith(".scene"))) {
    const said = names.firstComment(readFileSync(here(`../../../examples/${name}`), "utf8"));
    assert.ok(said.length >= 8 && said.length < 300 && !said.includes("//"), `${name}: ${said}`);
  }
});

test("a request is shown with what became of each phrase, whatever its letters", () => {
  const request = "A café 🪑 with a desk. Cosy!";
  const bytes = (words) => ((at) => [at, at + Buffer.byteLength(words)])(Buffer.byteLength(request.slice(0, request.indexOf(words))));
  const outcome = {
    understood: 1, clauses: 2, words: { used: 2, all: 3, unused: [{ bytes: bytes("Cosy"), text: "Cosy" }] }, preferences: 1,
    read: [{ bytes: bytes("with a desk"), text: "", understood: true, became: ["object desk"] }, { bytes: bytes("Cosy!"), text: "", understood: false, became: [] }],
    notes: [], absent: [], inferred: ["object door: a room has one"],
  };
  const { text, marks } = marked(request, outcome);
  assert.equal(text, "A café 🪑 with a desk.\nCosy!\n\nAdded, though not said:\n  object door: a room has one\n");
  assert.deepEqual(marks.map(({ start, end, fate, lines }) => [text.slice(start, end), fate, lines.join()]), [["with a desk", "became", "object desk"], ["Cosy!", "lost", ""], ["Cosy", "lost", ""]]);
  assert.equal(summary(outcome), "understood 1 of 2 clauses; not used: “Cosy”; 1 statement became a preference, since not all can hold together.");
});

test("what was exported is opened, the picture first", () => {
  const found = results([".scenelang-manifest.json", "picture.png", "plan.png", "plan.svg", "preview.html", "room.glb", "unity"]);
  assert.deepEqual(found.map(({ label, file, where }) => `${label} ${file} ${where}`), ["Picture picture.png editor", "Floor Plan plan.png editor", "Page with the Room preview.html outside", "GLB room.glb outside", "Unity Project unity folder"]);
  assert.deepEqual(results(["notes.txt"]), []);
});

test("margins have a sign and a unit", () => {
  for (const [value, unit, text] of [[0.123, "m", "+0.12 m"], [-0.003, "m", "−3.0 mm"], [1.54, "deg", "+1.5°"], [-2, null, "−2"], [null, "m", ""], [-0.5, "m²", "−0.5 m²"]]) assert.equal(margin({ margin: value, unit }), text);
});

test("the page runs one script, and loads nothing else", () => {
  const text = page({ script: "https://x/viewer.js", nonce: "abc" });
  const policy = /Content-Security-Policy" content="([^"]*)"/.exec(text)[1];
  assert.match(policy, /^default-src 'none'; script-src 'nonce-abc';/);
  assert.doesNotMatch(policy, /unsafe|https?:|\*/);
  assert.deepEqual(text.match(/<script[^>]*>/g), ['<script nonce="abc" src="https://x/viewer.js">']);
});

test("a program is run, and ended when it is called off", async () => {
  const never = new AbortController().signal;
  assert.deepEqual(await run(process.execPath, ["-e", "console.log(process.cwd()); console.error(2); process.exit(3)"], folder, never), { code: 3, stdout: `${folder}\n`, stderr: "2\n" });
  await assert.rejects(run(join(folder, "nothing"), [], folder, never), /ENOENT/);
  const abort = new AbortController();
  const script = 'process.on("SIGINT", () => { console.log("told"); process.exit(130); }); require("fs").writeFileSync("up", ""); setInterval(() => {}, 1000)';
  const running = run(process.execPath, ["-e", script], folder, abort.signal);
  // Before that it would end without a word.
  while (!existsSync(join(folder, "up"))) await new Promise((done) => setTimeout(done, 20));
  abort.abort();
  const ended = await running;
  assert.deepEqual([ended.code, ended.stdout], [130, "told\n"]);
});

test("the archive is a zip that others read, with the bits of programs", () => {
  const files = [{ name: "a.txt", bytes: Buffer.from("a".repeat(1000)) }, { name: "deep/ä.txt", bytes: Buffer.from("") }, { name: "bin/run", bytes: Buffer.from("#!/bin/sh\n"), executable: true }];
  const archive = join(folder, "a.zip");
  writeFileSync(archive, zip(files));
  assert.ok(zip(files).equals(readFileSync(archive)), "the same each time");
  const out = join(folder, "out");
  const script = "import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; z.extractall(sys.argv[2]); print([oct(i.external_attr >> 16) for i in z.infolist()])";
  const modes = execFileSync("python3", ["-c", script, archive, out]).toString().trim();
  assert.equal(modes, "['0o100644', '0o100644', '0o100755']");
  for (const { name, bytes } of files) assert.ok(readFileSync(join(out, name)).equals(bytes), name);
});

test("what the manifest names is there, and what is registered is in it", () => {
  const code = readdirSync(here("../src")).map((name) => readFileSync(here(`../src/${name}`), "utf8")).join("\n");
  const registered = [...code.matchAll(/[^.]\bon\("(\w+)"/g)].map(([, name]) => `scenelang.${name}`).concat([...code.matchAll(/registerCommand\("([\w.]+)"/g)].map(([, name]) => name));
  const { commands, menus, configuration, languages, grammars, snippets, walkthroughs } = manifest.contributes;
  const named = commands.map(({ command }) => command);
  // Code lenses call it with what it shows; nobody can from the palette.
  assert.deepEqual([...named, "scenelang.show"].sort(), registered.sort());
  for (const { command } of Object.values(menus).flat()) assert.ok(named.includes(command), command);
  // The client registers what the server offers under the server's own names.
  for (const name of ["check", "solve", "repair", "repairAll"]) assert.ok(!registered.includes(`scenelang.${name}`), name);
  for (const name of [...code.matchAll(/affectsConfiguration\("([\w.]+)"|"(scenelang\.server\.path|scenelang\.languageModel)"/g)].map(([, a, b]) => a ?? b)) assert.ok(configuration.properties[name], name);
  const files = [...languages.flatMap(({ configuration, icon }) => [configuration, icon.light, icon.dark]), ...grammars.map(({ path }) => path), ...snippets.map(({ path }) => path), ...walkthroughs.flatMap(({ steps }) => steps.map(({ media }) => media.markdown)), manifest.icon];
  for (const file of files) assert.ok(statSync(here(`../${file}`)).isFile(), file);
  const readme = readFileSync(here("../README.md"), "utf8");
  for (const name of Object.keys(configuration.properties)) assert.ok(readme.includes(`\`${name}\``) || readme.includes(`\`${name.replace("scenelang.inlayHints", "")}\``), `${name} is documented`);
});

test("what a folder that is not trusted may not set is declared to the editor", () => {
  const { supported, restrictedConfigurations } = manifest.capabilities.untrustedWorkspaces;
  assert.equal(supported, "limited");
  // All that names a program, or says to whom something is sent.
  assert.deepEqual(restrictedConfigurations, ["scenelang.server.path", "scenelang.languageModel", "scenelang.model.name", "scenelang.model.baseUrl"]);
  for (const name of restrictedConfigurations) assert.ok(manifest.contributes.configuration.properties[name], name);
});

test("the problem matcher reads what the command line writes", () => {
  const { regexp, ...groups } = manifest.contributes.problemMatchers[0].pattern;
  const found = new RegExp(regexp).exec("rooms/a room.scene:12:3: error[V0102]: `a` overlaps `b` by 0.04 m (margin -0.041 m)");
  assert.deepEqual(Object.fromEntries(Object.entries(groups).map(([name, i]) => [name, found[i]])), {
    file: "rooms/a room.scene", line: "12", column: "3", severity: "error", code: "V0102", message: "`a` overlaps `b` by 0.04 m (margin -0.041 m)",
  });
  assert.equal(new RegExp(regexp).exec("a.layout.json: 18 of 22 assertions hold"), null);
});
