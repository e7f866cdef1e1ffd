// Simulated time beside the clock's.

const SPAN = 2000; // ms over which the pace is looked at
const SLACK = 0.5; // ms by which a display of 60 Hz may tick early

export class Pace {
  private last = 0; // when it was asked last [ms]
  private due_ = 0; // simulated time that has come due since the last frame [ms]
  private marks: number[] = []; // when frames were simulated [ms]

  /** `frame`: its simulated time [ms]. */
  constructor(private readonly frame: number) {}

  /** From now on; what has passed before does not count. */
  begin(now: number): void {
    this.last = now;
    this.due_ = 0;
    this.marks = [];
  }

  /** Whether it is time for a frame, which then is to be simulated. What is late by more than a frame is dropped. */
  due(now: number): boolean {
    this.due_ = Math.min(this.due_ + Math.max(0, now - this.last), 2 * this.frame);
    this.last = now;
    if (this.due_ + SLACK < this.frame) return false;
    this.due_ -= this.frame;
    const old = this.marks.filter((mark) => now - mark > SPAN).length;
    this.marks = [...this.marks.slice(Math.min(old, Math.max(0, this.marks.length - 1))), now];
    return true;
  }

  /** Simulated over passed time; null before it is known. */
  get share(): number | null {
    const passed = this.marks.length > 1 ? this.marks.at(-1)! - this.marks[0]! : 0;
    return passed > 0 ? ((this.marks.length - 1) * this.frame) / passed : null;
  }
}
