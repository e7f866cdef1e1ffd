#include "contact/proximity/edge_limits.hpp"

namespace weft::contact {

Result<EdgeLimits> EdgeLimits::create(gpu::Device& device, std::span<const LimitedEdge> edges,
                                      std::size_t round_count, std::uint32_t workgroup_size) {
  EdgeLimits made;
  if (edges.empty()) return made;
  WEFT_SET(made.edges_, gpu::Buffer<LimitedEdge>::create_from(device, edges, "limited edges"));
  WEFT_SET(made.rounds_, SeparationRounds::create(device, "contact/proximity/limit_edges.wgsl", round_count,
                                                  workgroup_size));
  WEFT_SET(made.ask_, RoundKernel::create(device, "contact/proximity/shorten_edges.wgsl", {},
                                          shortening_rounds(), workgroup_size));
  WEFT_SET(made.shorten_, RoundKernel::create(device, "contact/proximity/shorten_ways.wgsl", {},
                                              shortening_rounds(), workgroup_size));
  return made;
}

Result<void> EdgeLimits::bind(const State& state, const ContactPairs& pairs) {
  if (empty()) return {};
  vertex_count_ = state.position[0].size();
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto& start = state.position[parity];
    const auto &position = state.position[1 - parity], &velocity = state.velocity[1 - parity];
    WEFT_CHECK(rounds_.bind(
        parity, {state.steps, start, position, velocity, edges_, pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(
        ask_.bind(parity, {state.steps, start, position, edges_, pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(shorten_.bind(parity, {state.steps, start, pairs.contacts, pairs.vertex_contacts, position,
                                      velocity, state.statistics}));
  }
  return {};
}

void EdgeLimits::record_shortening(gpu::ComputePass& pass) const {
  if (empty()) return;
  for (std::size_t round = 0; round < kShortenings; ++round) {
    ask_.dispatch(pass, round, edges_.size());
    shorten_.dispatch(pass, round, vertex_count_);
  }
}

}  // namespace weft::contact
