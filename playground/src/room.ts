// The room beside the editor: the viewer, whose source is the module.

import { readVerdicts, type Move, type Verdicts } from "../../viewer/src/live.js";
import { Shapes } from "../../viewer/src/source/shapes.js";
import type { Pointed, Sink, Source } from "../../viewer/src/source/source.js";

export interface Mover {
  /** Judges a move, or makes it. */
  move(move: Move): Promise<unknown>;
  /** Something was pressed in the room or in the list. */
  reveal(pointed: Pointed): void;
}

export class Room implements Source {
  private readonly shapes = new Shapes();
  private sink: Sink | null = null;

  constructor(private readonly mover: Mover) {}

  start(sink: Sink): void {
    this.sink = sink;
    sink.wait("");
  }

  /** The geometry that need not be sent again. */
  get known(): string {
    return this.shapes.known;
  }

  /** A room with its geometry. */
  whole(data: unknown): unknown {
    return this.shapes.whole(data);
  }

  wait(why: string): void {
    this.sink?.wait(why);
  }

  stale(why: string | null): void {
    this.sink?.stale(why);
  }

  readonly move = async (move: Move): Promise<Verdicts> => readVerdicts(await this.mover.move(move));

  reveal(pointed: Pointed): void {
    this.mover.reveal(pointed);
  }
}
