// The scene's parameters in groups: some change while the cloth moves, the others restart the scene.
import { schemaOf, type Catalog, type Schema } from "weft-cloth";
import { element } from "../elements.js";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import { blowing, headingOf, scaled, type Vector } from "../state/air.js";
import { choicesOf, meaningOf, parsed, rangeOf, unitOf } from "../state/limits.js";
import { withKey, type PageState, type Value } from "../state/page_state.js";
import { AIR, applies, DRAG, GRAVITY, GROUPS, WIND, type Group, type Parameter } from "../state/parameters.js";
import { NumberField, Slider } from "./fields.js";

const STILL: Vector = [0, 0, 0];

interface Field {
  readonly key: string;
  readonly rows: readonly HTMLElement[];
  show(scene: LoadedScene, value: unknown): void;
  enable(on: boolean): void;
}

interface Shown {
  readonly group: Group;
  readonly fields: readonly Field[];
  readonly reset: HTMLButtonElement;
}

export class Parameters {
  private readonly schema: Schema;
  private readonly groups: readonly Shown[];
  private readonly calm = document.createElement("p");

  constructor(catalog: Catalog, private readonly player: Player, private readonly open: (state: PageState) => void,
    private readonly say: (sentence: string) => void) {
    this.schema = catalog.schema;
    this.calm.className = "remark";
    this.calm.textContent = "Wind pulls by the air's drag, which is 0 here: raise it to feel the wind.";
    this.groups = GROUPS.map((group) => this.build(group));
  }

  enable(on: boolean): void {
    for (const { fields, reset } of this.groups) {
      for (const field of fields) field.enable(on);
      reset.disabled = !on;
    }
  }

  /** Another scene, or another value of one of its keys. */
  show(scene: LoadedScene, state: PageState): void {
    for (const { group, fields, reset } of this.groups) {
      for (const { key, rows, show } of fields) {
        for (const row of rows) row.hidden = !applies(key, scene.own);
        show(scene, state.set[key] ?? scene.own(key));
      }
      reset.hidden = !group.parameters.some(({ key }) => key in state.set);
    }
    this.calm.hidden = (state.set[DRAG] ?? scene.own(DRAG)) !== 0 || scene.own(AIR) !== undefined;
  }

  // Building

  private build(group: Group): Shown {
    const place = element(`group-${group.name}`, HTMLElement);
    const fields = group.parameters.map((
      parameter,
    ) => (group.live ? this.liveField(parameter) : this.numberField(parameter)));
    const reset = document.createElement("button");
    Object.assign(reset, { type: "button", className: "quiet", hidden: true });
    reset.textContent = `Reset ${group.title.toLowerCase()}`;
    reset.addEventListener("click", () => this.resetGroup(group));
    place.append(...fields.flatMap(({ rows }) => rows), ...(group.name === "wind" ? [this.calm] : []), reset);
    return { group, fields, reset };
  }

  private resetGroup({ live, parameters }: Group): void {
    if (live) { for (const { key } of parameters) this.player.setLive(key, null); }
    else this.open(parameters.reduce((state, { key }) => withKey(state, key, null), this.player.noteCamera()));
  }

  private look({ key, label }: Parameter) {
    const schema = schemaOf(this.schema, key) ?? {};
    return { label, unit: unitOf(schema), hint: meaningOf(schema),
      ...(rangeOf(schema) ?? { least: 0, most: 0, whole: false }), word: choicesOf(schema)[0] ?? null };
  }

  private numberField(parameter: Parameter): Field {
    const { key, label } = parameter;
    const field = new NumberField(this.look(parameter), (text) => {
      const found = parsed(this.schema, key, text);
      if ("value" in found) this.open(withKey(this.player.noteCamera(), key, found.value));
      else this.say(`${label} is “${text}”, but must ${found.must}.`);
      return "value" in found;
    });
    return { key, rows: [field.row], show: (_, value) => field.show(value), enable: (on) => {
      field.disabled = !on;
    } };
  }

  /** A number as it is, a vector by its strength, and the wind by its direction too. */
  private liveField(parameter: Parameter): Field {
    const { key, reach = 0 } = parameter;
    const look = this.look(parameter);
    const set = (value: Value) => this.player.setLive(key, value);
    const own = (): Vector => (this.player.loaded?.own(key) as Vector | undefined) ?? STILL;
    const sliders: Slider[] = [];
    const speed = new Slider({ ...look, step: look.unit ? 0.1 : 0.05 }, (value) =>
      set(
        key === GRAVITY ? scaled(own(), value) : key === WIND ? blowing(value, sliders[1]!.value, own()) : value,
      ));
    sliders.push(speed);
    if (key === WIND)
      sliders.push(
        new Slider({ label: "Direction", unit: "°", hint: "Where it blows to, about the vertical: 90° is along x.",
          step: 1 }, (heading) => set(blowing(speed.value, heading, own()))),
      );
    const show = (scene: LoadedScene, value: unknown) => {
      const strength = (of: unknown) => (Array.isArray(of) ? Math.hypot(...(of as number[])) : Number(of));
      const most = Math.max(reach, 2 * strength(scene.own(key)), strength(value));
      speed.show(strength(value), 0, Math.min(look.most, Math.ceil(most)));
      if (strength(value) > 0 || !sliders[1]?.value) sliders[1]?.show(headingOf(value as Vector), -180, 180);
    };
    return { key, rows: sliders.map(({ row }) => row), show, enable: (on) => {
      for (const slider of sliders) slider.disabled = !on;
    } };
  }
}
