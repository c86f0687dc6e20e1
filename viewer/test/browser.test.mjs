// The page in a real browser: the file that PREVIEW names, or else the fixture; and how it bears what is broken.
// Skipped where there is no Chromium (CHROMIUM names another than /usr/bin/chromium), which fails in CI.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";
import { bundle, fixtureData, page as pageOf, shapedData } from "./fixture.mjs";

const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
const missing = existsSync(chromium) ? false : `no browser at ${chromium}; set CHROMIUM to one`;
const FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const PATIENCE = { timeout: 60_000 };

let browser;
let folder;
/** A blank page that reads pictures for the tests. */
let reader;

before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), "scenelang-viewer-"));
  browser = await puppeteer.launch({ executablePath: chromium, headless: true, protocolTimeout: 60_000, args: FLAGS, userDataDir: join(folder, "profile") });
  reader = await browser.newPage();
});
after(async () => {
  await browser?.close();
  if (folder !== undefined) rmSync(folder, { recursive: true, force: true });
});

/** A test with a page of its own; nothing it loads may log an error. */
function check(name, run) {
  test(name, { skip: process.env.CI === "true" ? false : missing }, async () => {
    if (missing) assert.fail(missing);
    const page = await browser.newPage();
    const errors = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || errors.push(`asked for ${request.url()}`));
    await page.setViewport({ width: 1280, height: 800 });
    try {
      await run(page);
      assert.deepEqual(errors, []);
    } finally {
      await page.close();
    }
  });
}

/** The same for data of its own, and for what no data changes: once is enough, not again for every page that is given. */
function checkOwn(name, run) {
  if (process.env.PREVIEW === undefined) check(name, run);
}

async function open(page, data) {
  let path = process.env.PREVIEW === undefined ? undefined : resolve(process.env.PREVIEW);
  if (data !== undefined || path === undefined) {
    path = join(folder, "page.html");
    writeFileSync(path, pageOf(data ?? fixtureData(), bundle()));
  }
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => document.querySelector('#scenelang:is([data-state="ready"], [data-state="error"])') !== null, PATIENCE);
  const json = /<script[^>]*id="scenelang-data"[^>]*>([\s\S]*?)<\/script>/.exec(readFileSync(path, "utf8"));
  return JSON.parse(json[1]);
}

/** Takes a picture of the room alone, without words and buttons; the reader keeps it under the number that is returned. */
async function shoot(page) {
  const clip = await (await page.$(".stage")).boundingBox();
  const show = (shown) => page.$$eval(".labels, .tip, .toolbar, .hint", (over, shown) => over.forEach((e) => (e.style.visibility = shown ? "" : "hidden")), shown);
  await show(false);
  // The canvas must have been put on the screen, and must keep its size: beyond the window the browser would resize the page.
  await twoFrames(page);
  const image = await page.screenshot({ encoding: "base64", clip, captureBeyondViewport: false });
  await show(true);
  return reader.evaluate(async (source) => {
    const image = new Image();
    image.src = source;
    await image.decode();
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    window.shots ??= [];
    return window.shots.push(context.getImageData(0, 0, image.width, image.height).data) - 1;
  }, `data:image/png;base64,${image}`);
}

/** How many different colours, in steps of 16, at least one pixel in a thousand has: a blank or broken picture has few. */
function colours(shot) {
  return reader.evaluate((shot) => {
    const data = window.shots[shot];
    const found = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const key = ((data[i] >> 4) << 8) | ((data[i + 1] >> 4) << 4) | (data[i + 2] >> 4);
      found.set(key, (found.get(key) ?? 0) + 1);
    }
    return [...found.values()].filter((count) => count * 4000 > data.length).length;
  }, shot);
}

/** The share of pixels that clearly differ. */
function difference(a, b) {
  return reader.evaluate((a, b) => {
    const [one, other] = [window.shots[a], window.shots[b]];
    if (one.length !== other.length) throw new Error(`the pictures have ${one.length / 4} and ${other.length / 4} pixels`);
    let count = 0;
    for (let i = 0; i < one.length; i += 4) if (Math.max(...[0, 1, 2].map((k) => Math.abs(one[i + k] - other[i + k]))) > 24) count += 1;
    return (count * 4) / one.length;
  }, a, b);
}

