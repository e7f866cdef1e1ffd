// The functions that the C++ side of the browser back end calls; gpu_backend.ts is the other side. Objects are handles:
// small numbers that the JavaScript side keeps its GPU objects under. Texts are UTF-8 with a length. A
// creating call always gives a handle: what was wrong with it is known after weft_gpu_wait.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gpu/command_list.hpp"
#include "gpu/types.hpp"
#include "gpu/web/layout.hpp"

namespace weft::gpu::backend::web {

/// Mirrored in gpu_backend.ts, which reads these structs where they lie.
struct Text {
  const char* data;
  std::uint32_t size;
};
struct LayoutEntry {
  std::uint32_t binding, kind;
};
struct GroupEntry {
  std::uint32_t binding, kind, id, padding;
  double offset, size;  // bytes
};
struct ConstantEntry {
  Text name;
  double value;
};
struct RenderInfo {
  std::uint32_t topology, cull, color, depth, samples, depth_write, depth_or_equal, blend;
  std::int32_t depth_bias;
  float depth_bias_slope;
  Text vertex_entry, fragment_entry;
};
static_assert(sizeof(Text) == 8 && sizeof(GroupEntry) == 32 && sizeof(ConstantEntry) == 16 &&
              sizeof(RenderInfo) == 56);
static_assert(sizeof(Command) == kCommandLayout.size && offsetof(Command, ids) == kCommandLayout.ids &&
              offsetof(Command, args) == kCommandLayout.args &&
              offsetof(Command, sizes) == kCommandLayout.sizes);
static_assert(sizeof(RenderTarget) == kRenderTargetLayout.size &&
              offsetof(RenderTarget, color) == kRenderTargetLayout.color &&
              offsetof(RenderTarget, resolve) == kRenderTargetLayout.resolve &&
              offsetof(RenderTarget, depth) == kRenderTargetLayout.depth &&
              offsetof(RenderTarget, clear_color) == kRenderTargetLayout.clear_color &&
              offsetof(RenderTarget, store_depth) == kRenderTargetLayout.store_depth);

/// A command list as frame_encoder.ts walks it.
struct ListView {
  const Command* commands;
  std::uint32_t command_count;
  const RenderTarget* targets;
};

extern "C" {
/// Asks for an adapter and its device. Returns 0, or 1 + an ErrorKind whose sentence weft_gpu_text holds.
/// From then on `*error` becomes nonzero when something goes wrong that no call has returned. Sleeps.
std::uint32_t weft_gpu_open(const char* adapter, std::uint32_t size, std::uint32_t timestamps,
                            std::uint32_t* error);
void weft_gpu_close();
void weft_gpu_lose();
/// Whether the device has timestamp queries; limits[7] in the order of gpu::Limits.
std::uint32_t weft_gpu_limits(double* limits);
/// The ErrorKind of the first error since the last call, where `*error` says that there is one; weft_gpu_text
/// holds its sentence. A loss stays.
std::uint32_t weft_gpu_take_error();
std::uint32_t weft_gpu_text_size();
void weft_gpu_text(char* target);

void weft_gpu_release(std::uint32_t kind, std::uint32_t id);
std::uint32_t weft_gpu_buffer(double bytes, std::uint32_t usage, const Text* label);
void weft_gpu_write(std::uint32_t buffer, double offset, const void* bytes, std::uint32_t size);
std::uint32_t weft_gpu_shader_module(const Text* source, const Text* label);
std::uint32_t weft_gpu_bind_group_layout(const LayoutEntry* entries, std::uint32_t count,
                                         std::uint32_t for_render, const Text* label);
std::uint32_t weft_gpu_pipeline_layout(std::uint32_t bind_group_layout, const Text* label);
std::uint32_t weft_gpu_bind_group(std::uint32_t layout, const GroupEntry* entries, std::uint32_t count,
                                  const Text* label);
std::uint32_t weft_gpu_compute_pipeline(std::uint32_t layout, std::uint32_t module, const Text* entry,
                                        const ConstantEntry* constants, std::uint32_t count,
                                        const Text* label);
std::uint32_t weft_gpu_render_pipeline(std::uint32_t layout, std::uint32_t module, const RenderInfo* info,
                                       const ConstantEntry* constants, std::uint32_t count,
                                       const Text* label);
std::uint32_t weft_gpu_texture(std::uint32_t width, std::uint32_t height, std::uint32_t samples,
                               std::uint32_t format, std::uint32_t usage, const Text* label);
std::uint32_t weft_gpu_texture_view(std::uint32_t texture, const Text* label);
std::uint32_t weft_gpu_sampler(std::uint32_t linear, std::uint32_t repeat, std::uint32_t comparison,
                               const Text* label);
std::uint32_t weft_gpu_queries(std::uint32_t count, const Text* label);

/// Encodes all lists and submits them: the one crossing of a frame.
void weft_gpu_submit(const ListView* lists, std::uint32_t count);
/// Maps the buffer and then writes a MapState to `*state`.
void weft_gpu_map(std::uint32_t buffer, double bytes, std::uint32_t* state);
void weft_gpu_take_mapped(std::uint32_t buffer, void* target, std::uint32_t size);
/// See backend::wait. Sleeps.
void weft_gpu_wait();
}

}  // namespace weft::gpu::backend::web
