// The hand that holds the cloth. It goes after the pointer, but its speed in simulated time is bounded by the pointer's
// in real time: on a machine that simulates a twentieth of real time, a pull of a third of a second lasts some seconds,
// and does not tear the cloth away within a frame.

/** [CSS pixels] */
export interface Place {
  readonly x: number;
  readonly y: number;
}

const WINDOW = 50; // over which the pointer's speed is taken [ms]
const CATCH_UP = 1.5; // of that speed; as fast as the pointer, the hand would never make up for the window

const distance = (a: Place, b: Place): number => Math.hypot(b.x - a.x, b.y - a.y);

export class Hand {
  private pointer: Place;
  private moves: { at: number; way: number }[] = []; // of the pointer, within the window
  private speed = 0; // the highest allowed since the hand was where the pointer is [CSS pixels/s]

  constructor(private place: Place) {
    this.pointer = place;
  }

  /** Whether it is where the pointer is. */
  get arrived(): boolean {
    return this.place === this.pointer;
  }

  /** The pointer has come to a place; `at`: the event's time [ms]. */
  follow(to: Place, at: number): void {
    this.moves = [...this.moves.filter((move) => move.at > at - WINDOW), { at, way: distance(this.pointer, to) }];
    this.pointer = to;
    const way = this.moves.reduce((sum, move) => sum + move.way, 0);
    this.speed = Math.max(this.speed, (CATCH_UP * 1000 * way) / WINDOW);
  }

  /** Where it is after so much more simulated time [s]; Infinity: with the pointer. */
  after(seconds: number): Place {
    const left = distance(this.place, this.pointer);
    const way = this.speed * seconds;
    if (left === 0 || way >= left) {
      this.place = this.pointer;
      this.speed = 0;
    } else {
      const part = way / left;
      this.place = { x: this.place.x + part * (this.pointer.x - this.place.x),
        y: this.place.y + part * (this.pointer.y - this.place.y) };
    }
    return this.place;
  }
}
