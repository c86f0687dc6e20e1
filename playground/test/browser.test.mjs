// The built page (out/playground, or PLAYGROUND) in headless Chromium. Skipped where it was not built, or where there is no
// browser. With BINARY, the examples are compared with what that command line writes; FIGURES prints sizes and times.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { deflateRawSync } from "node:zlib";
import { PATIENCE, begin, chromium, end } from "./browser.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const folder = resolve(process.env.PLAYGROUND ?? here("../../out/playground"));
const examples = here("../../examples");
const missing = !existsSync(join(folder, "engine.bin")) ? `no playground in ${folder}; ./x playground builds it` : !existsSync(chromium) ? `no browser at ${chromium}; set CHROMIUM to one` : false;

let started;
let browser;
let address;

before(async () => {
  if (missing) return;
  started = await begin(folder);
  ({ browser, address } = started);
});
after(() => end(started));

/** A test with a page of its own: nothing may log an error, and nothing may be asked for but the three files. */
function check(name, run) {
  test(name, { skip: missing, timeout: 600_000 }, async (t) => {
    const context = await browser.createBrowserContext();
    const page = await context.newPage();
    const errors = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on("dialog", (dialog) => (errors.push(`a dialog: ${dialog.message()}`), dialog.dismiss()));
    page.on("request", (request) => {
      const url = request.url();
      const own = ["", "index.html", "playground.js", "engine.bin"].some((file) => url.split("#")[0] === address + file);
      if (!own && !/^(data|blob):/.test(url)) errors.push(`asked for ${url}`);
    });
    await page.setViewport({ width: 1440, height: 860 });
    try {
      await run(page, t);
      assert.deepEqual(errors, []);
    } finally {
      await context.close();
    }
  });
}

async function open(page, fragment = "") {
  await page.goto(address + fragment);
  await page.waitForFunction(() => window.playground !== undefined, PATIENCE);
}

/** Waits until nothing is under way and the room is drawn. */
async function rest(page) {
  await page.waitForFunction(() => window.playground.idle() && (window.playground.layout() === null || document.querySelector('#scenelang[data-state="ready"]') !== null), { ...PATIENCE, polling: 50 });
}

const status = (page) => page.$eval("#status", (e) => [e.textContent, e.dataset.state]);
const message = (page) => page.$eval("#message", (e) => (e.hidden ? "" : e.textContent));
/** What is zero on one platform may be the last digit of a sine on another. */
const NEGLIGIBLE = 1e-12;

/** How many numbers of two GLB files differ; fails if one does by more than that, or anything else does. */
function nearly(got, other, what) {
  assert.equal(got.length, other.length, what);
  const json = 20 + got.readUInt32LE(12);
  assert.equal(sum(got.subarray(0, json)), sum(other.subarray(0, json)), what);
  let words = 0;
  for (let at = json + 8; at < got.length; at += 4) {
    if (got.readUInt32LE(at) === other.readUInt32LE(at)) continue;
    const by = Math.abs(got.readFloatLE(at) - other.readFloatLE(at));
    assert.ok(by < NEGLIGIBLE, `${what}: ${by} at ${at}`);
    words += 1;
  }
  return words;
}
const shared = (value) => `#p=${deflateRawSync(JSON.stringify(value)).toString("base64url")}`;
const sum = (bytes) => createHash("sha256").update(bytes).digest("hex");
const shoot = (page, name) => process.env.SHOTS === undefined ? undefined : page.screenshot({ path: join(process.env.SHOTS, `${name}.png`) });

check("the first example is there with its room, and its constraints hold", async (page, t) => {
  const began = performance.now();
  await open(page);
  await page.waitForFunction(() => document.querySelector('#scenelang[data-state="ready"]') !== null && document.querySelector(".tok-keyword") !== null, { ...PATIENCE, polling: 10 });
  t.diagnostic(`interactive after ${(performance.now() - began).toFixed(0)} ms`);
  assert.deepEqual((await status(page))[1], "good");
  assert.ok((await page.$$(".cm-content .tok-comment")).length > 0, "comments have their colour");
  assert.match(await page.title(), /READY \d{3,}/);
  await rest(page);
  await shoot(page, "first");
});

