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
  /// `presses`: ContactPairs::presses, whose forces of holds are part of the state; null: there are none.
  /// `rigid`: the words of rigid bodies; null: there are none.
  static Result<LastGood> create(gpu::Device& device, const State& state, bool with_step_before,
                                 const gpu::Buffer<std::int32_t>* presses,
                                 const gpu::Buffer<std::uint32_t>* rigid = nullptr);
  void record(gpu::ComputePass& pass) const;  ///< of the state in position[pass.parity()]
  /// Makes the saved copy the state of this parity.
  void record_restore(gpu::CommandList& list, const State& state, std::uint32_t parity) const;
  /// Keeps this state of the vertices from `first` on, if all of it is finite.
  void renew(gpu::Device& device, std::span<const Vec4f> position, std::span<const Vec4f> velocity,
             std::size_t first) const;
  /// Keeps this state of all vertices as that of the substep before it, for a solver that reads that; finite.
  void renew_before(gpu::Device& device, std::span<const Vec4f> position,
                    std::span<const Vec4f> velocity) const;
  /// Keeps these creases of facets; finite.
  void renew_creases(gpu::Device& device, std::span<const Vec4f> creases) const;
  /// Copies the words of rigid bodies as they are now, which are finite.
  void record_rigid(gpu::CommandList& list) const;
  /// The same of the forces of holds.
  void renew_holds(gpu::Device& device, std::span<const std::int32_t> forces) const;

 private:
  /// A state that is kept: the last one, or that of the substep before it.
  struct Kept {
    gpu::Buffer<Vec4f> position, velocity;
    std::array<gpu::BindGroup, 2> groups;  // by the parity of the last one
  };

  gpu::Kernel guard_, keep_;
  std::array<gpu::BindGroup, 2> guard_groups_;
  std::vector<Kept> kept_;  // the last, then, if it is wanted, the one before
  const gpu::Buffer<std::int32_t>* presses_ = nullptr;
  gpu::Buffer<std::int32_t> holds_;
  gpu::Kernel keep_holds_;
  gpu::BindGroup keep_holds_group_;
  const gpu::Buffer<std::uint32_t>* rigid_ = nullptr;
  gpu::Buffer<std::uint32_t> good_rigid_;
  gpu::BindGroup keep_rigid_group_;
  gpu::Buffer<Vec4f> creases_;  // empty where no cloth keeps bends
  gpu::BindGroup keep_creases_group_;
};

}  // namespace weft
