// The allowed values of a scene's keys, from the core's schema.
import { schemaOf, type Schema } from "weft-cloth";
import type { Value } from "./page_state.js";

export const DIGITS = 4; // of a coordinate in metres

/** What the description of a key ends with, in brackets; "" for a plain number. */
export function unitOf(schema: Schema): string {
  return /\[([^\]]+)\]\.$/.exec(schema.description ?? "")?.[1] ?? "";
}

/** The description without its unit. */
export function meaningOf(schema: Schema): string {
  return (schema.description ?? "").replace(/\s*\[[^\]]+\]\.$/, ".");
}

/** A point as an address has it [m]. */
export function plainPoint(values: readonly number[]): string {
  return values.map((value) => Number(value.toFixed(DIGITS))).join();
}

const ways = (schema: Schema): readonly Schema[] => schema.anyOf ?? [schema];

/** What may be chosen, where it is one of a few words. */
export function choicesOf(schema: Schema): readonly string[] {
  return ways(schema).flatMap((way) => way.enum ?? []);
}

/** The numbers that are allowed, where it is a number or a list of them. */
export function rangeOf(schema: Schema): { least: number; most: number; whole: boolean } | null {
  for (const way of ways(schema)) {
    const number = way.type === "array" ? way.items : way;
    if (number?.minimum !== undefined && number.maximum !== undefined)
      return { least: number.minimum, most: number.maximum, whole: number.type === "integer" };
  }
  return null;
}

/** A text as a value of this key; a sentence's end that says what it must be where it is none. */
export function parsed(root: Schema, key: string, text: string): { value: Value } | { must: string } {
  const schema = schemaOf(root, key);
  return schema ? parsedBy(schema, text) : { must: "be a key of scenes" };
}

/** The same, where the key's schema is known. */
export function parsedBy(schema: Schema, text: string): { value: Value } | { must: string } {
  const [choices, range, unit] = [choicesOf(schema), rangeOf(schema), unitOf(schema)];
  if (choices.includes(text)) return { value: text };
  const words = choices.length > 0 ? [choices.map((word) => `“${word}”`).join(", ")] : [];
  if (!range) return { must: `be one of ${words.join("")}` };
  const list = ways(schema).find(({ type }) => type === "array");
  const count = list?.minItems ?? 1;
  const bounds = `from ${range.least} to ${range.most}${unit && ` ${unit}`}`;
  const number = range.whole ? "a whole number" : "a number";
  const must = `be ${[`${count > 1 ? `${count} numbers, each` : number} ${bounds}`, ...words].join(" or ")}`;
  const parts = text.split(",");
  const numbers = parts.map((part) => (part.trim() === "" ? NaN : Number(part)));
  const good = numbers.length === count &&
    numbers.every((n) => n >= range.least && n <= range.most && (!range.whole || Number.isInteger(n)));
  if (!good) return { must };
  return { value: list ? numbers : numbers[0]! };
}
