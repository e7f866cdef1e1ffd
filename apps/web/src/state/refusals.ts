// What an address asks for in vain, as one sentence.

const LONGEST = 24; // letters of a value that a sentence repeats

export class Refusals {
  private readonly faults: string[] = [];

  /** `instead`: what is used in the place of what was refused. */
  constructor(private readonly instead: string) {}

  add(name: string, value: string, must: string): void {
    const shown = value.length > LONGEST ? `${value.slice(0, LONGEST)}…` : value;
    this.faults.push(`${name} is “${shown}”, but must ${must}`);
  }

  /** null where all of it was good. */
  get sentence(): string | null {
    const [first, ...more] = this.faults;
    if (first === undefined) return null;
    const others = more.length === 0 ?
      "" :
      more.length === 1 ?
      ", and one more value is refused" :
      `, and ${more.length} more values are refused`;
    return `In the page's address ${first}${others}; ${this.instead} is used instead.`;
  }
}
