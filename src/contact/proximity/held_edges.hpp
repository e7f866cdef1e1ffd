#pragma once

#include <cstdint>
#include <span>

#include "contact/proximity/round_kernel.hpp"
#include "mesh/adjacency.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Shortens ways beside those that were held back, so that the edges between them are not stretched by what nothing has
/// paid for. Source: docs/contact.md, equation (6i).
/// Reads   state.steps; both positions [m], the second where ways end; pairs.contacts.
/// Writes  the second position and velocity; pairs.vertex_contacts; state.statistics: vertices truncated.
/// Errors  Shader, OutOfMemory.
class HeldEdges {
 public:
  HeldEdges() = default;
  /// `yielding`: YieldingEdges::edges, `time`: their time [s].
  static Result<HeldEdges> create(gpu::Device& device, std::span<const mesh::Edge> yielding, double time,
                                  std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  void record(gpu::ComputePass& pass) const;

 private:
  gpu::Buffer<mesh::Edge> edges_;
  RoundKernel ask_, shorten_;
  std::size_t vertex_count_ = 0;
};

}  // namespace weft::contact
