// A lesson on the page: its sliders, its readings, its plot, and its picture in time. What is shown has been computed
// before, so it is played at its own pace on any machine.
import { significant } from "../src/digits.js";
import { element, input } from "../src/elements.js";
import { LinePlot, type Axes, type Curve } from "../src/line_plot.js";
import { sentence } from "../src/sentence.js";
import { Ticks } from "../src/ticks.js";
import type { Course, Pen, Quantity } from "./course.js";

const REST = 0.8; // s, at the end, before it begins anew

export interface LessonOptions {
  /** Of the page's elements: a canvas NAME-canvas, a plot NAME-plot, and so on. */
  readonly name: string;
  readonly axes: Axes;
  /** Ids of its sliders; `compute` gets their values in this order. */
  readonly sliders: readonly string[];
  /** null: there is nothing to show yet. */
  compute(...values: number[]): Promise<Course | null>;
}

const still = matchMedia("(prefers-reduced-motion: reduce)");

export class LessonView {
  private course_: Course | null = null;
  private readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private readonly plot: LinePlot;
  private playing = !still.matches;
  private visible = false;
  private readonly ticks = new Ticks((elapsed) => this.tick(elapsed));
  private readonly player: HTMLButtonElement;
  private seconds = 0;
  private asked = 0;
  private turn: Promise<void> = Promise.resolve();

  constructor(private readonly options: LessonOptions) {
    const { name, axes, sliders } = options;
    this.canvas = element(`${name}-canvas`, HTMLCanvasElement);
    const context = this.canvas.getContext("2d");
    if (!context) throw new Error("The canvas gives no context to draw in.");
    this.context = context;
    this.plot = new LinePlot(element(`${name}-plot`, HTMLDivElement), axes);
    for (const id of sliders) input(id).addEventListener("input", () => void this.update());
    this.player = playButton(name);
    this.player.addEventListener("click", () => this.play(!this.playing));
    this.canvas.parentElement!.querySelector("figcaption")!.prepend(this.player);
    new IntersectionObserver(([entry]) => {
      this.visible = entry!.isIntersecting;
      this.schedule();
    }).observe(this.canvas);
    document.addEventListener("visibilitychange", () => this.schedule());
    addEventListener("resize", () => this.show());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    this.play(this.playing);
  }

  get course(): Course | null {
    return this.course_;
  }
  /** When all that has been asked for so far is shown. */
  get settled(): Promise<void> {
    return this.turn;
  }

  /** Computes anew with the sliders as they are now; of several calls in a row the last one counts. */
  update(): Promise<void> {
    const number = ++this.asked;
    const { name, sliders } = this.options;
    for (const id of sliders)
      element(`${id}-value`, HTMLOutputElement).value = `${input(id).value}${input(id).dataset["unit"] ?? ""}`;
    this.turn = this.turn.then(async () => {
      if (number !== this.asked) return;
      try {
        this.course_ = await this.options.compute(...sliders.map((id) => Number(input(id).value)));
        this.seconds = 0;
        this.show();
      } catch (reason) {
        element(`${name}-verdict`, HTMLParagraphElement).textContent = sentence(reason);
      }
    });
    return this.turn;
  }

  private show(): void {
    const { course } = this;
    const { name } = this.options;
    this.player.disabled = course === null;
    if (!course) return;
    for (const [id, reading] of Object.entries(course.readings))
      element(id, HTMLElement).textContent = inWords(reading);
    element(`${name}-verdict`, HTMLParagraphElement).textContent = course.verdict;
    element(`${name}-legend`, HTMLUListElement).replaceChildren(...course.curves.map(legendItem));
    this.plot.draw(course.curves, course.range);
    this.draw();
  }

  private play(on: boolean): void {
    this.playing = on;
    this.player.dataset["playing"] = String(on);
    element(`${this.options.name}-play-label`, HTMLSpanElement).textContent = on ? "Pause" : "Play";
    this.schedule();
  }

  private schedule(): void {
    this.ticks.run(this.playing && this.visible && !document.hidden);
  }

  private tick(elapsed: number): void {
    if (!this.course_) return;
    const { duration, slowed = 1 } = this.course_;
    // The time of a frame may lie before the click that began it.
    this.seconds += Math.max(0, elapsed) / 1000 / slowed;
    if (this.seconds > duration + REST / slowed) this.seconds = 0;
    this.draw();
  }

  private draw(): void {
    const { canvas, context, course } = this;
    if (!course || canvas.clientWidth === 0) return;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    const size = [Math.round(width * devicePixelRatio), Math.round(height * devicePixelRatio)] as const;
    if (canvas.width !== size[0] || canvas.height !== size[1]) [canvas.width, canvas.height] = size;
    context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    context.clearRect(0, 0, width, height);
    const style = getComputedStyle(canvas);
    const pen: Pen = { context, width, height, color: (name) => style.getPropertyValue(name) };
    const seconds = Math.min(this.seconds, course.duration);
    course.draw(pen, seconds);
    this.plot.point(course.at(seconds));
  }
}

/** The page's button to play, as that of a lesson: NAME-play, with the label NAME-play-label. */
function playButton(name: string): HTMLButtonElement {
  const made = element("play", HTMLTemplateElement).content.firstElementChild!.cloneNode(true) as HTMLButtonElement;
  made.id = `${name}-play`;
  made.setAttribute("aria-describedby", `${name}-title`);
  made.querySelector("span")!.id = `${name}-play-label`;
  return made;
}

/** With four digits that count. */
function inWords(reading: Quantity | string): string {
  return typeof reading === "string" ? reading : `${significant(reading.value, 4)}\u00a0${reading.unit}`;
}

function legendItem({ name, order, formula = false }: Curve): HTMLLIElement {
  const item = document.createElement("li"), key = document.createElement("span");
  key.className = `swatch series-${order}${formula ? " formula" : ""}`;
  item.append(key, name);
  return item;
}