/** How much darker one picture is than another: the share of pixels that clearly are, those that are brighter, the most in a part of it. */
function darkening(light, dark, part) {
  return reader.evaluate((light, dark, [left, top, right, bottom], width) => {
    const [one, other] = [window.shots[light], window.shots[dark]];
    const found = { share: 0, brighter: 0, most: 0 };
    for (let i = 0; i < one.length; i += 4) {
      const less = one[i] + one[i + 1] + one[i + 2] - other[i] - other[i + 1] - other[i + 2];
      const [x, y] = [(i / 4) % width, Math.floor(i / 4 / width)];
      if (less > 24) found.share += 4 / one.length;
      if (less < -6) found.brighter += 1;
      if (x >= left && x < right && y >= top && y < bottom) found.most = Math.max(found.most, less / 3);
    }
    return found;
  }, light, dark, part.area, part.width);
}

const twoFrames = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Waits until the picture stands still: what the pointer did has been seen, flights end, walls come to rest. */
async function settle(page) {
  // A pick waits for the next frame, and only then asks for one that shows it.
  await twoFrames(page);
  await page.waitForFunction(() => !window.scenelang.moving(), PATIENCE);
}

/** Waits until the picture is as it was, but for a share of its pixels: a page that is short of time shows late what has happened. */
async function becomes(page, shot, share, what) {
  let apart = 1;
  for (let i = 0; i < 20 && apart >= share; i += 1) {
    if (i > 0) await new Promise((done) => setTimeout(done, 500));
    await settle(page);
    apart = await difference(shot, await shoot(page));
  }
  assert.ok(apart < share, `${what}: ${apart} of the picture differs`);
}

const rowsOf = (page) => page.$$eval("button.row[data-row]", (rows) => rows.map((row) => ({ index: Number(row.dataset.row), text: row.querySelector(".text").textContent, margin: row.querySelector(".margin").textContent, verdict: ["holds", "fails", "unknown"].find((name) => row.classList.contains(name)) })));
const selected = (page) => page.evaluate(() => window.scenelang.selected());

check("the room is shown, and every constraint is listed", async (page) => {
  const data = await open(page);
  const title = /^(.*) — READY (\d+)$/.exec(await page.title());
  assert.ok(title, await page.title());
  assert.equal(title[1], data.name);
  assert.ok(Number(title[2]) > 100, title[0]);
  assert.equal(await page.$("#fallback"), null);

  const { constraints, summary } = data.report;
  const rows = await rowsOf(page);
  assert.deepEqual(rows.map(({ index }) => index).sort((a, b) => a - b), constraints.map((_, i) => i));
  for (const { index, text, margin, verdict } of rows) {
    const row = constraints[index];
    assert.equal(text, row.text);
    assert.equal(margin === "", row.margin === null, `row ${index}: ${margin}`);
    assert.equal(verdict, row.satisfied === null ? "unknown" : row.satisfied ? "holds" : "fails");
  }
  const headline = await page.$eval(".headline", (e) => e.textContent);
  if (summary.assertions.total > 0) assert.ok(headline.startsWith(`${summary.assertions.satisfied} of ${summary.assertions.total} assertion`), headline);
  assert.ok((await colours(await shoot(page))) >= 12);
});

check("pressing a constraint highlights its objects, and again lets go", async (page) => {
  const data = await open(page);
  const index = data.report.constraints.findIndex(({ objects }) => objects.some((name) => data.objects.some((o) => o.name === name)));
  const before = await shoot(page);
  await page.click(`button.row[data-row="${index}"]`);
  await settle(page);
  const names = await selected(page);
  assert.ok(names.length > 0);
  for (const name of data.report.constraints[index].objects) if (data.objects.some((o) => o.name === name)) assert.ok(names.includes(name), name);
  assert.equal(await page.$eval('button.row[aria-current="true"]', (row) => row.dataset.row), String(index));
  const tags = await page.$$eval(".tag.name", (tags) => tags.map((tag) => tag.textContent));
  assert.deepEqual(tags, names.filter((name) => data.objects.some((o) => o.name === name)).slice(0, 10));
  assert.ok((await difference(before, await shoot(page))) > 0.01);

  // Where the camera now is, the outlines alone are the difference.
  const marked = await shoot(page);
  await page.click(`button.row[data-row="${index}"]`);
  await settle(page);
  assert.deepEqual(await selected(page), []);
  assert.ok((await difference(marked, await shoot(page))) > 0.0005);
});

