// The page: chooses where its room comes from, and starts.

import { App, type Hook } from "./app.js";
import { el } from "./dom.js";
import { chooseSource } from "./source/choose.js";
import css from "./style.css";

declare global {
  interface Window {
    scenelang: Hook;
  }
}

function start(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(css);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  document.getElementById("fallback")?.remove();
  let root = document.getElementById("scenelang");
  if (root === null) {
    root = el("main", { id: "scenelang" });
    document.body.append(root);
  }
  const source = chooseSource(root);
  const app = new App(root, source);
  window.scenelang = app.hook;
  source.start(app);
}

if (document.readyState === "loading") document.addEventListener("DOMContentLoaded", start);
else start();
