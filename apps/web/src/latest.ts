/**
 * Carries out an asynchronous action for the newest value only: those that come while it is under way replace one
 * another. For sources that are quicker than the world's queue: pointers, sliders, the window's edge.
 */
export class Latest<T> {
  private waiting: { value: T } | null = null;
  private active = false;

  constructor(private readonly act: (value: T) => Promise<unknown>) {}

  set(value: T): void {
    this.waiting = { value };
    if (!this.active) void this.drain();
  }

  private async drain(): Promise<void> {
    this.active = true;
    try {
      while (this.waiting) {
        const { value } = this.waiting;
        this.waiting = null;
        await this.act(value);
      }
    } finally {
      this.active = false;
    }
  }
}
