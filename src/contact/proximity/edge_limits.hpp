#pragma once

#include <span>

#include "contact/proximity/round_kernel.hpp"
#include "model/limited_edges.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Keeps edges within their strain limit, in the rounds that separate pairs of cloth.
/// Source: docs/contact.md, equation (6f).
/// Reads   state.steps; both positions [m], the second where ways end; velocity[1 - parity] [m/s].
/// Writes  pairs.vertex_contacts: who shares the mass of a vertex, and by what it is moved; state.statistics.
/// Errors  Shader, OutOfMemory.
class EdgeLimits {
 public:
  EdgeLimits() = default;
  static Result<EdgeLimits> create(gpu::Device& device, std::span<const LimitedEdge> edges,
                                   std::size_t round_count, std::uint32_t workgroup_size);
  /// Takes over lists, at first or with other room. Errors  OutOfMemory.
  Result<void> bind(const State& state, const ContactPairs& pairs);
  void record_counts(gpu::ComputePass& pass, std::size_t round) const {
    if (!empty()) rounds_.count.dispatch(pass, round, edges_.size());
  }
  void record_gifts(gpu::ComputePass& pass, std::size_t round) const {
    if (!empty()) rounds_.give.dispatch(pass, round, edges_.size());
  }
  bool empty() const { return edges_.size() == 0; }

 private:
  gpu::Buffer<LimitedEdge> edges_;
  SeparationRounds rounds_;
};

}  // namespace weft::contact
