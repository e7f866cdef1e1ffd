#pragma once

#include <span>

#include "contact/proximity/round_kernel.hpp"
#include "model/limited_edges.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Keeps edges within their strain limit: in the rounds that separate pairs of cloth, and after those that hold ways
/// back. Source: docs/contact.md, equations (6f) and (6i).
/// Reads   state.steps; both positions [m], the second where ways end; velocity[1 - parity] [m/s].
/// Writes  pairs.vertex_contacts: who shares the mass of a vertex, and by what it is moved; the second position and
///         velocity; state.statistics.
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
  /// Shortens ways for edges that held ones would make too long: equation (6i).
  void record_shortening(gpu::ComputePass& pass) const;
  bool empty() const { return edges_.size() == 0; }

 private:
  gpu::Buffer<LimitedEdge> edges_;
  SeparationRounds rounds_;
  RoundKernel ask_, shorten_;
  std::size_t vertex_count_ = 0;
};

}  // namespace weft::contact
