// A browser, and a server of files without a header that helps, for the tests of built pages.
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import puppeteer from "puppeteer-core";

export const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
export const PATIENCE = { timeout: 180_000 };
const FLAGS = ["--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".bin": "application/octet-stream" };

/** Serves a folder to a browser of its own. */
export async function begin(folder) {
  const server = createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://localhost").pathname).slice(1) || "index.html";
    const file = join(folder, name);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { "content-type": TYPES[extname(name)] ?? "text/plain" }).end(readFileSync(file));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const profile = mkdtempSync(join(tmpdir(), "scenelang-playground-"));
  const browser = await puppeteer.launch({ executablePath: chromium, headless: true, args: FLAGS, userDataDir: profile, protocolTimeout: PATIENCE.timeout });
  return { server, profile, browser, address: `http://127.0.0.1:${server.address().port}/` };
}

/** Ends both, if they began. */
export async function end(started) {
  if (started === undefined) return;
  await started.browser.close();
  started.server.close();
  rmSync(started.profile, { recursive: true, force: true });
}
