#include "method/vbd/descend_fabric.hpp"

#include "method/holds/held_ways.hpp"
#include "method/vbd/node_colors.hpp"

namespace weft {

Result<DescendFabric> DescendFabric::create(const SolverInputs& inputs, const Body& body,
                                            const gpu::Buffer<Vec4f>& aim) {
  DescendFabric made;
  WEFT_SET(made.fabric_, FabricBuffers::create(inputs.device, inputs.model.host, body));
  WEFT_CHECK(made.create_moments(inputs, body));
  WEFT_CHECK(made.create_colors(inputs, body, aim));
  return made;
}

Result<void> DescendFabric::create_moments(const SolverInputs& inputs, const Body& body) {
  gpu::Device& device = inputs.device;
  WEFT_SET(bent_, BentHinges::create(inputs, body, fabric_));
  WEFT_SET(moments_,
           gpu::Buffer<Vec4f>::create(device, bent_.resist ? bent_.resistance.size() : 1, "moments"));
  if (!bent_.resist) {
    WEFT_SET(no_hinges_, gpu::Buffer<FabricBuffers::Four>::create(device, 1, "no hinges"));
    return {};
  }
  WEFT_TRY(weigh,
           gpu::create_shared_kernel(device, "method/vbd/weigh_hinges.wgsl", {}, inputs.workgroup_size));
  WEFT_SET(weigh_, gpu::Dispatch::create(
                       weigh, weigh->workgroups_of(fabric_.layout.hinges),
                       {fabric_.params, fabric_.rest_angles, fabric_.couplings, bent_.bends, moments_}));
  return {};
}

Result<void> DescendFabric::create_colors(const SolverInputs& inputs, const Body& body,
                                          const gpu::Buffer<Vec4f>& aim) {
  gpu::Device& device = inputs.device;
  const State& state = inputs.state;
  const NodeColors colors = color_nodes(inputs.model.host, body);
  const std::vector<std::uint32_t> gathers = gathers_of(inputs.model.host, body, {});
  std::vector<std::uint32_t> lists = colors.nodes;
  lists.insert(lists.end(), gathers.begin(), gathers.end());
  WEFT_SET(lists_,
           gpu::Buffer<std::uint32_t>::create_from(device, lists, "nodes by color and their elements"));
  std::vector<gpu::Constant> constants = holds_constant(inputs);
  constants.push_back({"kHinges", bent_.resist ? 1.0 : 0.0});
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/vbd/descend_fabric.wgsl", constants,
                                             inputs.workgroup_size));
  for (std::uint32_t color = 0; color < colors.count(); ++color) {
    const GatheredColor params{colors.starts[color], colors.starts[color + 1] - colors.starts[color],
                               body.first_vertex, static_cast<std::uint32_t>(colors.nodes.size())};
    WEFT_TRY(uniform, gpu::create_uniform(device, params, "nodes of color"));
    WEFT_TRY(dispatch, gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(params.count),
                                                       [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                         return {state.steps,
                                                                 uniform,
                                                                 fabric_.params,
                                                                 lists_,
                                                                 fabric_.corners,
                                                                 fabric_.slopes,
                                                                 bent_.resist ? fabric_.hinges : no_hinges_,
                                                                 moments_,
                                                                 state.position[p],
                                                                 aim,
                                                                 state.position[1 - p]};
                                                       }));
    params_.push_back(std::move(uniform));
    colors_.push_back(std::move(dispatch));
  }
  return {};
}

void DescendFabric::record(gpu::ComputePass& pass, bool first) const {
  if (first) bent_.creases.record(pass);
  bent_.bend.record(pass);
  weigh_.record(pass);
  for (const gpu::Dispatch& color : colors_) color.record(pass);
}

}  // namespace weft
