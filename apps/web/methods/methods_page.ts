// The page's state, its controls, and the panes of what it compares.
import type { Catalog, World } from "weft-cloth";
import { short, significant } from "../src/digits.js";
import { button, element, input, select } from "../src/elements.js";
import type { Limits } from "../src/memory.js";
import { parsedBy } from "../src/state/limits.js";
import { withSetting, write, type Asking } from "./address.js";
import type { Lane } from "./lane.js";
import { LockStep, type Plan, type Reading } from "./lock_step.js";
import { plainChoice, sweepsOf, type Offer } from "./offers.js";
import { Pane } from "./pane.js";
import { byMethod, fetchComparison, SCENES } from "./scenes.js";
import { storedFrame } from "./stored_run.js";
import { STORED } from "./stored_view.js";
import { MOST_CHOICES, NODES, type Choice, type MethodsState } from "./state.js";

const OF_RUN = "sheet"; // the scene of the stored run
const REAL_TIME = 0.97; // of real time: what misses less is the clock's unevenness

export class MethodsPage {
  private readonly panes: Pane[] = [];
  readonly lockStep: LockStep;
  readings: readonly (Reading | null)[] = [];

  constructor(private readonly catalog: Catalog, private readonly asking: Asking, private readonly limits: Limits,
    private readonly kinds: readonly string[], public state: MethodsState) {
    this.lockStep = new LockStep({
      preparing: (lane) => this.preparing(lane === null ? null : this.panes.find((pane) => pane.lane === lane)!),
      failed: (fault) => {
        showProblem(fault);
        element("panes", HTMLDivElement).hidden = true; // they are of something else
      },
      playing: (on) => showPlaying(on),
      read: (readings) => this.read(readings),
    });
    this.listen();
  }

  get worlds(): readonly (World | null)[] {
    return this.panes.map(({ lane }) => lane.live);
  }

  private listen(): void {
    const scene = select("scene"), nodes = input("nodes");
    scene.replaceChildren(...SCENES.map(({ name, title }) => new Option(title, name)));
    scene.addEventListener("change", () => {
      this.lockStep.resetCameras();
      void this.change({ ...this.state, scene: scene.value, nodes: null });
    });
    Object.assign(nodes, { min: String(NODES.least), max: String(NODES.most) });
    nodes.addEventListener("change", () => {
      const good = nodes.value !== "" && nodes.checkValidity();
      if (good) void this.change({ ...this.state, nodes: Number(nodes.value) });
      else this.showState();
    });
    button("add").addEventListener("click", () => {
      const { choices } = this.state;
      const { offers } = this.asking;
      const unused = offers.find(({ kind }) => choices.every((one) => one.kind !== kind)) ?? offers[0]!;
      void this.change({ ...this.state, choices: [...choices, plainChoice(unused.kind)] });
    });
    button("play").addEventListener("click", () => this.lockStep.play(!this.lockStep.playing));
    button("step").addEventListener("click", () => {
      say("Paused.");
      void this.lockStep.step();
    });
    button("reset").addEventListener("click", () => void this.open());
    for (const id of ["play", "step", "reset", "add"]) button(id).disabled = false;
    scene.disabled = nodes.disabled = false;
  }

  /** Opens what the state asks for, all of it at rest. */
  open(): Promise<void> {
    const { state } = this;
    this.showPanes();
    this.showState();
    const panes = [...this.panes];
    return this.lockStep.open(async (): Promise<Plan> => {
      const comparison = await fetchComparison(state, this.catalog);
      element("description", HTMLParagraphElement).textContent = comparison.loaded.description;
      return {
        gravity: comparison.gravity,
        lanes: state.choices.map((choice, i) => ({
          lane: panes[i]!.lane,
          opening: { kind: choice.kind, substeps: choice.substeps, sweeps: sweepsOf(this.offerOf(choice), choice),
            scene: () => byMethod(comparison, choice, this.limits) },
        })),
      };
    });
  }

  private change(state: MethodsState): Promise<void> {
    this.state = state;
    showProblem(null);
    history.replaceState(null, "", write(state));
    return this.open();
  }

  private offerOf({ kind }: Choice): Offer {
    return this.asking.offers.find((offer) => offer.kind === kind)!;
  }