checkOwn("pressing an object lists its constraints alone; Escape lists all again", async (page) => {
  const data = await open(page);
  const area = await (await page.$("canvas")).boundingBox();
  let names = [];
  for (let i = 0; names.length === 0 && i < 77; i += 1) {
    await page.mouse.click(area.x + area.width * (0.25 + 0.05 * (i % 11)), area.y + area.height * (0.3 + 0.06 * Math.floor(i / 11)));
    names = await selected(page);
  }
  assert.equal(names.length, 1, "somewhere in the middle of the picture there is an object");
  const object = data.objects.find(({ name }) => name === names[0]);
  const own = data.report.constraints.flatMap(({ objects }, i) => (object.constraints.includes(i) || objects.includes(object.name) ? [i] : []));
  assert.deepEqual((await rowsOf(page)).map(({ index }) => index).sort((a, b) => a - b), own);
  assert.equal(await page.$eval(".scope-name", (e) => e.textContent), object.name);
  await page.keyboard.press("Escape");
  assert.equal((await rowsOf(page)).length, data.report.constraints.length);
});

checkOwn("a press on a door opens it, another closes it, and a selected object shows what it sweeps", async (page) => {
  await page.emulateMediaFeatures([{ name: "prefers-reduced-motion", value: "reduce" }]);
  await open(page);
  const area = await (await page.$("canvas")).boundingBox();
  const opened = () => page.evaluate(() => window.scenelang.opened());
  const select = async (name) => {
    await page.evaluate((name) => window.scenelang.select(name), name);
    await settle(page);
  };
  /** Presses about the middle of the picture until so many parts are open. */
  const seek = async (count) => {
    for (let i = 0; i < 121 && (await opened()).length !== count; i += 1) {
      await page.mouse.click(area.x + area.width * (0.3 + 0.04 * (i % 11)), area.y + area.height * (0.3 + 0.04 * Math.floor(i / 11)));
    }
    await select(null);
    return opened();
  };
  // This brings it before the camera.
  await select("sideboard");
  const swept = await shoot(page);
  await select(null);
  const closed = await shoot(page);
  assert.deepEqual(await seek(1), ["sideboard/door"]);
  const open_ = await shoot(page);
  assert.ok((await difference(closed, open_)) > 0.002);
  assert.deepEqual(await seek(0), []);
  await becomes(page, closed, 0.001, "closed, it is as before");
  assert.ok((await difference(closed, swept)) > 0.01, "the floor that the door sweeps is coloured");
});

