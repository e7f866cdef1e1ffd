// Prints as JSON what the compiler made of everything that C++ shares with WGSL and with TypeScript.
#include <cstdio>

#include "gpu/web/layout.hpp"
#include "layouts.hpp"

int main() {
  constexpr auto command = weft::gpu::backend::web::kCommandLayout;
  constexpr auto target = weft::gpu::backend::web::kRenderTargetLayout;
  const weft::Json all = {
      {"structs", weft::struct_layouts()},
      {"constants", weft::shared_constants()},
      {"enums", weft::enum_values()},
      {"command",
       {{"size", command.size}, {"ids", command.ids}, {"args", command.args}, {"sizes", command.sizes}}},
      {"render_target",
       {{"size", target.size},
        {"color", target.color},
        {"resolve", target.resolve},
        {"depth", target.depth},
        {"clear_color", target.clear_color},
        {"store_depth", target.store_depth}}},
  };
  std::puts(all.dump(1).c_str());
}
