// How a set of kernels, one member each, is made from a table.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "gpu/kernel.hpp"

namespace weft {

template <class Set>
struct WantedKernel {
  gpu::Kernel Set::*kernel;
  const char* name;  // src/method/multigrid/NAME.wgsl
  std::uint32_t size;
  std::vector<gpu::Constant> constants = {};
};

/// Errors  Shader.
template <class Set>
Result<Set> make_kernels(gpu::Device& device, std::span<const WantedKernel<Set>> table) {
  Set made;
  for (const WantedKernel<Set>& wanted : table) {
    const std::string path = std::string("method/multigrid/") + wanted.name + ".wgsl";
    WEFT_TRY(kernel, gpu::Kernel::create(device, path, wanted.constants, wanted.size));
    made.*wanted.kernel = std::move(kernel);
  }
  return made;
}

/// A kernel, and where its bind group goes.
struct BindWanted {
  gpu::BindGroup& group;
  const gpu::Kernel& kernel;
};

/// Binds the same things for several kernels. Errors  Shape, OutOfMemory.
inline Result<void> bind_each(std::initializer_list<BindWanted> kernels,
                              std::initializer_list<gpu::Binding> sources) {
  for (const BindWanted& wanted : kernels) {
    WEFT_TRY(group, wanted.kernel.bind(sources));
    wanted.group = std::move(group);
  }
  return {};
}

/// The size of a workgroup that does all by itself.
inline std::uint32_t lone_workgroup_size(const gpu::Device& device) {
  return std::min(gpu::kDefaultWorkgroupSize, device.limits().max_invocations_per_workgroup);
}
/// Whether contact may hold nodes at obstacles, for the kernels that read what holds them.
inline std::vector<gpu::Constant> hold_constant(bool holds) { return {{"kHolds", holds ? 1.0 : 0.0}}; }

}  // namespace weft
