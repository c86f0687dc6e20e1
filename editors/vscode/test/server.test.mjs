// The extension with the server itself, in a real VS Code: an example is solved, something in it moved by hand, and what the
// editor then shows is read. Skipped where there is no editor or no server built.
// SHOTS names a folder for pictures; SCENELANG names the server, else it is the newest in target.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { lacking, open, sleep, until } from "./support/editor.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const server = process.env.SCENELANG ?? ["release", "debug"].map((kind) => here(`../../../target/${kind}/scenelang`)).filter((file) => existsSync(file)).sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];
const missing = lacking() ?? (server === undefined ? "no server in target; cargo build -p scenelang-cli makes one" : null);
const shots = process.env.SHOTS;
const ROOM = "meeting-room";

let folder;
let e;

before(async () => {
  if (missing !== null) return;
  folder = mkdtempSync(join(tmpdir(), "scenelang-server-"));
  const vsix = join(folder, "bundled.vsix");
  execFileSync(process.execPath, [here("../package.mjs"), vsix, "--server", server, "--target", "linux-x64"]);
  const workspace = join(folder, "rooms");
  execFileSync("mkdir", [workspace]);
  copyFileSync(here(`../../../examples/${ROOM}.scene`), join(workspace, `${ROOM}.scene`));
  execFileSync(server, ["solve", `${ROOM}.scene`], { cwd: workspace });
  const layout = join(workspace, `${ROOM}.layout.json`);
  const text = JSON.parse(readFileSync(layout, "utf8"));
  // A plant comes out of its corner.
  text.objects["plant[0]"].pos[0] += 0.6;
  writeFileSync(layout, JSON.stringify(text, null, 2));
  e = await open({ vsix, workspace, file: `${ROOM}.scene`, theme: process.env.THEME ?? "Default Dark Modern" });
});
after(async () => {
  await e?.close();
  if (folder !== undefined) rmSync(folder, { recursive: true, force: true });
});

function check(name, run) {
  test(name, { skip: missing ?? false }, async () => {
    if (missing !== null) assert.fail(missing);
    try {
      await run();
    } catch (error) {
      if (shots !== undefined) await e?.page.screenshot({ path: join(shots, "error.png") });
      throw error;
    }
  });
}

const shoot = async (name, pointer = "away") => {
  if (shots === undefined) return;
  // What is under the pointer tells its name, over other things; but a hover goes when the pointer does.
  if (pointer === "away") await e.page.mouse.move(2, 2);
  await sleep(1200);
  await e.page.screenshot({ path: join(shots, `${name}.png`) });
};
const command = (name, ...args) => e.api("return vscode.commands.executeCommand(args.name, ...args.args)", { name, args });
const begin = (name) => e.api("void vscode.commands.executeCommand(args.name)", { name });
const text = (name) => e.api("return (await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/' + args.name))).getText()", { name });
const show = (line, character = 0) =>
  e.api("const p = new vscode.Position(args.line, args.character); const e = await vscode.window.showTextDocument(vscode.Uri.file(args.ws + '/' + args.name), {viewColumn: 1, preview: false}); e.selection = new vscode.Selection(p, p); e.revealRange(new vscode.Range(p, p), 2)", { name: `${ROOM}.scene`, line, character });
const texts = (selector) => e.page.$$eval(selector, (all) => all.map((element) => element.innerText.replace(/\s+/g, " ").trim()));
const status = () => e.page.$eval('[id$="scenelang.status"]', (item) => item.innerText.trim());
const lineOf = async (words) => (await text(`${ROOM}.scene`)).split("\n").findIndex((line) => line.includes(words));
const counted = async () => /^(\d+)\/(\d+) hold$/.exec(await status())?.slice(1).map(Number);
const position = async (name) => JSON.parse(await text(`${ROOM}.layout.json`)).objects[name].pos;

async function room() {
  return until("the room in the preview", async () => {
    for (const frame of e.page.frames()) if (await frame.evaluate(() => window.scenelang?.ready === true).catch(() => false)) return frame;
    return null;
  });
}

