// The page's side of a worker. Of a worker that was ended, nobody hears any more; the next question starts another.

import script from "virtual:worker";
import { read } from "./engine.js";

interface Reply {
  readonly id: number;
  readonly answer?: string;
  readonly broken?: string;
}

/** Why a question will not be answered: it was called off. */
export class CalledOff extends Error {}

export class Client {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, { done(answer: unknown): void; failed(why: Error): void }>();
  private last = 0;

  /** No worker starts before the module is there: by then the page has the policy that a worker is to have. */
  constructor(private readonly module: Promise<WebAssembly.Module>) {}

  get busy(): boolean {
    return this.waiting.size > 0;
  }

  ask<T>(request: { readonly method: string; readonly [parameter: string]: unknown }): Promise<T> {
    return new Promise((done, failed) => {
      const id = ++this.last;
      this.waiting.set(id, { done: (answer) => done(answer as T), failed });
      this.module.then((module) => {
        // It may have been called off since.
        if (this.waiting.has(id)) (this.worker ?? this.begin(module)).postMessage({ id, request });
      }, failed);
    });
  }

  /** Ends what it does; a worker that waits is kept. */
  callOff(): void {
    if (this.busy) this.end(new CalledOff("it was called off"));
  }

  /** Ends it. */
  end(why: Error): void {
    this.worker?.terminate();
    this.worker = null;
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    for (const { failed } of waiting) failed(why);
  }

  private begin(module: WebAssembly.Module): Worker {
    // From a blob a worker has the policy of the page, by which it cannot reach anything.
    const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
    const worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.addEventListener("message", (e: MessageEvent<Reply>) => this.hear(e.data));
    worker.postMessage({ module });
    this.worker = worker;
    return worker;
  }

  private hear({ id, answer, broken }: Reply): void {
    const asked = this.waiting.get(id);
    this.waiting.delete(id);
    try {
      if (answer !== undefined) asked?.done(read(answer));
      else asked?.failed(new Error(broken));
    } catch (why) {
      asked?.failed(why instanceof Error ? why : new Error(String(why)));
    }
    if (broken !== undefined) this.end(new Error(broken));
  }
}
