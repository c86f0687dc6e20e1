// The playground: the module is fetched, then nothing more is; the program that the link or an example has is opened.

import { el } from "../../viewer/src/dom.js";
import { Playground } from "./playground.js";
import viewerStyle from "../../viewer/src/style.css";
import style from "./style.css";

async function start(root: HTMLElement): Promise<void> {
  for (const css of [viewerStyle, style]) {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  }
  const module = fetchModule();
  // The text is there to be read before the module is.
  const begun = new Playground(root, module).begin();
  await module;
  await begun;
}

/** The module is packed, so that it is small whatever server the folder is on. */
async function fetchModule(): Promise<WebAssembly.Module> {
  const answer = await fetch("engine.bin");
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
