#include "method/mass_spring/advance_grid_twice.hpp"

#include "method/mass_spring/advance_grid.hpp"

namespace weft {
namespace {

// As in src/method/mass_spring/advance_grid_twice.wgsl.
constexpr std::uint32_t kTileWidth = 16, kTileHeight = 8, kInvocations = 256;

}  // namespace

Result<AdvanceGridTwice> AdvanceGridTwice::create(const SolverInputs& inputs, const EqualCloths& cloths) {
  const Body& body = cloths.first;
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/advance_grid_twice.wgsl",
                                             grid_constants(body), kInvocations));
  const gpu::Workgroups tiles = {(body.grid->nx + kTileWidth - 1) / kTileWidth,
                                 (body.grid->ny + kTileHeight - 1) / kTileHeight, cloths.count};
  AdvanceGridTwice made;
  WEFT_SET(made.grid_, grid_uniform(inputs.device, body));
  WEFT_SET(made.dispatch_, grid_dispatch(inputs, kernel, tiles, made.grid_));
  return made;
}

}  // namespace weft
