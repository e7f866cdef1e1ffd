// Buffers, textures, samplers, queries, and reading buffers back.
#include <cassert>
#include <chrono>
#include <cstring>

#include "gpu/native/context.hpp"

namespace weft::gpu::backend {
namespace {

WGPUBufferUsage buffer_usage(std::uint32_t usage) {
  WGPUBufferUsage flags = WGPUBufferUsage_None;
  if (usage & kStorage) flags |= WGPUBufferUsage_Storage;
  if (usage & kUniform) flags |= WGPUBufferUsage_Uniform;
  if (usage & kCopySource) flags |= WGPUBufferUsage_CopySrc;
  if (usage & kCopyTarget) flags |= WGPUBufferUsage_CopyDst;
  if (usage & kIndex) flags |= WGPUBufferUsage_Index;
  if (usage & kIndirect) flags |= WGPUBufferUsage_Indirect;
  if (usage & kMapRead) flags |= WGPUBufferUsage_MapRead;
  if (usage & kQueryResolve) flags |= WGPUBufferUsage_QueryResolve;
  if (usage & kVertex) flags |= WGPUBufferUsage_Vertex;
  return flags;
}

void on_mapped(WGPUMapAsyncStatus status, WGPUStringView, void* user, void*) {
  const std::unique_ptr<std::shared_ptr<MapState>> state(static_cast<std::shared_ptr<MapState>*>(user));
  **state = status == WGPUMapAsyncStatus_Success ? MapState::Ready : MapState::Failed;
}

}  // namespace

WGPUTextureFormat texture_format(TextureFormat format);  // pipelines.cpp

void release(ObjectKind kind, Id id) {
  switch (kind) {
    case ObjectKind::Buffer:
      return wgpuBufferRelease(handle<WGPUBuffer>(id));
    case ObjectKind::Texture:
      return wgpuTextureRelease(handle<WGPUTexture>(id));
    case ObjectKind::TextureView:
      return wgpuTextureViewRelease(handle<WGPUTextureView>(id));
    case ObjectKind::Sampler:
      return wgpuSamplerRelease(handle<WGPUSampler>(id));
    case ObjectKind::ShaderModule:
      return wgpuShaderModuleRelease(handle<WGPUShaderModule>(id));
    case ObjectKind::BindGroupLayout:
      return wgpuBindGroupLayoutRelease(handle<WGPUBindGroupLayout>(id));
    case ObjectKind::PipelineLayout:
      return wgpuPipelineLayoutRelease(handle<WGPUPipelineLayout>(id));
    case ObjectKind::BindGroup:
      return wgpuBindGroupRelease(handle<WGPUBindGroup>(id));
    case ObjectKind::ComputePipeline:
      return wgpuComputePipelineRelease(handle<WGPUComputePipeline>(id));
    case ObjectKind::RenderPipeline:
      return wgpuRenderPipelineRelease(handle<WGPURenderPipeline>(id));
    case ObjectKind::QuerySet:
      return wgpuQuerySetRelease(handle<WGPUQuerySet>(id));
    case ObjectKind::None:
      return;
  }
}

Result<Id> create_buffer(Context& context, std::uint64_t bytes, std::uint32_t usage,
                         const std::string& label) {
  WGPUBufferDescriptor descriptor = WGPU_BUFFER_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.size = bytes;
  descriptor.usage = buffer_usage(usage);
  return make(context, "buffer", label, [&] { return wgpuDeviceCreateBuffer(context.device, &descriptor); });
}

void write_buffer(Context& context, Id buffer, std::uint64_t offset, std::span<const std::byte> bytes) {
  if (context.lost) return;
  const ErrorScope scope(context);
  wgpuQueueWriteBuffer(context.queue, handle<WGPUBuffer>(buffer), offset, bytes.data(), bytes.size());
}

Result<Id> create_texture(Context& context, const TextureInfo& info, const std::string& label) {
  WGPUTextureDescriptor descriptor = WGPU_TEXTURE_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.size = {info.width, info.height, 1};
  descriptor.format = texture_format(info.format);
  descriptor.sampleCount = info.samples;
  if (info.usage & kRenderTarget) descriptor.usage |= WGPUTextureUsage_RenderAttachment;
  if (info.usage & kSampled) descriptor.usage |= WGPUTextureUsage_TextureBinding;
  if (info.usage & kTextureCopySource) descriptor.usage |= WGPUTextureUsage_CopySrc;
  return make(context, "texture", label,
              [&] { return wgpuDeviceCreateTexture(context.device, &descriptor); });
}

Result<Id> create_texture_view(Context& context, Id texture, const std::string& label) {
  return make(context, "texture view", label,
              [&] { return wgpuTextureCreateView(handle<WGPUTexture>(texture), nullptr); });
}

Result<Id> create_sampler(Context& context, const SamplerInfo& info, const std::string& label) {
  WGPUSamplerDescriptor descriptor = WGPU_SAMPLER_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.magFilter = descriptor.minFilter = info.linear ? WGPUFilterMode_Linear : WGPUFilterMode_Nearest;
  descriptor.addressModeU = descriptor.addressModeV =
      info.repeat ? WGPUAddressMode_Repeat : WGPUAddressMode_ClampToEdge;
  if (info.comparison) descriptor.compare = WGPUCompareFunction_LessEqual;
  return make(context, "sampler", label,
              [&] { return wgpuDeviceCreateSampler(context.device, &descriptor); });
}

Result<Id> create_timestamp_queries(Context& context, std::uint32_t count, const std::string& label) {
  WGPUQuerySetDescriptor descriptor = WGPU_QUERY_SET_DESCRIPTOR_INIT;
  descriptor.label = view(label);
  descriptor.type = WGPUQueryType_Timestamp;
  descriptor.count = count;
  return make(context, "query set", label,
              [&] { return wgpuDeviceCreateQuerySet(context.device, &descriptor); });
}

double timestamp_period(Context& context) {
  return static_cast<double>(wgpuQueueGetTimestampPeriod(context.queue));
}

void poll(Context& context) {
  if (!context.lost) wgpuDevicePoll(context.device, 0, nullptr);
}

void wait(Context& context) {
  // wgpu-native returns early when a submission takes very long; the queue is asked until it is empty.
  while (!context.lost && wgpuDevicePoll(context.device, 1, nullptr) == 0) {
  }
}

void map_read(Context& context, Id buffer, std::uint64_t bytes, const std::shared_ptr<MapState>& state) {
  if (context.lost) {
    *state = MapState::Failed;
    return;
  }
  WGPUBufferMapCallbackInfo callback = WGPU_BUFFER_MAP_CALLBACK_INFO_INIT;
  callback.mode = WGPUCallbackMode_AllowSpontaneous;
  callback.callback = on_mapped;
  callback.userdata1 =
      new std::shared_ptr<MapState>(state);  // the callback's own share, since it may come late
  const ErrorScope scope(context);
  wgpuBufferMapAsync(handle<WGPUBuffer>(buffer), WGPUMapMode_Read, 0, bytes, callback);
}

void take_mapped(Id buffer, std::span<std::byte> target) {
  const auto mapped = handle<WGPUBuffer>(buffer);
  std::memcpy(target.data(), wgpuBufferGetConstMappedRange(mapped, 0, target.size()), target.size());
  wgpuBufferUnmap(mapped);
}

}  // namespace weft::gpu::backend
