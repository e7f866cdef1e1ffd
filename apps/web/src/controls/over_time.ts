// Energies, stretch and residual over time, measured while their part of the panel is open: the state is read back for
// each point.
import type { Measures } from "weft-cloth";
import { button, element } from "../elements.js";
import { LinePlot, type Curve } from "../line_plot.js";
import { Paced } from "../paced.js";
import type { Player } from "../player.js";
import { Series } from "../state/series.js";

const PACE = { calm: 200, share: 0.2 }; // of measurements
const HEIGHT = 170;

export class OverTime {
  private readonly place = element("over-time", HTMLDetailsElement);
  private readonly energy = new LinePlot(element("energy-plot", HTMLElement), { x: "time [s]", y: "energy [J]" },
    HEIGHT);
  private readonly stretch = new LinePlot(element("stretch-plot", HTMLElement), { x: "time [s]",
    y: "largest stretch [%]" }, HEIGHT);
  private readonly residual = new LinePlot(element("residual-plot", HTMLElement), { x: "time [s]", y: "residual [%]" },
    HEIGHT);
  private readonly series = new Series();
  private readonly measuring = new Paced(() => this.measure(), PACE);

  constructor(private readonly player: Player, say: (sentence: string) => void) {
    this.place.addEventListener("toggle", () => {
      if (this.place.open) void this.measuring.carryOut();
    });
    button("copy-series").addEventListener("click", () => {
      navigator.clipboard.writeText(this.series.csv()).then(
        () => say(`${this.series.rows.length} rows are copied as CSV.`),
        () => say("The browser does not let this page write to the clipboard, so the rows could not be copied."),
      );
    });
  }

  /** Another scene, or none. */
  restart(): void {
    this.series.clear();
    this.draw();
    if (this.place.open) void this.measuring.carryOut();
  }

  /** A frame has been simulated or drawn. */
  frame(now: number): void {
    if (this.place.open) this.measuring.frame(now);
    else this.measuring.stop();
  }

  private async measure(): Promise<void> {
    const measures = await this.player.ask((world) => world.measure());
    if (measures && this.series.add(measures)) this.draw();
  }

  private draw(): void {
    if (!this.place.open) return;
    const { rows } = this.series;
    const first = rows[0];
    const curve = (order: number, name: string, value: (of: Measures) => number): Curve => ({ order, name,
      points: rows.map((of) => [of.seconds, value(of)] as const) });
    const height = (of: Measures) => of.potential - (first?.potential ?? 0);
    this.energy.draw([curve(0, "kinetic", ({ kinetic }) => kinetic), curve(1, "elastic", elastic),
      curve(2, "height", height), curve(3, "sum", (of) => of.kinetic + elastic(of) + height(of))], undefined);
    this.stretch.draw([curve(0, "largest stretch", ({ maxStretch }) => 100 * Math.max(0, maxStretch - 1))], undefined);
    element("residual-part", HTMLElement).hidden = !rows.some(({ residual }) => residual > 0);
    this.residual.draw([curve(0, "residual", ({ residual }) => 100 * residual)], undefined);
    button("copy-series").disabled = rows.length === 0;
  }
}

const elastic = (of: Measures): number => of.springs + of.membranes + of.bending + of.tetrahedra + of.gas;