checkOwn("the pointer over an object tells its name, size and place", async (page) => {
  await open(page);
  const area = await (await page.$("canvas")).boundingBox();
  let tip = null;
  for (let i = 0; tip === null && i < 77; i += 1) {
    await page.mouse.move(area.x + area.width * (0.25 + 0.05 * (i % 11)), area.y + area.height * (0.3 + 0.06 * Math.floor(i / 11)));
    await twoFrames(page);
    tip = await page.$eval(".tip", (e) => (e.hidden ? null : e.textContent));
  }
  assert.match(tip ?? "", /\d\.\d\d × \d+\.\d\d × \d+\.\d\d m.*at \(/);
});

checkOwn("chips, words and keys narrow the list", async (page) => {
  const { report } = await open(page);
  for (const [chip, keeps] of [["violated", ({ satisfied }) => satisfied === false], ["assert", ({ kind }) => kind === "assert"], ["all", () => true]]) {
    if ((await page.$(`[data-filter="${chip}"]`)) === null) continue;
    await page.click(`[data-filter="${chip}"]`);
    assert.deepEqual((await rowsOf(page)).map(({ index }) => index).sort((a, b) => a - b), report.constraints.flatMap((row, i) => (keeps(row) ? [i] : [])));
  }
  await page.keyboard.press("/");
  await page.keyboard.type(report.constraints[0].text);
  const rows = await rowsOf(page);
  assert.ok(rows.some(({ index }) => index === 0));
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  assert.equal(await page.$eval('button.row[aria-current="true"]', (row) => row.dataset.row), String(rows[0].index));
  assert.equal(await page.evaluate(() => document.activeElement.dataset.row), String(rows[0].index));
  await page.keyboard.press("Escape");
  assert.deepEqual(await selected(page), []);
  await page.keyboard.press("Escape");
  assert.equal((await rowsOf(page)).length, report.constraints.length);
});

checkOwn("corners and what stands on the floor take light from each other, and from nothing else", async (page) => {
  await open(page);
  // Nothing red over what is looked at, and a tag that says where it is.
  const stage = await (await page.$(".stage")).boundingBox();
  const [x, y] = await placeOf(page, "coffee");
  const width = Math.round(stage.width);
  const without = async () => {
    await page.evaluate(() => window.scenelang.occlusion(false));
    await settle(page);
    return shoot(page);
  };
  const shaded = await shoot(page);
  const plain = await without();
  const area = (left, top, right, bottom) => ({ width, area: [left, top, right, bottom] });
  const below = await darkening(plain, shaded, area(x - stage.x - 50, y - stage.y, x - stage.x + 50, y - stage.y + 70));
  assert.ok(below.most > 10, `the floor below a low table is darker, by ${below.most}`);
  assert.ok(below.share > 0.005 && below.share < 0.3, `${below.share} of the picture is darker`);
  assert.equal(below.brighter, 0);
  const background = await darkening(plain, shaded, area(0, 0, width, 30));
  assert.equal(background.most, 0, "around the room nothing changes");

  await page.evaluate(() => window.scenelang.occlusion(true));
  await becomes(page, shaded, 0.0005, "on again");
});

checkOwn("the plan shows the room from straight above, named; back again, and reset", async (page) => {
  const { regions } = await open(page);
  const before = await shoot(page);
  const [, plan] = await page.$$(".toolbar .group:first-child button");
  await plan.click();
  await settle(page);
  assert.equal(await plan.evaluate((e) => e.getAttribute("aria-pressed")), "true");
  assert.deepEqual(await page.$$eval(".tag.region", (tags) => tags.map((tag) => tag.textContent)), regions.map(({ name }) => name));
  const above = await shoot(page);
  assert.ok((await colours(above)) >= 8);
  assert.ok((await difference(before, above)) > 0.05);
  await page.keyboard.press("p");
  await settle(page);
  assert.ok((await difference(before, await shoot(page))) < 0.01, "the first view is found again");
});

/** Where the tag of an object points to, once that is selected. */
async function placeOf(page, name) {
  await page.evaluate((name) => window.scenelang.select(name), name);
  await settle(page);
  return page.$eval(".tag.name", (tag) => ((box) => [box.x + box.width / 2, box.bottom])(tag.getBoundingClientRect()));
}

checkOwn("the plan is not mirrored: x runs to the right, z up", async (page) => {
  const { objects } = await open(page);
  await page.keyboard.press("p");
  await settle(page);
  const place = ({ name }) => placeOf(page, name);
  for (const [axis, k, sign] of [["x", 0, 1], ["z", 2, -1]]) {
    const along = [...objects].sort((a, b) => a.pos[k] - b.pos[k]);
    const [low, high] = [await place(along[0]), await place(along.at(-1))];
    assert.ok((high[k / 2] - low[k / 2]) * sign > 50, `${axis}: ${along[0].name} at ${low}, ${along.at(-1).name} at ${high}`);
  }
});

checkOwn("plus goes nearer, minus farther away", async (page) => {
  const { objects } = await open(page);
  await page.keyboard.press("p");
  await settle(page);
  const along = [...objects].sort((a, b) => a.pos[0] - b.pos[0]);
  const apart = async () => {
    const [low, high] = [await placeOf(page, along[1].name), await placeOf(page, along.at(-2).name)];
    return high[0] - low[0];
  };
  const before = await apart();
  for (const [key, times] of [["+", 1.2], ["-", 1], ["-", 1 / 1.2]]) {
    await page.keyboard.press(key);
    await settle(page);
    const after = await apart();
    assert.ok(Math.abs(after / before - times) < 0.05, `${key}: ${before} became ${after}`);
  }
});

checkOwn("a message replaces the room", async (page) => {
  await open(page, fixtureData());
  const next = fixtureData();
  next.name = "another";
  next.objects = next.objects.slice(0, 3);
  for (const object of next.objects) object.constraints = object.constraints.filter((row) => row < 2);
  next.report.constraints.length = 2;
  await page.evaluate((data) => window.postMessage({ type: "scenelang-data", data }, "*"), next);
  await page.waitForFunction(() => document.title.startsWith("another — READY"), PATIENCE);
  assert.equal((await rowsOf(page)).length, 2);
  // Data that cannot be read leaves what is shown, and says so.
  await page.evaluate(() => window.postMessage({ type: "scenelang-data", data: { format: "else" } }, "*"));
  await page.waitForFunction(() => !document.querySelector(".notice").hidden, PATIENCE);
  assert.match(await page.$eval(".notice", (e) => e.textContent), /format: expected/);
  assert.equal((await rowsOf(page)).length, 2);
});

/** An editor around the page: notes what it is told, and answers moves by `answer`. */
async function inEditor(page, data, answer) {
  await page.exposeFunction("answerMove", answer);
  await page.evaluateOnNewDocument((room) => {
    window.told = [];
    const send = (message) => window.postMessage(message, "*");
    window.acquireVsCodeApi = () => ({
      setState: (state) => window.told.push({ type: "state", state }),
      postMessage: (message) => {
        window.told.push(message);
        if (message.type === "ready") send({ type: "scenelang-data", data: room, uri: "file:///meeting.scene" });
        if (message.type === "move") window.answerMove(message).then((said) => send({ type: "moved", id: message.id, ...said }));
      },
    });
  }, data);
  const path = join(folder, "editor.html");
  writeFileSync(path, pageOf({}, bundle()).replace(/<script type="application.json"[^]*?<.script>/, ""));
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => document.querySelector('#scenelang[data-state="ready"]') !== null, PATIENCE);
  return (type) => page.evaluate((type) => window.told.filter((message) => message.type === type), type);
}

