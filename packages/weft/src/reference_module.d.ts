// Emscripten's output (packages/weft/core/CMakeLists.txt): build/reference_module.js.
import type { Loader } from "./module_file.js";

declare const createReferenceModule: Loader;
export default createReferenceModule;
