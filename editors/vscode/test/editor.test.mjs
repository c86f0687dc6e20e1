// The extension in a real VS Code, installed from the .vsix, on a server that plays the contract (`fake/scenelang`). What is
// read is what is drawn, and what the editor's own API says. Skipped where there is no editor.
// SHOTS names a folder for pictures of each step.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { lacking, open, sleep, until } from "./support/editor.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const missing = lacking();
const shots = process.env.SHOTS;
const LIMIT = 3 << 20;

let folder;
let vsix;
/** The editor of most tests. */
let editor;

before(async () => {
  if (missing !== null) return;
  folder = mkdtempSync(join(tmpdir(), "scenelang-vsix-"));
  const pack = (name, ...options) => (execFileSync(process.execPath, [here("../package.mjs"), join(folder, name), ...options]), join(folder, name));
  vsix = { bare: pack("bare.vsix"), bundled: pack("bundled.vsix", "--server", here("fake/scenelang"), "--target", "linux-x64") };
  editor = await open({ vsix: vsix.bundled, workspace: here("workspace"), file: "meeting.scene", env: environment("main") });
});
after(async () => {
  await editor?.close();
  if (folder !== undefined) rmSync(folder, { recursive: true, force: true });
});

/** For the fake server, which is far from its files when it is in an extension. */
function environment(log) {
  return { FAKE_MODULES: here("fake"), FAKE_ROOM: here("../../../viewer/test/fixture.mjs"), FAKE_LOG: join(folder, `${log}.log`) };
}
const logged = (log) => (existsSync(join(folder, `${log}.log`)) ? readFileSync(join(folder, `${log}.log`), "utf8").trim().split("\n").map((line) => JSON.parse(line)) : []);

function check(name, run) {
  test(name, { skip: missing ?? false }, async () => {
    if (missing !== null) assert.fail(missing);
    try {
      await run(editor);
    } catch (error) {
      if (shots !== undefined) await editor?.page.screenshot({ path: join(shots, "error.png") });
      throw error;
    }
  });
}

const shoot = async (name, { page } = editor) => {
  if (shots !== undefined) await page.screenshot({ path: join(shots, `${name}.png`) });
};
const command = ({ api }, name, ...args) => api("return vscode.commands.executeCommand(args.name, ...args.args)", { name, args });
/** Begins a command that ends only when the user has answered. */
const begin = ({ api }, name, ...args) => api("void vscode.commands.executeCommand(args.name, ...args.args)", { name, args });
const text = ({ api }, name) => api("return (await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/' + args.name))).getText()", { name });
const show = ({ api }, name, line = 0, character = 0) =>
  api("const p = new vscode.Position(args.line, args.character); const e = await vscode.window.showTextDocument(vscode.Uri.file(args.ws + '/' + args.name), {viewColumn: 1, preview: false}); e.selection = new vscode.Selection(p, p); e.revealRange(new vscode.Range(p, p), 2)", { name, line, character });
const lineOf = async (e, words) => (await text(e, "meeting.scene")).split("\n").findIndex((line) => line.includes(words));
const texts = ({ page }, selector) => page.$$eval(selector, (all) => all.map((e) => e.innerText.replace(/\s+/g, " ").trim()));
const status = async ({ page }) => page.$eval('[id$="scenelang.status"]', (e) => e.innerText.trim());
const notices = async (e) => {
  const selector = ".notifications-center .notification-list-item";
  // Toasts go away by themselves.
  if ((await e.page.$(".notifications-center.visible")) === null) await command(e, "notifications.showList");
  return texts(e, selector);
};

/** Presses a button of a notification; where it is on the screen may change at any moment, so the pointer could miss it. */
const press = ({ page }, words) =>
  until(`the button "${words}"`, async () => {
    const [button] = await page.$$(`::-p-xpath(//div[contains(@class, 'notification-list-item')]//a[contains(., '${words}')])`);
    await button.evaluate((element) => element.click());
    return true;
  });

