import { catalog, type World } from "weft-cloth";
import { element } from "../src/elements.js";
import { adapterLimits } from "../src/memory.js";
import { sentence } from "../src/sentence.js";
import { missingDevice, missingSupport, type Missing } from "../src/support.js";
import { read, type Asking } from "./address.js";
import type { Reading } from "./lock_step.js";
import { MethodsPage, say, showProblem } from "./methods_page.js";
import { offersOf, substepsSchema } from "./offers.js";
import { SCENES } from "./scenes.js";
import { MOST_CHOICES, type MethodsState } from "./state.js";
import { byNearness, kindsOf } from "./stored_run.js";
import { STORED, StoredView } from "./stored_view.js";

/** `window.methods`, for tests and the browser's console. */
export interface MethodsHandle {
  /** All that the address asks for is at rest, or refused. Rejects where the page can simulate nothing. */
  readonly ready: Promise<void>;
  readonly state: MethodsState | null;
  readonly frames: number;
  readonly playing: boolean;
  /** One for each method; null where it was refused. */
  readonly worlds: readonly (World | null)[];
  readonly readings: readonly (Reading | null)[];
  /** When all that has been asked for so far is done. */
  settled(): Promise<void>;
}

function showMissing({ cause, advice }: Missing): void {
  element("live", HTMLDivElement).hidden = true;
  element("fallback", HTMLDivElement).hidden = false;
  element("fallback-cause", HTMLParagraphElement).textContent = cause;
  element("fallback-advice", HTMLParagraphElement).textContent = advice;
}

let page: MethodsPage | null = null;

async function start(): Promise<void> {
  const offers = await catalog();
  const found = offersOf(offers), stored = kindsOf(STORED);
  // A colour for each: first those of the stored run, then those that are newer.
  const colours = [...stored, ...found.map(({ kind }) => kind).filter((kind) => !stored.includes(kind))];
  new StoredView(colours);
  const missing = await missingSupport();
  if (missing) {
    showMissing(missing);
    throw new Error(missing.cause);
  }
  // The first is what the others are compared with, so the nearest one to the stored run's reference is.
  const usual = byNearness(STORED, found.map(({ kind }) => kind)).slice(0, MOST_CHOICES);
  const asking: Asking = { offers: found, substeps: substepsSchema(offers.schema), usual,
    scenes: SCENES.map(({ name }) => name) };
  const { state, refused } = read(location.href, asking);
  page = new MethodsPage(offers, asking, await adapterLimits(), colours, state);
  showProblem(refused);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!still) page.lockStep.play(true); // as soon as there is something to play
  await page.open();
  if (page.worlds.every((world) => world === null)) {
    const device = await missingDevice();
    if (device) showMissing(device);
  }
  if (still) say("Your system asks for less motion, so the cloth waits until you press Play.");
}

const ready = start();
ready.catch((reason: unknown) => {
  if (element("fallback", HTMLDivElement).hidden) showProblem(sentence(reason));
});
const handle: MethodsHandle = {
  ready,
  get state() {
    return page?.state ?? null;
  },
  get frames() {
    return page?.lockStep.frames ?? 0;
  },
  get playing() {
    return page?.lockStep.playing ?? false;
  },
  get worlds() {
    return page?.worlds ?? [];
  },
  get readings() {
    return page?.readings ?? [];
  },
  settled: () => page?.lockStep.settled ?? Promise.resolve(),
};
Object.assign(window, { methods: handle });
