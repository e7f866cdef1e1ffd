/** Stops what is measured between two batches: for a while, where the page is hidden, or for good. */
export class Gate {
  private closed = false;
  private stopped = false;
  private wake: (() => void) | null = null;

  get paused(): boolean {
    return this.closed;
  }
  set paused(on: boolean) {
    this.closed = on;
    this.look();
  }

  stop(): void {
    this.stopped = true;
    this.look();
  }

  /** Lets the page do its own work first. Errors  Stopped. */
  async pass(): Promise<void> {
    await new Promise((done) => setTimeout(done));
    while (!this.stopped && (this.closed || document.hidden))
      await new Promise<void>((done) => {
        this.wake = done;
        document.addEventListener("visibilitychange", () => done(), { once: true });
      });
    if (this.stopped) throw new Stopped();
  }

  private look(): void {
    this.wake?.();
    this.wake = null;
  }
}

export class Stopped extends Error {}
