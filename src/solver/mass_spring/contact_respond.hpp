#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Answers pairs of features by impulses with friction, then holds vertices back from what they would pass
/// through. Source: docs/contact.md, equations (2) to (6). Reads   steps; position[parity] [m]; pairs. Writes
/// position[1 - parity], velocity[1 - parity]; statistics: what was held back, whether pairs are to be looked
/// for. Errors  Shader, OutOfMemory.
class ContactRespond {
 public:
  static Result<ContactRespond> create(gpu::Device& device, const State& state, const ContactPairs& pairs,
                                       std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, groups_[pass.parity()], count_); }

 private:
  gpu::Kernel kernel_;
  std::array<gpu::BindGroup, 2> groups_;
  std::size_t count_ = 0;
};

}  // namespace weft
