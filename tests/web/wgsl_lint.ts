// Rules for the kernels that decide the state: what keeps its bits equal from driver to driver and from host to host.
import { withoutComments } from "./shaders.js";

interface Rule {
  name: string;
  why: string;
  forbidden: RegExp;
  only?: (match: readonly string[]) => boolean;
}

const call = (names: string) => new RegExp(`\\b(${names.trim().split(/\s+/).join("|")})\\s*\\(`, "g");

const operand = (text = "") => text.replace(/\breturn\b|\s/g, "");

// WGSL gives these an error bound or leaves their steps to the driver (WGSL §15.7.4). Not in the list: what is exact,
// and sqrt, length, distance, dot, cross and fract: the state needs some of them, and hosts.test.ts finds its bits
// equal.
const RULES: readonly Rule[] = [
  { name: "inexact", why: "each driver rounds it its own way",
    forbidden: call(`sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh exp exp2 log log2 pow
      normalize mix smoothstep inverseSqrt degrees radians reflect refract faceForward`) },
  { name: "fma",
    why: "a driver may round it once or twice; write it only where each product must be added alike in two kernels",
    forbidden: call("fma") },
  { name: "nan-test", why: "a compiler may take NaN to be absent; look at the exponent's bits",
    forbidden: /([^(,;{}=&|!<>]+)[!=]=([^),;{}=&|!<>]+)/g, only: ([, a, b]) => operand(a) === operand(b) },
  { name: "f16", why: "it is optional, and too coarse for a state",
    forbidden: /\b(?:f16|(?:vec[234]|mat[234]x[234])h)\b|\b(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?h\b/g },
  { name: "float-atomic", why: "a sum of floats depends on the order of threads; add integers in fixed point",
    forbidden: /\batomicCompareExchangeWeak\b/g },
];

// contact/pushes/ adds every product by fma, so that `paper` and `bvh`, where they share a function, leave a compiler
// nothing to choose (triangle_pair.wgsl says more).
const ALLOWED: Readonly<Record<string, readonly string[]>> = {
  "contact/pushes/triangle_pair.wgsl": ["fma"],
  "contact/pushes/analytic.wgsl": ["fma"],
  "contact/proximity/place_kept_forces.wgsl": ["float-atomic"], // a hash table of whole numbers; no sum
};

/** What a shader may not contain, as sentences with the line. */
export function lint(path: string, text: string): string[] {
  const found: { line: number; sentence: string }[] = [];
  if (!/^\/\/ \S/.test(text))
    found.push({ line: 1, sentence: "comment: the first line does not say what the file is." });
  const code = withoutComments(text);
  for (const { name, why, forbidden, only } of RULES) {
    if (ALLOWED[path]?.includes(name)) continue;
    for (const match of code.matchAll(forbidden)) {
      if (only && !only(match)) continue;
      const at = match.index + match[0].search(/\S/);
      const line = code.slice(0, at).split("\n").length;
      found.push({ line, sentence: `${name}: \`${match[0].trim()}\`: ${why}.` });
    }
  }
  return found.sort((a, b) => a.line - b.line).map(({ line, sentence }) => `${path}:${line}: ${sentence}`);
}

/** The exceptions that no shader needs any more. */
export function unusedExceptions(read: (path: string) => string): string[] {
  return Object.entries(ALLOWED).flatMap(([path, names]) =>
    names
      .filter((name) => withoutComments(read(path)).search(RULES.find((rule) => rule.name === name)!.forbidden) < 0)
      .map((name) => `${path}: ${name}`)
  );
}
