import { defineConfig } from "vite";

/** What the page may do, said to the browser. `style` is what a style may come from. */
function headers(style: string): Record<string, string> {
  return {
    // WebAssembly needs a word of its own; everything else comes from the page's origin.
    "Content-Security-Policy": `default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src ${style}; ` +
      "object-src 'none'; base-uri 'none'; frame-ancestors 'none'; form-action 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Permissions-Policy": "camera=(), microphone=(), geolocation=(), payment=(), usb=()",
  };
}

export default defineConfig({
  root: import.meta.dirname,
  base: "./", // the build works in any folder of a server
  build: {
    target: "es2023",
    outDir: "dist",
    emptyOutDir: true,
    // Nothing as a data: address: the policy above lets none be fetched, and the module is compiled from a file.
    assetsInlineLimit: 0,
    license: { fileName: "licenses.txt" }, // of three.js, whose comments the bundler drops
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 700, // kB: three.js, which only /compare loads
    rollupOptions: {
      input: { main: `${import.meta.dirname}/index.html`, compare: `${import.meta.dirname}/compare/index.html`,
        methods: `${import.meta.dirname}/methods/index.html`, teach: `${import.meta.dirname}/teach/index.html` },
    },
  },
  worker: { format: "es" }, // as the page: the core finds its file beside the module
  server: { headers: headers("'self' 'unsafe-inline'") }, // Vite hands styles over inline while developing
  preview: { headers: headers("'self'") },
});
