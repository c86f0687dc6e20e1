// From an empty window to a room and out of it, in a real VS Code with the server itself: a sentence becomes a room, something is
// added by hand, something dragged, what that broke is repaired, and the room is exported; then a small program and an example.
// Skipped where there is no editor or no server built.
// SHOTS names a folder for pictures; SCENELANG names the server, else it is the newest in target.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { lacking, open, sleep, until } from "./support/editor.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const server = process.env.SCENELANG ?? ["release", "debug"].map((kind) => here(`../../../target/${kind}/scenelang`)).filter((file) => existsSync(file)).sort((a, b) => statSync(b).mtimeMs - statSync(a).mtimeMs)[0];
const missing = lacking() ?? (server === undefined ? "no server in target; cargo build -p scenelang-cli makes one" : null);
const shots = process.env.SHOTS;
const SENTENCE = "A study with a desk against a wall, a chair at the desk and two bookshelves. It feels snug.";

let folder;
let e;

before(async () => {
  if (missing !== null) return;
  folder = mkdtempSync(join(tmpdir(), "scenelang-start-"));
  const vsix = join(folder, "bundled.vsix");
  execFileSync(process.execPath, [here("../package.mjs"), vsix, "--server", server, "--target", "linux-x64"]);
  const workspace = join(folder, "empty");
  mkdirSync(workspace);
  e = await open({ vsix, workspace });
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

const shoot = async (name) => {
  if (shots === undefined) return;
  await e.page.mouse.move(2, 2);
  await sleep(1200);
  await e.page.screenshot({ path: join(shots, `${name}.png`) });
};
const command = (name) => e.api("return vscode.commands.executeCommand(args.name)", { name });
const begin = (name) => e.api("void vscode.commands.executeCommand(args.name)", { name });
const texts = (selector) => e.page.$$eval(selector, (all) => all.map((element) => element.innerText.replace(/\s+/g, " ").trim()));
const status = () => e.page.$eval('[id$="scenelang.status"]', (item) => item.innerText.trim()).catch(() => "");
const counted = async () => /^(\d+)\/(\d+) hold$/.exec(await status())?.slice(1).map(Number);
const active = () => e.api("return vscode.window.activeTextEditor?.document.uri.path.split('/').at(-1)");
const notices = async () => {
  if ((await e.page.$(".notifications-center.visible")) === null) await command("notifications.showList");
  return texts(".notifications-center .notification-list-item");
};
const rooms = async () => {
  let drawn = 0;
  for (const frame of e.page.frames()) if (await frame.evaluate(() => window.scenelang?.ready === true && /READY [1-9]/.test(document.title)).catch(() => false)) drawn += 1;
  return drawn;
};
const layout = (name) => JSON.parse(readFileSync(e.path(`${name}.layout.json`), "utf8"));

check("where nothing is open, the view offers what one can begin with", async () => {
  await command("scenelang.constraints.focus");
  await until("three buttons", async () => {
    const buttons = await texts(".pane-body .welcome-view-content .monaco-button");
    return ["New Scene", "New Scene from a Description", "Open Example"].every((words) => buttons.includes(words));
  });
  await shoot("empty");
});

check("a sentence becomes a program, a layout and a room, and each phrase says what became of it", async () => {
  const [button] = await e.page.$$("::-p-xpath(//a[contains(@class, 'monaco-button')][contains(., 'from a Description')])");
  await button.evaluate((element) => element.click());
  await until("the box", async () => (await texts(".quick-input-widget")).some((words) => words.includes("What is in the room")));
  await e.page.keyboard.type(SENTENCE);
  await shoot("sentence");
  await e.page.keyboard.press("Enter");
  await until("the program", async () => (await active()) === "room.scene", 120_000);
  const [holds, total] = await until("that all holds", async () => ((now) => now !== undefined && now[0] === now[1] && now)(await counted()), 120_000);
  assert.ok(total > 0, `${holds} of ${total}`);
  assert.ok(Object.keys(layout("room").objects).some((name) => /desk/.test(name)), "the layout is on disk, whole");
  await until("the room", async () => (await rooms()) === 1, 60_000);
  const request = () => e.api("const d = vscode.workspace.textDocuments.find((d) => d.uri.scheme === 'scenelang-request'); return d?.getText()");
  await until("the request", async () => /two bookshelves\.\nIt feels snug\./.test((await request()) ?? ""));
  await until("what was not used", async () => (await notices()).some((notice) => /understood \d+ of \d+ clauses?; not used: .*snug/.test(notice)));
  await command("notifications.clearAll");
  await command("workbench.action.closeSidebar");
  await shoot("described");
  assert.equal(await active(), "room.scene", "one goes on in the program");
  assert.equal(await e.api("return vscode.workspace.textDocuments.some((d) => d.isDirty)"), false, "nothing is left unsaved");
});

check("solving again leaves a room as it is, and warns of nothing", async () => {
  const before = layout("room");
  await begin("scenelang.solveScene");
  await until("what it said", async () => (await notices()).some((notice) => /solved: (\d+) of \1 hold, with everything where it was/.test(notice)), 120_000);
  assert.deepEqual(layout("room"), before);
  assert.ok((await notices()).every((notice) => !/did not apply/.test(notice)));
  await command("notifications.clearAll");
});

/** What is in the program, whether it is saved or not. */
const source = () => e.api("return vscode.workspace.textDocuments.find((d) => d.uri.path.endsWith('/room.scene')).getText()");
/** Opens the menu of the light bulb at some words of the program, and chooses the first row that fits. */
async function choose(words, row) {
  await e.api("const d = vscode.workspace.textDocuments.find((d) => d.uri.path.endsWith('/room.scene')); const e = await vscode.window.showTextDocument(d, vscode.ViewColumn.One); const p = d.positionAt(d.getText().lastIndexOf(args.words) + 1); e.selection = new vscode.Selection(p, p); e.revealRange(new vscode.Range(p, p), 2)", { words });
  const focused = async () => (await texts(".action-widget .monaco-list-row.focused"))[0];
  await until(`the menu with ${row}`, async () => {
    if ((await texts(".action-widget .monaco-list-row")).some((offered) => row.test(offered))) return true;
    // The server may not have judged the new text yet.
    await begin("editor.action.quickFix");
    await sleep(700);
    return false;
  });
  const menu = await texts(".action-widget .monaco-list-row");
  await until(`${row}`, async () => row.test((await focused()) ?? "") || (await e.page.keyboard.press("ArrowDown"), false));
  await e.page.keyboard.press("Enter");
  return menu;
}
/** Saves what Solve, Place and repairs have changed of the layout. */
const saved = () => e.api("return (await vscode.workspace.openTextDocument(vscode.Uri.file(args.file))).save()", { file: e.path("room.layout.json") });
/** The page of the preview, which is a frame in a frame. */
async function preview() {
  for (const frame of e.page.frames()) if (await frame.evaluate(() => window.scenelang?.ready === true).catch(() => false)) return frame;
  throw new Error("there is no preview");
}
/** Where an object can be seized in the preview: found as a user finds it, by its name under the pointer. */
async function pointed(name) {
  const frame = await preview();
  const area = await (await frame.$("canvas")).boundingBox();
  return until(`${name} under the pointer`, async () => {
    for (let i = 0; i < 2400; i += 1) {
      const [x, y] = [area.x + area.width * (0.03 + 0.0157 * (i % 60)), area.y + area.height * (0.03 + 0.0235 * Math.floor(i / 60))];
      await e.page.mouse.move(x, y);
      await frame.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      if ((await frame.$eval(".tip", (tip) => (tip.hidden ? null : tip.querySelector("strong").textContent))) === name) return [x, y];
    }
    return null;
  }, 240_000);
}
const ADDED = 'object plant;\nplant.category <- "potted plant";\nassert inside(plant, study);\nassert gap(plant, desk) <= 0.3;\n';

check("an object that is added by hand is placed, and nothing else moves", async () => {
  const before = layout("room");
  await e.api("const e = await vscode.window.showTextDocument(vscode.workspace.textDocuments.find((d) => d.uri.path.endsWith('/room.scene')), vscode.ViewColumn.One); await e.edit((b) => b.insert(new vscode.Position(e.document.lineCount, 0), args.text)); await e.document.save()", { text: `\n${ADDED}` });
  await choose("object plant", /^Place `plant`/);
  await until("that it is placed", async () => (await notices()).some((notice) => /placed `plant`: (\d+) of \1 hold/.test(notice)), 120_000);
  await saved();
  const after = await until("its place", () => ((now) => now.objects.plant !== undefined && now)(layout("room")));
  for (const [name, placed] of Object.entries(before.objects)) assert.deepEqual(after.objects[name].pos, placed.pos, name);
  await command("notifications.clearAll");
  await shoot("placed");
});

check("what is dragged away breaks a constraint, and the first repair that is offered brings it back", async () => {
  const before = layout("room").objects.plant.pos;
  const frame = await preview();
  await frame.evaluate(() => window.scenelang.select(null));
  const place = () => e.api("return JSON.parse((await vscode.workspace.openTextDocument(vscode.Uri.file(args.file))).getText()).objects.plant.pos", { file: e.path("room.layout.json") });
  // Away from the desk, in whatever direction that is on the screen.
  for (const [dx, dy] of [[-90, 25], [90, 25], [0, 70], [0, -70]]) {
    const [x, y] = await pointed("plant");
    await e.page.mouse.down();
    await e.page.mouse.move(x + dx, y + dy, { steps: 6 });
    await e.page.mouse.up();
    await until("an edit of the layout", async () => (await place()).some((v, i) => Math.abs(v - before[i]) > 0.01));
    if (await until("a verdict", async () => ((now) => now !== undefined && now[1] > 0 && now)(await counted())).then(async () => (await sleep(1500), (await e.page.$$(".editor-instance .squiggly-error")).length > 0))) break;
  }
  const [holds, total] = await until("that something fails", async () => ((now) => now !== undefined && now[0] < now[1] && now)(await counted()));
  await shoot("broken");
  const menu = await choose("gap(plant, desk)", /^(Move|Turn) `plant`/);
  assert.match(menu.filter((row) => !/^(Quick Fix|Fix)/.test(row))[0], /^Move `plant`/, menu.join("\n"));
  await until("a ghost", async () => (await frame.evaluate(() => window.scenelang.ghosts())).join() === "plant");
  await until("a question", async () => (await texts(".quick-input-list .monaco-list-row"))[0]?.startsWith("Apply"));
  await shoot("ghost");
  await e.page.keyboard.press("Enter");
  await until(`that all ${total} hold, not ${holds}`, async () => ((now) => now !== undefined && now[0] === now[1])(await counted()), 60_000);
  await until("no ghost", async () => (await frame.evaluate(() => window.scenelang.ghosts())).length === 0);
  await saved();
  await shoot("repaired");
  assert.ok((await source()).includes("assert gap(plant, desk) <= 0.3;"), "the layout was repaired, not the program");
});

check("the room is exported, and what was written is opened", async () => {
  await command("notifications.clearAll");
  await e.api("void vscode.commands.executeCommand('scenelang.exportScene', vscode.Uri.file(args.file))", { file: e.path("room.scene") });
  const rows = () => texts(".quick-input-list .monaco-list-row");
  await until("the formats", async () => (await rows()).some((row) => /^unity/.test(row)));
  await shoot("formats");
  await e.page.keyboard.press("Enter");
  await until("where to", async () => (await rows()).some((row) => /out\/room/.test(row)));
  await e.page.keyboard.press("Enter");
  await until("that it is written", async () => (await notices()).some((notice) => /Written to .*out\/room/.test(notice)), 180_000);
  for (const file of ["picture.png", "unity"]) assert.ok(existsSync(e.path(`out/room/${file}`)), file);
  assert.ok(readdirSync(e.path("out/room")).some((file) => file.endsWith(".glb")));
  await until("the button", async () => {
    const [button] = await e.page.$$("::-p-xpath(//div[contains(@class, 'notification-list-item')]//a[contains(., 'Open')])");
    await button.evaluate((element) => element.click());
    return true;
  });
  await until("what there is to open", async () => (await rows())[0]?.startsWith("Picture"));
  await e.page.keyboard.press("Enter");
  await until("the picture", async () => (await e.api("return vscode.window.tabGroups.activeTabGroup.activeTab?.label")) === "picture.png");
  await command("notifications.clearAll");
  await shoot("exported");
  await command("workbench.action.closeAllEditors");
});

check("a new program has a name of one's own", async () => {
  await begin("scenelang.newScene");
  await until("the box", async () => (await texts(".quick-input-widget")).some((words) => words.includes("The name of the program")));
  // What is there already is refused.
  await e.page.keyboard.type("room");
  await until("why not", async () => (await texts(".quick-input-widget")).some((words) => words.includes("room.scene is there already")));
  for (let i = 0; i < 4; i += 1) await e.page.keyboard.press("Backspace");
  await e.page.keyboard.type("study");
  await e.page.keyboard.press("Enter");
  await until("the program", async () => (await active()) === "study.scene", 60_000);
  await until("that all holds", async () => ((now) => now !== undefined && now[0] === now[1])(await counted()), 120_000);
  await command("workbench.action.closeAllEditors");
});

check("an example is a copy of one's own, with its room", async () => {
  await begin("scenelang.openExample");
  await until("the examples", async () => (await texts(".quick-input-list .monaco-list-row")).some((row) => /^bedroom/.test(row)));
  await shoot("examples");
  await e.page.keyboard.type("bedroom");
  await until("one of them", async () => (await texts(".quick-input-list .monaco-list-row")).length === 1);
  await e.page.keyboard.press("Enter");
  await until("the program", async () => (await active()) === "bedroom.scene", 60_000);
  await until("a count", counted, 120_000);
  await until("the room", async () => (await rooms()) === 1, 60_000);
  assert.ok(existsSync(e.path("bedroom.scene")) && existsSync(e.path("bedroom.layout.json")));
  await command("notifications.clearAll");
  await shoot("example");
});

check("a program without a layout is shown all the same, and written when it is solved", async () => {
  await command("workbench.action.closeAllEditors");
  writeFileSync(e.path("bare.scene"), 'region r;\nr.pos <- vec3(0, 0, 0);\nr.scale <- vec3(3, 2.5, 3);\nobject chair;\nchair.category <- "chair";\nassert inside(chair, r);\n');
  await e.api("await vscode.window.showTextDocument(vscode.Uri.file(args.file))", { file: e.path("bare.scene") });
  await begin("scenelang.openPreview");
  await until("the room", async () => (await rooms()) === 1, 60_000);
  const notice = async () => {
    const told = await Promise.all(e.page.frames().map((frame) => frame.evaluate(() => document.querySelector(".notice:not([hidden])")?.textContent ?? "").catch(() => "")));
    return told.some((words) => words.includes("provisional"));
  };
  await until("that it is provisional", notice, 60_000);
  await shoot("provisional");
  assert.ok(!existsSync(e.path("bare.layout.json")), "nothing is written");
  await begin("scenelang.solveScene");
  await until("the layout", async () => existsSync(e.path("bare.layout.json")), 120_000);
  await until("that it is no longer provisional", async () => !(await notice()), 60_000);
  await command("notifications.clearAll");
});

check("the key of a service that is not listed: its address and its model are asked for, too", async () => {
  const box = () => texts(".quick-input-widget").then((all) => all.join(" "));
  const answer = async (asked, text) => {
    await until(asked, async () => (await box()).includes(asked));
    await e.page.keyboard.type(text);
    await e.page.keyboard.press("Enter");
  };
  await begin("scenelang.setKey");
  await until("whose", async () => (await texts(".quick-input-list .monaco-list-row")).some((row) => row.startsWith("Another that speaks like OpenAI")));
  await e.page.keyboard.type("Another");
  await e.page.keyboard.press("Enter");
  await answer("Where is the model?", "http://127.0.0.1:9/v1");
  await answer("What is the model called there?", "qwen3-32b");
  await until("the box", () => e.page.$eval(".quick-input-widget input", ({ type }) => type === "password"));
  await shoot("key");
  await e.page.keyboard.type("sk-of-a-test");
  await e.page.keyboard.press("Enter");
  const kept = () => e.api("const all = vscode.workspace.getConfiguration('scenelang'); return [all.get('model.baseUrl'), all.get('model.name')]");
  await until("both settings", async () => (await kept()).join(" ") === "http://127.0.0.1:9/v1 compatible:qwen3-32b");
  assert.throws(() => execFileSync("grep", ["-rl", "sk-of-a-test", folder, "--include=*.json", "--include=*.log"]), "no setting and no log has it");
});

check("where the model cannot be used, the room is solved all the same", async () => {
  const set = (name, value) => e.api("await vscode.workspace.getConfiguration('scenelang').update(args.name, args.value, 1)", { name, value });
  await command("workbench.action.closeAllEditors");
  // A model whose key nobody has given.
  await set("model.baseUrl", undefined);
  await set("model.name", "openai:some-model");
  await set("languageModel", "configured");
  writeFileSync(e.path("keyless.scene"), 'region r;\nr.pos <- vec3(0, 0, 0);\nr.scale <- vec3(3, 2.5, 3);\nobject chair;\nchair.category <- "chair";\nassert inside(chair, r);\n');
  await e.api("await vscode.window.showTextDocument(vscode.Uri.file(args.file))", { file: e.path("keyless.scene") });
  await until("the server", async () => (await status()) !== "", 60_000);
  await begin("scenelang.solveScene");
  await until("the layout", async () => existsSync(e.path("keyless.layout.json")), 120_000);
  await until("that all holds", async () => ((now) => now !== undefined && now[0] === now[1])(await counted()), 120_000);
  await shoot("keyless");
  await set("languageModel", undefined);
  await set("model.name", undefined);
  await command("notifications.clearAll");
});

check("nothing was asked of the network, and no script failed", () => {
  assert.deepEqual([...e.outside], []);
  assert.deepEqual(e.errors, []);
});