/** The page of the preview, which is a frame in a frame. */
async function room({ page }) {
  return until("the room in the preview", async () => {
    for (const frame of page.frames()) if (await frame.evaluate(() => window.scenelang?.ready === true).catch(() => false)) return frame;
    return null;
  });
}

/** Where in the preview the pointer is on an object, and its name: found as a user finds it. */
async function pointed({ page }, frame, name) {
  const area = await (await frame.$("canvas")).boundingBox();
  return until(`the pointer on ${name}`, async () => {
    for (let i = 0; i < 600; i += 1) {
      const at = [area.x + area.width * (0.05 + 0.03 * (i % 30)), area.y + area.height * (0.05 + 0.045 * Math.floor(i / 30))];
      await page.mouse.move(...at);
      await frame.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      const found = await frame.$eval(".tip", (tip) => (tip.hidden ? "" : tip.querySelector("strong").textContent));
      if (name.test(found)) return { at, name: found };
    }
    return null;
  });
}

check("the package is small, and the same each time", async () => {
  assert.ok(statSync(vsix.bare).size <= LIMIT, `${statSync(vsix.bare).size} bytes`);
  const again = join(folder, "again.vsix");
  execFileSync(process.execPath, [here("../package.mjs"), again]);
  assert.ok(readFileSync(again).equals(readFileSync(vsix.bare)));
});

