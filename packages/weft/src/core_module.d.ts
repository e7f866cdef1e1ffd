// Emscripten's output (packages/weft/core/CMakeLists.txt): build/core_module.js.
import type { CoreModule } from "./core.js";

declare function createCore(options: Record<string, unknown>): Promise<CoreModule>;
export default createCore;
