#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft {

/// Mirror of GridParams in src/method/mass_spring/grid_springs.wgsl.
struct GridParams {
  std::uint32_t first_vertex = 0, nx = 0, ny = 0;
  std::uint32_t uniform_weights = 0;
  Vec4f stiffness;                    // structural, shear, bend [N/m]
  Vec4f damping;                      // the same; 0 where the stiffness is 0 [N·s/m]
  Vec4f rest_length;                  // structural along i, along j, shear [m]
  std::array<float, 2> bending = {};  // along i, along j [N/m]
  std::uint32_t tile_width = 0, tiles_x = 0;
};
static_assert(sizeof(GridParams) == 80 && offsetof(GridParams, tile_width) == 72);

/// For workgroups of `workgroup_size` nodes: of 64 or 32 along i, what leaves fewer of them without a node.
GridParams grid_params(const ClothModel& cloth, std::uint32_t workgroup_size);

/// The overrides of a kernel for this cloth: what it does not have is not computed.
std::vector<gpu::Constant> grid_constants(const ClothModel& cloth);

}  // namespace weft
