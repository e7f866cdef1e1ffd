// weft: real-time cloth on WebGPU. README.md has an example.
export { catalog, schemaOf, type Catalog, type Fabric, type NamedLook, type Method, type Schema } from "./catalog.js";
export { WeftError } from "./error.js";
export { checkScene, readMesh, type MeshFile, type SceneSize } from "./files.js";
export { DEVICE_LIMITS, type ErrorKind } from "./gpu_tables.js";
export type { Placement } from "./placement.js";
export { createReference, Reference, type ReferenceInfo, type ReferenceOptions } from "./reference.js";
export { meshNames, type Bytes, type Scene } from "./scene.js";
export type * from "./scene_types.js";
export type { Totals } from "./totals.js";
export { createWorld, World } from "./world.js";
export { VIEWS, type Camera, type Measures, type MemoryUse, type OpenedState, type PassTime, type Pick, type Point,
  type Probe, type SceneOptions, type Snapshot, type Statistics, type Step, type StepOptions, type View,
  type WorldBuffer, type WorldBuffers, type WorldInfo, type WorldOptions } from "./world_types.js";
