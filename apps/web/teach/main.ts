import { button, element } from "../src/elements.js";
import { sentence } from "../src/sentence.js";
import { LessonView } from "./lesson_view.js";
import { energy } from "./lessons/energy.js";
import { Fineness } from "./lessons/fineness.js";
import { friction } from "./lessons/friction.js";
import { spring } from "./lessons/spring.js";
import { stability } from "./lessons/stability.js";
import { showStoredTimes } from "./stored_times.js";

/** `window.teach`, for tests and the browser's console. */
export interface TeachHandle {
  /** All lessons that compute by themselves have done so. */
  readonly ready: Promise<void>;
  /** When all that has been asked for so far is shown. */
  settled(): Promise<void>;
  /** The numbers that are shown, by their id. */
  readings(): Record<string, number | string>;
}

const fineness = new Fineness();
const views = [
  new LessonView({ name: "spring", axes: { x: "time [s]", y: "fallen [cm]" },
    sliders: ["spring-mass", "spring-stiffness"], compute: spring }),
  new LessonView({ name: "stability", axes: { x: "steps", y: "farthest way [10ⁿ m]" },
    sliders: ["stability-masses", "stability-percent"], compute: stability }),
  new LessonView({ name: "fineness", axes: { x: "nodes along a side", y: "time of a frame [ms]" },
    sliders: ["fineness-error"], compute: async (percent) => fineness.course(percent) }),
  new LessonView({ name: "friction", axes: { x: "angle of the slope [°]", y: "acceleration [m/s²]" },
    sliders: ["friction-slope", "friction-coefficient"], compute: friction }),
  new LessonView({ name: "energy", axes: { x: "periods", y: "energy left [%]" }, sliders: ["energy-steps"],
    compute: energy }),
];
let measuring: Promise<void> = Promise.resolve();

button("fineness-measure").addEventListener("click", () => {
  const said = element("fineness-verdict", HTMLParagraphElement);
  button("fineness-measure").disabled = true;
  measuring = fineness.measure((size) => {
    said.textContent = `${size} × ${size} nodes are being measured.`;
  }).then(() => views[2]!.update(), (reason: unknown) => {
    said.textContent = sentence(reason);
  }).finally(() => {
    button("fineness-measure").disabled = false;
  });
});

showStoredTimes();
const all = async (): Promise<void> => {
  await measuring;
  await Promise.all(views.map(({ settled }) => settled));
};
const ready = Promise.all(views.map((view) => view.update())).then(all);
const handle: TeachHandle = {
  ready,
  settled: all,
  readings: () =>
    Object.fromEntries(
      views.flatMap(({ course }) => Object.entries(course?.readings ?? {})).map((
        [id, reading],
      ) => [id, typeof reading === "string" ? reading : reading.value]),
    ),
};
Object.assign(window, { teach: handle });
