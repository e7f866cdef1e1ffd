#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/recently_used.hpp"
#include "gpu/object.hpp"
#include "gpu/types.hpp"

namespace weft::gpu {

/// What compiling a kernel gives. It does not change, so all who compile the same share it.
struct CompiledKernel {
  std::vector<BindingLayout> bindings;
  Object group_layout, layout, pipeline;
  bool reads_step = false;
};
using SharedCompiledKernel = std::shared_ptr<const CompiledKernel>;

/// The compiled kernels of a device, found by what they were compiled from: a world that is made again compiles
/// nothing. Who uses one that gives way keeps it. A world has 70 at most; constants may hold the size of a grid, so
/// their number has no bound of its own.
using KernelCache = RecentlyUsed<std::string, SharedCompiledKernel, 256>;

}  // namespace weft::gpu
