// The page's state as its address has it: ?v=1&scene=sheet&nodes=64&methods=mass_spring,xpbd:substeps=32:iterations=4.
// What an address asks for is checked by the core's schema; what does not pass is left out, and said.
import type { Schema } from "weft-cloth";
import { parsedBy } from "../src/state/limits.js";
import type { Value } from "../src/state/page_state.js";
import { Refusals } from "../src/state/refusals.js";
import { plainChoice, type Offer } from "./offers.js";
import { MOST_CHOICES, NODES, type Choice, type MethodsState } from "./state.js";

const VERSION = "1";
const SUBSTEPS = "substeps";

/** What may be asked for. */
export interface Asking {
  readonly offers: readonly Offer[];
  /** Of substeps. */
  readonly substeps: Schema;
  readonly scenes: readonly string[];
  /** The kinds that are compared where the address names none. */
  readonly usual: readonly string[];
}

export interface Asked {
  readonly state: MethodsState;
  /** What was refused, one sentence; null where all of it was good. */
  readonly refused: string | null;
}

export function read(address: string, asking: Asking): Asked {
  const asked = new URL(address).searchParams;
  const refusals = new Refusals("what the page has");
  const usual: MethodsState = { scene: asking.scenes[0]!, nodes: null, choices: asking.usual.map(plainChoice) };
  const version = asked.get("v");
  if (version !== null && version !== VERSION) {
    refusals.add("v", version, `be ${VERSION}`);
    return { state: usual, refused: refusals.sentence };
  }
  const scene = asked.get("scene") ?? usual.scene;
  if (!asking.scenes.includes(scene)) refusals.add("scene", scene, `be one of ${asking.scenes.join(", ")}`);
  const nodes = asked.get("nodes");
  const good = nodes === null || (/^\d{1,9}$/.test(nodes) && Number(nodes) >= NODES.least &&
    Number(nodes) <= NODES.most);
  if (!good) refusals.add("nodes", nodes, `be a whole number from ${NODES.least} to ${NODES.most}`);
  const choices = asked.has("methods") ? choicesOf(asked.get("methods")!, asking, refusals) : [];
  return {
    state: {
      scene: asking.scenes.includes(scene) ? scene : usual.scene,
      nodes: nodes !== null && good ? Number(nodes) : null,
      choices: choices.length > 0 ? choices : usual.choices,
    },
    refused: refusals.sentence,
  };
}

function choicesOf(text: string, asking: Asking, refusals: Refusals): Choice[] {
  const words = text.split(",");
  if (words.length > MOST_CHOICES) refusals.add("methods", text, `be at most ${MOST_CHOICES} methods`);
  return words.slice(0, MOST_CHOICES).flatMap((word) => choiceOf(word, asking, refusals));
}

function choiceOf(text: string, { offers, substeps }: Asking, refusals: Refusals): Choice[] {
  const [kind, ...parts] = text.split(":");
  const offer = offers.find((one) => one.kind === kind);
  if (!offer) {
    refusals.add("a method", kind ?? "", `be one of ${offers.map((one) => one.kind).join(", ")}`);
    return [];
  }
  let choice = plainChoice(offer.kind);
  for (const part of parts) {
    const [key, value = ""] = part.split("=", 2) as [string, string?];
    const schema = key === SUBSTEPS ? substeps : Object.hasOwn(offer.settings, key) ? offer.settings[key] : undefined;
    if (!schema) {
      refusals.add(`a setting of ${offer.kind}`, key,
        `be one of ${[SUBSTEPS, ...Object.keys(offer.settings)].join(", ")}`);
      continue;
    }
    const found = parsedBy(schema, value);
    if ("value" in found) choice = withSetting(choice, offer, key, found.value);
    else refusals.add(`${key} of ${offer.kind}`, value, found.must);
  }
  return [choice];
}

/** A choice with its substeps or a setting changed. */
export function withSetting(choice: Choice, { settings }: Offer, key: string, value: Value): Choice {
  if (key === SUBSTEPS) return { ...choice, substeps: typeof value === "number" ? value : "auto" };
  const { [key]: _, ...rest } = choice.settings;
  return { ...choice, settings: value === settings[key]?.default ? rest : { ...rest, [key]: value } };
}

export function write({ scene, nodes, choices }: MethodsState): string {
  const methods = choices.map(({ kind, substeps, settings }) =>
    [kind, ...(substeps === "auto" ? [] : [`${SUBSTEPS}=${substeps}`]),
      ...Object.entries(settings).map(([key, value]) => `${key}=${String(value)}`)].join(":")
  );
  const parts = [`v=${VERSION}`, `scene=${scene}`, ...(nodes === null ? [] : [`nodes=${nodes}`]),
    `methods=${methods.join(",")}`];
  return `?${parts.join("&")}`;
}
