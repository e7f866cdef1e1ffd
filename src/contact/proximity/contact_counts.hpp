#pragma once

#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"

namespace weft::contact {

/// Counts the pairs that act on each vertex, as the last substep has left them. Reads   pairs. Writes counts:
/// vertex_count x f32. Errors  Shader.
class ContactCounts {
 public:
  ContactCounts() = default;
  static Result<ContactCounts> create(gpu::Device& device, const ContactPairs& pairs,
                                      const gpu::Buffer<float>& counts);
  void record(gpu::ComputePass& pass) const { kernel_.dispatch(pass, group_, vertex_count_); }

 private:
  gpu::Kernel kernel_;
  gpu::BindGroup group_;
  std::uint64_t vertex_count_ = 0;
};

}  // namespace weft::contact
