// A smooth object with as many triangles as are asked for, and a sheet that lies on it.
#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.hpp"

namespace weft::bench {

inline constexpr double kRoundRadius = 0.6;  // m

/// A sphere of kRoundRadius around the origin with bumps of a hundredth of it: about `triangle_count`
/// triangles, closed and facing outward.
mesh::TriangleMesh make_round_object(std::uint32_t triangle_count);

/// A square sheet of `side` by `side` nodes, `size` wide [m], that was made to lie on the object's top:
/// `distance` above its surface along the radius [m]. A node has the direction and the way from the middle
/// that it would have on a flat sheet.
mesh::TriangleMesh make_round_sheet(std::uint32_t side, double size, double distance);

}  // namespace weft::bench
