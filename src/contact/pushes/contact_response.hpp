#pragma once

#include <array>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Answers contacts by the mean of their pushes from the previous position, and velocity × -0.5; clears the
/// pushes. Source: Sung et al., Algorithm 2. Reads   steps; position[parity] [m]: the previous positions.
/// Writes  position[1 - parity], velocity[1 - parity] of vertices with contacts; contacts.pushes, to zero.
/// Errors  Shader, OutOfMemory.
class ContactResponse {
 public:
  static Result<ContactResponse> create(gpu::Device& device, const State& state, const Contacts& contacts,
                                        std::uint32_t workgroup_size);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, groups_[pass.parity()], count_); }

 private:
  gpu::Kernel kernel_;
  std::array<gpu::BindGroup, 2> groups_;
  std::size_t count_ = 0;
};

}  // namespace weft
