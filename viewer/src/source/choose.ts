// Which source a page has: an editor says so by its API, a server by the page it serves.

import { Embedded } from "./embedded.js";
import { Server } from "./server.js";
import type { Source } from "./source.js";
import { Webview } from "./webview.js";

export function chooseSource(root: HTMLElement): Source {
  if (globalThis.acquireVsCodeApi !== undefined) return new Webview(globalThis.acquireVsCodeApi());
  const { token } = root.dataset;
  return token === undefined ? new Embedded() : new Server(token);
}
