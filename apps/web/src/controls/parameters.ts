// The scene's parameters in groups: some change while the cloth moves, the others restart the scene.
import { schemaOf, type Catalog, type Schema } from "weft-cloth";
import { element } from "../elements.js";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import { blowing, headingOf, scaled, type Vector } from "../state/air.js";
import { choicesOf, meaningOf, parsed, rangeOf, unitOf } from "../state/limits.js";
import { withKey, type PageState, type Value } from "../state/page_state.js";
import { AIR, applies, COLOR, DRAG, FABRIC, GRAVITY, GROUPS, LOOK, SUN, WIND, withChoice, type Group,
  type Parameter } from "../state/parameters.js";
import { azimuthOf, besideCamera, elevationOf, shining } from "../state/sun.js";
import { Choice, ColorField, spoken } from "./choices.js";
import { NumberField, Slider } from "./fields.js";

const STILL: Vector = [0, 0, 0];

interface Field {
  readonly key: string;
  readonly rows: readonly HTMLElement[];
  show(scene: LoadedScene, value: unknown, set: PageState["set"]): void;
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
  private readonly fabric = document.createElement("p");

  constructor(private readonly catalog: Catalog, private readonly player: Player,
    private readonly open: (state: PageState) => void, private readonly say: (sentence: string) => void) {
    this.schema = catalog.schema;
    this.calm.className = this.fabric.className = "remark";
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
        for (const row of rows) row.hidden = !applies(key, (one) => scene.valueOf(one, state.set));
        show(scene, scene.valueOf(key, state.set), state.set);
      }
      reset.hidden = !group.parameters.some(({ key }) => key in state.set);
    }
    const fabric = scene.valueOf(FABRIC, state.set);
    this.fabric.textContent = this.catalog.fabrics.find(({ name }) => name === fabric)?.what ?? "";
    this.fabric.hidden = this.fabric.textContent === "";
    this.calm.hidden = (state.set[DRAG] ?? scene.own(DRAG)) !== 0 || scene.own(AIR) !== undefined;
  }

  // Building

  private build(group: Group): Shown {
    const place = element(`group-${group.name}`, HTMLElement);
    const fields = group.parameters.map((parameter) => this.field(parameter, group.live));
    const reset = document.createElement("button");
    Object.assign(reset, { type: "button", className: "quiet", hidden: true });
    reset.textContent = `Reset ${group.title.toLowerCase()}`;
    reset.addEventListener("click", () => this.resetGroup(group));
    const remarks = { wind: [this.calm], fabric: [this.fabric] }[group.name] ?? [];
    place.append(...fields.flatMap(({ rows }) => rows), ...remarks, reset);
    return { group, fields, reset };
  }

  private field(parameter: Parameter, live: boolean): Field {
    if (parameter.key === COLOR) return this.colorField(parameter);
    if (parameter.key === SUN) return this.sunField();
    if (!rangeOf(schemaOf(this.schema, parameter.key) ?? {})) return this.choiceField(parameter, live);
    return live ? this.liveField(parameter) : this.numberField(parameter);
  }

  private resetGroup({ live, parameters }: Group): void {
    if (live) {
      const { set } = this.player.state; // what is not in it, the scene may have no place for
      for (const { key } of parameters) if (key in set) this.player.setLive(key, null);
    } else this.open(parameters.reduce((state, { key }) => withKey(state, key, null), this.player.noteCamera()));
  }

  private look({ key, label }: Parameter) {
    const schema = schemaOf(this.schema, key) ?? {};
    return { label, unit: unitOf(schema), hint: meaningOf(schema),
      ...(rangeOf(schema) ?? { least: 0, most: 0, whole: false }), word: choicesOf(schema)[0] ?? null };
  }

  private choiceField({ key, label }: Parameter, live: boolean): Field {
    const schema = schemaOf(this.schema, key) ?? {};
    const field = new Choice({ label, hint: meaningOf(schema), words: choicesOf(schema) }, (word) => {
      if (live) this.player.setLive(key, word);
      else this.open(withChoice(this.player.noteCamera(), key, word));
    });
    const show = (scene: LoadedScene, value: unknown, { [key]: _, ...set }: PageState["set"]) => {
      const standing = scene.valueOf(key, set);
      field.show(value, standing, standingFor(key, standing));
      const obstacle = obstacleName(key, scene);
      if (obstacle) field.label = obstacle;
    };
    return { key, rows: [field.row], show, enable: (on) => {
      field.disabled = !on;
    } };
  }

  private colorField({ key, label }: Parameter): Field {
    const field = new ColorField(label, meaningOf(schemaOf(this.schema, key) ?? {}),
      (value) => this.player.setLive(key, value));
    const show = (scene: LoadedScene, value: unknown, set: PageState["set"]) => {
      const look = scene.valueOf(LOOK, set);
      const name = typeof look === "string" ? look : (look as { name?: string } | undefined)?.name;
      const { color } = this.catalog.looks.find((one) => one.name === name) ?? this.catalog.looks[0]!;
      field.show((value as Vector | undefined) ?? color);
    };
    return { key, rows: [field.row], show, enable: (on) => {
      field.disabled = !on;
    } };
  }

  /** The sun, or the studio's key light, by two angles. */
  private sunField(): Field {
    const set = () => this.player.setLive(SUN, shining(azimuth.value, elevation.value));
    const azimuth = new Slider({ label: "Azimuth", unit: "°", step: 1,
      hint: "Where the sun or the key light is, about the vertical: 90° is along x." }, set);
    const elevation = new Slider({ label: "Elevation", unit: "°", step: 1,
      hint: "How high the sun or the key light stands above the horizon." }, set);
    const show = (_: LoadedScene, value: unknown) => {
      const { home } = this.player;
      const to = (value as Vector | null | undefined) ?? (home && besideCamera(home));
      if (!to) return;
      const high = elevationOf(to);
      elevation.show(high, Math.min(0, high), 90);
      if (high < 90 || azimuth.value === 0) azimuth.show(azimuthOf(to), -180, 180); // overhead there is none to show
    };
    return { key: SUN, rows: [azimuth.row, elevation.row], show, enable: (on) => {
      azimuth.disabled = elevation.disabled = !on;
    } };
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
      speed.show(strength(value), Math.max(0, look.least), Math.min(look.most, Math.ceil(most)));
      if (strength(value) > 0 || !sliders[1]?.value) sliders[1]?.show(headingOf(value as Vector), -180, 180);
    };
    return { key, rows: sliders.map(({ row }) => row), show, enable: (on) => {
      for (const slider of sliders) slider.disabled = !on;
    } };
  }
}

/** What holds where nothing is chosen, and is none of the words. */
function standingFor(key: string, standing: unknown): string {
  if (key === FABRIC && standing === undefined) return "None: springs";
  const name = (standing as { name?: string } | null | undefined)?.name;
  return name === undefined ? "The scene's own" : `${spoken(name)}, altered`;
}

const KINDS: Readonly<Record<string, string>> = { plane: "Floor", sphere: "Ball", box: "Board", capsule: "Rod" };

/** What the collider that a key is of is called: those of a kind are numbered. */
function obstacleName(key: string, scene: LoadedScene): string | null {
  const index = Number(/^colliders\.(\d+)\./.exec(key)?.[1] ?? NaN);
  if (Number.isNaN(index)) return null;
  const nameOf = (at: number) => {
    const kind = scene.own(`colliders.${at}.kind`);
    return kind === undefined ? null : KINDS[String(kind)] ?? "Obstacle";
  };
  const name = nameOf(index) ?? "Obstacle";
  const same = (count: number) => Array.from({ length: count }, (_, at) => nameOf(at)).filter((one) => one === name);
  return same(index).length === 0 && nameOf(index + 1) !== name ? name : `${name} ${same(index).length + 1}`;
}
