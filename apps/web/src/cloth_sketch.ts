// A cloth's triangles on a 2D canvas, the far ones first. Shading only: where the nodes are comes from the core.
// Light and sky are those of shaders/render (lighting.wgsl, cloth.wgsl), without shadow and single threads.
import type { Point } from "weft-cloth";

/** Where the picture is taken from. */
export interface Look {
  eye: Point;
  target: Point;
  /** Vertical field of view [degrees]. */
  fov: number;
}

type Vector = [number, number, number];

// Linear colours: the first dye of src/render/cloth_surface.cpp, and how far the back is blended with its colour there.
const BASE: Vector = [0.0331, 0.1548, 0.2140];
const DARK: Vector = [0.0100, 0.0331, 0.0782];
const BACK: Vector = [0.5711, 0.2140, 0.1329];
const BACK_PART = 0.68;
const BAND = 3; // meshes that a stripe is wide
const KEY: Vector = [1.92, 1.85, 1.73];
const SKY: Vector = [0.37, 0.405, 0.465];
const GROUND: Vector = [0.185, 0.168, 0.15];
const WRAP = 0.16; // how far light reaches round the terminator
const THROUGH = 0.16; // the share of the sun that comes through
const STEEPEST = 1.45; // of the camera, from the horizon [rad]
const NARROW = 1.2; // a picture narrower than this shows as much of the width as one of this aspect
const SEAM = 0.8; // each triangle is drawn this much larger, or the background shows between two [pixel]

export class ClothSketch {
  private readonly look: { target: Point; distance: number; azimuth: number; elevation: number; slope: number };
  private readonly light: Vector;
  private readonly normals: Float32Array; // 3 a node, not of unit length
  private readonly seen: Float32Array; // x, y [pixel] and depth [m] of each node
  private readonly depths: Float32Array; // of each triangle [m]
  private readonly order: Uint32Array;
  private readonly dyes: readonly Vector[]; // of each triangle's front, linear

  constructor(private readonly canvas: HTMLCanvasElement, private readonly context: CanvasRenderingContext2D,
    private readonly triangles: Uint32Array, grid: readonly [number, number], { eye, target, fov }: Look) {
    const back = minus(eye, target);
    const distance = Math.hypot(...back);
    this.look = { target, distance, azimuth: Math.atan2(back[0], back[2]), elevation: Math.asin(back[1] / distance),
      slope: Math.tan((fov * Math.PI) / 360) };
    const { right } = this.axes();
    const flat = unit([back[0], 0, back[2]]);
    // From above, left of the first view: it stays where it is when the eye moves (render/camera.cpp).
    this.light = unit(
      [0, 1, 2].map((axis) => -0.85 * right[axis]! + (axis === 1 ? 0.9 : 0) + 0.4 * flat[axis]!) as Vector,
    );
    const nodes = grid[0] * grid[1];
    this.normals = new Float32Array(3 * nodes);
    this.seen = new Float32Array(3 * nodes);
    this.depths = new Float32Array(triangles.length / 3);
    this.order = Uint32Array.from(this.depths.keys());
    this.dyes = Array.from(this.depths,
      (_, triangle) => dyeOf(triangles.subarray(3 * triangle, 3 * triangle + 3), grid[0]));
  }

