// A page that carries its room: `<script type="application/json" id="scenelang-data">`. A page around it, or a script in it,
// may send another as a message `{type: "scenelang-data", data}`. Nothing can be moved here: there is nobody to keep it.

import type { Sink, Source } from "./source.js";

export class Embedded implements Source {
  readonly move = null;

  start(sink: Sink): void {
    window.addEventListener("message", (e: MessageEvent<{ type?: unknown; data?: unknown } | null>) => {
      // Only this page itself and the one it is framed in may say what to show.
      if (e.source !== window && e.source !== window.parent) return;
      if (e.data?.type === "scenelang-data") sink.load(e.data.data);
    });
    const text = document.getElementById("scenelang-data")?.textContent?.trim();
    if (text === undefined || text === "") sink.wait("");
    else sink.loadText(text);
  }

  reveal(): void {}
}