checkOwn("an editor says that the room is provisional or out of date, and takes it back", async (page) => {
  await inEditor(page, fixtureData(), () => ({}));
  const send = (message) => page.evaluate((message) => window.postMessage(message, "*"), message);
  const notice = (pattern) =>
    page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector(".notice:not([hidden])")?.textContent), PATIENCE, pattern);
  await send({ type: "provisional" });
  await notice("provisional");
  await send({ type: "stale", why: "the program has errors" });
  await notice("the program has errors");
  await send({ type: "stale", why: null });
  await page.waitForFunction(() => document.querySelector(".notice").hidden, PATIENCE);
});

/** A place of the window where an object is seen. */
async function find(page, name) {
  const area = await (await page.$("canvas")).boundingBox();
  for (let i = 0; i < 400; i += 1) {
    const [x, y] = [area.x + area.width * (0.1 + 0.04 * (i % 20)), area.y + area.height * (0.15 + 0.035 * Math.floor(i / 20))];
    await page.mouse.move(x, y);
    await twoFrames(page);
    if ((await page.$eval(".tip", (e) => (e.hidden ? null : e.querySelector("strong").textContent))) === name) return [x, y];
  }
  return assert.fail(`${name} is nowhere to be seen`);
}

checkOwn("a room that was only rearranged is not built anew", async (page) => {
  const load = async (data) => {
    await page.evaluate((data) => window.scenelang.load(data), data);
    await settle(page);
    return shoot(page);
  };
  await open(page, fixtureData());
  await settle(page);
  const baked = await shoot(page);
  const shaped = shapedData();
  assert.ok((await difference(baked, await load(shaped))) < 0.002, "things stand where the data has them");
  // The geometry is not looked at again: this is none.
  const moved = structuredClone({ ...shaped, glb: "none" });
  const sofa = moved.objects.find(({ category }) => category === "sofa");
  [sofa.pos, sofa.rot] = [[sofa.pos[0] - 0.5, 0, sofa.pos[2] - 0.8], [0, sofa.rot[1] + 40, 0]];
  assert.ok((await difference(baked, await load(moved))) > 0.005, "the sofa is elsewhere");
  assert.match(await page.title(), /READY [1-9]/);
  assert.ok((await difference(baked, await load({ ...shaped, glb: "none" }))) < 0.002, "and back");
});

