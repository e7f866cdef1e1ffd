#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "gpu/backend.hpp"
#include "gpu/pipeline_cache.hpp"
#include "gpu/types.hpp"

namespace weft::gpu {

/// One WebGPU device and its queue. Never moves: buffers, kernels and readbacks keep a reference to it.
class Device {
 public:
  /// Errors  NoAdapter: there is none, or none of that name. Failure: the adapter gives no device. Input, Limit: a
  ///         given device is null, or less than weft's shaders need.
  static Result<std::unique_ptr<Device>> create(const DeviceOptions& options = {});
  static Result<std::vector<AdapterInfo>> adapters() { return backend::list_adapters(); }

  const AdapterInfo& adapter() const { return adapter_; }
  const Limits& limits() const { return limits_; }
  bool has_timestamps() const { return timestamps_; }

  /// Lowers a limit, so that a test can reach it. Never raises one.
  void lower_limits(const Limits& limits);

  /// Submits the lists, in their order, as one.
  /// Errors  DeviceLost, OutOfMemory, Shader (a command does not validate; nothing was submitted).
  Result<void> submit(std::span<const CommandList* const> lists) { return backend::submit(*context_, lists); }
  Result<void> submit(const CommandList& list);
  /// Waits until all that was submitted is done, then says whether the device is well.
  Result<void> wait();
  /// Runs the callbacks that are due, without blocking.
  void poll() { backend::poll(*context_); }
  /// Whether anything has gone wrong that no call returned.
  Result<void> status() { return backend::status(*context_); }
  /// Gives the device up as a driver reset would, so that a test can see what follows.
  void lose() { backend::lose(*context_); }

  void write(const BindingSource& target, std::span<const std::byte> bytes);
  std::uint64_t allocated_bytes() const { return allocated_bytes_; }
  /// The bytes of the largest buffer that was made since this was last asked.
  std::uint64_t take_largest_buffer() { return std::exchange(largest_buffer_, 0); }

  backend::Context& context() { return *context_; }
  KernelCache& kernels() { return kernels_; }
  RenderPipelineCache& render_pipelines() { return render_pipelines_; }
  /// Natively a WGPUAdapter and a WGPUDevice, valid for as long as the device lives.
  DeviceHandles handles() const { return backend::handles(*context_); }
  /// Bytes taken, or given back.
  void count_allocation(std::int64_t bytes) {
    allocated_bytes_ += static_cast<std::uint64_t>(bytes);
    if (bytes > 0) largest_buffer_ = std::max(largest_buffer_, static_cast<std::uint64_t>(bytes));
  }

 private:
  explicit Device(backend::Opened opened);

  backend::ContextPointer context_;
  KernelCache kernels_;
  RenderPipelineCache render_pipelines_;
  AdapterInfo adapter_;
  Limits limits_;
  bool timestamps_ = false;
  std::uint64_t allocated_bytes_ = 0, largest_buffer_ = 0;
};

}  // namespace weft::gpu
