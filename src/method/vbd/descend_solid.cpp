#include "method/vbd/descend_solid.hpp"

#include "method/holds/held_ways.hpp"
#include "method/vbd/node_colors.hpp"

namespace weft {

Result<DescendSolid> DescendSolid::create(const SolverInputs& inputs, const Body& body,
                                          const gpu::Buffer<Vec4f>& aim) {
  gpu::Device& device = inputs.device;
  const State& state = inputs.state;
  DescendSolid made;
  WEFT_SET(made.solid_, SolidBuffers::create(device, inputs.model.host, body));
  const NodeColors colors = color_nodes(inputs.model.host, body);
  const std::vector<std::uint32_t> places = tet_corners_of_nodes(inputs.model.host, body);
  std::vector<std::uint32_t> lists = colors.nodes;
  lists.insert(lists.end(), places.begin(), places.end());
  WEFT_SET(made.lists_,
           gpu::Buffer<std::uint32_t>::create_from(device, lists, "nodes by color and their tetrahedra"));
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/vbd/descend_solid.wgsl", holds_constant(inputs),
                                             inputs.workgroup_size));
  for (std::uint32_t color = 0; color < colors.count(); ++color) {
    const GatheredColor params{colors.starts[color], colors.starts[color + 1] - colors.starts[color],
                               body.first_vertex, static_cast<std::uint32_t>(colors.nodes.size())};
    WEFT_TRY(uniform, gpu::create_uniform(device, params, "nodes of color"));
    WEFT_TRY(dispatch,
             gpu::Dispatch::create_by_parity(
                 kernel, kernel->workgroups_of(params.count), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                   return {state.steps,          uniform,           made.solid_.params, made.lists_,
                           made.solid_.corners,  made.solid_.rests, state.position[p],  aim,
                           state.position[1 - p]};
                 }));
    made.params_.push_back(std::move(uniform));
    made.colors_.push_back(std::move(dispatch));
  }
  return made;
}

void DescendSolid::record(gpu::ComputePass& pass) const {
  for (const gpu::Dispatch& color : colors_) color.record(pass);
}

}  // namespace weft
