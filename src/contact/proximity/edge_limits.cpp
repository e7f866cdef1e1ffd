#include "contact/proximity/edge_limits.hpp"

namespace weft::contact {

Result<EdgeLimits> EdgeLimits::create(gpu::Device& device, std::span<const LimitedEdge> edges,
                                      std::size_t round_count, std::uint32_t workgroup_size) {
  EdgeLimits made;
  if (edges.empty()) return made;
  WEFT_SET(made.edges_, gpu::Buffer<LimitedEdge>::create_from(device, edges, "limited edges"));
  WEFT_SET(made.rounds_, SeparationRounds::create(device, "contact/proximity/limit_edges.wgsl", round_count,
                                                  workgroup_size));
  return made;
}

Result<void> EdgeLimits::bind(const State& state, const ContactPairs& pairs) {
  if (empty()) return {};
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto& start = state.position[parity];
    const auto &position = state.position[1 - parity], &velocity = state.velocity[1 - parity];
    WEFT_CHECK(rounds_.bind(
        parity, {state.steps, start, position, velocity, edges_, pairs.vertex_contacts, state.statistics}));
  }
  return {};
}

}  // namespace weft::contact
