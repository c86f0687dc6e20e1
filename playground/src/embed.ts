// The script that a book loads from beside the playground: below each program it puts a button, which opens the program in a
// playground on the same page. A book without a playground beside it does not find this script, and has no buttons.

import { encode } from "./link.js";

const ADDRESS = new URL("index.html", (document.currentScript as HTMLScriptElement).src).href;
/** Imports of the library work in the playground; those of other files do not, since it has one file. */
const OTHER_FILES = /^\s*import\s+"(?!std\/)/m;

const STYLE = `
.playground-bar { margin: -0.6em 0 1.4em; text-align: right; }
.playground-bar button { padding: 2px 10px; border: 1px solid var(--table-border-color); border-radius: 6px; background: none; color: var(--links); font: inherit; font-size: 0.85em; cursor: pointer; }
.playground-bar button:hover { border-color: var(--links); }
.playground-frame { display: block; width: 100%; height: min(80vh, 640px); margin: 0 0 0.6em; border: 1px solid var(--table-border-color); border-radius: 6px; }
`;

/** Closes the playground that is open: each has workers and a module of its own, so one is enough. */
let close = (): void => {};

function add(code: HTMLElement): void {
  const text = code.textContent ?? "";
  const pre = code.closest("pre");
  if (pre === null || OTHER_FILES.test(text)) return;
  const bar = document.createElement("div");
  bar.className = "playground-bar";
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Try it";
  bar.append(button);
  pre.after(bar);
  let frame: HTMLIFrameElement | null = null;
  const shut = (): void => {
    frame?.remove();
    frame = null;
    button.textContent = "Try it";
    close = () => {};
  };
  button.addEventListener("click", () => {
    if (frame !== null) return shut();
    void encode({ name: "example.scene", text }).then((fragment) => {
      close();
      frame = document.createElement("iframe");
      frame.className = "playground-frame";
      frame.title = "This program in the playground";
      frame.src = ADDRESS + fragment;
      bar.before(frame);
      button.textContent = "Close";
      close = shut;
    });
  });
}

// The page that has all chapters, for printers, stays as it is.
if (!location.pathname.endsWith("/print.html")) {
  const style = document.createElement("style");
  style.textContent = STYLE;
  document.head.append(style);
  for (const code of document.querySelectorAll<HTMLElement>("code.language-scene")) add(code);
}