check("what a layout breaks is underlined in the program, listed, counted and explained", async () => {
  const line = await lineOf("inCorner(p, room)");
  await show(line, 30);
  await until("a squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length > 0);
  await command("workbench.actions.view.problems");
  await until("a problem", async () => (await texts(".markers-panel .monaco-list-row")).some((row) => row.includes("must be at most 0")));
  await shoot("squiggle");
  await command("workbench.action.closePanel");
  const [holds, total] = await until("a count", counted);
  assert.ok(holds < total, `${holds} of ${total}`);
  await show(line, 30);
  await begin("editor.action.showHover");
  await until("a hover", async () => (await texts(".monaco-hover:not(.hidden) .hover-row")).some((row) => /plant\[0\]/.test(row)));
  await shoot("hover", "stays");
  await e.page.keyboard.press("Escape");
});

check("a category is shown with its picture and its usual size", async () => {
  const line = await lineOf('.category <- "');
  const at = (await text(`${ROOM}.scene`)).split("\n")[line].indexOf('"') + 2;
  await show(line, at);
  await begin("editor.action.showHover");
  await until("its size", async () => (await texts(".monaco-hover:not(.hidden) .hover-row")).some((row) => /usual size/.test(row)));
  await until("its picture", async () => (await e.page.$$eval(".monaco-hover:not(.hidden) img", (all) => all.some((img) => img.complete && img.naturalWidth === 176))));
  await shoot("category", "stays");
  await e.page.keyboard.press("Escape");
});

/** Text of one's own at the end of the program, for as long as something is done; nothing of it stays. */
async function withEnding(ending, act) {
  const before = await text(`${ROOM}.scene`);
  await e.api("const e = vscode.window.activeTextEditor; await e.edit((b) => b.insert(e.document.positionAt(e.document.getText().length), args.ending)); const end = e.document.positionAt(e.document.getText().length); e.selection = new vscode.Selection(end, end); e.revealRange(new vscode.Range(end, end), 2)", { ending });
  try {
    await act();
  } finally {
    await e.page.keyboard.press("Escape");
    await e.api("const e = vscode.window.activeTextEditor; await e.edit((b) => b.replace(new vscode.Range(0, 0, e.document.lineCount, 0), args.before)); await e.document.save()", { before });
  }
}
const offered = async () => (await texts(".suggest-widget.visible .monaco-list-row")).map((row) => row.split(" ")[0]);

check("what is completed at the end of a file fits where it stands", async () => {
  await show(0);
  // Within an expression there are names, and no statements.
  await withEnding("\nassert ", async () => {
    await begin("editor.action.triggerSuggest");
    const inside = await until("suggestions", async () => ((now) => now.length > 3 && now)(await offered()));
    for (const word of ["region", "import", "predicate", "prefer"]) assert.ok(!inside.includes(word), `${word}: ${inside}`);
  });
  await withEnding("\n@re", async () => {
    await begin("editor.action.triggerSuggest");
    await until("@req", async () => (await offered()).some((word) => /^@?req/.test(word)));
  });
});

check("a contradiction stays marked while one types elsewhere, and when program and layout are saved together", async () => {
  await show(0);
  const marks = () => e.api("return vscode.languages.getDiagnostics(vscode.window.activeTextEditor.document.uri).map((d) => d.code?.value ?? d.code)");
  const contradicts = async () => (await marks()).some((code) => /^E040/.test(String(code)));
  await withEnding("\nassert plant[0].top < 0.1 and plant[0].bottom > 0.2;", async () => {
    // Proofs are looked for in what is saved.
    await e.api("await vscode.window.activeTextEditor.document.save()");
    await until("the contradiction", contradicts);
    await e.page.keyboard.press("Enter");
    for (let i = 0; i < 20; i += 1) {
      assert.ok(await contradicts(), "after a newline");
      await sleep(100);
    }
    await e.api("const d = await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/' + args.layout)); const w = new vscode.WorkspaceEdit(); w.insert(d.uri, d.positionAt(d.getText().length), '\\n'); await vscode.workspace.applyEdit(w); await Promise.all([vscode.window.activeTextEditor.document.save(), d.save()])", { layout: `${ROOM}.layout.json` });
    for (let i = 0; i < 20; i += 1) {
      await sleep(100);
      if (i > 9) assert.ok(await contradicts(), "after saving both");
    }
  });
  await until("no contradiction", async () => !(await contradicts()));
});

check("a task is run, says how it went, and its findings are problems", async () => {
  await show(0);
  const marks = () => e.api("return vscode.languages.getDiagnostics(vscode.Uri.file(args.ws + '/' + args.name)).map((d) => [d.range.start.line, d.severity, d.message])", { name: `${ROOM}.scene` });
  const before = await marks();
  const run = (name) => e.api("const task = (await vscode.tasks.fetchTasks({type: 'scenelang'})).find((t) => t.name === args.name); const ended = new Promise((done) => vscode.tasks.onDidEndTaskProcess((e) => e.execution.task.name === args.name && done(e.exitCode))); await vscode.tasks.executeTask(task); return ended", { name });
  assert.equal(await run(`check ${ROOM}.layout.json`).catch(() => "no such task"), "no such task", "tasks are for programs");
  assert.equal(await run("check"), 1, "the whole folder: something fails in it");
  const found = await until("its findings", async () => ((now) => now.length > before.length && now)(await marks()));
  const line = await lineOf("inCorner(p, room)");
  assert.ok(found.filter(([at, severity]) => at === line && severity === 0).length >= 2, `of the server and of the task: ${JSON.stringify(found)}`);
  assert.equal(await run(`check ${ROOM}.scene`), 0, "the program by itself is sound");
  await command("workbench.action.closePanel");
});

check("the tree lists it, and the preview draws it", async () => {
  await command("scenelang.constraints.focus");
  await until("the tree", async () => (await texts(".pane-body .monaco-list-row")).some((row) => /inCorner/.test(row)));
  await command("scenelang.openPreview");
  const frame = await room();
  await until("a drawn room", () => frame.evaluate(() => /READY [1-9]/.test(document.title)));
  assert.ok((await frame.$$(".row.fails")).length > 0);
  await shoot("tree");
  await command("workbench.action.closeSidebar");
  await frame.evaluate(() => document.querySelector(".row.fails").click());
  await shoot("preview");
  await frame.evaluate(() => window.scenelang.select(null));
});

check("a plant is dragged, judged on its way, and the layout follows", async () => {
  const frame = await room();
  const canvas = await frame.$("canvas");
  const area = await canvas.boundingBox();
  const at = await until("the plant", async () => {
    for (let i = 0; i < 900; i += 1) {
      const [x, y] = [area.x + area.width * (0.02 + 0.032 * (i % 30)), area.y + area.height * (0.15 + 0.027 * Math.floor(i / 30))];
      await e.page.mouse.move(x, y);
      await frame.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      if ((await frame.$eval(".tip", (tip) => (tip.hidden ? null : tip.querySelector("strong").textContent))) === "plant[0]") return [x, y];
    }
    return null;
  });
  const [before, was] = [await position("plant[0]"), await text(`${ROOM}.layout.json`)];
  const margins = () => frame.$$eval(".row.fails .margin", (all) => all.map((margin) => margin.textContent).join());
  const told = await margins();
  await e.page.mouse.move(...at);
  await e.page.mouse.down();
  await e.page.mouse.move(at[0] + 12, at[1] + 8, { steps: 4 });
  await until("margins that follow", async () => (await margins()) !== told);
  assert.equal(await text(`${ROOM}.layout.json`), was, "nothing is written on the way");
  await e.page.mouse.up();
  const after = await until("an edit", async () => ((now) => now.join() !== before.join() && now)(await position("plant[0]")));
  assert.equal(after[1], before[1]);
  await command("workbench.action.files.saveAll");
});

check("the light bulb repairs it, and then all holds", async () => {
  const line = await lineOf("inCorner(p, room)");
  await show(line, 10);
  const titles = () => e.api("const e = vscode.window.activeTextEditor; return (await vscode.commands.executeCommand('vscode.executeCodeActionProvider', e.document.uri, e.selection)).map((a) => a.title)");
  await until("a repair", async () => (await titles()).some((title) => /^Repair/.test(title)));
  await until("the menu", async () => {
    if ((await texts(".action-widget .monaco-list-row")).some((row) => /^Repair/.test(row))) return true;
    await begin("editor.action.quickFix");
    await sleep(500);
    return false;
  });
  await shoot("repair");
  await until("the repair in focus", async () => {
    if ((await texts(".action-widget .monaco-list-row.focused"))[0] === "Repair this constraint") return true;
    await e.page.keyboard.press("ArrowDown");
    return false;
  });
  await e.page.keyboard.press("Enter");
  // It is shown before it is made.
  await until("a question", async () => (await texts(".quick-input-list .monaco-list-row"))[0]?.startsWith("Apply"));
  await until("ghosts", async () => (await (await room()).evaluate(() => window.scenelang.ghosts())).length > 0);
  await shoot("asked");
  await e.page.keyboard.press("Enter");
  const frame = await room();
  await until("that every assertion holds", () => frame.$eval(".headline", ({ textContent }) => ((n) => n !== null && n[1] === n[2])(/^(\d+) of (\d+) assertions hold$/.exec(textContent))), 60_000);
  await until("no squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length === 0);
  assert.match(await text(`${ROOM}.scene`), /assert forall p in plant: inCorner/, "the layout was repaired, not the program");
  await shoot("repaired");
});

check("the room is solved anew and exported; the server starts again when told to", async () => {
  const notices = async () => {
    if ((await e.page.$(".notifications-center.visible")) === null) await command("notifications.showList");
    return texts(".notifications-center .notification-list-item");
  };
  await show(0);
  await begin("scenelang.solveScene");
  await until("what it said", async () => (await notices()).some((notice) => /solved: /.test(notice)), 60_000);
  await command("notifications.clearAll");
  await begin("scenelang.exportScene");
  const plan = await until("the formats", async () => {
    for (const row of await e.page.$$(".quick-input-list .monaco-list-row")) if (/^plan/.test(await row.evaluate((e) => e.textContent))) return row;
  });
  await plan.click();
  await e.page.keyboard.press("Enter");
  await until("where to", async () => (await texts(".quick-input-list .monaco-list-row")).length === 2);
  await e.page.keyboard.press("Enter");
  await until("that it is written", async () => (await notices()).some((notice) => notice.includes("Written to")), 60_000);
  const written = e.path(`out/${ROOM}`);
  assert.ok(readdirSync(written).some((name) => name.endsWith(".glb")), readdirSync(written).join());
  // What was written is opened from where it is said.
  const button = await until("a button", async () => {
    for (const found of await e.page.$$(".notifications-center .notification-list-item .monaco-button")) if (/Open…/.test(await found.evaluate((e) => e.textContent))) return found;
  });
  await button.click();
  await until("the results", async () => (await texts(".quick-input-list .monaco-list-row")).some((row) => /^GLB/.test(row)));
  await e.page.keyboard.type("Floor Plan");
  await e.page.keyboard.press("Enter");
  await until("the plan", () => e.api("return vscode.window.tabGroups.activeTabGroup.activeTab?.label === 'plan.png'"));
  await shoot("exported");
  await show(0);
  await command("notifications.clearAll");
  await command("scenelang.restartServer");
  const [holds, total] = await until("a count", counted);
  assert.equal(holds, total);
});

check("nothing was asked of the network, and no script failed", () => {
  assert.deepEqual([...e.outside], []);
  assert.deepEqual(e.errors, []);
});
