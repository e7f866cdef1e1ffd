// Global properties of a surface, for cloth that starts tangled: where its rim is, whether it has an
// outside. One rule for the GPU and for the reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

/// For each vertex how far its sheet goes on beyond it [m]: the largest distance of any vertex of its
/// connected part from that part's middle, less its own. The middle is the mean of the vertices, and a tenth
/// of the way from there to one of them, so that a sheet that is crossed right through its middle has a
/// shorter side too.
std::vector<double> rim_distances(std::span<const Vec3d> positions,
                                  std::span<const mesh::Triangle> triangles);

/// Whether every edge has two triangles, which pass it in opposite directions, and the volume is positive:
/// the triangles' normals point outward.
bool faces_outward(std::span<const Vec3d> positions, std::span<const mesh::Triangle> triangles);

inline constexpr std::uint32_t kNoCorner = 0xffffffffU;
/// For each triangle the corners across its three edges, of the first other triangle there; kNoCorner at a
/// rim.
std::vector<mesh::Triangle> opposite_corners(std::span<const mesh::Triangle> triangles);

}  // namespace weft
