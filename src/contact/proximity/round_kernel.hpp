#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "gpu/kernel.hpp"

namespace weft::contact {

/// The rounds of a substep are numbered: pairs of cloth that may meet are separated in up to kMostSeparations, of which
/// the last has that number, and cloth is then held back; for edges that this leaves too long ways are shortened in
/// kShortenings. What that brings together is held back in the rest of kRounds. Mirrors: state/contact.wgsl,
/// reference/proximity/truncate.cpp.
inline constexpr std::size_t kMostSeparations = 6, kRounds = 3, kShortenings = 6;

/// Mirror of src/contact/proximity/rounds.wgsl.
struct Round {
  std::uint32_t number = 1, is_first = 0, is_last = 0, since = 0;
};
/// The `count` rounds that separate.
std::vector<Round> separation_rounds(std::size_t count);
/// The rounds that hold back: where cloth does not meet cloth there is one, and none is the last.
std::vector<Round> holding_rounds(bool self);
/// The rounds that shorten ways for the edges between them.
std::vector<Round> shortening_rounds();

/// A kernel that asks, or acts, in each of some rounds.
class RoundKernel {
 public:
  RoundKernel() = default;
  /// Errors  Shader, OutOfMemory.
  static Result<RoundKernel> create(gpu::Device& device, const std::string& path,
                                    std::vector<gpu::Constant> constants, std::span<const Round> rounds,
                                    std::uint32_t workgroup_size);
  /// What the kernel binds after its round, the same in each. Errors  Shape, OutOfMemory.
  Result<void> bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers);
  void dispatch(gpu::ComputePass& pass, std::size_t round, std::size_t elements) const {
    kernel_.dispatch(pass, groups_[pass.parity()][round], elements);
  }
  void dispatch_strided(gpu::ComputePass& pass, std::size_t round, std::size_t capacity) const {
    kernel_.dispatch_strided(pass, groups_[pass.parity()][round], capacity);
  }

 private:
  gpu::Kernel kernel_;
  std::vector<gpu::RawBuffer> rounds_;
  std::array<std::vector<gpu::BindGroup>, 2> groups_;  // by parity
};

/// What one kernel does in the rounds that separate: in each it counts who shares the mass of a vertex, and then gives
/// what moves the vertex. Source: docs/contact.md, equations (6d), (6f), (6g).
struct SeparationRounds {
  RoundKernel count, give;

  /// Errors  Shader, OutOfMemory.
  static Result<SeparationRounds> create(gpu::Device& device, const std::string& path, std::size_t rounds,
                                         std::uint32_t workgroup_size);
  /// As RoundKernel. Errors  Shape, OutOfMemory.
  Result<void> bind(std::size_t parity, std::initializer_list<gpu::Binding> buffers);
};

}  // namespace weft::contact
