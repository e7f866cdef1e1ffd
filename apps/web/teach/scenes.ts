// The scenes of the lessons, made from the numbers of their sliders.
import type { Scene } from "weft-cloth";
import { SEMI_IMPLICIT_EULER, type Integrator } from "./integrators.js";

export const GRAVITY = 9.81; // m/s²

export interface Chain {
  readonly masses: number;
  /** Of each [kg]. */
  readonly mass: number;
  /** Of each spring [N/m]. */
  readonly stiffness: number;
  /** Of each spring at rest [m]. */
  readonly length: number;
  readonly gravity: number;
  /** A frame has one step [s]. */
  readonly step: number;
  readonly solver: Integrator;
}

/** Masses below each other on springs without damping, as two equal columns side by side: a grid has no fewer. */
export function chain({ masses, mass, stiffness, length, gravity, step, solver }: Chain): Scene {
  return { format: "weft-scene/1", gravity: [0, -gravity, 0], time: { frame: step, substeps: 1 }, solver,
    contact: { method: "none" },
    cloths: [{ grid: [2, masses + 1], size: [length, masses * length], node_mass: mass, damping: 0,
      stiffness: { structural: stiffness, shear: 0, bend: 0 }, pins: ["top"] }] };
}

/** The heights of the first column's nodes, of its pin first [m]. */
export function column(positions: Float32Array): number[] {
  return Array.from({ length: positions.length / 6 }, (_, row) => positions[6 * row + 1]!);
}

export const FRAME = 1 / 60; // s

/** A small sheet on a slope of this angle [rad]: gravity is tilted instead of the slope, and +x is down. */
export function slope(angle: number, friction: number): Scene {
  return { format: "weft-scene/1", gravity: [GRAVITY * Math.sin(angle), -GRAVITY * Math.cos(angle), 0],
    time: { frame: FRAME }, solver: SEMI_IMPLICIT_EULER, contact: { method: "proximity", thickness: 0.005 },
    cloths: [{ grid: [4, 4], size: [0.3, 0.3], plane: "xz", transform: { translate: [0, 0.005, 0] }, density: 0.3,
      stiffness: { structural: 60, shear: 12, bend: 0.5 }, damping: 0.01, friction }],
    colliders: [{ kind: "plane", point: [0, 0, 0], normal: [0, 1, 0], friction }] };
}

/** A flat sheet of 2 m that falls from two corners: stiff springs, whatever its grid is. */
export function sheet(nodes: number, solver: Integrator, substeps: number | "auto"): Scene {
  return { format: "weft-scene/1", drag: 0.2, time: { frame: FRAME, substeps }, solver, contact: { method: "none" },
    cloths: [{ grid: [nodes, nodes], size: [2, 2], plane: "xz", bump: 0.001, density: 0.15, damping: 0,
      stiffness: { structural: 1500, shear: 750, bend: 15 }, pins: ["top_left", "top_right"] }] };
}
