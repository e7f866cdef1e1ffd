/** Calls `tick` in each frame of the display while it runs, with the time since the last call or the start [ms]. */
export class Ticks {
  private timer = 0;
  private last = 0;

  constructor(private readonly tick: (elapsed: number) => void) {}

  get running(): boolean {
    return this.timer !== 0;
  }

  run(on: boolean): void {
    if (on === this.running) return;
    if (on) {
      this.last = performance.now();
      this.timer = requestAnimationFrame((now) => this.next(now));
    } else {
      cancelAnimationFrame(this.timer);
      this.timer = 0;
    }
  }

  private next(now: number): void {
    this.timer = requestAnimationFrame((next) => this.next(next));
    const elapsed = now - this.last;
    this.last = now;
    this.tick(elapsed);
  }
}
