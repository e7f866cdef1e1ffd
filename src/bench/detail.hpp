// How near a sheet is to a reference, and how much of its detail it has. Positions alone prove little: a
// sheet of few nodes, drawn finely, is near too.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace weft::bench {

/// RMS |x - reference| over RMS |reference - start|, of all nodes.
double position_error(std::span<const Vec3d> x, std::span<const Vec3d> reference,
                      std::span<const Vec3d> start);

/// The area-weighted mean of the normals around each vertex, as pictures have it: unit, or zero where it
/// vanishes.
std::vector<Vec3d> vertex_normals(std::span<const Vec3d> x, std::span<const mesh::Triangle> triangles);

/// The mean over all vertices of the angle between their normals [degrees]. Where a normal vanishes it
/// counts 90.
double mean_normal_angle(std::span<const Vec3d> x, std::span<const Vec3d> reference,
                         std::span<const mesh::Triangle> triangles);

/// The nodes along an edge of a sheet, one after the other.
using Chain = std::vector<std::uint32_t>;

/// The two sides of a grid cloth (i = 0, and the last i), each from its last pinned node down to the bottom
/// corner; from the top corner where none is pinned.
std::vector<Chain> free_sides(const Model& model, const Body& body);

/// What chains have in length, over the same at rest, less 1; 0 where they have none.
double stretch_of(std::span<const Chain> chains, std::span<const Vec3d> x, std::span<const Vec3d> rest);

/// Σ ½ m |v|² [J] of masses [kg] and velocities [m/s].
double kinetic_energy(std::span<const double> mass, std::span<const Vec4f> velocity);

}  // namespace weft::bench
