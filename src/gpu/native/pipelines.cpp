// Shader modules, layouts, bind groups and pipelines.
#include <vector>

#include "gpu/native/context.hpp"

namespace weft::gpu::backend {

WGPUTextureFormat texture_format(TextureFormat format) {
  switch (format) {
    case TextureFormat::None:
      break;
    case TextureFormat::Rgba8Unorm:
      return WGPUTextureFormat_RGBA8Unorm;
    case TextureFormat::Bgra8Unorm:
      return WGPUTextureFormat_BGRA8Unorm;
    case TextureFormat::Rgba8UnormSrgb:
      return WGPUTextureFormat_RGBA8UnormSrgb;
    case TextureFormat::Bgra8UnormSrgb:
      return WGPUTextureFormat_BGRA8UnormSrgb;
    case TextureFormat::Depth32Float:
      return WGPUTextureFormat_Depth32Float;
  }
  return WGPUTextureFormat_Undefined;
}

namespace {

WGPUBindGroupLayoutEntry layout_entry(const BindingLayout& binding, WGPUShaderStage stages) {
  WGPUBindGroupLayoutEntry entry = WGPU_BIND_GROUP_LAYOUT_ENTRY_INIT;
  entry.binding = binding.binding;
  entry.visibility = stages;
  entry.buffer.type = WGPUBufferBindingType_BindingNotUsed;
  entry.sampler.type = WGPUSamplerBindingType_BindingNotUsed;
  entry.texture.sampleType = WGPUTextureSampleType_BindingNotUsed;
  entry.storageTexture.access = WGPUStorageTextureAccess_BindingNotUsed;
  switch (binding.kind) {
    case BindingKind::StepUniform:
      entry.buffer.hasDynamicOffset = 1;
      [[fallthrough]];
    case BindingKind::Uniform:
      entry.buffer.type = WGPUBufferBindingType_Uniform;
      break;
    case BindingKind::StorageRead:
      entry.buffer.type = WGPUBufferBindingType_ReadOnlyStorage;
      break;
    case BindingKind::StorageReadWrite:
      entry.buffer.type = WGPUBufferBindingType_Storage;
      break;
    case BindingKind::Texture:
    case BindingKind::DepthTexture:
      entry.texture.sampleType =
          binding.kind == BindingKind::Texture ? WGPUTextureSampleType_Float : WGPUTextureSampleType_Depth;
      entry.texture.viewDimension = WGPUTextureViewDimension_2D;
      break;
    case BindingKind::Sampler:
      entry.sampler.type = WGPUSamplerBindingType_Filtering;
      break;
    case BindingKind::ComparisonSampler:
      entry.sampler.type = WGPUSamplerBindingType_Comparison;
      break;
  }
  return entry;
}

std::vector<WGPUConstantEntry> constant_entries(std::span<const Constant> constants) {
  std::vector<WGPUConstantEntry> entries;
  for (const Constant& constant : constants) {
    WGPUConstantEntry entry = WGPU_CONSTANT_ENTRY_INIT;
    entry.key = view(constant.name);
    entry.value = constant.value;
    entries.push_back(entry);
  }
  return entries;
}

}  // namespace

Result<Id> create_shader_module(Context& context, const std::string& source, const std::string& label) {
  WGPUShaderSourceWGSL wgsl = WGPU_SHADER_SOURCE_WGSL_INIT;
  wgsl.code = view(source);
  WGPUShaderModuleDescriptor descriptor = WGPU_SHADER_MODULE_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.nextInChain = &wgsl.chain;
  return make(context, "shader", label, [&] {
    return context.unchecked ? wgpuDeviceCreateShaderModuleTrusted(context.device, &descriptor,
                                                                   WGPUShaderRuntimeChecks_None)
                             : wgpuDeviceCreateShaderModule(context.device, &descriptor);
  });
}

Result<Id> create_bind_group_layout(Context& context, std::span<const BindingLayout> bindings,
                                    bool for_render, const std::string& label) {
  std::vector<WGPUBindGroupLayoutEntry> entries;
  for (const BindingLayout& binding : bindings)
    entries.push_back(layout_entry(
        binding, for_render ? WGPUShaderStage_Vertex | WGPUShaderStage_Fragment : WGPUShaderStage_Compute));
  WGPUBindGroupLayoutDescriptor descriptor = WGPU_BIND_GROUP_LAYOUT_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.entries = entries.data();
  descriptor.entryCount = entries.size();
  return make(context, "bind group layout", label,
              [&] { return wgpuDeviceCreateBindGroupLayout(context.device, &descriptor); });
}

Result<Id> create_pipeline_layout(Context& context, Id bind_group_layout, const std::string& label) {
  const auto layout = handle<WGPUBindGroupLayout>(bind_group_layout);
  WGPUPipelineLayoutDescriptor descriptor = WGPU_PIPELINE_LAYOUT_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.bindGroupLayouts = &layout;
  descriptor.bindGroupLayoutCount = 1;
  return make(context, "pipeline layout", label,
              [&] { return wgpuDeviceCreatePipelineLayout(context.device, &descriptor); });
}

Result<Id> create_bind_group(Context& context, Id layout, std::span<const BindingLayout> bindings,
                             std::span<const BindingSource> sources, const std::string& label) {
  std::vector<WGPUBindGroupEntry> entries;
  for (std::size_t i = 0; i < bindings.size(); ++i) {
    const BindingSource& source = sources[i];
    WGPUBindGroupEntry entry = WGPU_BIND_GROUP_ENTRY_INIT;
    entry.binding = bindings[i].binding;
    if (source.kind == ObjectKind::Buffer) {
      entry.buffer = handle<WGPUBuffer>(source.id);
      entry.offset = source.offset;
      entry.size =
          bindings[i].kind == BindingKind::StepUniform ? bindings[i].steps * kStepStride : source.size;
    } else if (source.kind == ObjectKind::TextureView) {
      entry.textureView = handle<WGPUTextureView>(source.id);
    } else {
      entry.sampler = handle<WGPUSampler>(source.id);
    }
    entries.push_back(entry);
  }
  WGPUBindGroupDescriptor descriptor = WGPU_BIND_GROUP_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.layout = handle<WGPUBindGroupLayout>(layout);
  descriptor.entries = entries.data();
  descriptor.entryCount = entries.size();
  return make(context, "bind group", label,
              [&] { return wgpuDeviceCreateBindGroup(context.device, &descriptor); });
}

Result<Id> create_compute_pipeline(Context& context, Id layout, Id module, const std::string& entry,
                                   std::span<const Constant> constants, const std::string& label) {
  const auto entries = constant_entries(constants);
  WGPUComputePipelineDescriptor descriptor = WGPU_COMPUTE_PIPELINE_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.layout = handle<WGPUPipelineLayout>(layout);
  descriptor.compute.module = handle<WGPUShaderModule>(module);
  descriptor.compute.entryPoint = view(entry);
  descriptor.compute.constants = entries.data();
  descriptor.compute.constantCount = entries.size();
  return make(context, "pipeline", label,
              [&] { return wgpuDeviceCreateComputePipeline(context.device, &descriptor); });
}

Result<Id> create_render_pipeline(Context& context, Id layout, Id module, const RenderPipelineInfo& info,
                                  const std::string& label) {
  const auto constants = constant_entries(info.constants);
  WGPUBlendState blend = WGPU_BLEND_STATE_INIT;
  blend.color = {WGPUBlendOperation_Add, WGPUBlendFactor_SrcAlpha, WGPUBlendFactor_OneMinusSrcAlpha};
  blend.alpha = {WGPUBlendOperation_Add, WGPUBlendFactor_One, WGPUBlendFactor_OneMinusSrcAlpha};
  WGPUColorTargetState color = WGPU_COLOR_TARGET_STATE_INIT;
  color.format = texture_format(info.color);
  color.blend = info.blend ? &blend : nullptr;
  color.writeMask = WGPUColorWriteMask_All;
  WGPUFragmentState fragment = WGPU_FRAGMENT_STATE_INIT;
  fragment.module = handle<WGPUShaderModule>(module);
  fragment.entryPoint = view(info.fragment_entry);
  fragment.constants = constants.data();
  fragment.constantCount = constants.size();
  fragment.targets = &color;
  fragment.targetCount = 1;
  WGPUDepthStencilState depth = WGPU_DEPTH_STENCIL_STATE_INIT;
  depth.format = texture_format(info.depth);
  depth.depthWriteEnabled = info.depth_write ? WGPUOptionalBool_True : WGPUOptionalBool_False;
  depth.depthCompare = info.depth_or_equal ? WGPUCompareFunction_LessEqual : WGPUCompareFunction_Less;
  depth.depthBias = info.depth_bias;
  depth.depthBiasSlopeScale = info.depth_bias_slope;

  WGPURenderPipelineDescriptor descriptor = WGPU_RENDER_PIPELINE_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.layout = handle<WGPUPipelineLayout>(layout);
  descriptor.vertex.module = handle<WGPUShaderModule>(module);
  descriptor.vertex.entryPoint = view(info.vertex_entry);
  descriptor.vertex.constants = constants.data();
  descriptor.vertex.constantCount = constants.size();
  descriptor.primitive.topology =
      info.topology == Topology::Lines ? WGPUPrimitiveTopology_LineList : WGPUPrimitiveTopology_TriangleList;
  descriptor.primitive.cullMode = info.cull == CullMode::Back ? WGPUCullMode_Back : WGPUCullMode_None;
  descriptor.multisample.count = info.samples;
  descriptor.depthStencil = info.depth == TextureFormat::None ? nullptr : &depth;
  descriptor.fragment = info.fragment_entry.empty() ? nullptr : &fragment;
  return make(context, "pipeline", label,
              [&] { return wgpuDeviceCreateRenderPipeline(context.device, &descriptor); });
}

}  // namespace weft::gpu::backend
