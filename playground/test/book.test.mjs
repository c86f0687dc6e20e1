// The built book with the playground beside it (out/site, or SITE) in headless Chromium: its examples can be tried where they
// stand. Skipped where it was not built, or where there is no browser.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { PATIENCE, begin, chromium, end } from "./browser.mjs";

const folder = resolve(process.env.SITE ?? fileURLToPath(new URL("../../out/site", import.meta.url)));
const missing = !existsSync(join(folder, "playground/engine.bin")) ? `no book in ${folder}; ./x site builds it` : !existsSync(chromium) ? `no browser at ${chromium}; set CHROMIUM to one` : false;
const shoot = (page, name) => process.env.SHOTS === undefined ? undefined : page.screenshot({ path: join(process.env.SHOTS, `${name}.png`) });

let started;

before(async () => {
  if (!missing) started = await begin(folder);
});
after(() => end(started));

/** A page of the book in a tab of its own; nothing may log an error. */
async function chapter(name, run) {
  const page = await started.browser.newPage();
  const errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.setViewport({ width: 1280, height: 900 });
  try {
    // The page with all chapters would open the dialog of a printer.
    await page.evaluateOnNewDocument(() => (window.print = () => {}));
    await page.goto(started.address + name, { ...PATIENCE, waitUntil: "domcontentloaded" });
    await run(page);
    assert.deepEqual(errors, [], name);
  } finally {
    await page.close();
  }
}

test("an example is tried where it stands, one at a time", { skip: missing, timeout: 300_000 }, () =>
  chapter("tutorial/first-room.html", async (page) => {
    const [first, second] = [1, 2];
    const texts = await page.$$eval("code.language-scene", (all) => all.map((code) => code.textContent));
    const press = (which) => page.$$eval(".playground-bar button", (all, which) => all[which].click(), which);
    await press(first);
    const frame = await (await page.waitForSelector("iframe.playground-frame", PATIENCE)).contentFrame();
    await frame.waitForFunction(() => window.playground?.idle() && window.playground.layout() !== null && document.title.includes("READY"), PATIENCE);
    assert.equal(await frame.evaluate(() => window.playground.text()), texts[first]);
    await page.$eval("iframe.playground-frame", (frame) => frame.scrollIntoView());
    await shoot(page, "book");
    await press(second);
    await page.waitForFunction(() => document.querySelectorAll("iframe.playground-frame").length === 1, PATIENCE);
    assert.deepEqual(await page.$$eval(".playground-bar button", (all) => all.slice(1, 3).map((button) => button.textContent)), ["Try it", "Close"]);
    await press(second);
    await page.waitForFunction(() => document.querySelector("iframe.playground-frame") === null, PATIENCE);
  }));

test("examples have a button, except where they need other files, or are printed", { skip: missing, timeout: 300_000 }, async () => {
  for (const name of ["index.html", "reference/imports.html", "std/guidelines.html", "codes/E0206.html", "print.html"]) {
    await chapter(name, async (page) => {
      const [texts, buttons] = await page.evaluate(() => [
        [...document.querySelectorAll("code.language-scene")].map((code) => code.textContent),
        document.querySelectorAll(".playground-bar button").length,
      ]);
      assert.ok(texts.length > 0, name);
      assert.equal(buttons, name === "print.html" ? 0 : texts.filter((text) => !/^\s*import "(?!std\/)/m.test(text)).length, name);
    });
  }
});
