// A worker: one instance of the module, asked one thing after the other.
//
//   to it:    {module} once, then {id, request}
//   from it:  {id, answer}, or {id, broken}: the instance has trapped, and answers no more

import { type Ask, start } from "./engine.js";

type Message = { readonly module: WebAssembly.Module } | { readonly id: number; readonly request: unknown };

let ask: Promise<Ask> | undefined;

self.addEventListener("message", (e: MessageEvent<Message>) => {
  const message = e.data;
  if ("module" in message) ask = start(message.module);
  else void answer(message.id, message.request);
});

async function answer(id: number, request: unknown): Promise<void> {
  try {
    const asked = await ask;
    self.postMessage({ id, answer: asked?.(request) });
  } catch (why) {
    const tooMuch = why instanceof WebAssembly.RuntimeError || why instanceof RangeError;
    self.postMessage({ id, broken: tooMuch ? "it is too much for this page" : why instanceof Error ? why.message : String(why) });
  }
}
