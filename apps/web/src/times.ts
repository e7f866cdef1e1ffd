/** The median of the last measurements of something [ms]. */
export class Times {
  private last: readonly number[] = [];

  constructor(private readonly kept: number) {}

  add(time: number): void {
    this.last = [...this.last.slice(1 - this.kept), time];
  }

  /** Adds what an action takes until it is done; one that fails does not count. */
  async measure(action: () => Promise<unknown>): Promise<void> {
    const start = performance.now();
    await action();
    this.add(performance.now() - start);
  }

  clear(): void {
    this.last = [];
  }

  /** null: nothing has been measured. */
  get median(): number | null {
    const sorted = this.last.toSorted((a, b) => a - b);
    const middle = sorted.length >> 1;
    if (sorted.length === 0) return null;
    return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
  }
}
