#include "gpu/kernel_cache.hpp"

#include <algorithm>
#include <utility>

namespace weft::gpu {

SharedCompiledKernel KernelCache::find(const std::string& source) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.source == source; });
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->kernel;
}

void KernelCache::keep(std::string source, SharedCompiledKernel kernel) {
  entries_.push_front({std::move(source), std::move(kernel)});
  if (entries_.size() > kMost) entries_.pop_back();
}

}  // namespace weft::gpu
