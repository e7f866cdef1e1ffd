#include "gpu/render_pipeline.hpp"

#include <array>
#include <cstdio>

namespace weft::gpu {
namespace {

Result<CompiledPipeline> compile_shaders(Device& device, const ShaderSource& source, const std::string& path,
                                         const RenderPipelineInfo& info) {
  backend::Context& context = device.context();
  WEFT_TRY(laid, lay_out(context, source, path, true));
  CompiledPipeline& made = laid.made;
  WEFT_TRY(pipeline,
           backend::create_render_pipeline(context, made.layout.id(), laid.module.id(), info, path));
  made.pipeline = Object(ObjectKind::RenderPipeline, pipeline);
  return std::move(made);
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
  WEFT_SET(made.compiled_, compiled_once(device.render_pipelines(),
                                         words_of(info) + pipeline_key(source.text, path, info.constants),
                                         [&] { return compile_shaders(device, source, path, info); }));
  return made;
}

Result<BindGroup> RenderPipeline::bind(std::initializer_list<Binding> sources) const {
  return BindGroup::create(*device_, compiled_->group_layout.id(), compiled_->bindings,
                           std::span(sources.begin(), sources.size()), label_);
}

}  // namespace weft::gpu
