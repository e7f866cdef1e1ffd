// Baseline: mass-spring cloth on the CPU in JavaScript, on one thread: what Sung et al. (arXiv 2507.11794, experiment
// 1) set WebGPU against. The same step as src/method/mass_spring/reference/mass_spring.cpp: forces at the state before
// the step, damping along the spring, semi-implicit Euler. Source of the equations: docs/solvers/mass_spring.md, (1) to
// (4).
//
// Written for speed: flat typed arrays, each spring once, no lists of springs on a grid, row by row so that what a
// row's springs touch is still in the cache, nothing allocated in a step. Doubles throughout: at 64² to 512² nodes
// Float32Array took 20 % longer for the conversions (V8 of Node 24), and half the memory did not make up for it.
import { restPositions, type Sheet } from "./sheet.js";

const MIN_LENGTH = 1e-9; // m; a shorter spring has no direction, and pulls nowhere

export class CpuSheet {
  readonly position: Float64Array; // x, y, z of every node [m]
  readonly velocity: Float64Array; // [m/s]
  private readonly force: Float64Array; // [N]; 0 between steps
  private readonly pins: readonly { at: number; place: Float64Array }[];

  constructor(private readonly sheet: Sheet) {
    this.position = restPositions(sheet);
    this.velocity = new Float64Array(this.position.length);
    this.force = new Float64Array(this.position.length);
    this.pins = sheet.pinned.map((node) => ({ at: 3 * node, place: this.position.slice(3 * node, 3 * node + 3) }));
  }

  step(): void {
    const { nx, ny, springs } = this.sheet;
    for (let j = 0; j < ny; j++)
      for (const { di, dj, restLength, stiffness } of springs) {
        if (j + dj >= ny) continue;
        const begin = 3 * (j * nx + Math.max(0, -di)), end = 3 * (j * nx + nx - Math.max(0, di));
        this.pull(begin, end, 3 * (dj * nx + di), restLength, stiffness);
      }
    this.integrate();
  }

  /** The springs from the nodes at `begin` up to `end` to those `offset` further on, in places of the arrays. */
  private pull(begin: number, end: number, offset: number, restLength: number, stiffness: number): void {
    const { position: x, velocity: v, force: f } = this;
    const damping = this.sheet.damping;
    for (let a = begin; a < end; a += 3) {
      const b = a + offset;
      const dx = x[b]! - x[a]!, dy = x[b + 1]! - x[a + 1]!, dz = x[b + 2]! - x[a + 2]!;
      const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
      if (length < MIN_LENGTH) continue;
      const inverse = 1 / length;
      const rate = ((v[b]! - v[a]!) * dx + (v[b + 1]! - v[a + 1]!) * dy + (v[b + 2]! - v[a + 2]!) * dz) * inverse;
      const part = (stiffness * (length - restLength) + damping * rate) * inverse; // tension / length [N/m]
      const fx = part * dx, fy = part * dy, fz = part * dz;
      f[a]! += fx;
      f[a + 1]! += fy;
      f[a + 2]! += fz;
      f[b]! -= fx;
      f[b + 1]! -= fy;
      f[b + 2]! -= fz;
    }
  }

  private integrate(): void {
    const { position: x, velocity: v, force: f } = this;
    const { step, nodeMass, gravity: [gx, gy, gz] } = this.sheet;
    const part = step / nodeMass;
    for (let at = 0; at < x.length; at += 3) {
      v[at]! += part * f[at]! + step * gx;
      v[at + 1]! += part * f[at + 1]! + step * gy;
      v[at + 2]! += part * f[at + 2]! + step * gz;
      x[at]! += step * v[at]!;
      x[at + 1]! += step * v[at + 1]!;
      x[at + 2]! += step * v[at + 2]!;
      f[at] = f[at + 1] = f[at + 2] = 0;
    }
    for (const { at, place } of this.pins) { // put back, rather than asked for at every node
      x.set(place, at);
      v.fill(0, at, at + 3);
    }
  }
}
