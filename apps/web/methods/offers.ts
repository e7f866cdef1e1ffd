// The methods that there are and their settings, from the core's own tables: one that is added there appears here.
import { schemaOf, type Catalog, type Schema } from "weft-cloth";
import { MOST_SUBSTEPS } from "../src/files/limits.js";
import type { Choice } from "./state.js";

export interface Offer {
  readonly kind: string;
  /** Of its settings, by the word that scenes have for each. */
  readonly settings: Readonly<Record<string, Schema>>;
}

export function offersOf({ schema, methods }: Catalog): Offer[] {
  const ways = schemaOf(schema, "solver")?.oneOf ?? [];
  return methods.map(({ kind }) => {
    const { kind: _, ...settings } = ways.find((way) => way.properties?.["kind"]?.const === kind)?.properties ?? {};
    return { kind, settings };
  });
}

/** What substeps may be here: as in scenes, up to the page's limit. */
export function substepsSchema(schema: Schema): Schema {
  const own = schemaOf(schema, "time.substeps") ?? {};
  return { ...own,
    anyOf: (own.anyOf ?? []).map((way) => (way.maximum === undefined ? way : { ...way, maximum: MOST_SUBSTEPS })) };
}

/** A method as it is where nothing is said of it. */
export const plainChoice = (kind: string): Choice => ({ kind, substeps: "auto", settings: {} });

/** How often its settings have a method go over the cloth in a substep: the product of those that are counts. */
export function sweepsOf({ settings }: Offer, choice: Choice): number {
  return Object.entries(settings).reduce(
    (product, [key, schema]) =>
      schema.type === "integer" ? product * Number(choice.settings[key] ?? schema.default) : product,
    1,
  );
}
