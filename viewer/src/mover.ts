// Moves on their way: one question at a time, the newest waits and takes the place of older ones; what changes the layout is
// never dropped. So a slow answer makes margins late, and never a queue.

import type { Move, Verdicts } from "./live.js";

export interface MoverEvents {
  judged(move: Move, verdicts: Verdicts): void;
  /** A move was refused; `why` says for what reason. */
  refused(move: Move, why: unknown): void;
}

export class Mover {
  private waiting: Move[] = [];
  private busy = false;

  constructor(
    private readonly ask: (move: Move) => Promise<Verdicts>,
    private readonly events: MoverEvents,
  ) {}

  /** Asks what a move would do, or does it. */
  send(move: Move): void {
    this.waiting = [...this.waiting.filter(({ commit }) => commit), move];
    if (!this.busy) void this.run();
  }

  private async run(): Promise<void> {
    this.busy = true;
    for (let move = this.waiting.shift(); move !== undefined; move = this.waiting.shift()) {
      let answer: { verdicts: Verdicts } | { why: unknown };
      try {
        answer = { verdicts: await this.ask(move) };
      } catch (why) {
        answer = { why };
      }
      if ("why" in answer) this.events.refused(move, answer.why);
      else this.events.judged(move, answer.verdicts);
    }
    this.busy = false;
  }
}
