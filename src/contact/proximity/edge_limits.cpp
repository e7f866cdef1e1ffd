#include "contact/proximity/edge_limits.hpp"

namespace weft::contact {

Result<EdgeLimits> EdgeLimits::create(gpu::Device& device, std::span<const LimitedEdge> edges,
                                      std::size_t round_count, std::uint32_t workgroup_size) {
  EdgeLimits made;
  if (edges.empty()) return made;
  WEFT_SET(made.edges_, gpu::Buffer<LimitedEdge>::create_from(device, edges, "limited edges"));
  made.rounds_.resize(round_count);
  for (std::size_t round = 0; round < round_count; ++round) {
    const gpu::Constant number{"kRound", separation_number(round, round_count)};
    const gpu::Constant is_first{"kFirst", round == 0 ? 1.0 : 0.0};
    constexpr const char* kPath = "contact/proximity/limit_edges.wgsl";
    WEFT_SET(made.rounds_[round].count.kernel,
             gpu::Kernel::create(device, kPath, {number, is_first}, workgroup_size));
    WEFT_SET(made.rounds_[round].give.kernel,
             gpu::Kernel::create(device, kPath, {number, is_first, {"kGives", 1}}, workgroup_size));
  }
  return made;
}

Result<void> EdgeLimits::bind(const State& state, const ContactPairs& pairs) {
  if (empty()) return {};
  for (Round& round : rounds_)
    for (Part* part : {&round.count, &round.give})
      for (std::size_t parity = 0; parity < 2; ++parity)
        WEFT_SET(
            part->groups[parity],
            part->kernel.bind({state.steps, state.position[parity], state.position[1 - parity],
                               state.velocity[1 - parity], edges_, pairs.vertex_contacts, state.statistics}));
  return {};
}

}  // namespace weft::contact
