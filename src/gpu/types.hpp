// Plain data that the GPU layer's headers share. Nothing here knows webgpu.h: native/ and web/ translate it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weft/adapter.hpp"

namespace weft::gpu {

/// A WebGPU object as its back end names it; 0 is none.
using Id = std::uintptr_t;

/// The device of a back end and its adapter, as the back end names them.
struct DeviceHandles {
  Id adapter = 0, device = 0;
};

enum class ObjectKind : std::uint8_t {
  None,
  Buffer,
  Texture,
  TextureView,
  Sampler,
  ShaderModule,
  BindGroupLayout,
  PipelineLayout,
  BindGroup,
  ComputePipeline,
  RenderPipeline,
  QuerySet,
};

using weft::AdapterInfo;

/// The limits that weft checks itself, before anything is allocated.
struct Limits {
  std::uint64_t max_buffer_size = 0;           // bytes
  std::uint64_t max_storage_binding_size = 0;  // bytes
  std::uint32_t max_storage_buffers_per_stage = 0;
  std::uint32_t max_invocations_per_workgroup = 0;  // also along x alone
  std::uint32_t max_workgroup_storage = 0;          // bytes
  std::uint32_t max_workgroups_per_dimension = 0;
  std::uint32_t max_texture_size = 0;                // pixels a side
  std::uint32_t min_uniform_offset_alignment = 256;  // bytes
};

enum BufferUsage : std::uint32_t {
  kStorage = 1U << 0U,
  kUniform = 1U << 1U,
  kCopySource = 1U << 2U,
  kCopyTarget = 1U << 3U,
  kIndex = 1U << 4U,
  kIndirect = 1U << 5U,
  kMapRead = 1U << 6U,
  kQueryResolve = 1U << 7U,
  kVertex = 1U << 8U,
};

enum TextureUsage : std::uint32_t {
  kRenderTarget = 1U << 0U,
  kSampled = 1U << 1U,
  kTextureCopySource = 1U << 2U,
};

enum class TextureFormat : std::uint8_t {
  None,
  Rgba8UnormSrgb,
  Bgra8UnormSrgb,
  Rgba8Unorm,
  Bgra8Unorm,
  Depth32Float
};

/// The type of a shader's binding, read from its WGSL.
enum class BindingKind : std::uint8_t {
  Uniform,
  StepUniform,  // one block a substep, or an array of two, chosen by the dispatch
  StorageRead,
  StorageReadWrite,
  Texture,
  DepthTexture,
  Sampler,
  ComparisonSampler,
};

struct BindingLayout {
  std::uint32_t binding = 0;
  BindingKind kind = BindingKind::Uniform;
  std::string name;
  std::uint32_t steps = 0;  // of a StepUniform: blocks that the kernel sees
};

/// The resource of a binding: a buffer (range), a texture view or a sampler.
struct BindingSource {
  Id id = 0;
  ObjectKind kind = ObjectKind::None;
  std::uint64_t offset = 0;  // bytes
  std::uint64_t size = 0;    // bytes; for a buffer
};

struct Constant {
  std::string name;
  double value = 0;
};

enum class Topology : std::uint8_t { Triangles, Lines };
enum class CullMode : std::uint8_t { None, Back };

struct RenderPipelineInfo {
  Topology topology = Topology::Triangles;
  CullMode cull = CullMode::None;
  TextureFormat color = TextureFormat::None;
  TextureFormat depth = TextureFormat::None;
  std::uint32_t samples = 1;
  bool depth_write = true;
  bool depth_or_equal = false;  // passes where depth is equal: for lines drawn over their own triangles
  bool blend = false;           // source over
  std::int32_t depth_bias = 0;
  float depth_bias_slope = 0;
  std::vector<Constant> constants;
  std::string vertex_entry = "vertex_main";
  std::string fragment_entry = "fragment_main";  // empty: depth only
};

struct TextureInfo {
  std::uint32_t width = 1, height = 1, samples = 1;
  TextureFormat format = TextureFormat::Rgba8Unorm;
  std::uint32_t usage = 0;  // TextureUsage
};

struct SamplerInfo {
  bool linear = true;
  bool repeat = false;
  bool comparison = false;  // less-or-equal, for shadow maps
};

}  // namespace weft::gpu