  private choose(index: number, choice: Choice): void {
    void this.change({ ...this.state, choices: this.state.choices.with(index, choice) });
  }

  private makePane(): Pane {
    const index = () => this.panes.indexOf(pane);
    const pane: Pane = new Pane(
      { offers: this.asking.offers, substeps: this.asking.substeps, turned: this.lockStep.turned,
        order: (kind) => this.kinds.indexOf(kind) },
      {
        chosen: (kind) => this.choose(index(), plainChoice(kind)),
        set: (key, text) => this.set(index(), key, text),
        removed: () => this.removePane(index()),
        orbit: (dx, dy) => this.lockStep.orbit(dx, dy),
        failed: () => void this.lockStep.look(),
      },
    );
    return pane;
  }

  private set(index: number, key: string, text: string): boolean {
    const choice = this.state.choices[index]!, offer = this.offerOf(choice);
    const found = parsedBy(key === "substeps" ? this.asking.substeps : offer.settings[key]!, text);
    if ("value" in found) this.choose(index, withSetting(choice, offer, key, found.value));
    else showProblem(`${key} of ${choice.kind} must ${found.must}.`);
    return "value" in found;
  }

  private removePane(index: number): void {
    this.panes.splice(index, 1)[0]!.dispose();
    void this.change({ ...this.state, choices: this.state.choices.toSpliced(index, 1) });
    button("add").focus(); // the button that had it is gone
  }

  private showPanes(): void {
    const { choices } = this.state;
    const list = element("panes", HTMLDivElement);
    list.dataset["count"] = String(choices.length);
    list.hidden = false;
    while (this.panes.length < choices.length) {
      const pane = this.makePane();
      this.panes.push(pane);
      list.append(pane.box);
      pane.placed();
    }
    this.panes.forEach((pane, i) => pane.show(choices[i]!, i, choices.length));
    button("add").disabled = choices.length >= MOST_CHOICES;
  }

  private showState(): void {
    const { scene, nodes } = this.state;
    select("scene").value = scene;
    input("nodes").value = String(nodes ?? SCENES.find(({ name }) => name === scene)!.nodes);
  }

  private preparing(pane: Pane | null): void {
    pane?.preparing();
    if (pane) say(`${pane.box.getAttribute("aria-label")!} is being prepared.`);
    else say(this.lockStep.playing ? "Playing." : "At rest.");
  }

  /** What the stored run has of a pane's work, if that is on its sheet. */
  private stored(index: number): { adapter: string; milliseconds: number } | null {
    const { scene, choices } = this.state, reading = this.readings[index], choice = choices[index]!;
    if (scene !== OF_RUN || !reading) return null;
    const milliseconds = storedFrame(STORED, Number(input("nodes").value), choice, reading.substeps,
      sweepsOf(this.offerOf(choice), choice));
    return milliseconds === null ? null : { adapter: STORED.adapter, milliseconds };
  }

  private read(readings: ReadonlyMap<Lane, Reading | null>): void {
    this.readings = this.panes.map(({ lane }) => readings.get(lane) ?? null);
    this.panes.forEach((pane, i) => {
      if (readings.has(pane.lane)) pane.read(this.readings[i]!, i === 0, this.stored(i)); // else it is still to be made
    });
    const { seconds, share, frames, wait } = this.lockStep;
    const pace = share === null ?
      "" :
      share > REAL_TIME ?
      ", in real time" :
      `, at ${significant(100 * share, 2)} % of real time`;
    if (wait !== null) element("wait", HTMLSpanElement).textContent = `${short(wait)} ms`;
    element("clock", HTMLParagraphElement).textContent = `${seconds.toFixed(2)} s, ${frames} frames${pace}`;
  }
}

export const say = (text: string): void => {
  element("said", HTMLParagraphElement).textContent = text;
};

export function showProblem(text: string | null): void {
  const problem = element("error", HTMLParagraphElement);
  problem.hidden = text === null;
  problem.textContent = text;
}

function showPlaying(on: boolean): void {
  element("play-label", HTMLSpanElement).textContent = on ? "Pause" : "Play";
  button("play").dataset["playing"] = String(on);
  say(on ? "Playing." : "Paused.");
}
