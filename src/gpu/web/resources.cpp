// Buffers, textures, layouts, bind groups and pipelines of the browser, by handle.
#include <vector>

#include "gpu/web/context.hpp"

namespace weft::gpu::backend {
namespace {

/// The handle of what was just asked for. Whether it could be made is known after wait; only what has come to
/// light before is returned here.
Result<Id> made(Context& context, ObjectKind kind, std::uint32_t id, const char* what,
                const std::string& label) {
  if (auto error = context.take_error(); !error) {
    release(kind, id);
    return error.error().while_doing(std::string("making ") + what + " " + label);
  }
  return static_cast<Id>(id);
}

std::vector<web::ConstantEntry> constant_entries(std::span<const Constant> constants) {
  std::vector<web::ConstantEntry> entries;
  for (const Constant& constant : constants) entries.push_back({text(constant.name), constant.value});
  return entries;
}

std::uint32_t count_of(const auto& list) { return static_cast<std::uint32_t>(list.size()); }

}  // namespace

void release(ObjectKind kind, Id id) { web::weft_gpu_release(static_cast<std::uint32_t>(kind), handle(id)); }

Result<Id> create_buffer(Context& context, std::uint64_t bytes, std::uint32_t usage,
                         const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::Buffer, web::weft_gpu_buffer(static_cast<double>(bytes), usage, &name),
              "buffer", label);
}

void write_buffer(Context&, Id buffer, std::uint64_t offset, std::span<const std::byte> bytes) {
  web::weft_gpu_write(handle(buffer), static_cast<double>(offset), bytes.data(), count_of(bytes));
}

Result<Id> create_shader_module(Context& context, const std::string& source, const std::string& label) {
  const web::Text code = text(source), name = text(label);
  return made(context, ObjectKind::ShaderModule, web::weft_gpu_shader_module(&code, &name), "shader", label);
}

Result<Id> create_bind_group_layout(Context& context, std::span<const BindingLayout> bindings,
                                    bool for_render, const std::string& label) {
  std::vector<web::LayoutEntry> entries;
  for (const BindingLayout& binding : bindings)
    entries.push_back({binding.binding, static_cast<std::uint32_t>(binding.kind)});
  const web::Text name = text(label);
  return made(context, ObjectKind::BindGroupLayout,
              web::weft_gpu_bind_group_layout(entries.data(), count_of(entries), for_render ? 1 : 0, &name),
              "bind group layout", label);
}

Result<Id> create_pipeline_layout(Context& context, Id bind_group_layout, const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::PipelineLayout,
              web::weft_gpu_pipeline_layout(handle(bind_group_layout), &name), "pipeline layout", label);
}

Result<Id> create_bind_group(Context& context, Id layout, std::span<const BindingLayout> bindings,
                             std::span<const BindingSource> sources, const std::string& label) {
  std::vector<web::GroupEntry> entries;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const std::uint64_t size =
        bindings[i].kind == BindingKind::StepUniform ? bindings[i].steps * kStepStride : sources[i].size;
    entries.push_back({bindings[i].binding, static_cast<std::uint32_t>(sources[i].kind),
                       handle(sources[i].id), 0, static_cast<double>(sources[i].offset),
                       static_cast<double>(size)});
  }
  const web::Text name = text(label);
  return made(context, ObjectKind::BindGroup,
              web::weft_gpu_bind_group(handle(layout), entries.data(), count_of(entries), &name),
              "bind group", label);
}

Result<Id> create_compute_pipeline(Context& context, Id layout, Id module, const std::string& entry,
                                   std::span<const Constant> constants, const std::string& label) {
  const auto entries = constant_entries(constants);
  const web::Text entry_name = text(entry), name = text(label);
  return made(context, ObjectKind::ComputePipeline,
              web::weft_gpu_compute_pipeline(handle(layout), handle(module), &entry_name, entries.data(),
                                             count_of(entries), &name),
              "compute pipeline", label);
}

Result<Id> create_render_pipeline(Context& context, Id layout, Id module, const RenderPipelineInfo& info,
                                  const std::string& label) {
  const auto entries = constant_entries(info.constants);
  const web::RenderInfo raw = {static_cast<std::uint32_t>(info.topology),
                               static_cast<std::uint32_t>(info.cull),
                               static_cast<std::uint32_t>(info.color),
                               static_cast<std::uint32_t>(info.depth),
                               info.samples,
                               info.depth_write ? 1U : 0U,
                               info.depth_or_equal ? 1U : 0U,
                               info.blend ? 1U : 0U,
                               info.depth_bias,
                               info.depth_bias_slope,
                               text(info.vertex_entry),
                               text(info.fragment_entry)};
  const web::Text name = text(label);
  return made(context, ObjectKind::RenderPipeline,
              web::weft_gpu_render_pipeline(handle(layout), handle(module), &raw, entries.data(),
                                            count_of(entries), &name),
              "render pipeline", label);
}

Result<Id> create_texture(Context& context, const TextureInfo& info, const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::Texture,
              web::weft_gpu_texture(info.width, info.height, info.samples,
                                    static_cast<std::uint32_t>(info.format), info.usage, &name),
              "texture", label);
}

Result<Id> create_texture_view(Context& context, Id texture, const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::TextureView, web::weft_gpu_texture_view(handle(texture), &name),
              "texture view", label);
}

Result<Id> create_sampler(Context& context, const SamplerInfo& info, const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::Sampler,
              web::weft_gpu_sampler(info.linear ? 1 : 0, info.repeat ? 1 : 0, info.comparison ? 1 : 0, &name),
              "sampler", label);
}

Result<Id> create_timestamp_queries(Context& context, std::uint32_t count, const std::string& label) {
  const web::Text name = text(label);
  return made(context, ObjectKind::QuerySet, web::weft_gpu_queries(count, &name), "query set", label);
}

double timestamp_period(Context&) { return 1; }  // a browser resolves to nanoseconds

}  // namespace weft::gpu::backend
