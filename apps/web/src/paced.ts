/**
 * Carries out what takes a while after frames, in a share of the time at most and one at a time. The frame before a
 * pause counts too: it is made up for once it may be.
 */
export class Paced {
  private restAt = 0; // not before then
  private active = false;
  private again = false; // asked for while it was under way
  private late: ReturnType<typeof setTimeout> | undefined;

  /** `calm`: from the end of one to the next, at least [ms]; `share`: of the time. */
  constructor(private readonly act: () => Promise<unknown>,
    private readonly limits: { readonly calm: number; readonly share: number }) {}

  /** A frame has been simulated or drawn. */
  frame(now: number): void {
    clearTimeout(this.late);
    const wait = this.active ? this.limits.calm : this.restAt - now;
    if (wait <= 0) void this.carryOut();
    else this.late = setTimeout(() => this.frame(performance.now()), wait);
  }

  /** Nothing is made up for. */
  stop(): void {
    clearTimeout(this.late);
  }

  /** At once; where it is under way, once more after that. */
  async carryOut(): Promise<void> {
    this.again = this.active;
    if (this.active) return;
    this.active = true;
    const start = performance.now();
    try {
      await this.act();
    } finally {
      const now = performance.now();
      this.restAt = now + Math.max(this.limits.calm, (now - start) / this.limits.share);
      this.active = false;
    }
    if (this.again) await this.carryOut();
  }
}
