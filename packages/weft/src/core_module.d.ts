// Emscripten's output (packages/weft/core/CMakeLists.txt): build/core_module.js.
import type { Loader } from "./module_file.js";

declare const createCore: Loader;
export default createCore;
