#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/buffer.hpp"
#include "gpu/command_list.hpp"
#include "gpu/device.hpp"
#include "gpu/pipeline_cache.hpp"
#include "gpu/shader_source.hpp"

namespace weft::gpu {

/// One thing to bind: a buffer, part of one, a texture's view, a sampler.
struct Binding {
  BindingSource source;
  Binding(const RawBuffer& buffer) : source(buffer.source()) {}
  Binding(const BindingSource& source_) : source(source_) {}
};

/// The buffers of one dispatch, in the order of the shader's binding table.
class BindGroup {
 public:
  BindGroup() = default;
  Id id() const { return object_.id(); }

  static Result<BindGroup> create(Device& device, Id layout, std::span<const BindingLayout> bindings,
                                  std::span<const Binding> sources, const std::string& label);

 private:
  Object object_;
};

inline constexpr std::uint32_t kDefaultWorkgroupSize = 256;

/// How many there are of a dispatch, along each of its dimensions.
struct Workgroups {
  std::uint32_t x = 1, y = 1, z = 1;
};

/// A compute kernel: one WGSL file whose entry point bears the file's name.
class Kernel {
 public:
  Kernel() = default;

  /// Compiles src/`path` with its `override`s set, unless the device has done so already. A file without
  /// `override kWorkgroupSize` must pass its fixed workgroup size.
  /// Errors  Shader: it does not compile, or its bindings exceed the adapter's limits.
  static Result<Kernel> create(Device& device, const std::string& path, std::vector<Constant> constants = {},
                               std::uint32_t workgroup_size = kDefaultWorkgroupSize);

  /// Errors  Shape: another number of buffers than the shader binds.
  Result<BindGroup> bind(std::span<const Binding> sources) const;
  Result<BindGroup> bind(std::initializer_list<Binding> sources) const {
    return bind(std::span(sources.begin(), sources.size()));
  }

  /// One invocation for each of `count` elements. The kernel finds its element by flat_index
  /// (gpu/index.wgsl), since past 65,535 workgroups the dispatch gets a second dimension.
  void dispatch(ComputePass& pass, const BindGroup& group, std::uint64_t count) const;
  /// For a grid-stride loop over up to `capacity` elements, whose number only the GPU knows: as many invocations as
  /// keep the adapter busy.
  void dispatch_strided(ComputePass& pass, const BindGroup& group, std::uint64_t capacity) const;
  /// The workgroups of dispatch_strided.
  Workgroups strided(std::uint64_t capacity) const;
  void dispatch_groups(ComputePass& pass, const BindGroup& group, const Workgroups& workgroups) const;
  /// How many workgroups `dispatch` makes of `count` invocations, along x and y.
  Workgroups workgroups_of(std::uint64_t count) const;

  std::uint32_t workgroup_size() const { return workgroup_size_; }

 private:
  Device* device_ = nullptr;
  std::string label_;
  SharedPipeline compiled_;
  std::uint32_t workgroup_size_ = kDefaultWorkgroupSize;
};

/// A kernel that several dispatches share: the last one ends it.
using SharedKernel = std::shared_ptr<const Kernel>;

/// Workgroups along x once a dispatch has a second dimension; the same number stands in gpu/index.wgsl.
inline constexpr std::uint32_t kGroupsPerRow = 32768;

}  // namespace weft::gpu
