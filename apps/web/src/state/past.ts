// Saved states of the last seconds, in the order of their time.

const SPAN = 10; // of simulated time that is kept [s]
const MOST_BYTES = 96 << 20; // of all of them
const FEWEST = 12; // that must fit for it to be of use

export interface Moment {
  readonly seconds: number;
  readonly bytes: Uint8Array;
}

export class Past {
  private kept: Moment[] = [];

  get moments(): readonly Moment[] {
    return this.kept;
  }

  clear(): void {
    this.kept = [];
  }

  /** Whether states of so many bytes are small enough to be kept; larger ones would also make frames wait. */
  static takes(bytes: number): boolean {
    return bytes * FEWEST <= MOST_BYTES;
  }

  /** What was at this time or later is another future, and goes; so does what is too old, or too much. */
  keep(moment: Moment): void {
    this.kept = this.kept.filter(({ seconds }) => seconds < moment.seconds && seconds >= moment.seconds - SPAN);
    this.kept.push(moment);
    let bytes = this.kept.reduce((sum, one) => sum + one.bytes.length, 0);
    while (bytes > MOST_BYTES && this.kept.length > 1) bytes -= this.kept.shift()!.bytes.length;
  }
}