checkOwn("what a repair would move is shown where it would be, until it is called off", async (page) => {
  const data = shapedData();
  await inEditor(page, data, () => ({}));
  await settle(page);
  const ghosts = () => page.evaluate(() => window.scenelang.ghosts());
  const send = async (message) => {
    await page.evaluate((message) => window.postMessage(message, "*"), message);
    await settle(page);
  };
  const plain = await shoot(page);
  const sofa = data.objects.find(({ category }) => category === "sofa");
  const there = { object: sofa.name, pos: [sofa.pos[0] - 0.5, 0, sofa.pos[2] - 0.8], rot: [0, sofa.rot[1] + 40, 0] };
  await send({ type: "ghost", ghosts: [there, { ...there, object: "nothing" }] });
  assert.deepEqual(await ghosts(), [sofa.name]);
  assert.ok((await difference(plain, await shoot(page))) > 0.005, "a copy is seen");
  await send({ type: "ghost", ghosts: [] });
  assert.deepEqual(await ghosts(), []);
  await becomes(page, plain, 0.002, "the room is as it was");
  // A new room has none.
  await send({ type: "ghost", ghosts: [there] });
  await send({ type: "scenelang-data", data: { ...data, glb: "none" }, uri: "file:///meeting.scene" });
  assert.deepEqual(await ghosts(), []);
});

checkOwn("what fails is drawn between the objects", async (page) => {
  const data = fixtureData();
  await open(page, data);
  assert.deepEqual(await page.$$eval(".tag.gap", (tags) => tags.map((tag) => tag.textContent)), ["−0.12 m", "−0.04 m"]);
  const red = await shoot(page);
  for (const row of data.report.constraints) if (row.satisfied === false) row.satisfied = true;
  await open(page, data);
  assert.deepEqual(await page.$$(".tag.gap"), []);
  assert.ok((await difference(red, await shoot(page))) > 0.002, "and nothing where all holds");
});

checkOwn("an object is dragged, judged on its way, written once, and put back by Ctrl+Z", async (page) => {
  const data = fixtureData();
  const [id, failing] = [data.report.constraints[5].id, data.report.constraints[0].id];
  const told = await inEditor(page, data, async ({ pos }) => ({
    verdicts: { constraints: [{ id, state: "holds", margin: pos[0] }, { id: failing, state: "fails", margin: -pos[2] }], physical: [] },
  }));
  const [x, y] = await find(page, "sofa");
  const headline = () => page.$eval(".headline", (e) => e.textContent);
  const before = await headline();
  await page.mouse.down();
  await page.mouse.move(x - 30, y + 10, { steps: 5 });
  await page.waitForFunction(() => window.told.some(({ type }) => type === "move"), PATIENCE);
  await page.waitForFunction((row) => document.querySelector(`[data-row="${row}"]`)?.className.includes("holds"), PATIENCE, 5);
  assert.ok((await page.$('[data-row="0"].fails')) !== null);
  assert.equal(await headline(), before, "one holds that did not, one fails that did");
  assert.ok((await told("move")).every(({ commit, object }) => !commit && object === "sofa"));
  await page.mouse.up();
  await page.waitForFunction(() => window.told.some(({ commit }) => commit === true), PATIENCE);
  const sofa = data.objects.find(({ name }) => name === "sofa");
  const [made] = (await told("move")).filter(({ commit }) => commit);
  assert.equal(made.pos[1], sofa.pos[1], "over the floor");
  assert.ok(Math.hypot(made.pos[0] - sofa.pos[0], made.pos[2] - sofa.pos[2]) > 0.1);
  assert.deepEqual(made.rot, sofa.rot);
  await settle(page);
  await page.keyboard.down("Control");
  await page.keyboard.press("z");
  await page.keyboard.up("Control");
  await page.waitForFunction(() => window.told.filter(({ commit }) => commit === true).length === 2, PATIENCE);
  assert.deepEqual((await told("move")).at(-1).pos, sofa.pos);
});

