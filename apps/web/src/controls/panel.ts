// The panel as a whole: its parts, and what each is told.
import type { Catalog, Statistics, View, WorldInfo } from "weft-cloth";
import { element } from "../elements.js";
import type { Limits } from "../memory.js";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import type { PageState } from "../state/page_state.js";
import { Comparing } from "./comparing.js";
import { offerCopies } from "./copying.js";
import type { Gallery } from "./gallery.js";
import { Graph } from "./graph.js";
import { Help } from "./help.js";
import { followKeys } from "./keys.js";
import { OverTime } from "./over_time.js";
import { Parameters } from "./parameters.js";
import { Passes } from "./passes.js";
import type { Pins } from "./pins.js";
import { Probes } from "./probes.js";
import { Readings } from "./readings.js";
import { ScenePicker } from "./scene_picker.js";
import type { Theme } from "./theme.js";
import { Timeline } from "./timeline.js";
import { Transport } from "./transport.js";
import { Views } from "./views.js";

export interface PanelInputs {
  readonly canvas: HTMLCanvasElement;
  readonly catalog: Catalog;
  readonly limits: Limits;
  readonly player: Player;
  readonly pins: Pins;
  readonly theme: Theme;
  readonly gallery: Gallery;
  open(state: PageState): void;
  /** The address of the page as it is. */
  link(): { readonly address: string; readonly but: string | null };
  say(sentence: string): void;
}

export class Panel {
  private readonly transport: Transport;
  private readonly picker: ScenePicker;
  private readonly views: Views;
  private readonly parameters: Parameters;
  private readonly passes: Passes;
  private readonly readings: Readings;
  private readonly overTime: OverTime;
  private readonly probes: Probes;
  private readonly timeline: Timeline;
  private readonly comparing: Comparing;
  private info: WorldInfo | null = null;

  constructor(private readonly inputs: PanelInputs) {
    const { canvas, catalog, limits, player, pins, theme, gallery, open, link, say } = inputs;
    this.transport = new Transport(player);
    this.picker = new ScenePicker(catalog, limits, () => player.noteCamera(), open);
    this.views = new Views(player, catalog, say);
    this.parameters = new Parameters(catalog, player, open, say);
    this.passes = new Passes(player);
    const graph = new Graph();
    this.readings = new Readings(graph);
    this.overTime = new OverTime(player, say);
    this.probes = new Probes(canvas, player, say);
    this.timeline = new Timeline(player, say);
    this.comparing = new Comparing(catalog, limits, player);
    theme.onChange = () => graph.draw();
    followKeys({ player, pins, probes: this.probes, theme, gallery, views: this.views, help: new Help() });
    offerCopies({ link, readings: () => this.report() }, say);
  }

  private enable(on: boolean): void {
    const { transport, picker, views, parameters, probes, timeline, comparing } = this;
    for (const part of [transport, picker, views, parameters, probes, timeline, comparing, this.inputs.pins])
      part.enable(on);
  }

  opening(): void {
    this.enable(false);
  }

  opened(scene: LoadedScene, info: WorldInfo): void {
    this.info = info;
    this.picker.opened(scene, info);
    this.views.opened(info);
    this.comparing.opened(scene);
    this.enable(true);
    this.passes.show(info);
    this.readings.showFacts(info);
    this.begin(scene.title);
  }

  empty(): void {
    this.info = null;
    this.enable(false);
    this.picker.empty();
    this.passes.show(null);
    this.readings.showFacts(null);
    this.begin("");
  }

  /** What is kept of a run goes: there is another scene, or none. */
  private begin(title: string): void {
    this.overTime.restart();
    this.probes.forget();
    this.timeline.restart();
    element("scene-title", HTMLElement).textContent = title;
  }

  changed(scene: LoadedScene, state: PageState): void {
    this.parameters.show(scene, state);
    this.timeline.changed(state);
    this.comparing.show(state);
  }

  /** There is another side of a comparison now, or none any more. */
  compared(): void {
    this.comparing.compared();
    this.timeline.restart(); // its states are of one side
    this.readings.restart();
  }

  playing(on: boolean): void {
    this.transport.playing(on);
    this.timeline.playing(on);
    this.readings.restart();
  }

  viewed(view: View): void {
    this.views.viewed(view);
  }

  frame(now: number, statistics: Readonly<Statistics>, host: number | null): void {
    this.readings.frame(now, statistics, host);
    this.overTime.frame(now);
    this.probes.frame(now);
    this.timeline.frame(now);
    this.comparing.frame(now);
  }

  /** The picture has another size. */
  resized(): void {
    this.probes.draw();
  }

  /** All that the panel says, for whoever reports how it went. */
  private report(): unknown {
    const { state, beside } = this.inputs.player;
    return { weft: 1, page: this.inputs.link().address, state, browser: navigator.userAgent, loaded: this.info,
      ...this.readings.values, pins: this.inputs.pins.pinned, passes: this.passes.times,
      beside: beside.world && { loaded: beside.world.info, milliseconds: beside.milliseconds } };
  }
}
