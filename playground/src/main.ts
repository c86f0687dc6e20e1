// The playground: the module is fetched, then nothing more is; the program that the link or an example has is opened.

import { el } from "../../viewer/src/dom.js";
import { Playground } from "./playground.js";
import viewerStyle from "../../viewer/src/style.css";
import style from "./style.css";

/** Milliseconds for which the page waits for an answer before it shows the text. */
const PATIENCE = 200;

async function start(root: HTMLElement): Promise<void> {
  for (const css of [viewerStyle, style]) {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  }
  const answer = fetch("engine.bin");
  const module = compile(answer);
  // The module is compiled beside this thread. That begins with the answer, which is there at once or takes as long as the
  // network does; the text can be read before.
  await Promise.race([answer.catch(() => {}), new Promise((done) => setTimeout(done, PATIENCE))]);
  const begun = new Playground(root, module).begin();
  await module;
  await begun;
}

/** The module is packed, so that it is small whatever server the folder is on. */
async function compile(asked: Promise<Response>): Promise<WebAssembly.Module> {
  const answer = await asked;
  if (!answer.ok || answer.body === null) throw new Error(`engine.bin: ${answer.status} ${answer.statusText}`);
  const unpacked = answer.body.pipeThrough(new DecompressionStream("gzip"));
  const module = await WebAssembly.compileStreaming(new Response(unpacked, { headers: { "content-type": "application/wasm" } }));
  // From here on neither the page nor its workers can ask anybody for anything; the viewer reads textures from blobs.
  document.head.append(el("meta", { "http-equiv": "Content-Security-Policy", content: "connect-src blob:" }));
  return module;
}

const root = document.getElementById("playground");
if (root !== null) {
  start(root).catch((why: unknown) => {
    root.replaceChildren(el("p.failed", { role: "alert" }, `The playground could not start: ${why instanceof Error ? why.message : String(why)}`));
  });
}