checkOwn("Escape calls a drag off; a refusal puts the object back and says why", async (page) => {
  const data = fixtureData();
  const told = await inEditor(page, data, async ({ commit }) => (commit ? { error: "the layout cannot be written" } : { verdicts: { constraints: [], physical: [] } }));
  await settle(page);
  const shot = await shoot(page);
  const [x, y] = await find(page, "sofa");
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 20, { steps: 5 });
  await page.waitForFunction(() => window.told.some(({ type }) => type === "move"), PATIENCE);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await settle(page);
  assert.deepEqual((await told("move")).filter(({ commit }) => commit), []);
  await page.mouse.move(2, 2);
  await page.waitForFunction(() => document.querySelector(".tip").hidden, PATIENCE);
  await becomes(page, shot, 0.01, "it is back");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 20, { steps: 5 });
  await page.mouse.up();
  await page.waitForFunction(() => !document.querySelector(".notice").hidden, PATIENCE);
  assert.match(await page.$eval(".notice", (e) => e.textContent), /It was not moved.*the layout cannot be written/);
});

checkOwn("keys move what is selected, and what is pressed is told to the editor", async (page) => {
  const data = fixtureData();
  const told = await inEditor(page, data, async () => ({ verdicts: { constraints: [], physical: [] } }));
  await page.evaluate(() => window.postMessage({ type: "select", what: "sofa" }, "*"));
  await page.waitForFunction(() => window.scenelang.selected().length === 1, PATIENCE);
  assert.deepEqual(await told("reveal"), [], "who selects it knows where it is");
  await page.keyboard.down("Alt");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.up("Alt");
  await page.keyboard.press("]");
  await page.waitForFunction(() => window.told.filter(({ commit }) => commit === true).length === 2, PATIENCE);
  const sofa = data.objects.find(({ name }) => name === "sofa");
  const [pushed, turned] = await told("move");
  assert.ok(Math.abs(Math.hypot(pushed.pos[0] - sofa.pos[0], pushed.pos[2] - sofa.pos[2]) - 0.05) < 1e-9);
  assert.deepEqual(turned.pos, pushed.pos);
  assert.equal(turned.rot[1], -165);
  await page.keyboard.press("Escape");
  await page.click('[data-row="5"]');
  assert.deepEqual(await told("reveal"), [{ type: "reveal", row: data.report.constraints[5].id }]);
  assert.deepEqual(await told("state"), [{ type: "state", state: { uri: "file:///meeting.scene" } }]);
});

check("without WebGL there are the plan, the list, and the reason", async (page) => {
  await page.evaluateOnNewDocument(() => (HTMLCanvasElement.prototype.getContext = () => null));
  const data = await open(page);
  assert.equal(await page.title(), `${data.name} — READY 0`);
  assert.match(await page.$eval(".notice", (e) => e.textContent), /WebGL/);
  assert.ok(await page.$eval("img.flat", (image) => image.decode().then(() => image.naturalWidth > 0)));
  assert.equal((await rowsOf(page)).length, data.report.constraints.length);
  await page.click("button.row");
  assert.equal((await page.$$('button.row[aria-current="true"]')).length, 1);
});

checkOwn("a GLB that cannot be read leaves the plan", async (page) => {
  const data = await open(page, { ...fixtureData(), glb: "bm90IGEgZ2xi" });
  assert.equal(await page.title(), "meeting — READY 0");
  assert.ok(await page.$("img.flat"));
  assert.equal((await rowsOf(page)).length, data.report.constraints.length);
});

checkOwn("data that breaks the contract is named, and nothing else is shown", async (page) => {
  const data = fixtureData();
  data.report.constraints[3].margin = "much";
  await open(page, data);
  assert.match(await page.$eval(".notice", (e) => e.textContent), /report\.constraints\[3\]\.margin: expected a finite number, found string/);
  assert.equal(await page.$eval(".panel", (e) => getComputedStyle(e).display), "none");
});

checkOwn("names are text, whatever they contain", async (page) => {
  const data = fixtureData();
  data.name = '</script><img src=x onerror="document.title=1">';
  data.objects[0].category = "<b>bold</b>";
  data.report.constraints[0].message = "<script>document.title = 2</script>";
  data.report.constraints[0].satisfied = false;
  await open(page, data);
  assert.ok((await page.title()).startsWith("</script><img"));
  assert.equal(await page.$("#scenelang img, #scenelang b, #scenelang script"), null);
});
