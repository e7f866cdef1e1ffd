#pragma once

#include <array>
#include <span>
#include <vector>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Keeps the state of the last frame in which all was finite, and freezes the state there once a frame is
/// not; for solvers that read it, also that of the substep before. Reads   position, velocity. Writes  the
/// same once frozen; statistics.nonfinite, statistics.frozen. Errors  Shader, Limit, OutOfMemory.
class LastGood {
 public:
  static Result<LastGood> create(gpu::Device& device, const State& state, bool with_step_before);
  void record(gpu::ComputePass& pass) const;  ///< of the state in position[pass.parity()]
  /// Makes the saved copy the state of this parity.
  void record_restore(gpu::CommandList& list, const State& state, std::uint32_t parity) const;
  /// Keeps this state of the vertices from `first` on, if all of it is finite.
  void renew(gpu::Device& device, std::span<const Vec4f> position, std::span<const Vec4f> velocity,
             std::size_t first) const;

 private:
  /// A state that is kept: the last one, or that of the substep before it.
  struct Kept {
    gpu::Buffer<Vec4f> position, velocity;
    std::array<gpu::BindGroup, 2> groups;  // by the parity of the last one
  };

  gpu::Kernel guard_, keep_;
  std::array<gpu::BindGroup, 2> guard_groups_;
  std::vector<Kept> kept_;  // the last, then, if it is wanted, the one before
};

}  // namespace weft
