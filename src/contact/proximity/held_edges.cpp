#include "contact/proximity/held_edges.hpp"

namespace weft::contact {

Result<HeldEdges> HeldEdges::create(gpu::Device& device, std::span<const mesh::Edge> yielding, double time,
                                    std::uint32_t workgroup_size) {
  HeldEdges made;
  if (yielding.empty()) return made;
  const std::vector<gpu::Constant> constants{{"kYielding", time}};
  WEFT_SET(made.edges_, gpu::Buffer<mesh::Edge>::create_from(device, yielding, "edges beside held ways"));
  WEFT_SET(made.ask_, RoundKernel::create(device, "contact/proximity/shorten_edges.wgsl", constants,
                                          shortening_rounds(), workgroup_size));
  WEFT_SET(made.shorten_, RoundKernel::create(device, "contact/proximity/shorten_ways.wgsl", {},
                                              shortening_rounds(), workgroup_size));
  return made;
}

Result<void> HeldEdges::bind(const State& state, const ContactPairs& pairs) {
  if (edges_.size() == 0) return {};
  vertex_count_ = state.position[0].size();
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto& start = state.position[parity];
    const auto &position = state.position[1 - parity], &velocity = state.velocity[1 - parity];
    WEFT_CHECK(
        ask_.bind(parity, {state.steps, start, position, edges_, pairs.vertex_contacts, state.statistics}));
    WEFT_CHECK(shorten_.bind(parity, {state.steps, start, pairs.contacts, pairs.vertex_contacts, position,
                                      velocity, state.statistics}));
  }
  return {};
}

void HeldEdges::record(gpu::ComputePass& pass) const {
  if (edges_.size() == 0) return;
  for (std::size_t round = 0; round < kShortenings; ++round) {
    ask_.dispatch(pass, round, edges_.size());
    shorten_.dispatch(pass, round, vertex_count_);
  }
}

}  // namespace weft::contact
