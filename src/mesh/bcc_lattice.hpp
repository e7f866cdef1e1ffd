// The body-centred cubic lattice: corners and centres of cubes, and the tetrahedra between them.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "base/vec.hpp"

namespace weft::mesh {

/// Points have numbers: first the corners of nx * ny * nz cubes, then their centres, each with x fastest. In halves of
/// a cube's edge, corners have three even coordinates and centres three odd ones. Edges are long (between neighbours of
/// one sort, a cube's edge) or short (from a centre to the corners of its cube, sqrt(3)/2 of that).
class BccLattice {
 public:
  using Half = std::array<std::int32_t, 3>;                 // coordinates in halves of a cube's edge
  static constexpr double kShort = 0.86602540378443864676;  // length of a short edge over that of a long one

  BccLattice(const std::array<std::uint32_t, 3>& cubes, const Vec3d& origin, double cell)
      : cubes_(cubes), origin_(origin), cell_(cell) {}

  double cell() const { return cell_; }  // m
  const std::array<std::uint32_t, 3>& cubes() const { return cubes_; }
  std::uint32_t corner_count() const { return (cubes_[0] + 1) * (cubes_[1] + 1) * (cubes_[2] + 1); }
  std::uint32_t point_count() const { return corner_count() + cubes_[0] * cubes_[1] * cubes_[2]; }
  bool is_corner(std::uint32_t point) const { return point < corner_count(); }
  bool is_long(std::uint32_t a, std::uint32_t b) const { return is_corner(a) == is_corner(b); }

  std::uint32_t number(const Half& at) const {
    const bool centre = at[0] % 2 != 0;
    const std::uint32_t more = centre ? 0 : 1;
    const auto index = [&](std::size_t axis) { return static_cast<std::uint32_t>(at[axis]) / 2; };
    return (centre ? corner_count() : 0) + (index(2) * (cubes_[1] + more) + index(1)) * (cubes_[0] + more) +
           index(0);
  }

  Half half(std::uint32_t point) const {
    const std::uint32_t more = is_corner(point) ? 1 : 0;
    if (more == 0) point -= corner_count();
    const std::uint32_t nx = cubes_[0] + more, ny = cubes_[1] + more;
    const auto at = [&](std::uint32_t i) { return static_cast<std::int32_t>(2 * i + 1 - more); };
    return {at(point % nx), at(point / nx % ny), at(point / nx / ny)};
  }

  Vec3d place(const Half& at) const {
    Vec3d place = origin_;
    for (int axis = 0; axis < 3; ++axis)
      place[axis] += cell_ * (static_cast<double>(at[static_cast<std::size_t>(axis)]) / 2);
    return place;
  }

  /// visit(neighbour) with the points at the end of a point's edges, in rising order of their numbers.
  template <class Visit>
  void for_each_neighbour(std::uint32_t point, const Visit& visit) const {
    const Half at = half(point);
    const auto visit_if_there = [&](const Half& other) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (other[axis] < 0 || other[axis] > static_cast<std::int32_t>(2 * cubes_[axis])) return;
      visit(number(other));
    };
    const auto visit_other_sort = [&] {
      for (const int z : {-1, 1})
        for (const int y : {-1, 1})
          for (const int x : {-1, 1}) visit_if_there({at[0] + x, at[1] + y, at[2] + z});
    };
    if (!is_corner(point)) visit_other_sort();
    for (const auto& [axis, step] : {std::pair(2, -2), {1, -2}, {0, -2}, {0, 2}, {1, 2}, {2, 2}}) {
      Half other = at;
      other[static_cast<std::size_t>(axis)] += step;
      visit_if_there(other);
    }
    if (is_corner(point)) visit_other_sort();
  }

  /// visit(points) with the four points of each tetrahedron, the right way round: two neighbouring centres, and two
  /// neighbouring corners of the square between their cubes.
  template <class Visit>
  void for_each_tet(const Visit& visit) const {
    static constexpr int kRound[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (std::uint32_t centre = corner_count(); centre < point_count(); ++centre) {
      const Half at = half(centre);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Half next = at;
        next[axis] += 2;
        if (next[axis] > static_cast<std::int32_t>(2 * cubes_[axis])) continue;
        std::array<std::uint32_t, 4> square;
        for (std::size_t k = 0; k < 4; ++k) {
          Half corner = at;
          corner[axis] += 1;
          corner[(axis + 1) % 3] += kRound[k][0];
          corner[(axis + 2) % 3] += kRound[k][1];
          square[k] = number(corner);
        }
        for (std::size_t k = 0; k < 4; ++k)
          visit(std::array<std::uint32_t, 4>{centre, number(next), square[k], square[(k + 1) % 4]});
      }
    }
  }

 private:
  std::array<std::uint32_t, 3> cubes_;
  Vec3d origin_;  // m, of the lowest corner
  double cell_;   // m
};

}  // namespace weft::mesh
