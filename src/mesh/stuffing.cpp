#include "mesh/stuffing.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace weft::mesh {
namespace {

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

// A cut violates an end that is nearer than this part of the edge. The two numbers are found here: with them the worst
// that any stencil makes of any cuts and moved points, tried at the ends and the middle of their ranges, is 10.7843°
// and 164.7369°, within what the paper proves for its own two. With 0.25 and 0.41 it is 9.3° and 161.4°.
constexpr double kAlphaLong = 0.285109, kAlphaShort = 0.39882;

class Stuffing {
 public:
  Stuffing(const BccLattice& lattice, const std::vector<std::uint8_t>& inside,
           const std::vector<LatticeCut>& cuts);
  StuffedLattice run();

 private:
  /// The sign of the paper's function: that of a point on the surface is 0.
  enum class Sign : std::int8_t { Outside = -1, On = 0, Inside = 1 };

  std::uint32_t find_cut(std::uint32_t point, std::uint32_t other) const;
  void warp(std::uint32_t point);
  std::uint32_t corner(std::uint32_t point);
  std::uint32_t corner(std::uint32_t inside, std::uint32_t outside);
  std::uint32_t add(std::uint32_t& number, const Vec3d& place);
  bool from_first(std::uint32_t first, std::uint32_t second, std::uint32_t outside) const;
  void add_tet(const std::array<std::uint32_t, 4>& points);
  void add_one_outside(std::array<std::uint32_t, 3> others, std::uint32_t outside);
  void add_two_outside(const std::array<std::uint32_t, 4>& points);
  void add_prism(const Triangle& a, const Triangle& b, const Triangle& order);
  Vec3d cut_place(const LatticeCut& cut) const;

  const BccLattice& lattice_;
  const std::vector<LatticeCut>& cuts_;
  std::vector<std::uint32_t> first_cut_;  // of each point, those that it is `a` of
  std::vector<Sign> signs_;
  std::vector<std::uint32_t> moved_to_;  // the cut to which a point moved, kNoNumber for others
  std::vector<std::uint32_t> point_numbers_, cut_numbers_;  // in the mesh
  StuffedLattice made_;
};

Stuffing::Stuffing(const BccLattice& lattice, const std::vector<std::uint8_t>& inside,
                   const std::vector<LatticeCut>& cuts)
    : lattice_(lattice),
      cuts_(cuts),
      first_cut_(inside.size() + 1, 0),
      signs_(inside.size()),
      moved_to_(inside.size(), kNoNumber),
      point_numbers_(inside.size(), kNoNumber),
      cut_numbers_(cuts.size(), kNoNumber) {
  assert(inside.size() == lattice.point_count());
  for (std::size_t i = 0; i < inside.size(); ++i) signs_[i] = inside[i] != 0 ? Sign::Inside : Sign::Outside;
  for (const LatticeCut& cut : cuts) ++first_cut_[cut.a + 1];
  for (std::size_t i = 0; i + 1 < first_cut_.size(); ++i) first_cut_[i + 1] += first_cut_[i];
}

std::uint32_t Stuffing::find_cut(std::uint32_t point, std::uint32_t other) const {
  const std::uint32_t a = std::min(point, other), b = std::max(point, other);
  for (std::uint32_t c = first_cut_[a]; c < first_cut_[a + 1]; ++c)
    if (cuts_[c].b == b) return c;
  return kNoNumber;
}

Vec3d Stuffing::cut_place(const LatticeCut& cut) const {
  const Vec3d a = lattice_.place(lattice_.half(cut.a)), b = lattice_.place(lattice_.half(cut.b));
  return a + cut.t * (b - a);
}

// One after the other: where a point has moved, the cuts of its edges are gone, and violate no other point.
void Stuffing::warp(std::uint32_t point) {
  double nearest = std::numeric_limits<double>::infinity();
  lattice_.for_each_neighbour(point, [&](std::uint32_t other) {
    if (signs_[other] == Sign::On) return;
    const std::uint32_t found = find_cut(point, other);
    if (found == kNoNumber) return;
    const double part = cuts_[found].a == point ? cuts_[found].t : 1 - cuts_[found].t;
    const bool is_long = lattice_.is_long(point, other);
    if (!(part < (is_long ? kAlphaLong : kAlphaShort))) return;
    const double away = is_long ? part : part * BccLattice::kShort;
    if (!(away < nearest)) return;
    nearest = away;
    moved_to_[point] = found;
  });
  if (moved_to_[point] != kNoNumber) signs_[point] = Sign::On;
}

std::uint32_t Stuffing::add(std::uint32_t& number, const Vec3d& place) {
  if (number == kNoNumber) {
    number = static_cast<std::uint32_t>(made_.positions.size());
    made_.positions.push_back(place);
  }
  return number;
}

std::uint32_t Stuffing::corner(std::uint32_t point) {
  if (point_numbers_[point] != kNoNumber) return point_numbers_[point];
  const std::uint32_t moved = moved_to_[point];
  return add(point_numbers_[point],
             moved != kNoNumber ? cut_place(cuts_[moved]) : lattice_.place(lattice_.half(point)));
}

std::uint32_t Stuffing::corner(std::uint32_t inside, std::uint32_t outside) {
  const std::uint32_t found = find_cut(inside, outside);
  assert(found != kNoNumber);
  return add(cut_numbers_[found], cut_place(cuts_[found]));
}

// A face with two points inside leaves a square. Whether its diagonal goes from the first point to the cut below the
// second, or the other way round, depends on the face alone, so that neighbours agree. The cut of a long edge gets it.
// Where both cut edges are short, the parity rule: the points inside are two apart along one axis and beside the other
// point along all three, so that just one of them lies above it along an even number of axes.
bool Stuffing::from_first(std::uint32_t first, std::uint32_t second, std::uint32_t outside) const {
  if (lattice_.is_long(second, outside)) return true;
  if (lattice_.is_long(first, outside)) return false;
  const BccLattice::Half a = lattice_.half(first), b = lattice_.half(outside);
  int above = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) above += a[axis] > b[axis] ? 1 : 0;
  return above % 2 == 0;
}

