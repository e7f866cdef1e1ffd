#include "method/mass_spring/advance_grid.hpp"

#include <algorithm>

namespace weft {
namespace {

std::uint32_t tiles_of(std::uint32_t nodes, std::uint32_t width) { return (nodes + width - 1) / width; }

}  // namespace

std::vector<gpu::Constant> grid_constants(const Body& body) {
  return {{"kDamped", body.damping > 0 ? 1.0 : 0.0},
          {"kBend", body.stiffness.bend > 0 ? 1.0 : 0.0},
          {"kBending", body.stiffness.bending > 0 ? 1.0 : 0.0}};
}

Result<gpu::Buffer<SpringGrid>> grid_uniform(gpu::Device& device, const Body& body) {
  return gpu::create_uniform(device, spring_grid(*body.grid, body.material(), body.first_vertex),
                             "spring grid");
}

Result<gpu::Dispatch> grid_dispatch(const SolverInputs& inputs, const gpu::SharedKernel& kernel,
                                    const gpu::Workgroups& workgroups, const gpu::RawBuffer& grid) {
  const State& state = inputs.state;
  return gpu::Dispatch::create_by_parity(kernel, workgroups, [&](std::size_t p) -> gpu::Dispatch::Bindings {
    return {state.steps,
            grid,
            state.position[p],
            state.velocity[p],
            inputs.model.rest_position,
            state.motions,
            state.position[1 - p],
            *inputs.predicted()[p]};
  });
}

Result<AdvanceGrid> AdvanceGrid::create(const SolverInputs& inputs, const EqualCloths& cloths) {
  const Body& body = cloths.first;
  const std::uint32_t nx = body.grid->nx, ny = body.grid->ny, size = inputs.workgroup_size;
  // Workgroups are 64 or 32 nodes wide, whichever leaves fewer invocations idle.
  const std::uint32_t narrow = std::min(32U, size), wide = std::min(64U, size);
  const std::uint32_t width = tiles_of(nx, wide) * wide > tiles_of(nx, narrow) * narrow ? narrow : wide;
  std::vector<gpu::Constant> constants = grid_constants(body);
  constants.push_back({"kTileWidth", static_cast<double>(width)});
  constants.push_back({"kTilesX", static_cast<double>(tiles_of(nx, width))});
  WEFT_TRY(kernel,
           gpu::create_shared_kernel(inputs.device, "method/mass_spring/advance_grid.wgsl", constants, size));
  const std::uint64_t tiles = std::uint64_t{tiles_of(nx, width)} * tiles_of(ny, size / width);
  gpu::Workgroups workgroups = kernel->workgroups_of(tiles * size);
  workgroups.z = cloths.count;
  AdvanceGrid made;
  WEFT_SET(made.grid_, grid_uniform(inputs.device, body));
  WEFT_SET(made.dispatch_, grid_dispatch(inputs, kernel, workgroups, made.grid_));
  return made;
}

}  // namespace weft
