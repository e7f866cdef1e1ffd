#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>
#include <vector>

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
/// nothing. Past kMost the one that was asked for the longest ago goes; who uses it keeps it.
class KernelCache {
 public:
  /// A world has 70 at most; constants may hold the size of a grid, so their number has no bound of its own.
  static constexpr std::size_t kMost = 256;

  /// Null: there is none.
  SharedCompiledKernel find(const std::string& source);
  void keep(std::string source, SharedCompiledKernel kernel);
  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    std::string source;
    SharedCompiledKernel kernel;
  };
  std::list<Entry> entries_;  // the last asked for first
};

}  // namespace weft::gpu
