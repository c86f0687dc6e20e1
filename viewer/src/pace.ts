// Whether motion is smooth here, from the time between its frames: where it is not, frames in motion do without what is dear.
// On a machine without a graphics card every frame is slow; what stands still may take its time even there.

/** Milliseconds from one frame to the next from which motion is not smooth. */
const LONG = 45;
/** One frame may be late for any reason; so many in a row are the machine. */
const LATE = 3;

export class Pace {
  private before: number | null = null;
  private late = 0;

  /** Motion was not smooth. That stays so: to try again and again would make the picture flicker. */
  get slow(): boolean {
    return this.late >= LATE;
  }

  /** A frame at a time (ms); `more`: the next one follows as soon as it can. */
  frame(now: number, more: boolean): void {
    if (this.before !== null && !this.slow) this.late = now - this.before > LONG ? this.late + 1 : 0;
    this.before = more ? now : null;
  }
}
