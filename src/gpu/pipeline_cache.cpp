#include "gpu/pipeline_cache.hpp"

#include <array>
#include <cstdio>

namespace weft::gpu {

Result<LaidOut> lay_out(backend::Context& context, const ShaderSource& source, const std::string& path,
                        bool for_render) {
  LaidOut laid;
  laid.made.bindings = source.bindings;
  WEFT_TRY(module_id, backend::create_shader_module(context, source.text, path));
  laid.module = Object(ObjectKind::ShaderModule, module_id);
  WEFT_TRY(group_layout, backend::create_bind_group_layout(context, source.bindings, for_render, path));
  laid.made.group_layout = Object(ObjectKind::BindGroupLayout, group_layout);
  WEFT_TRY(layout, backend::create_pipeline_layout(context, group_layout, path));
  laid.made.layout = Object(ObjectKind::PipelineLayout, layout);
  return laid;
}

std::string pipeline_key(const std::string& text, const std::string& path,
                         std::span<const Constant> constants) {
  std::string all = path;
  for (const Constant& constant : constants) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "=%a", constant.value);
    all += "\n" + constant.name + value.data();
  }
  return all + "\n" + text;
}

}  // namespace weft::gpu
