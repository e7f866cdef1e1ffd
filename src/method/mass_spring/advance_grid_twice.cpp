#include "method/mass_spring/advance_grid_twice.hpp"

#include "element/spring/spring_grid.hpp"
#include "method/mass_spring/advance_grid.hpp"

namespace weft {
namespace {

// As in src/method/mass_spring/advance_grid_twice.wgsl.
constexpr std::uint32_t kTileWidth = 16, kTileHeight = 8, kInvocations = 256;

}  // namespace

Result<AdvanceGridTwice> AdvanceGridTwice::create(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/advance_grid_twice.wgsl",
                                             grid_constants(body), kInvocations));
  const gpu::Dispatch::Workgroups tiles = {(body.grid->nx + kTileWidth - 1) / kTileWidth,
                                           (body.grid->ny + kTileHeight - 1) / kTileHeight};
  AdvanceGridTwice made;
  WEFT_SET(made.grid_,
           gpu::create_uniform(inputs.device, spring_grid(*body.grid, body.material(), body.first_vertex),
                               "spring grid"));
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(kernel, tiles, [&](std::size_t p) -> gpu::Dispatch::Bindings {
             return {state.steps,
                     made.grid_,
                     state.position[p],
                     state.velocity[p],
                     inputs.model.rest_position,
                     state.motions,
                     state.position[1 - p],
                     state.velocity[1 - p]};
           }));
  return made;
}

}  // namespace weft