check("a constraint that fails has a squiggle, a row among the problems, and a hover", async (e) => {
  const line = await lineOf(e, "distance(lamp");
  await until("a squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length > 0);
  await command(e, "workbench.actions.view.problems");
  await until("a problem", async () => (await texts(e, ".markers-panel .monaco-list-row")).some((row) => row.includes("at most 3.20 m")));
  await shoot("squiggle");
  await command(e, "workbench.action.closePanel");
  await show(e, "meeting.scene", line, 10);
  await begin(e, "editor.action.showHover");
  await until("a hover", async () => (await texts(e, ".monaco-hover:not(.hidden) .hover-row")).some((row) => row.includes("margin -0.")));
  await shoot("hover");
  await e.page.keyboard.press("Escape");
});

check("the status bar counts what holds", async (e) => {
  await until("8/11", async () => (await status(e)) === "8/11 hold");
});

check("the status bar counts for each program, whichever was opened first", async (e) => {
  await command(e, "workbench.view.explorer");
  writeFileSync(e.path("other.scene"), readFileSync(e.path("meeting.scene")));
  // It is judged while nobody looks at it.
  const marks = () => e.api("const d = await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/other.scene')); return vscode.languages.getDiagnostics(d.uri).length");
  await until("its verdict", async () => (await marks()) > 0);
  await show(e, "other.scene");
  await until("its count", async () => (await status(e)) === "8/11 hold");
  await command(e, "workbench.action.closeActiveEditor");
  await show(e, "meeting.scene");
  await until("the count of the first", async () => (await status(e)) === "8/11 hold");
});

check("the tree shows the constraints by state and by object, and leads to the text", async (e) => {
  const rows = () => texts(e, '[id="workbench.view.extension.scenelang"] .monaco-list-row, .pane-body .monaco-list-row');
  await command(e, "scenelang.constraints.focus");
  await until("groups by state", async () => (await rows()).some((row) => row.startsWith("Fails")));
  assert.ok((await rows()).some((row) => /−0\.\d\d m distance\(lamp, plant\) <= 3\.2/.test(row)), (await rows()).join("\n"));
  await shoot("tree");
  const line = await lineOf(e, "distance(lamp");
  await until("the line in the text", async () => {
    // Rows move while the tree is being filled, and another may be under the pointer.
    const [row] = await e.page.$$("::-p-xpath(//div[contains(concat(' ', @class, ' '), ' monaco-list-row ')][contains(., 'distance(lamp')])");
    await row.click();
    await sleep(300);
    return (await e.api("return vscode.window.activeTextEditor?.selection.start.line")) === line;
  });
  await command(e, "scenelang.treeByObject");
  await until("groups by object", async () => (await rows()).some((row) => /^lamp ?0\/1/.test(row)));
  await shoot("tree-by-object");
  await command(e, "scenelang.treeByState");
  await command(e, "workbench.view.explorer");
});

check("the preview shows the room; what is pressed is shown in the text, where the cursor is in the room", async (e) => {
  await show(e, "meeting.scene", 0);
  await command(e, "scenelang.openPreview");
  const frame = await room(e);
  await until("a drawn room", () => frame.evaluate(() => /READY [1-9]/.test(document.title)));
  await shoot("preview");
  await frame.click('[data-row="5"]');
  const line = await lineOf(e, "distance(lamp");
  await until("the statement", async () => (await e.api("return vscode.window.visibleTextEditors[0]?.selection.start.line")) === line);
  await frame.evaluate(() => window.scenelang.select(null));
  await show(e, "meeting.scene", await lineOf(e, "object sofa"), 8);
  await until("the sofa selected", async () => (await frame.evaluate(() => window.scenelang.selected())).join() === "sofa");
  await show(e, "meeting.scene", line, 3);
  await until("what the constraint speaks of", async () => (await frame.evaluate(() => window.scenelang.selected())).join() === "lamp,plant");
});

check("one chair of six that is pressed stays selected; its declaration speaks of all six", async (e) => {
  const frame = await room(e);
  const { name: found } = await pointed(e, frame, /^chair\[\d\]$/);
  await e.page.mouse.down();
  await e.page.mouse.up();
  const line = await lineOf(e, "object chair[6]");
  await until("its declaration", async () => (await e.api("return vscode.window.visibleTextEditors[0]?.selection.start.line")) === line);
  const selected = async () => (await frame.evaluate(() => window.scenelang.selected())).join();
  // What the editor says of its selection comes later.
  await sleep(1000);
  assert.equal(await selected(), found);
  await frame.evaluate(() => window.scenelang.select(null));
  await show(e, "meeting.scene", line, 9);
  await until("all six", async () => (await selected()).split(",").filter((name) => name.startsWith("chair[")).length === 6);
  await shoot("array");
});

check("the preview comes back when the window is loaded anew, and still follows the text", async (e) => {
  await show(e, "meeting.scene", 0);
  const old = e.page.frames();
  // What is open is written down now and then.
  const written = async () => {
    const told = [];
    for (const { name } of (await indexedDB.databases()).filter(({ name }) => name.startsWith("vscode-web-state-db-"))) {
      const answer = (request) => new Promise((done, failed) => Object.assign(request, { onsuccess: () => done(request.result), onerror: () => failed(request.error) }));
      const base = await answer(indexedDB.open(name));
      told.push(...(await answer(base.transaction("ItemTable").objectStore("ItemTable").getAll())));
      base.close();
    }
    return told.some((value) => /scenelang\.preview.*uri[\\":]+file:/s.test(String(value)));
  };
  await until("that the panel is written down", () => e.page.evaluate(written));
  // Where the address names a file to open, an editor opens that and nothing from before.
  const address = new URL(e.page.url());
  address.searchParams.set("payload", JSON.stringify(JSON.parse(address.searchParams.get("payload")).filter(([name]) => name !== "openFile")));
  await e.page.goto(address.href);
  const frame = await until("the room again", async () => {
    for (const frame of e.page.frames()) if (!old.includes(frame) && (await frame.evaluate(() => window.scenelang?.ready === true && /READY [1-9]/.test(document.title)).catch(() => false))) return frame;
    return null;
  });
  await until("the probe", () => e.api("return true"));
  await show(e, "meeting.scene", await lineOf(e, "object sofa"), 8);
  await until("the sofa selected", async () => (await frame.evaluate(() => window.scenelang.selected())).join() === "sofa");
  await command(e, "scenelang.openPreview");
  assert.equal((await texts(e, ".tab")).filter((tab) => tab.startsWith("Preview")).length, 1, "there is one panel, not another beside it");
});

check("what is dragged changes the layout, and can be undone there", async (e) => {
  const frame = await room(e);
  await frame.evaluate(() => window.scenelang.select(null));
  const { at } = await pointed(e, frame, /^plant$/);
  const verdict = () => frame.$eval('[data-row="5"] .margin', (margin) => margin.textContent);
  const before = await verdict();
  await e.page.mouse.move(...at);
  await e.page.mouse.down();
  await e.page.mouse.move(at[0] - 15, at[1] + 5, { steps: 4 });
  await until("a margin that follows", async () => (await verdict()) !== before);
  await shoot("drag");
  const written = await text(e, "meeting.layout.json");
  assert.equal(JSON.parse(written).objects.plant, undefined, "nothing is written on the way");
  await e.page.mouse.up();
  const layout = await until("an edit of the layout", async () => ((now) => now !== written && now)(await text(e, "meeting.layout.json")));
  const { pos } = JSON.parse(layout).objects.plant;
  assert.notDeepEqual(pos, [4.78, 0, 3.75]);
  assert.equal(pos[1], 0);
  await show(e, "meeting.layout.json");
  await command(e, "undo");
  await until("the layout as it was", async () => (await text(e, "meeting.layout.json")) === written);
  await until("the room as it was", async () => (await verdict()) === before);
});

check("the light bulb repairs a constraint", async (e) => {
  const line = await lineOf(e, "distance(lamp");
  await show(e, "meeting.scene", line, 10);
  await until("an action", async () => (await e.api("const e = vscode.window.activeTextEditor; return (await vscode.commands.executeCommand('vscode.executeCodeActionProvider', e.document.uri, e.selection)).map((a) => a.title)")).includes("Repair this constraint"));
  await e.page.keyboard.down("Control");
  await e.page.keyboard.press(".");
  await e.page.keyboard.up("Control");
  await until("the menu", async () => (await texts(e, ".action-widget .monaco-list-row")).includes("Repair this constraint"));
  await shoot("repair");
  const [row] = await e.page.$$("::-p-xpath(//div[contains(@class, 'action-widget')]//div[contains(concat(@class, ' '), 'monaco-list-row ')][contains(., 'Repair this')])");
  await row.click();
  await until("a ghost", async () => (await (await room(e)).evaluate(() => window.scenelang.ghosts())).join() === "plant");
  await until("a question", async () => (await texts(e, ".quick-input-list .monaco-list-row"))[0]?.startsWith("Apply"));
  assert.match((await texts(e, ".quick-input-list .monaco-list-row"))[0], /Move `plant` 0.45 m south.*→/, "what moves, and which margins change");
  await shoot("proposed");
  await e.page.keyboard.press("Enter");
  await until("no squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length === 0);
  await until("9/11", async () => (await status(e)) === "9/11 hold");
  const frame = await room(e);
  assert.equal(await frame.$('[data-row="5"].fails'), null);
});

check("what a repair would move is shown in the preview, and asks before it is made", async (e) => {
  const frame = await room(e);
  const ghosts = () => frame.evaluate(() => window.scenelang.ghosts());
  await e.api("const d = await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/meeting.layout.json')); const w = new vscode.WorkspaceEdit(); w.replace(d.uri, new vscode.Range(0, 0, d.lineCount, 0), '{}'); await vscode.workspace.applyEdit(w)");
  await show(e, "meeting.scene", await lineOf(e, "distance(lamp"), 10);
  await until("a squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length > 0);
  const before = await text(e, "meeting.layout.json");
  await command(e, "notifications.clearAll");
  await until("the menu", async () => {
    if ((await texts(e, ".action-widget .monaco-list-row")).some((row) => row.startsWith("Move `plant`"))) return true;
    // The server may not have marked the new text yet.
    await begin(e, "editor.action.quickFix");
    await sleep(500);
    return false;
  });
  await until("the move", async () => (await texts(e, ".action-widget .monaco-list-row.focused"))[0]?.startsWith("Move `plant`") || (await e.page.keyboard.press("ArrowDown"), false));
  await e.page.keyboard.press("Enter");
  await until("a ghost", async () => (await ghosts()).join() === "plant");
  await until("a question", async () => (await texts(e, ".quick-input-list .monaco-list-row"))[0]?.startsWith("Apply"));
  await until("the difference", async () => (await e.page.$$(".diff-editor, .monaco-diff-editor")).length > 0);
  await shoot("ghost");
  assert.equal(await text(e, "meeting.layout.json"), before, "nothing is done yet");
  await e.page.keyboard.press("Escape");
  await until("no ghost", async () => (await ghosts()).length === 0);
  assert.equal(await text(e, "meeting.layout.json"), before, "nothing is done after all");
  assert.equal((await e.page.$$(".monaco-diff-editor")).length, 0);
  await show(e, "meeting.layout.json");
  await command(e, "undo");
  await until("9/11", async () => (await status(e)) === "9/11 hold");
});

check("what was chosen and cannot be done is said", async (e) => {
  await e.api("const d = await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/meeting.layout.json')); const w = new vscode.WorkspaceEdit(); w.replace(d.uri, new vscode.Range(0, 0, d.lineCount, 0), '{}'); await vscode.workspace.applyEdit(w)");
  await show(e, "meeting.scene", await lineOf(e, "distance(lamp"), 10);
  await until("a squiggle", async () => (await e.page.$$(".editor-instance .squiggly-error")).length > 0);
  await command(e, "notifications.clearAll");
  await e.page.keyboard.down("Control");
  await e.page.keyboard.press(".");
  await e.page.keyboard.up("Control");
  await until("the menu", async () => (await texts(e, ".action-widget .monaco-list-row")).some((row) => row.startsWith("Change the program")));
  await e.page.keyboard.press("ArrowDown");
  await until("the other action", async () => (await texts(e, ".action-widget .monaco-list-row.focused"))[0] === "Change the program so that this holds" || (await e.page.keyboard.press("ArrowDown"), false));
  await e.page.keyboard.press("Enter");
  await until("why", async () => (await notices(e)).some((notice) => notice.includes("no number was found whose change would repair it")));
  await shoot("refused");
  await command(e, "notifications.clearAll");
  await show(e, "meeting.layout.json");
  await command(e, "undo");
  await until("9/11", async () => (await status(e)) === "9/11 hold");
});

check("commands of the palette speak to the server; a broken program leaves the last room", async (e) => {
  await show(e, "meeting.scene");
  await command(e, "scenelang.checkScene");
  await until("what it said", async () => (await notices(e)).some((notice) => notice.includes("9 of 11 hold")));
  await command(e, "notifications.clearAll");
  await e.api("await vscode.window.activeTextEditor.edit((b) => b.insert(new vscode.Position(0, 0), 'oops\\n'))");
  const frame = await room(e);
  await until("why it is old", () => frame.$eval(".notice", (notice) => !notice.hidden && /does not compile/.test(notice.textContent)));
  await command(e, "undo");
  await until("the room again", () => frame.$eval(".notice", (notice) => notice.hidden));
});

check("an object is locked in the tree, and stays; of alternatives one is chosen", async (e) => {
  await show(e, "meeting.scene");
  const uri = await e.api("return vscode.window.activeTextEditor.document.uri.toString()");
  const asked = (name) => logged("main").filter(({ asked }) => asked === name).map(({ argument }) => argument);
  const rows = () => texts(e, '.pane-body .monaco-list-row');
  await command(e, "scenelang.constraints.focus");
  await command(e, "scenelang.treeByObject");
  await command(e, "scenelang.lockObject", { object: "lamp", uri });
  await until("the lock", async () => (await rows()).some((row) => /^lamp.*locked/.test(row)));
  await shoot("locked");
  const locked = () => logged("main").filter(({ locked }) => locked !== undefined).at(-1)?.locked.join();
  await until("that the server knows", () => locked() === "lamp");
  await command(e, "scenelang.solveObject", { object: "plant", uri });
  await until("a solution of one object", () => asked("scenelang.solve").some(({ only }) => only?.join() === "plant"));
  await command(e, "scenelang.unlockObject", { object: "lamp", uri });
  await until("no lock", async () => (await rows()).every((row) => !/locked/.test(row)));
  await until("that the server knows of none", () => locked() === "");
  await command(e, "scenelang.treeByState");
  await command(e, "scenelang.showAlternatives");
  const frame = await until("the alternatives", async () => {
    for (const frame of e.page.frames()) if ((await frame.$("button[data-seed]").catch(() => null)) !== null) return frame;
    return null;
  });
  assert.equal(await frame.$$eval("img", (all) => all.filter((img) => img.complete && img.naturalWidth > 0).length), 1);
  await shoot("alternatives");
  await frame.$eval('button[data-seed="2"]', (button) => button.click());
  await until("the one that was chosen", () => asked("scenelang.solveAnew").some(({ seed }) => seed === 2));
  await command(e, "notifications.clearAll");
  await command(e, "workbench.view.explorer");
});

check("the menu of the preview locks what the pointer is on", async (e) => {
  await show(e, "meeting.scene");
  const uri = await e.api("return vscode.window.activeTextEditor.document.uri.toString()");
  await command(e, "scenelang.openPreview");
  const frame = await room(e);
  const { at } = await pointed(e, frame, /^plant$/);
  await e.page.mouse.click(...at, { button: "right" });
  // Menus are in a tree of their own.
  const entry = (words) => e.page.$$eval(">>> .monaco-menu .action-label", (all, words) => all.map((label) => label.textContent).filter((text) => words.includes(text)), words);
  await until("the menu", async () => (await entry(["Solve Only This", "Lock"])).length === 2);
  await shoot("menu");
  const [lock] = await e.page.$$(">>> .monaco-menu .action-label[aria-label='Lock']");
  await lock.click();
  const locked = () => logged("main").filter(({ locked }) => locked !== undefined).at(-1)?.locked.join();
  await until("that the server knows", () => locked() === "plant");
  await command(e, "scenelang.unlockObject", { object: "plant", uri });
  await until("that the server knows of none", () => locked() === "");
});

check("intermediate forms are shown beside, and follow the text", async (e) => {
  await show(e, "meeting.scene");
  await begin(e, "scenelang.showForms");
  await until("the question", async () => (await texts(e, ".quick-input-list .monaco-list-row")).some((row) => row.startsWith("hir")));
  await e.page.keyboard.type("hir");
  await e.page.keyboard.press("Enter");
  const form = () => e.api("return vscode.workspace.textDocuments.find((d) => d.uri.scheme === 'scenelang-form')?.getText()");
  await until("the form", async () => (await form())?.startsWith("hir of file:///"));
  await e.api("const d = await vscode.workspace.openTextDocument(vscode.Uri.file(args.ws + '/meeting.scene')); const w = new vscode.WorkspaceEdit(); w.insert(d.uri, new vscode.Position(0, 0), '// newer\\n'); await vscode.workspace.applyEdit(w)");
  await until("the newer form", async () => (await form())?.includes("// newer"));
  await command(e, "workbench.action.closeActiveEditor");
});

check("building shows progress, and ends when it is called off", async (e) => {
  await show(e, "meeting.scene");
  const build = async () => {
    await begin(e, "scenelang.synthScene");
    await until("where to", async () => (await texts(e, ".quick-input-list .monaco-list-row")).length === 2);
    await e.page.keyboard.press("Enter");
  };
  await build();
  await until("that it is written", async () => (await notices(e)).some((notice) => notice.includes("Written to")));
  assert.ok(existsSync(e.path("out/meeting/made")));
  await command(e, "notifications.clearAll");
  writeFileSync(e.path("slow"), "");
  await build();
  await until("progress", async () => (await notices(e)).some((notice) => notice.includes("Building meeting.scene")));
  // A program that has hardly begun ends without a word.
  await until("the builder", () => logged("main").filter(({ ran }) => ran === "synth").length === 2);
  await press(e, "Cancel");
  await until("its end", () => logged("main").some(({ ended }) => ended === "SIGINT"));
  rmSync(e.path("slow"));
});

check("there are tasks for the folder and for the program", async (e) => {
  await show(e, "meeting.scene");
  const tasks = () => e.api("return (await vscode.tasks.fetchTasks({type: 'scenelang'})).map((t) => [t.name, t.execution.args.join(' '), t.problemMatchers.join()])");
  assert.deepEqual(await until("tasks", async () => ((found) => found.length > 0 && found)(await tasks())), [
    ["check", "check . --verbosity compact", "$scenelang"],
    ["check meeting.scene", "check meeting.scene --verbosity compact", "$scenelang"],
    ["solve meeting.scene", "solve meeting.scene", "$scenelang"],
    ["synth meeting.scene", "synth meeting.scene", "$scenelang"],
  ]);
});

check("fenced programs in Markdown have colours", async (e) => {
  writeFileSync(e.path("notes.md"), "```scene\nobject first;\n```\n\n```other\nobject second;\n```\n");
  await show(e, "notes.md");
  const pieces = (word) => e.page.$$eval(".view-line", (lines, word) => lines.filter((line) => line.innerText.includes(word)).map((line) => line.querySelectorAll("span > span").length)[0], word);
  await until("pieces of several colours", async () => (await pieces("first")) >= 2);
  assert.equal(await pieces("second"), 1, "what is no program has one");
  await command(e, "workbench.action.closeActiveEditor");
});

check("without a server it says so, and how to name one", async () => {
  const other = await open({ vsix: vsix.bare, workspace: here("workspace"), file: "meeting.scene", env: { PATH: "/usr/bin:/bin" } });
  try {
    await until("the message", async () => (await notices(other)).some((notice) => /has no server/.test(notice)));
    await shoot("no-server", other);
    assert.match(await status(other), /no server/);
    await press(other, "Open Setting");
    await until("the setting", async () => (await other.api("return vscode.window.tabGroups.activeTabGroup.activeTab?.label")) === "Settings");
    // And with the setting it starts.
    await other.api("await vscode.workspace.getConfiguration('scenelang').update('server.path', args.path, 1)", { path: here("fake/scenelang") });
    await until("a server", async () => /\d+\/\d+ hold/.test(await status(other)));
  } finally {
    await other.close();
  }
});

/** A folder whose settings name a program, which says that it ran by a file, and a language model. */
function tempting() {
  const workspace = mkdtempSync(join(folder, "tempting-"));
  execFileSync("cp", ["-r", `${here("workspace")}/.`, workspace]);
  execFileSync("mkdir", [join(workspace, ".vscode")]);
  const ran = join(workspace, "ran");
  writeFileSync(join(workspace, "own"), `#!/bin/sh\ntouch ${ran}\n`, { mode: 0o755 });
  writeFileSync(join(workspace, ".vscode/settings.json"), JSON.stringify({ "scenelang.server.path": join(workspace, "own"), "scenelang.languageModel": "editor" }));
  return { workspace, ran };
}

for (const [kind, settings] of [["bundled", {}], ["bare", { "scenelang.server.path": here("fake/scenelang") }]]) {
  check(`a folder that is not trusted chooses neither server nor model (${kind})`, async () => {
    const { workspace, ran } = tempting();
    const log = `untrusted-${kind}`;
    const other = await open({ vsix: vsix[kind], workspace, file: "meeting.scene", env: environment(log), settings, trusted: false });
    try {
      await until("the extension's server, or the user's", () => logged(log).length > 0);
      assert.equal(await other.api("return vscode.workspace.isTrusted"), false);
      assert.equal(logged(log)[0].model, "none");
      assert.ok(!existsSync(ran), "the folder's program was not started");
    } finally {
      await other.close();
    }
  });
}

check("a folder that is trusted chooses the server where none is bundled", async () => {
  const { workspace, ran } = tempting();
  const other = await open({ vsix: vsix.bare, workspace, file: "meeting.scene", env: environment("trusted"), settings: { "scenelang.server.path": here("fake/scenelang") } });
  try {
    await until("the folder's program", () => existsSync(ran));
    assert.deepEqual(logged("trusted"), [], "the user's was not started");
  } finally {
    await other.close();
  }
});

check("the editor's own model answers the server; a key goes from the secret storage to the server that may use it, and nowhere else", async () => {
  const settings = { "chat.disableAIFeatures": false, "scenelang.languageModel": "editor" };
  const other = await open({ vsix: vsix.bundled, workspace: here("workspace"), file: "meeting.scene", env: { ...environment("model"), PROBE_MODEL: "1" }, settings });
  try {
    await until("a server", async () => /hold/.test(await status(other)));
    assert.equal(logged("model")[0].model, "client");
    await until("a model", () => other.api("return (await vscode.lm.selectChatModels()).length"));
    await begin(other, "scenelang.repairScene");
    await until("its answer", () => logged("model").some(({ said }) => said === "the first piece, the second"));
    await until("the proposal", async () => (await texts(other, ".quick-input-list .monaco-list-row"))[0]?.startsWith("Apply"));
    await other.page.keyboard.press("Escape");
    // Where a difference closes, the focus goes elsewhere, and a question that is asked too early with it.
    await until("no difference", async () => (await other.page.$$(".monaco-diff-editor")).length === 0);
    await sleep(500);
    const asked = JSON.parse(readFileSync(`${other.socket}.said`, "utf8")).map(([, said]) => said);
    assert.deepEqual(asked.slice(0, 2), ["You move furniture.", "Where to?"]);
    assert.match(asked[2], /JSON Schema:\n\{"type":"object"\}/);

    await begin(other, "scenelang.setKey");
    await until("whose", async () => (await texts(other, ".quick-input-list .monaco-list-row")).some((row) => /^OpenAI/.test(row)));
    await other.page.keyboard.press("Enter");
    await until("the box", () => other.page.$eval(".quick-input-widget input", ({ type }) => type === "password"));
    await other.page.keyboard.type("sk-very-secret");
    await other.page.keyboard.press("Enter");
    const first = await until("another server", () => logged("model").filter(({ model }) => model !== undefined)[1]);
    assert.deepEqual([first.model, first.keys], ["client", []], "the editor's own model needs no key");
    await other.api("await vscode.workspace.getConfiguration('scenelang').update('languageModel', 'configured', 1)");
    const restarted = await until("a server with the key", () => logged("model").find(({ keys, model }) => model !== undefined && keys.includes("OPENAI_API_KEY")));
    assert.equal(restarted.model, "configured");
    assert.throws(() => execFileSync("grep", ["-rl", "sk-very-secret", join(other.ws, ".."), "--include=*.json", "--include=*.log", "--include=*.txt"]), "no setting and no log has it");

    const started = () => logged("model").filter(({ model }) => model !== undefined);
    const before = started().length;
    await begin(other, "scenelang.forgetKey");
    await until("which", async () => (await texts(other, ".quick-input-list .monaco-list-row")).some((row) => /^OpenAI/.test(row)));
    await other.page.keyboard.press("Enter");
    await until("a server without it", () => started().length > before && !started().at(-1).keys.includes("OPENAI_API_KEY"));
  } finally {
    await other.close();
  }
});

check("a server that crashes five times is gone, and the status says so until it is started again", async (e) => {
  await show(e, "meeting.scene");
  const started = () => logged("main").filter(({ pid }) => pid !== undefined);
  await until("a count", async () => /hold/.test(await status(e)));
  for (let crash = 1; crash <= 5; crash += 1) {
    const before = started();
    process.kill(before.at(-1).pid, "SIGKILL");
    if (crash === 5) break;
    await until(`another server after crash ${crash}`, () => started().length > before.length);
    // One that ends before it has begun has not crashed.
    await until("a count again", async () => /hold/.test(await status(e)));
  }
  await until("that there is none", async () => /no server/.test(await status(e)));
  await shoot("crashed");
  await command(e, "scenelang.restartServer");
  await until("a count again", async () => /hold/.test(await status(e)));
  await command(e, "notifications.clearAll");
});

check("nothing was asked of the network, and no script failed", async ({ outside, errors }) => {
  assert.deepEqual([...outside], []);
  assert.deepEqual(errors, []);
});
