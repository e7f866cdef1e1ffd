#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/dispatch.hpp"
#include "gpu/kernel.hpp"
#include "method/projection/multipliers.hpp"

namespace weft {

/// Mirror: src/method/projection/color.wgsl.
struct ElementsOfColor {
  std::uint32_t first = 0, count = 0;
  std::uint32_t padding[2] = {};
};
static_assert(sizeof(ElementsOfColor) == 16);

/// A sweep over elements: a dispatch a colour.
using Sweep = std::vector<gpu::Dispatch>;

/// The colours of a list, each a run of it and a uniform for its dispatch.
class ColorRuns {
 public:
  /// Behind those before. Without elements it is left out. Errors  OutOfMemory.
  Result<void> add(gpu::Device& device, std::uint32_t count) {
    if (count == 0) return {};
    const ElementsOfColor run{end_, count};
    WEFT_TRY(uniform, gpu::create_uniform(device, run, "elements of color"));
    uniforms_.push_back(std::move(uniform));
    counts_.push_back(count);
    end_ += count;
    return {};
  }

  /// A dispatch for each colour, which binds bindings_of(parity, its uniform).
  template <class BindingsOf>
  Result<Sweep> dispatches(const gpu::SharedKernel& kernel, const BindingsOf& bindings_of) const {
    Sweep sweep;
    for (std::size_t color = 0; color < counts_.size(); ++color) {
      WEFT_TRY(dispatch, gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(counts_[color]),
                                                         [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                           return bindings_of(p, uniforms_[color]);
                                                         }));
      sweep.push_back(std::move(dispatch));
    }
    return sweep;
  }

 private:
  std::uint32_t end_ = 0;
  std::vector<std::uint32_t> counts_;
  std::vector<gpu::Buffer<ElementsOfColor>> uniforms_;
};

/// For the kernels of a sweep, by whether elements have pulled before in the substep.
inline std::vector<gpu::Constant> sweep_constants(Multipliers multipliers, bool pulled) {
  const bool kept = multipliers == Multipliers::Kept;
  return {{"kFirst", kept && pulled ? 0.0 : 1.0}, {"kKeeps", kept ? 1.0 : 0.0}};
}
/// How many a buffer has for `count` elements: one where none is kept, which is not read.
inline std::size_t kept_multipliers(Multipliers multipliers, std::size_t count) {
  return multipliers == Multipliers::Kept ? count : 1;
}

}  // namespace weft
