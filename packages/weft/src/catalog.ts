// The choices, from the core's own tables: no world, device or scene is needed.
import { Core } from "./core.js";
import type { View } from "./world_types.js";

/** JSON Schema 2020-12, as far as that of scenes goes. */
export interface Schema {
  readonly type?: string;
  readonly description?: string;
  readonly default?: unknown;
  readonly const?: unknown;
  readonly enum?: readonly string[];
  readonly minimum?: number;
  readonly maximum?: number;
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly items?: Schema;
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly anyOf?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly $ref?: string;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

export interface Catalog {
  /** Of scenes (docs/scene.md), as `weft schema` prints it. */
  readonly schema: Schema;
  /** The renderer's colour map, sRGB in [0, 1], from the lowest value to the highest. */
  readonly colors: readonly (readonly [red: number, green: number, blue: number])[];
  /** What stands at the ends of the map, of the views that have one. */
  readonly ranges: Readonly<Partial<Record<View, readonly [lowest: number, highest: number]>>>;
  /** Nodes that can be grabbed at once. */
  readonly mostGrabs: number;
  /** What a scene's solver.kind can be, but for "auto". */
  readonly methods: readonly Method[];
  /** The measured cloths that a scene's cloths.0.fabric can name (docs/fabrics.md). */
  readonly fabrics: readonly Fabric[];
  /** What a scene's cloths.0.look can name (docs/scene.md). */
  readonly looks: readonly NamedLook[];
}

export interface Fabric {
  readonly name: string;
  /** The kind of cloth, for people. */
  readonly what: string;
  /** [kg/m²] */
  readonly density: number;
  /** The look that it brings. */
  readonly look: string;
}

export interface NamedLook {
  readonly name: string;
  /** Of a scene's first cloth, where it has no colour of its own: sRGB in [0, 1]. */
  readonly color: readonly [red: number, green: number, blue: number];
}

export interface Method {
  readonly kind: string;
  /**
   * What its solver asks of the GPU for a grid beside the state, by the word of its settings (solver.forces), "" for a
   * method without: in all and in its largest buffer [bytes a node].
   */
  readonly memory: Readonly<Record<string, { readonly node: number; readonly buffer: number }>>;
  /** Whether its matrix has contact, which takes memory of its own. */
  readonly holdsContact: boolean;
}

let read: Promise<Catalog> | null = null;

/** Read once, from a module that is dropped again. */
export function catalog(): Promise<Catalog> {
  read ??= Core.create().then((core) => {
    const told = (name: string): unknown => {
      core.call(name);
      return JSON.parse(core.text());
    };
    return { schema: told("schema") as Schema, ...(told("catalog") as Omit<Catalog, "schema">) };
  });
  read.catch(() => {
    read = null;
  }); // the next call tries again
  return read;
}

/** The schema of a dotted key as `set` takes it ("cloths.0.stiffness.shear"); null where scenes have no such key. */
export function schemaOf(root: Schema, key: string): Schema | null {
  const resolved = (
    schema: Schema | undefined,
  ): Schema | undefined => (schema?.$ref ? root.$defs?.[schema.$ref.replace("#/$defs/", "")] : schema);
  let at: Schema | undefined = root;
  for (const part of key.split(".")) {
    const inner: Schema | undefined = /^\d+$/.test(part) ?
      at?.items :
      [at, ...(at?.oneOf ?? []), ...(at?.anyOf ?? [])]
        .find((way) => way?.properties && Object.hasOwn(way.properties, part))?.properties?.[part];
    if (!inner) return null;
    at = { ...resolved(inner), ...inner }; // what stands beside a reference is of this key
  }
  const anyOf = at?.anyOf?.map((way) => resolved(way) ?? way);
  return at ? { ...at, ...(anyOf && { anyOf }) } : null;
}