// The prism between the triangles a and b, with a0 a1 a2 b0 the right way round, as a staircase over its three columns
// in some order: the diagonal of the side between two columns goes from a of the earlier to b of the later. Tetrahedra
// that name a corner twice, as where a column has no height, are none.
void Stuffing::add_prism(const Triangle& a, const Triangle& b, const Triangle& order) {
  const auto [i, j, k] = order;
  const bool odd = (i > j) != ((i > k) != (j > k));
  for (Tet tet : {Tet{a[i], a[j], a[k], b[k]}, Tet{a[i], a[j], b[k], b[j]}, Tet{a[i], b[i], b[j], b[k]}}) {
    bool has_twice = false;
    for (std::size_t c = 1; c < 4; ++c)
      for (std::size_t other = 0; other < c; ++other) has_twice = has_twice || tet[other] == tet[c];
    if (has_twice) continue;
    if (odd) std::swap(tet[2], tet[3]);
    made_.tets.push_back(tet);
  }
}

void Stuffing::add_one_outside(std::array<std::uint32_t, 3> others, std::uint32_t outside) {
  Triangle a{}, b{};
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = corner(others[k]);
    b[k] = signs_[others[k]] == Sign::On ? a[k] : corner(others[k], outside);
  }
  const auto before = [&](std::uint32_t i, std::uint32_t j) {
    const bool flat_i = a[i] == b[i], flat_j = a[j] == b[j];
    if (flat_i || flat_j) return flat_i && (!flat_j || i < j);
    return from_first(others[i], others[j], outside);
  };
  Triangle order{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    std::uint32_t place = 0;
    for (std::uint32_t j = 0; j < 3; ++j) place += j != i && before(j, i) ? 1 : 0;
    order[place] = i;
  }
  add_prism(a, b, order);
}

// Points: two that are not outside, the first inside; then two outside.
void Stuffing::add_two_outside(const std::array<std::uint32_t, 4>& points) {
  const auto [p, q, m, n] = points;
  const Triangle a{corner(p), corner(p, m), corner(p, n)};
  if (signs_[q] == Sign::On) {
    const std::uint32_t end = corner(q);
    made_.tets.push_back({a[0], a[1], a[2], end});
    return;
  }
  // Of the two sides through p and q, one has its diagonal at p and the other at q: where p to q is long, since m and n
  // differ in parity; elsewhere, since p's long edge ends in one of them and q's in the other.
  const bool at_p = from_first(p, q, m);
  assert(at_p != from_first(p, q, n));
  add_prism(a, {corner(q), corner(q, m), corner(q, n)}, at_p ? Triangle{2, 0, 1} : Triangle{1, 0, 2});
}

void Stuffing::add_tet(const std::array<std::uint32_t, 4>& points) {
  std::array<std::uint32_t, 4> sorted{};  // those inside, on, outside the surface
  std::size_t count = 0, inside = 0, outside = 0;
  bool odd = false;
  for (const Sign sign : {Sign::Inside, Sign::On, Sign::Outside})
    for (std::size_t k = 0; k < 4; ++k) {
      if (signs_[points[k]] != sign) continue;
      for (std::size_t before = 0; before < k; ++before) odd = odd != (signs_[points[before]] < sign);
      sorted[count++] = points[k];
      inside += sign == Sign::Inside ? 1 : 0;
      outside += sign == Sign::Outside ? 1 : 0;
    }
  if (inside == 0) return;
  if (odd && outside >= 2) std::swap(sorted[2], sorted[3]);
  if (odd && outside < 2) std::swap(sorted[0], sorted[1]);
  const auto [p, q, m, n] = sorted;
  if (outside == 0) made_.tets.push_back({corner(p), corner(q), corner(m), corner(n)});
  if (outside == 1) add_one_outside({p, q, m}, n);
  if (outside == 2) add_two_outside(sorted);
  if (outside == 3) made_.tets.push_back({corner(p), corner(p, q), corner(p, m), corner(p, n)});
}

StuffedLattice Stuffing::run() {
  std::vector<bool> has_cut(signs_.size(), false);
  for (const LatticeCut& cut : cuts_) has_cut[cut.a] = has_cut[cut.b] = true;
  for (std::uint32_t point = 0; point < signs_.size(); ++point)
    if (has_cut[point]) warp(point);
  lattice_.for_each_tet([&](const std::array<std::uint32_t, 4>& points) { add_tet(points); });
  return std::move(made_);
}

}  // namespace

StuffedLattice stuff_lattice(const BccLattice& lattice, const std::vector<std::uint8_t>& inside,
                             const std::vector<LatticeCut>& cuts) {
  return Stuffing(lattice, inside, cuts).run();
}

}  // namespace weft::mesh