check("every example is shown as the command line makes it", async (page, t) => {
  await open(page);
  const out = mkdtempSync(join(tmpdir(), "scenelang-examples-"));
  try {
    const files = readdirSync(examples).filter((file) => file.endsWith(".scene"));
    assert.ok(files.length >= 7);
    for (const file of files) {
      const stem = file.replace(".scene", "");
      await page.select("#examples", stem);
      await page.waitForFunction((stem) => document.title.startsWith(`${stem} `) && document.title.includes("READY"), PATIENCE, stem);
      await rest(page);
      assert.equal(await page.evaluate(() => window.playground.text()), readFileSync(join(examples, file), "utf8"));
      assert.deepEqual([stem, (await status(page))[1]], [stem, "good"]);
      await shoot(page, stem);
      const { BINARY } = process.env;
      if (BINARY === undefined) continue;
      execFileSync(resolve(BINARY), ["synth", join(examples, file), "-o", join(out, stem), "--only", "glb"], { stdio: "pipe" });
      const wanted = (name) => readFileSync(join(out, stem, name));
      assert.equal(await page.evaluate(() => window.playground.layout()), wanted(`${stem}.layout.json`).toString(), `layout of ${stem}`);
      const glb = await page.evaluate(() => window.playground.file("glb"));
      const [got, other] = [Buffer.from(glb.base64, "base64"), wanted(`${stem}.glb`)];
      const words = got.equals(other) ? 0 : nearly(got, other, `GLB of ${stem}`);
      t.diagnostic(`${stem}: the same layout, ${words === 0 ? "the same GLB" : `a GLB with ${words} numbers that differ by less than ${NEGLIGIBLE}`}`);
    }
  } finally {
    rmSync(out, { recursive: true, force: true });
  }
});

check("solving in the page gives the layout that came with the example", async (page) => {
  await open(page);
  await page.select("#examples", "bedroom");
  await rest(page);
  const layout = await page.evaluate(() => window.playground.layout());
  await page.click("#solve");
  await page.waitForFunction(() => document.querySelector("#solve").disabled, PATIENCE);
  await rest(page);
  assert.equal(await page.evaluate(() => window.playground.layout()), layout);
  assert.equal(await page.$eval("#solve", (e) => e.disabled), false);
  assert.equal(await page.$eval("#stop", (e) => e.hidden), true);
});

