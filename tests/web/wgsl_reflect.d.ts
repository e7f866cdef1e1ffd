// The package's own entry for Node is CommonJS by the name of an ES module and does not load.
declare module "wgsl_reflect/wgsl_reflect.module.js" {
  export * from "wgsl_reflect";
}
