// How TypeScript, JavaScript, CSS and HTML are formatted.
// dprint's plugins, since they keep the author's line breaks and one-line rules: half as many lines of this tree change
// as with prettier or biome. They run as WebAssembly, so that package-lock.json needs no binary of any platform.
import { createContext } from "@dprint/formatter";
import { readFileSync } from "node:fs";

const PLUGINS = {
  "@dprint/typescript": {
    preferHanging: true,
    bracePosition: "sameLine",
    useBraces: "maintain",
    nextControlFlowPosition: "sameLine",
    operatorPosition: "sameLine",
    "arrowFunction.useParentheses": "force",
    "enumDeclaration.memberSpacing": "maintain",
    "module.sortImportDeclarations": "maintain",
    "module.sortExportDeclarations": "maintain",
    "importDeclaration.sortNamedImports": "maintain",
    "exportDeclaration.sortNamedExports": "maintain",
  },
  "dprint-plugin-malva": { singleLineBlockThreshold: 120 },
  "dprint-plugin-markup": { closingBracketSameLine: true, doctypeKeywordCase: "lower" },
};

const context = createContext({ lineWidth: 120, indentWidth: 2, useTabs: false, newLineKind: "lf" });
for (const [name, config] of Object.entries(PLUGINS)) {
  const wasm = new URL(`../node_modules/${name}/plugin.wasm`, import.meta.url);
  const diagnostics = context.addPlugin(readFileSync(wasm), config).getConfigDiagnostics();
  if (diagnostics.length > 0) throw new Error(`${name}: ${JSON.stringify(diagnostics)}`);
}

export function formatted(filePath: string, fileText: string): string {
  for (let pass = 0; pass < 5; pass++) { // what one pass breaks, the next may join
    const text = context.formatText({ filePath, fileText });
    if (text === fileText) return text;
    fileText = text;
  }
  throw new Error(`${filePath}: five passes of the formatter give five texts`);
}
