#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/grid.hpp"

namespace weft::bench {

/// Where the nodes of a fine grid come to lie if they follow a coarse grid of the same sheet: at rest [m]
/// plus its displacement, bicubic (Catmull-Rom) between its nodes. Beyond the boundary the displacement goes
/// on straight, so that affine maps are kept. Reads  positions row by row, as grids number their nodes.
std::vector<Vec3d> upsample(const mesh::Grid& coarse, std::span<const Vec3d> coarse_rest,
                            std::span<const Vec3d> coarse_position, const mesh::Grid& fine,
                            std::span<const Vec3d> fine_rest);

}  // namespace weft::bench
