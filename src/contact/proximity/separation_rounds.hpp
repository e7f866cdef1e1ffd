#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "gpu/kernel.hpp"

namespace weft::contact {

/// The rounds of a substep are numbered: pairs of cloth that may meet are separated in up to kMostSeparations, of which
/// the last has that number, and cloth is then held back in kRounds. Mirrors: state/contact.wgsl,
/// reference/proximity/truncate.cpp.
inline constexpr std::size_t kMostSeparations = 6, kRounds = 3;
/// The number of a round of `count` that separate.
constexpr double separation_number(std::size_t round, std::size_t count) {
  return static_cast<double>(kMostSeparations + 1 + round - count);
}

/// What one kernel does in the rounds that separate: in each it counts who shares the mass of a vertex, and then gives
/// what moves the vertex. Source: docs/contact.md, equations (6d), (6f), (6g).
/// Errors  Shader, OutOfMemory.
class SeparationRounds {
 public:
  struct Part {
    gpu::Kernel kernel;
    std::array<gpu::BindGroup, 2> groups;  // by parity
    void dispatch(gpu::ComputePass& pass, std::size_t elements) const {
      kernel.dispatch(pass, groups[pass.parity()], elements);
    }
    void dispatch_strided(gpu::ComputePass& pass, std::size_t capacity) const {
      kernel.dispatch_strided(pass, groups[pass.parity()], capacity);
    }
  };
  SeparationRounds() = default;
  static Result<SeparationRounds> create(gpu::Device& device, const std::string& path, std::size_t count,
                                         std::uint32_t workgroup_size);
  /// The same buffers for each round. Errors  Shape, OutOfMemory.
  Result<void> bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers);

  const Part& count(std::size_t round) const { return rounds_[round].count; }
  const Part& give(std::size_t round) const { return rounds_[round].give; }

 private:
  struct Round {
    Part count, give;
  };
  std::vector<Round> rounds_;
};

}  // namespace weft::contact