check("a mistake is marked while it is typed, and help comes with it", async (page) => {
  await open(page);
  await rest(page);
  await page.evaluate(() => window.playground.replace(0, 0, "object stool;\nassert near(stool, tabel, 1);\n"));
  await page.waitForFunction(() => document.querySelector("#problems li.error") !== null, PATIENCE);
  assert.match(await page.$eval("#problems li.error", (e) => e.textContent), /tabel.*line 2/s);
  await page.waitForSelector(".cm-lintRange-error", PATIENCE);
  // The problem leads to its place.
  await page.click("#problems li.error button");
  await page.keyboard.type("tab");
  await page.keyboard.down("Control");
  await page.keyboard.press("Space");
  await page.keyboard.up("Control");
  await page.waitForSelector(".cm-tooltip-autocomplete li", PATIENCE);
  const proposed = await page.$$eval(".cm-tooltip-autocomplete li", (items) => items.map((item) => item.textContent));
  assert.ok(proposed.some((text) => text.startsWith("table")), proposed.join(", "));
  await shoot(page, "completion");
  // Right after a list has opened, the editor takes Enter for a line that was meant.
  await page.click(".cm-tooltip-autocomplete li");
  await page.waitForFunction(() => window.playground.text().includes("near(stool, table, 1)"), PATIENCE);
  await rest(page);
  assert.match(await page.evaluate(() => window.playground.text()), /near\(stool, table, 1\)/);
  // The stool has got a place, since it is looked for as one types.
  assert.match(await page.evaluate(() => window.playground.layout()), /"stool"/);
  assert.equal((await status(page))[1], "good");
  const word = await page.evaluateHandle(() => [...document.querySelectorAll(".cm-content .tok-function")].find((e) => e.textContent === "near"));
  await word.hover();
  await page.waitForSelector(".cm-tooltip .markdown pre", PATIENCE);
  assert.match(await page.$eval(".cm-tooltip .markdown", (e) => e.textContent), /near\(Object/);
  await shoot(page, "hover");
});

check("keys in the editor are text, and none of the viewer's", async (page) => {
  await open(page);
  await rest(page);
  await page.click(".cm-content");
  await page.keyboard.press("End");
  await page.keyboard.type(" // p r / +");
  assert.match(await page.evaluate(() => window.playground.text()), /\/\/ p r \/ \+/);
  assert.equal(await page.$eval('.toolbar button[aria-pressed="true"]', (e) => e.textContent), "3D");
});

check("without WebGL there is the plan, and it follows", async (page) => {
  await page.evaluateOnNewDocument(() => (HTMLCanvasElement.prototype.getContext = () => null));
  await open(page);
  const shown = () => document.querySelector("#scenelang .flat")?.getAttribute("src") ?? "";
  await page.waitForFunction(() => document.querySelector("#scenelang .flat") !== null, PATIENCE);
  await rest(page);
  assert.match(await page.evaluate(shown), /^data:image\/svg\+xml.*table/);
  await page.select("#examples", "bedroom");
  await page.waitForFunction(() => document.title.startsWith("bedroom ") && document.title.includes("READY"), PATIENCE);
  await rest(page);
  assert.match(await page.evaluate(shown), /^data:image\/svg\+xml.*wardrobe/);
});

check("a contradiction is told", async (page) => {
  await open(page, shared(["a.scene", "region r;\nr.pos <- vec3(0,0,0);\nr.scale <- vec3(4,3,4);\nobject a;\na.category <- \"desk\";\nassert a.pos.x > 3;\nassert a.pos.x < 2;\n"]));
  await page.waitForFunction(() => document.querySelector("#message:not([hidden])") !== null, PATIENCE);
  assert.match(await message(page), /No layout can satisfy/);
  await rest(page);
  assert.ok((await page.$$("#problems li.error")).length > 0);
});

check("a sentence becomes a room", async (page) => {
  await open(page);
  await page.type("#request", "a study with a desk, a chair and two bookshelves");
  await page.click("#describe");
  await page.waitForFunction(() => document.title.startsWith("room ") && document.title.includes("READY"), PATIENCE);
  await rest(page);
  assert.match(await page.evaluate(() => window.playground.text()), /bookshelf/);
  assert.equal((await status(page))[1], "good");
  await shoot(page, "sentence");
});

check("a program goes into a link and out of it", async (page) => {
  await open(page);
  await page.evaluate(() => window.playground.replace(0, 0, "// 🪑 mine\n"));
  await page.click("#share");
  await page.waitForFunction(() => location.hash.startsWith("#p="), PATIENCE);
  const link = await page.evaluate(() => location.href);
  const text = await page.evaluate(() => window.playground.text());
  await page.goto("about:blank");
  await page.goto(link);
  await page.waitForFunction(() => window.playground?.text().startsWith("// 🪑 mine"), PATIENCE);
  assert.equal(await page.evaluate(() => window.playground.text()), text);
});

check("a hostile link does nothing but say so", async (page) => {
  const script = '<img src=x onerror="window.hurt=1"><script>window.hurt=1</script>';
  const refused = ["#p=<script>window.hurt=1</script>", `#${script}`, "#p=AAAA", `#p=${"A".repeat(300_000)}`, `#p=${deflateRawSync("0".repeat(50_000_000)).toString("base64url")}`, shared({ name: script }), shared([1, 2])];
  for (const fragment of refused) {
    await page.goto("about:blank");
    await open(page, fragment);
    await page.waitForFunction(() => document.querySelector("#message:not([hidden])") !== null, PATIENCE);
    assert.match(await message(page), /This link cannot be opened/, fragment.slice(0, 40));
    await page.waitForFunction(() => window.playground.text().includes("meeting room"), PATIENCE);
  }
  // Programs that are markup, or as deep or as long as a link can hold.
  const nasty = [script, `object a; // ${script}\nassert nonsense("${script}");`, `assert ${"(".repeat(30_000)}1`, `assert 0${" + 1".repeat(12_000)} > 0;`, `import "${script}";`, "object a[100000000];", "\u0000\u202e"];
  for (const text of nasty) {
    await page.goto("about:blank");
    await open(page, shared([`${script}.scene`, text]));
    await page.waitForFunction((text) => window.playground.text() === text, PATIENCE, text);
    await page.waitForFunction(() => document.querySelector("#status").textContent !== "", PATIENCE);
    await rest(page);
  }
  assert.equal(await page.evaluate(() => window.hurt), undefined);
  assert.equal(await page.$("img[src='x']"), null);
});

test("from the page nothing can be reached", { skip: missing }, async () => {
  const page = await browser.newPage();
  try {
    await open(page);
    const reached = await page.evaluate(async (address) => {
      const tried = [fetch(address), fetch("https://example.org/"), new Promise((done, failed) => {
        const image = new Image();
        image.onload = done;
        image.onerror = failed;
        image.src = `${address}engine.bin`;
      })];
      return (await Promise.allSettled(tried)).map(({ status }) => status);
    }, address);
    assert.deepEqual(reached, ["rejected", "rejected", "rejected"]);
    const inWorker = await page.evaluate(() => new Promise((done) => {
      const worker = new Worker(URL.createObjectURL(new Blob(["fetch('https://example.org/').then(() => postMessage('fulfilled'), () => postMessage('rejected'))"])));
      worker.addEventListener("message", (e) => done(e.data));
    }));
    assert.equal(inWorker, "rejected");
  } finally {
    await page.close();
  }
});

/** A program of 500 lines: desks and chairs on a grid. */
function large() {
  const lines = ["region hall;", "hall.pos <- vec3(0, 0, 0);", "hall.scale <- vec3(20, 3, 20);"];
  for (let i = 0; lines.length + 20 <= 500; i += 1) {
    const [x, z] = [(i % 5) * 4 - 8, Math.floor(i / 5) * 4 - 8];
    lines.push(`object desk${i};`, `desk${i}.category <- "desk";`, `desk${i}.dimensions <- vec3(1.4, 0.74, 0.7);`, `desk${i}.color <- "oak";`, `desk${i}.pos <- vec3(${x}, 0, ${z});`, `desk${i}.rot <- rot(0, 0, 0);`);
    lines.push(`object chair${i};`, `chair${i}.category <- "chair";`, `chair${i}.dimensions <- vec3(0.5, 0.9, 0.5);`, `chair${i}.rot <- rot(0, 180, 0);`);
    lines.push(`assert inside(desk${i}, hall);`, `assert inside(chair${i}, hall);`, `assert near(chair${i}, desk${i}, 0.5);`, `assert facing(chair${i}, desk${i});`, `assert inFrontOf(chair${i}, desk${i});`);
    lines.push(`assert chair${i}.pos.y <= 0.01;`, `assert desk${i}.pos.y <= 0.01;`, `assert chair${i}.size.x < desk${i}.size.x;`, `prefer near(chair${i}, desk${i}, 0.2);`, `// desk ${i}`);
  }
  while (lines.length < 500) lines.push(`// ${lines.length}`);
  return lines.join("\n");
}

check("a program of 500 lines is followed", async (page, t) => {
  await open(page);
  await rest(page);
  await page.evaluate(() => (document.querySelector("#live").checked = true));
  const text = large();
  await page.evaluate((text) => window.playground.open("large.scene", text, null), text);
  await page.waitForFunction(() => window.playground.layout() !== null, PATIENCE);
  await rest(page);
  const [told] = await status(page);
  t.diagnostic(`${text.split("\n").length} lines: ${told}`);
  await page.evaluate(() => (document.querySelector("#live").checked = false));
  // The verdict and the room, without a new layout; then the figures of a desk are changed and the room follows.
  const at = text.indexOf("near(chair7, desk7, 0.5)") + "near(chair7, desk7, 0.".length;
  await page.evaluate(() => (window.playground.latencies.length = 0));
  await page.$$eval(".panel .rows li", (items) => items.forEach((item) => (item.kept = true)));
  for (let i = 0; i < 30; i += 1) {
    const shown = await page.evaluate(() => window.playground.shown);
    await page.evaluate((at, digit) => window.playground.replace(at, at + 1, digit), at, String(5 + (i % 4)));
    await page.waitForFunction((shown) => window.playground.shown > shown && window.playground.idle(), { ...PATIENCE, polling: 5 }, shown);
  }
  const times = (await page.evaluate(() => window.playground.latencies)).sort((a, b) => a - b);
  assert.equal(times.length, 30);
  const rows = await page.$$eval(".panel .rows li", (items) => items.map((item) => [item.kept === true, item.textContent]));
  assert.ok(rows.length > 300);
  assert.deepEqual(rows.filter(([kept, text]) => !kept && !text.includes("chair7")), [], "rows that are the same are not made again");
  t.diagnostic(`edit to room: median ${times[15].toFixed(1)} ms, 90 % ${times[27].toFixed(1)} ms, most ${times[29].toFixed(1)} ms`);
  await shoot(page, "large");
});
