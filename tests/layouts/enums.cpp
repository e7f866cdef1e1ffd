// The enumerations that gpu_backend.ts knows by number. Each is named by a switch without `default`, so that
// the compiler refuses one with an enumerator that is missing here.
#include <cstdint>

#include "base/result.hpp"
#include "gpu/backend.hpp"
#include "gpu/command_list.hpp"
#include "gpu/types.hpp"
#include "layouts.hpp"

namespace weft {
namespace {

#define NAME(enumerator) \
  case enumerator:       \
    return #enumerator

const char* name_of(ErrorKind kind) {
  switch (kind) {
    using enum ErrorKind;
    NAME(Failure);
    NAME(Usage);
    NAME(Input);
    NAME(Shape);
    NAME(Shader);
    NAME(NoAdapter);
    NAME(Limit);
    NAME(OutOfMemory);
    NAME(DeviceLost);
    NAME(Diverged);
    NAME(Interrupted);
  }
  return nullptr;
}

const char* name_of(gpu::ObjectKind kind) {
  switch (kind) {
    using enum gpu::ObjectKind;
    NAME(None);
    NAME(Buffer);
    NAME(Texture);
    NAME(TextureView);
    NAME(Sampler);
    NAME(ShaderModule);
    NAME(BindGroupLayout);
    NAME(PipelineLayout);
    NAME(BindGroup);
    NAME(ComputePipeline);
    NAME(RenderPipeline);
    NAME(QuerySet);
  }
  return nullptr;
}

const char* name_of(gpu::TextureFormat format) {
  switch (format) {
    using enum gpu::TextureFormat;
    NAME(None);
    NAME(Rgba8UnormSrgb);
    NAME(Bgra8UnormSrgb);
    NAME(Rgba8Unorm);
    NAME(Bgra8Unorm);
    NAME(Depth32Float);
  }
  return nullptr;
}

const char* name_of(gpu::CommandKind kind) {
  switch (kind) {
    using enum gpu::CommandKind;
    NAME(BeginCompute);
    NAME(EndCompute);
    NAME(Dispatch);
    NAME(CopyBuffer);
    NAME(ClearBuffer);
    NAME(ResolveQueries);
    NAME(BeginRender);
    NAME(EndRender);
    NAME(Draw);
    NAME(CopyTexture);
  }
  return nullptr;
}

const char* name_of(gpu::BindingKind kind) {
  switch (kind) {
    using enum gpu::BindingKind;
    NAME(Uniform);
    NAME(StepUniform);
    NAME(StorageRead);
    NAME(StorageReadWrite);
    NAME(Texture);
    NAME(DepthTexture);
    NAME(Sampler);
    NAME(ComparisonSampler);
  }
  return nullptr;
}

const char* name_of(gpu::backend::MapState state) {
  switch (state) {
    using enum gpu::backend::MapState;
    NAME(Idle);
    NAME(Pending);
    NAME(Ready);
    NAME(Failed);
  }
  return nullptr;
}

const char* name_of(gpu::BufferUsage usage) {
  switch (usage) {
    using enum gpu::BufferUsage;
    NAME(kStorage);
    NAME(kUniform);
    NAME(kCopySource);
    NAME(kCopyTarget);
    NAME(kIndex);
    NAME(kIndirect);
    NAME(kMapRead);
    NAME(kQueryResolve);
    NAME(kVertex);
  }
  return nullptr;
}

const char* name_of(gpu::TextureUsage usage) {
  switch (usage) {
    using enum gpu::TextureUsage;
    NAME(kRenderTarget);
    NAME(kSampled);
    NAME(kTextureCopySource);
  }
  return nullptr;
}

#undef NAME

template <class Enum>
Json counted() {
  Json values = Json::object();
  for (std::uint32_t value = 0; const char* name = name_of(static_cast<Enum>(value)); ++value)
    values[name] = value;
  return values;
}

template <class Enum>
Json bits() {
  Json values = Json::object();
  for (std::uint32_t value = 1; const char* name = name_of(static_cast<Enum>(value)); value <<= 1U)
    values[name] = value;
  return values;
}

}  // namespace

Json enum_values() {
  return {{"ErrorKind", counted<ErrorKind>()},
          {"ObjectKind", counted<gpu::ObjectKind>()},
          {"TextureFormat", counted<gpu::TextureFormat>()},
          {"CommandKind", counted<gpu::CommandKind>()},
          {"BindingKind", counted<gpu::BindingKind>()},
          {"MapState", counted<gpu::backend::MapState>()},
          {"BufferUsage", bits<gpu::BufferUsage>()},
          {"TextureUsage", bits<gpu::TextureUsage>()}};
}

}  // namespace weft
