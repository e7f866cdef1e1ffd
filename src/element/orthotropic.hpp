// A sheet with two axes at right angles, warp and weft: what it resists with, and where its triangles lie.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

/// Per width: of stretching [N/m], of bending [N·m].
struct Moduli {
  double warp = 0, weft = 0;  // Young's, along each axis; of bending: of strips cut along each axis
  double poisson =
      0;             // weft's contraction by warp's extension, where warp is pulled; its square < warp / weft
  double shear = 0;  // of bending: moment by twist 2 K12

  static Moduli isotropic(double modulus, double poisson) {
    return {modulus, modulus, poisson, modulus / (2 * (1 + poisson))};
  }
};

/// Young's modulus of a strip cut along a direction, by its parts along warp and weft [N/m].
inline double modulus_along(const Moduli& m, double warp, double weft) {
  const double square = warp * warp + weft * weft, p = warp * warp / square, q = weft * weft / square;
  return 1 / (p * p / m.warp + q * q / m.weft + p * q * (1 / m.shear - 2 * m.poisson / m.warp));
}

/// Stress by strain, or moment by curvature: the inverse of the moduli's compliance. Source: docs/elements.md, eq. 2.
struct Stiffness {
  double warp = 0, coupled = 0, weft = 0, shear = 0;  // C11, C12, C22, C33

  static Stiffness of(const Moduli& m) {
    const double scale = 1 / (1 - m.poisson * m.poisson * m.weft / m.warp);
    return {scale * m.warp, scale * m.poisson * m.weft, scale * m.weft, m.shear};
  }
};

/// A point of the sheet at rest, along its axes [m].
struct MaterialPoint {
  double warp = 0, weft = 0;
};

/// Corners of a triangle at rest by the sheet's axes: warp lies along a direction as seen from the triangle's normal,
/// weft a quarter turn from it, and corner 0 is the origin.
inline std::array<MaterialPoint, 3> places_of(const std::array<Vec3d, 3>& corners, const Vec3d& warp) {
  const Vec3d side = corners[1] - corners[0], other = corners[2] - corners[0];
  const Vec3d area = cross(side, other), normal = area / length(area);
  Vec3d along = warp - dot(warp, normal) * normal;
  if (length(along) < 1e-6 * length(warp)) along = side;  // seen end on; any direction is as good
  along *= 1 / length(along);
  const Vec3d across = cross(normal, along);
  return {MaterialPoint{0, 0}, MaterialPoint{dot(side, along), dot(side, across)},
          MaterialPoint{dot(other, along), dot(other, across)}};
}

/// A sheet at rest.
struct RestSheet {
  std::span<const Vec3d> position;            // [m]
  std::span<const mesh::Triangle> triangles;  // that have areas
  Vec3d warp{1, 0, 0};                        // the direction of warp; triangles see it projected
  std::span<const std::uint8_t> held{};  // nodes that do not move (1), if any: what is clamped does not bend
  /// Of what is sewn: where each triangle's corners are in `position`, as it was cut. Empty: at its nodes.
  std::span<const mesh::Triangle> cut{};
  std::span<const Vec3d> warps{};  // of each triangle, where they differ

  std::array<Vec3d, 3> corners(std::size_t triangle) const {
    const auto& [a, b, c] = (cut.empty() ? triangles : cut)[triangle];
    return {position[a], position[b], position[c]};
  }
  std::array<MaterialPoint, 3> places(std::size_t triangle) const {
    return places_of(corners(triangle), warps.empty() ? warp : warps[triangle]);
  }
};

}  // namespace weft
