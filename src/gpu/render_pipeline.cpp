#include "gpu/render_pipeline.hpp"

namespace weft::gpu {

Result<RenderPipeline> RenderPipeline::create(Device& device, const std::string& path,
                                              const RenderPipelineInfo& info) {
  WEFT_TRY(source, ShaderSource::load(path));
  RenderPipeline made;
  made.device_ = &device;
  made.label_ = path;
  made.bindings_ = std::move(source.bindings);
  backend::Context& context = device.context();
  WEFT_TRY(module_id, backend::create_shader_module(context, source.text, path));
  const Object module(ObjectKind::ShaderModule, module_id);
  WEFT_TRY(group_layout, backend::create_bind_group_layout(context, made.bindings_, true, path));
  made.group_layout_ = Object(ObjectKind::BindGroupLayout, group_layout);
  WEFT_TRY(layout, backend::create_pipeline_layout(context, group_layout, path));
  made.layout_ = Object(ObjectKind::PipelineLayout, layout);
  WEFT_TRY(pipeline, backend::create_render_pipeline(context, layout, module_id, info, path));
  made.pipeline_ = Object(ObjectKind::RenderPipeline, pipeline);
  return made;
}

Result<BindGroup> RenderPipeline::bind(std::initializer_list<Binding> sources) const {
  return BindGroup::create(*device_, group_layout_.id(), bindings_,
                           std::span(sources.begin(), sources.size()), label_);
}

}  // namespace weft::gpu
