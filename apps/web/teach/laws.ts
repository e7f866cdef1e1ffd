// What a textbook says of each lesson, from the same numbers that its scene gets. SI units.

/** Of a mass on a spring [s]. */
export const period = (mass: number, stiffness: number): number => 2 * Math.PI * Math.sqrt(mass / stiffness);

/**
 * The highest angular frequency of equal masses in a row, joined by equal springs, the first of which hangs on a wall
 * [rad/s]: mode n of 2 √(k/m) sin((2n - 1) π / (4n + 2)).
 */
export function highestFrequency(masses: number, mass: number, stiffness: number): number {
  return 2 * Math.sqrt(stiffness / mass) * Math.sin(((2 * masses - 1) * Math.PI) / (4 * masses + 2));
}

/** The longest step at which semi-implicit Euler follows that frequency without growing [s]. */
export const longestStep = (frequency: number): number => 2 / frequency;

/** How fast what lies on a slope of this angle [rad] slides off, 0 where friction holds it [m/s²]. */
export function slide(angle: number, friction: number, gravity: number): number {
  return Math.tan(angle) <= friction ? 0 : gravity * (Math.sin(angle) - friction * Math.cos(angle));
}

/** What a step of backward Euler leaves of the energy of an oscillation, `phase` = ω h [rad]; forward Euler makes it
 *  grow by the inverse. */
export const backwardEuler = (phase: number): number => 1 / (1 + phase * phase);

/** The same of BDF2: |z|² of the principal root of 3 z² - 4 z + 1 = 2 i ω h z², z = 1 / (2 - √(1 + 2 i ω h)). */
export function bdf2(phase: number): number {
  const length = Math.hypot(1, 2 * phase);
  const real = Math.sqrt((length + 1) / 2), imaginary = Math.sqrt((length - 1) / 2); // of √(1 + 2 i ω h)
  return 1 / ((2 - real) ** 2 + imaginary ** 2);
}
