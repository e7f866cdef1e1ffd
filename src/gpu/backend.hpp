// The interface of a back end: native/ on webgpu.h, web/ on the browser. Only gpu/ calls these.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "base/result.hpp"
#include "gpu/command_list.hpp"
#include "gpu/types.hpp"

namespace weft::gpu {

struct DeviceOptions {
  std::string adapter;          ///< part of the adapter's name, any case; empty: the fastest kind there is
  bool timestamps = false;      ///< ask for timestamp queries
  bool default_limits = false;  ///< native only: WebGPU's default limits instead of all that the adapter has
  bool unchecked = false;       ///< native only: kernels without the run-time checks of bounds and loops
  std::optional<DeviceHandles> given;  ///< native only: a device that the caller made and goes on using
};

namespace backend {

struct Context;  // instance, device, queue, and the first error that nobody asked for
struct ContextDeleter {
  void operator()(Context* context) const;
};
using ContextPointer = std::unique_ptr<Context, ContextDeleter>;

struct Opened {
  ContextPointer context;
  AdapterInfo adapter;
  Limits limits;
  bool timestamps = false;
};

Result<std::vector<AdapterInfo>> list_adapters();
Result<Opened> open(const DeviceOptions& options);

void release(ObjectKind kind, Id id);

Result<Id> create_buffer(Context&, std::uint64_t bytes, std::uint32_t usage, const std::string& label);
void write_buffer(Context&, Id buffer, std::uint64_t offset, std::span<const std::byte> bytes);

Result<Id> create_shader_module(Context&, const std::string& text, const std::string& label);
Result<Id> create_bind_group_layout(Context&, std::span<const BindingLayout>, bool for_render,
                                    const std::string& label);
Result<Id> create_pipeline_layout(Context&, Id bind_group_layout, const std::string& label);
Result<Id> create_bind_group(Context&, Id layout, std::span<const BindingLayout>,
                             std::span<const BindingSource>, const std::string& label);
Result<Id> create_compute_pipeline(Context&, Id layout, Id module, const std::string& entry,
                                   std::span<const Constant>, const std::string& label);
Result<Id> create_render_pipeline(Context&, Id layout, Id module, const RenderPipelineInfo&,
                                  const std::string& label);

Result<Id> create_texture(Context&, const TextureInfo&, const std::string& label);
Result<Id> create_texture_view(Context&, Id texture, const std::string& label);
Result<Id> create_sampler(Context&, const SamplerInfo&, const std::string& label);
Result<Id> create_timestamp_queries(Context&, std::uint32_t count, const std::string& label);
double timestamp_period(Context&);  ///< ns a tick
DeviceHandles handles(Context&);    ///< native only

/// Encodes the lists one after the other into one submit; what does not validate is an error and is not
/// submitted. In a browser the error arrives later, with wait or status.
Result<void> submit(Context&, std::span<const CommandList* const>);
/// Runs callbacks that are due.
void poll(Context&);
/// Returns once the queue is empty, all maps have settled and every error of earlier calls is known. In a
/// browser the caller sleeps meanwhile (Asyncify), and nothing else may be called.
void wait(Context&);
/// The error that nobody asked for, if there was one since the device was made.
Result<void> status(Context&);
/// Gives the device up, as a driver reset would: for tests of loss.
void lose(Context&);

enum class MapState : std::uint32_t { Idle, Pending, Ready, Failed };
/// Sets `state` to Ready or Failed when the time has come, be it after whoever asked has gone.
void map_read(Context&, Id buffer, std::uint64_t bytes, const std::shared_ptr<MapState>& state);
/// Copies the first bytes of a mapped buffer and unmaps it.
void take_mapped(Id buffer, std::span<std::byte> target);

}  // namespace backend
}  // namespace weft::gpu
