// The page's limits on a visitor's file. Each is reported with the value that exceeds it.

export const MOST_BYTES = 64_000_000; // of the files that are opened together, packed or not
export const MOST_STATE_BYTES = 512_000_000; // of a saved state: more than a million nodes in contact have
export const MOST_SCENE_BYTES = 16_000_000; // of a scene's JSON, the core's bound too
export const MOST_SECONDS = 10; // that reading may take
/** The core sorts a cloth's springs and finds its step on the page's own thread. */
export const MOST_CLOTH_NODES = 200_000;
export const MOST_SCENE_NODES = 1_048_576; // of a scene's grids: as the page's address allows
export const MOST_OBSTACLE_TRIANGLES = 1_000_000;
export const MOST_SUBSTEPS = 1024; // a frame: beyond, one frame keeps a GPU busy for so long that it may be given up
/** Of a mesh's longest side [m]. */
export const LENGTH = { least: 0.1, most: 10, first: 1.2 };
export const MOST_VIDEO_SECONDS = 60;

const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
const one = new Intl.NumberFormat("en", { minimumFractionDigits: 1, maximumFractionDigits: 1 });
const digits = new Intl.NumberFormat("en", { maximumSignificantDigits: 3 });

export const count = (number: number): string => whole.format(number);
export const megabytes = (bytes: number): string => `${one.format(bytes / 1e6)} MB`;

/** Refuses what is over a limit. `things` are counted; without, they are bytes. */
export function checkLimit(name: string, value: number, most: number, things: string | null = null): void {
  if (value <= most) return;
  const over = things === null ? megabytes(value) : `${count(value)} ${things}`;
  throw new Error(`${name}: ${over} are more than the limit of ${things === null ? megabytes(most) : count(most)}.`);
}

/** Three lengths, as "1.2 × 0.8 × 0.4". */
export const box = (sides: readonly number[]): string => sides.map((side) => digits.format(side)).join(" × ");
