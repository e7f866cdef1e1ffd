#include "mesh/fill_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/check_tets.hpp"
#include "mesh/closed_surface.hpp"
#include "mesh/stuffing.hpp"

namespace weft::mesh {
namespace {

constexpr double kWholeCells =
    1e-4;  // a size that is a multiple of the cell up to this part of it has no cell more
constexpr double kCutError =
    1e-7;  // of an edge: what single precision makes of a place beside its body's size
constexpr int kMaxCutSteps = 8;

Result<BccLattice> lattice_around(const Bounds& bounds, double cell) {
  if (!(cell > 0 && std::isfinite(cell)))
    return input_error("The cell is %g m, which is not a positive number.", cell);
  const Vec3d low = bounds.low.to<double>(), high = bounds.high.to<double>();
  std::array<std::uint32_t, 3> cubes{};
  std::array<double, 3> counts{};
  Vec3d origin;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    // A layer on each side, outside: the lattice's outermost tetrahedra are not cut.
    counts[at] = std::max(1.0, std::ceil((high[axis] - low[axis]) / cell - kWholeCells)) + 2;
    origin[axis] = (low[axis] + high[axis]) / 2 - counts[at] * cell / 2;
  }
  const double points =
      (counts[0] + 1) * (counts[1] + 1) * (counts[2] + 1) + counts[0] * counts[1] * counts[2];
  if (points > double{kMaxFillPoints})
    return input_error("A cell of %g m makes a lattice of %.0f points, more than the limit of %u.", cell,
                       points, kMaxFillPoints);
  for (std::size_t axis = 0; axis < 3; ++axis) cubes[axis] = static_cast<std::uint32_t>(counts[axis]);
  return BccLattice(cubes, origin, cell);
}

// Of each point, by the majority of three rays (closed_surface.hpp). A ray serves all points of its line.
std::vector<std::uint8_t> points_inside(const BccLattice& lattice, const ClosedSurface& surface) {
  std::vector<std::uint8_t> votes(lattice.point_count(), 0);
  std::vector<double> crossings;
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = static_cast<std::size_t>(axis), u = (along + 1) % 3, v = (along + 2) % 3;
    for (const std::int32_t first : {0, 1}) {  // corners, centres
      const auto last = [&](std::size_t side) {
        return static_cast<std::int32_t>(2 * lattice.cubes()[side]);
      };
      BccLattice::Half at{};
      for (at[v] = first; at[v] <= last(v); at[v] += 2)
        for (at[u] = first; at[u] <= last(u); at[u] += 2) {
          at[along] = first;
          surface.crossings(axis, lattice.place(at), crossings);
          std::size_t passed = 0;
          for (; at[along] <= last(along) && !crossings.empty(); at[along] += 2) {
            const double place = lattice.place(at)[axis];
            while (passed < crossings.size() && crossings[passed] <= place) ++passed;
            votes[lattice.number(at)] += passed % 2 != 0 ? 1 : 0;
          }
        }
    }
  }
  for (std::uint8_t& vote : votes) vote = vote >= 2 ? 1 : 0;
  return votes;
}

// Where the depth is zero between a and b, in parts of the way, by the Illinois form of regula falsi. Between the two
// the sign changes, so it stays within the edge wherever rounding leads.
double cut_between(const ClosedSurface& surface, const Vec3d& a, const Vec3d& b, double depth_a,
                   double depth_b) {
  double low = 0, high = 1, at_low = depth_a, at_high = depth_b, t = 0;
  const double error = kCutError * length(b - a);
  int side = 0;
  for (int step = 0; step < kMaxCutSteps; ++step) {
    const double fall = at_low - at_high;
    t = fall != 0 ? low + (high - low) * (at_low / fall) : low;
    if (low == 0 && high == 1 && (at_low == 0 || at_high == 0)) return t;
    const double depth = surface.depth(a + t * (b - a));
    if (std::abs(depth) <= error) return t;
    if ((depth > 0) == (depth_a > 0)) {
      low = t, at_low = depth;
      if (side == -1) at_high /= 2;
      side = -1;
    } else {
      high = t, at_high = depth;
      if (side == 1) at_low /= 2;
      side = 1;
    }
  }
  return t;
}

std::vector<LatticeCut> cuts_of(const BccLattice& lattice, const ClosedSurface& surface,
                                const std::vector<std::uint8_t>& inside) {
  constexpr double kUnknown = -1;
  std::vector<double> distances(lattice.point_count(), kUnknown);  // known only where an edge is cut
  const auto depth = [&](std::uint32_t point) {
    double& distance = distances[point];
    if (distance == kUnknown) distance = surface.distance(lattice.place(lattice.half(point)));
    return inside[point] != 0 ? distance : -distance;
  };
  std::vector<LatticeCut> cuts;
  for (std::uint32_t a = 0; a < inside.size(); ++a)
    lattice.for_each_neighbour(a, [&](std::uint32_t b) {
      if (b < a || inside[a] == inside[b]) return;
      const Vec3d place_a = lattice.place(lattice.half(a)), place_b = lattice.place(lattice.half(b));
      cuts.push_back({a, b, cut_between(surface, place_a, place_b, depth(a), depth(b))});
    });
  return cuts;
}

Result<TetMesh> rounded_mesh(StuffedLattice made, double cell) {
  TetMesh mesh;
  mesh.tets = std::move(made.tets);
  mesh.positions.reserve(made.positions.size());
  for (const Vec3d& place : made.positions) mesh.positions.push_back(place.to<float>());
  for (const Tet& tet : mesh.tets) {
    std::array<Vec3d, 4> exact, rounded;
    for (std::size_t k = 0; k < 4; ++k) {
      exact[k] = made.positions[tet[k]];
      rounded[k] = mesh.positions[tet[k]].to<double>();
    }
    const double due = six_volumes(exact), volumes = six_volumes(rounded);
    if (std::abs(volumes - due) <= due / 10) continue;
    return input_error(
        "A cell of %g m is too small at coordinates such as %g m: rounding to single precision makes %g m^3 "
        "of a "
        "tetrahedron of %g m^3.",
        cell, rounded[0].x, volumes / 6, due / 6);
  }
  return mesh;
}

}  // namespace

Result<TetMesh> fill_surface(const TriangleMesh& surface, double cell) {
  WEFT_TRY(closed, ClosedSurface::create(surface));
  WEFT_TRY(lattice, lattice_around(closed.bounds(), cell));
  const std::vector<std::uint8_t> inside = points_inside(lattice, closed);
  StuffedLattice made = stuff_lattice(lattice, inside, cuts_of(lattice, closed, inside));
  if (made.tets.empty())
    return input_error("A cell of %g m is too large: no point of its lattice is inside the surface.", cell);
  return rounded_mesh(std::move(made), cell);
}

}  // namespace weft::mesh
