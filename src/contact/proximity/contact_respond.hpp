#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Answers pairs of features by impulses with friction, then holds vertices back from what they would pass
/// through. Two dispatches. Source: docs/contact.md, equations (2) to (6). Reads   steps; position[parity]
/// [m]; pairs. Writes  position[1 - parity], velocity[1 - parity]; statistics: what was held back, whether
/// pairs are to be looked for. Errors  Shader, OutOfMemory.
class ContactRespond {
 public:
  static Result<ContactRespond> create(gpu::Device& device, const State& state, const ContactPairs& pairs,
                                       std::uint32_t interval, std::uint32_t workgroup_size);
  /// Takes over lists with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::Kernel impulse_, respond_;
  std::array<gpu::BindGroup, 2> impulse_groups_, respond_groups_;  // by parity
  std::size_t pair_room_ = 0, vertex_count_ = 0;
};

}  // namespace weft
