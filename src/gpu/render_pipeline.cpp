#include "gpu/render_pipeline.hpp"

#include <array>
#include <cstdio>

namespace weft::gpu {
namespace {

Result<SharedPipeline> compile_shaders(Device& device, ShaderSource source, const std::string& path,
                                       const RenderPipelineInfo& info) {
  backend::Context& context = device.context();
  CompiledPipeline made;
  made.bindings = std::move(source.bindings);
  WEFT_TRY(module_id, backend::create_shader_module(context, source.text, path));
  const Object module(ObjectKind::ShaderModule, module_id);
  WEFT_TRY(group_layout, backend::create_bind_group_layout(context, made.bindings, true, path));
  made.group_layout = Object(ObjectKind::BindGroupLayout, group_layout);
  WEFT_TRY(layout, backend::create_pipeline_layout(context, group_layout, path));
  made.layout = Object(ObjectKind::PipelineLayout, layout);
  WEFT_TRY(pipeline, backend::create_render_pipeline(context, layout, module_id, info, path));
  made.pipeline = Object(ObjectKind::RenderPipeline, pipeline);
  return std::make_shared<const CompiledPipeline>(std::move(made));
}

/// All of what an info says but its constants.
std::string words_of(const RenderPipelineInfo& info) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%d %d %d %d %u %d %d %d %d %a ", static_cast<int>(info.topology),
                static_cast<int>(info.cull), static_cast<int>(info.color), static_cast<int>(info.depth),
                info.samples, info.depth_write ? 1 : 0, info.depth_or_equal ? 1 : 0, info.blend ? 1 : 0,
                info.depth_bias, static_cast<double>(info.depth_bias_slope));
  return text.data() + info.vertex_entry + ' ' + info.fragment_entry + ' ';
}

}  // namespace

Result<RenderPipeline> RenderPipeline::create(Device& device, const std::string& path,
                                              const RenderPipelineInfo& info) {
  WEFT_TRY(source, ShaderSource::load(path));
  RenderPipeline made;
  made.device_ = &device;
  made.label_ = path;
  const std::string from = words_of(info) + pipeline_key(source.text, path, info.constants);
  if (const SharedPipeline* known = device.render_pipelines().find(from)) {
    made.compiled_ = *known;
  } else {
    WEFT_SET(made.compiled_, compile_shaders(device, std::move(source), path, info));
    device.render_pipelines()[from] = made.compiled_;
  }
  return made;
}

Result<BindGroup> RenderPipeline::bind(std::initializer_list<Binding> sources) const {
  return BindGroup::create(*device_, compiled_->group_layout.id(), compiled_->bindings,
                           std::span(sources.begin(), sources.size()), label_);
}

}  // namespace weft::gpu