  /** Turns the eye about the target, to the right and upwards [rad]. */
  orbit(dx: number, dy: number): void {
    this.look.azimuth += dx;
    this.look.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, this.look.elevation + dy));
  }

  /** `positions`: x, y, z of every node [m]. */
  draw(positions: Float32Array): void {
    this.project(positions);
    this.findNormals(positions);
    this.sort();
    const { context, triangles, seen } = this;
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.lineWidth = 2 * SEAM;
    context.lineJoin = "round";
    const { back } = this.axes();
    for (const triangle of this.order) {
      const [a, b, c] = [0, 1, 2].map((corner) => 3 * triangles[3 * triangle + corner]!) as Vector;
      const turn = (seen[b]! - seen[a]!) * (seen[c + 1]! - seen[a + 1]!) -
        (seen[b + 1]! - seen[a + 1]!) * (seen[c]! - seen[a]!);
      const front = turn < 0; // y points down, so what is counter-clockwise turns negative
      const dye = this.dyes[triangle]!;
      const color = this.lit(a, b, c, front, front ? dye : mix(dye, BACK, BACK_PART), back);
      context.fillStyle = color;
      context.strokeStyle = color;
      context.beginPath();
      context.moveTo(seen[a]!, seen[a + 1]!);
      context.lineTo(seen[b]!, seen[b + 1]!);
      context.lineTo(seen[c]!, seen[c + 1]!);
      context.closePath();
      context.fill();
      context.stroke();
    }
  }

  private axes(): { right: Vector; up: Vector; back: Vector } {
    const { azimuth, elevation } = this.look;
    const back: Vector = [Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation),
      Math.cos(azimuth) * Math.cos(elevation)];
    const right: Vector = [Math.cos(azimuth), 0, -Math.sin(azimuth)];
    return { right, back, up: cross(back, right) };
  }

  private project(positions: Float32Array): void {
    const { width, height } = this.canvas;
    const { target, distance, slope } = this.look;
    const { right, up, back } = this.axes();
    const scale = Math.min(height, width / NARROW) / (2 * slope);
    for (let at = 0; at < positions.length; at += 3) {
      const p = minus([positions[at]!, positions[at + 1]!, positions[at + 2]!], target);
      const depth = Math.max(distance - dot(p, back), 0.01 * distance);
      this.seen[at] = 0.5 * width + (scale * dot(p, right)) / depth;
      this.seen[at + 1] = 0.5 * height - (scale * dot(p, up)) / depth;
      this.seen[at + 2] = depth;
    }
  }

  private findNormals(positions: Float32Array): void {
    this.normals.fill(0);
    const place = (at: number): Vector => [positions[at]!, positions[at + 1]!, positions[at + 2]!];
    for (let first = 0; first < this.triangles.length; first += 3) {
      const corners = [0, 1, 2].map((corner) => 3 * this.triangles[first + corner]!) as Vector;
      const [a, b, c] = corners.map(place) as [Vector, Vector, Vector];
      const normal = cross(minus(b, a), minus(c, a)); // as long as the triangle is large: that is its weight
      for (const corner of corners)
        for (const axis of [0, 1, 2] as const) this.normals[corner + axis]! += normal[axis];
    }
  }

  private sort(): void {
    for (let triangle = 0; triangle < this.depths.length; triangle++)
      this.depths[triangle] = [0, 1, 2].reduce(
        (sum, corner) => sum + this.seen[3 * this.triangles[3 * triangle + corner]! + 2]!,
        0,
      );
    this.order.sort((a, b) => this.depths[b]! - this.depths[a]!);
  }

  private lit(a: number, b: number, c: number, front: boolean, albedo: Vector, toEye: Vector): string {
    const sum = [0, 1, 2].map((axis) =>
      this.normals[a + axis]! + this.normals[b + axis]! + this.normals[c + axis]!
    ) as Vector;
    const side = front ? 1 : -1;
    const normal = unit(sum).map((value) => side * value) as Vector;
    const facing = dot(normal, this.light);
    const sun = saturate((facing + WRAP) / (1 + WRAP)) + THROUGH * saturate(-facing);
    const ambient = 0.72 + 0.4 * saturate(dot(normal, toEye));
    const sky = mix(GROUND, SKY, 0.5 + 0.5 * normal[1]);
    const light = albedo.map((value, axis) => value * (KEY[axis]! * sun + ambient * sky[axis]!));
    return `rgb(${light.map((value) => Math.round(255 * encoded(value))).join(" ")})`;
  }
}

/** The colour of a check at the mesh that a triangle is half of: a warp and a weft of two tones, blended. */
function dyeOf(corners: Uint32Array, across: number): Vector {
  const thread = (mesh: number) => (Math.floor(mesh / BAND) % 2 === 0 ? BASE : DARK);
  const column = Math.min(...Array.from(corners, (node) => node % across));
  const row = Math.min(...Array.from(corners, (node) => Math.floor(node / across)));
  return mix(thread(column), thread(row), 0.5);
}

/** sRGB of a linear value. The dyes stay below the renderer's shoulder, so there is no tone curve here. */
function encoded(linear: number): number {
  return linear <= 0.0031308 ? 12.92 * linear : Math.min(1, 1.055 * linear ** (1 / 2.4) - 0.055);
}

const saturate = (value: number): number => Math.min(1, Math.max(0, value));
const minus = (a: Point, b: Point): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const mix = (a: Point, b: Point,
  part: number): Vector => [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point,
  b: Point): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (v: Vector): Vector => {
  const length = Math.hypot(...v) || 1;
  return [v[0] / length, v[1] / length, v[2] / length];
};
