// Bending of a sheet by the angles at its edges, such that a bending modulus is what a strip of the cloth has, on
// every triangulation and in every direction. In double. Source: docs/elements.md, Calibration.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/mat3.hpp"
#include "element/hinge/law.hpp"
#include "element/orthotropic.hpp"

namespace weft::hinge {

inline constexpr std::uint32_t kNone = ~0U;

/// An edge between two triangles. Its angle falls to them in parts, so that the normal at the edge's middle, from which
/// both parts are measured, is that of any sheet with even curvature: half to each, and `shift` more to the first and
/// less to the second, a sum over this hinge and the other hinges of its triangles.
struct Hinge {
  std::array<std::uint32_t, 4> nodes{};      // law.hpp has the drawing
  std::array<std::uint32_t, 2> triangles{};  // a b c, b a d
  double rest_angle = 0;
  std::array<std::uint32_t, 4> others{};  // at b c, c a, a d, d b; kNone at the rim
  std::array<double, 5> shift{};          // weights of its own angle and of the others'
};

inline Corners corners_of(const Hinge& hinge, std::span<const Vec3d> x) {
  return {x[hinge.nodes[0]], x[hinge.nodes[1]], x[hinge.nodes[2]], x[hinge.nodes[3]]};
}

/// A triangle's edges (the first opposite corner 0), and its moments by the parts of their angles that fall to it.
struct Facet {
  std::array<std::uint32_t, 3> hinges{};  // kNone at the rim, where no moment acts
  std::array<double, 3> sign{};           // 1: the triangle is the hinge's first, -1: its second
  Mat3 stiffness;                         // [N·m]
  Mat3 curving;                           // the square of its curvature's size, by the same parts [1/m²]
  bool rigid = false;                     // it does not bend, and takes no part of an angle
  bool sliver = false;                    // it bends freely
};

struct Plate {
  std::vector<Hinge> hinges;
  std::vector<Facet> facets;
};

/// Where the nodes of a hinge are at rest. None: at a seam, whose sides were cut apart; there it is flat.
std::optional<Corners> rest_corners(const RestSheet& sheet, const Hinge& hinge);

/// Hinges at all edges between two triangles that turn the same way round, with their angles at rest; other edges are
/// free, like the rim. A triangle with three held nodes does not bend: what is clamped to it begins to bend at its
/// edge. One that is far thinner than a neighbour takes its part of their angle, but bends freely: its moments would be
/// those of a zigzag.
Plate build_plate(const RestSheet& sheet, const Stiffness& bending);

/// Of every hinge, less its angle at rest [rad].
std::vector<double> bends(const Plate& plate, std::span<const Vec3d> position);
/// How fast each hinge bends where nodes move so fast [rad/s].
std::vector<double> bend_rates(const Plate& plate, std::span<const Vec3d> position,
                               std::span<const Vec3d> velocity);
struct Crease;
/// [J]. `creases`: what each facet keeps of its bend (creases.hpp); none: nothing.
double energy(const Plate& plate, std::span<const double> bends, std::span<const Crease> creases = {});
/// The energy's slope by every bend [N·m]: a symmetric, positive semidefinite matrix times them, less what creases
/// take off.
std::vector<double> moments(const Plate& plate, std::span<const double> bends,
                            std::span<const Crease> creases = {});
/// Adds what moments at the hinges do to the nodes [N].
void add_forces(const Plate& plate, std::span<const double> moments, std::span<const Vec3d> position,
                std::span<Vec3d> force);

/// A matrix as a sum of entries.
struct Coupling {
  std::uint32_t row = 0, column = 0;
  double entry = 0;
};
/// The matrix of `moments`, by hinges, row by row with columns ascending [N·m]. The Gauss-Newton Hessian of the energy
/// is its product with the angles' slopes from both sides.
std::vector<Coupling> couplings(const Plate& plate);
/// Of each hinge, what it resists with in a diagonal matrix that is nowhere below that of `couplings` [N·m]: by
/// Gershgorin, the sum of its row's absolute values.
std::vector<double> stiffness_bounds(const Plate& plate);

/// Of a sheet that is plane at rest, at these places: the matrix by nodes [N/m] of the quadratic energy
/// ½ Σ S_ab x_a · x_b, which is that of small bends, and stays within their squares where the sheet is not stretched.
std::vector<Coupling> isometric_matrix(const Plate& plate, std::span<const Vec3d> rest);

}  // namespace weft::hinge
