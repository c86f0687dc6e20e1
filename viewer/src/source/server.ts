// A page of `scenelang view`: the room over HTTP, news of it as server-sent events, moves as requests.
//
//   GET  scene?known=SHAPE   the room, without the geometry where that is known
//   GET  events  `changed`, `stale` (data: why), `select` (data: an object, or a row by its id)
//   POST move    {object, pos, rot, commit} -> verdicts
//
// Every request needs the cookie that the browser got for the secret in the printed address. A move also needs a token that
// only the page knows (`data-token`): a page on another port of this machine has requests sent with the cookie, but not with
// this header.

import { type Move, readVerdicts, type Verdicts } from "../live.js";
import { Shapes } from "./shapes.js";
import type { Sink, Source } from "./source.js";

export class Server implements Source {
  private readonly shapes = new Shapes();

  constructor(private readonly token: string) {}

  start(sink: Sink): void {
    sink.wait("");
    // The first event comes at once, and again after a connection was lost.
    const events = new EventSource("events");
    const fetchRoom = async () => {
      const answer = await fetch(`scene?known=${encodeURIComponent(this.shapes.known)}`);
      if (answer.ok) sink.load(this.shapes.whole(await answer.json()));
      else sink.stale((await answer.text()) || answer.statusText);
    };
    const load = () => void fetchRoom().catch((why: unknown) => sink.stale(String(why)));
    events.addEventListener("changed", load);
    events.addEventListener("select", (e: MessageEvent<string>) => sink.select(e.data));
    events.addEventListener("stale", (e: MessageEvent<string>) => sink.stale(e.data));
    events.addEventListener("error", () => sink.stale("the server has gone; scenelang view starts it again"));
  }

  readonly move = async (move: Move): Promise<Verdicts> => {
    const headers = { "content-type": "application/json", "x-scenelang-token": this.token };
    const answer = await fetch("move", { method: "POST", headers, body: JSON.stringify(move) });
    if (!answer.ok) throw new Error((await answer.text()) || answer.statusText);
    return readVerdicts(await answer.json());
  };

  reveal(): void {}
}
