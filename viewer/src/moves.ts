// What the user moves: judged on its way, written when let go, taken back with Ctrl+Z.

import type { Triple } from "./data.js";
import type { Move, Verdicts } from "./live.js";
import { Mover } from "./mover.js";

export interface Place {
  readonly pos: Triple;
  readonly rot: Triple;
}

export interface MovesEvents {
  /** Shows an object elsewhere. */
  placed(object: string, place: Place): void;
  judged(move: Move, verdicts: Verdicts): void;
  refused(move: Move, why: unknown): void;
}

interface Step {
  readonly object: string;
  readonly from: Place;
  readonly to: Place;
}

export class Moves {
  private readonly mover: Mover;
  private done: Step[] = [];
  private undone: Step[] = [];

  constructor(
    ask: (move: Move) => Promise<Verdicts>,
    private readonly events: MovesEvents,
  ) {
    this.mover = new Mover(ask, {
      judged: (move, verdicts) => events.judged(move, verdicts),
      refused: (move, why) => {
        // What did not happen cannot be taken back.
        if (move.commit) [this.done, this.undone] = [[], []];
        events.refused(move, why);
      },
    });
  }

  /** Asks what a move would do. */
  consider(object: string, place: Place): void {
    this.mover.send({ object, ...place, commit: false });
  }

  make(object: string, from: Place, to: Place): void {
    this.done.push({ object, from, to });
    this.undone = [];
    this.mover.send({ object, ...to, commit: true });
  }

  undo(): void {
    const step = this.done.pop();
    if (step === undefined) return;
    this.undone.push(step);
    this.go(step.object, step.from);
  }

  redo(): void {
    const step = this.undone.pop();
    if (step === undefined) return;
    this.done.push(step);
    this.go(step.object, step.to);
  }

  private go(object: string, place: Place): void {
    this.events.placed(object, place);
    this.mover.send({ object, ...place, commit: true });
  }
}
