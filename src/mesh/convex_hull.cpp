#include "mesh/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "mesh/closest.hpp"
#include "mesh/orientation.hpp"

namespace weft::mesh {
namespace {

constexpr std::uint32_t kNoFace = std::numeric_limits<std::uint32_t>::max();

struct HullFace {
  Triangle corners{};
  Triangle beside{};  // beside[k]: the face beyond the edge from corner k to the next
  std::vector<std::uint32_t> outside;
  bool alive = true;
};

/// An edge of what a new corner sees, and the face beyond it, which it does not see.
struct HorizonEdge {
  std::uint32_t from = 0, to = 0, beyond = 0, seen = 0;
};

/// Quickhull. All decisions on which the hull's topology hangs are exact signs: what a point sees is in one piece,
/// bounded by one loop, and no triangle is without area (the point would lie in the plane of a face that it sees).
class Quickhull {
 public:
  explicit Quickhull(std::span<const Vec3f> points)
      : tolerance_(0.5 * hull_tolerance(points)),  // a point to a first hull, its corners to the last
        from_(points.size(), kNoFace) {
    for (const Vec3f& p : points) points_.push_back(p.to<double>());
  }

  /// The hull of `chosen`, then of `others` too as far as they lie outside of that.
  Result<void> run(const std::vector<std::uint32_t>& chosen, const std::vector<std::uint32_t>& others) {
    WEFT_CHECK(begin(chosen));
    grow_all();
    hand_out(others, 0);
    grow_all();
    return {};
  }

  std::vector<std::uint32_t> corners() const;
  /// The corners, without some from which the others' hull is no further than the tolerance.
  std::vector<std::uint32_t> needed() const;
  TriangleMesh mesh(std::span<const Vec3f> points);

 private:
  double height(const HullFace& face, const Vec3d& point) const {
    const Vec3d &a = points_[face.corners[0]], &b = points_[face.corners[1]], &c = points_[face.corners[2]];
    const Vec3d normal = cross(b - a, c - a);
    return dot(normal, point - a) / length(normal);
  }
  bool sees(std::uint32_t point, const HullFace& face) const {
    return orientation(points_[face.corners[0]], points_[face.corners[1]], points_[face.corners[2]],
                       points_[point]) > 0;
  }

  /// The point of `list` for which `measure` is largest. Among those within the tolerance of it, the one farthest from
  /// `middle`: a corner, and not one of the points of a flat face.
  template <class List, class Measure>
  std::uint32_t farthest(const List& list, const Vec3d& middle, const Measure& measure) const {
    double most = 0;
    for (const std::uint32_t p : list) most = std::max(most, measure(points_[p]));
    std::uint32_t best = kNoFace;
    double best_size = -1;
    for (const std::uint32_t p : list) {
      if (measure(points_[p]) < most - tolerance_) continue;
      const double size = length(points_[p] - middle);
      if (size > best_size) best = p, best_size = size;
    }
    return best;
  }

  /// A tetrahedron of points far apart.
  Result<void> begin(const std::vector<std::uint32_t>& all) {
    Vec3d middle;
    for (const std::uint32_t p : all) middle += points_[p] / static_cast<double>(all.size());
    double thickness = 0;
    std::array<std::uint32_t, 4> corner{};
    if (!all.empty()) {
      corner[0] = farthest(all, middle, [&](const Vec3d& p) { return length(p - middle); });
      const Vec3d a = points_[corner[0]];
      corner[1] = farthest(all, a, [&](const Vec3d& p) { return length(p - a); });
      const Vec3d b = points_[corner[1]];
      corner[2] = farthest(all, 0.5 * (a + b), [&](const Vec3d& p) {
        return length(b - a) > 0 ? length(cross(b - a, p - a)) / length(b - a) : 0;
      });
      const Vec3d c = points_[corner[2]], area = cross(b - a, c - a);
      const auto off = [&](const Vec3d& p) {
        return length(area) > 0 ? std::abs(dot(area, p - a)) / length(area) : 0;
      };
      const bool line = length(area) <= tolerance_ * length(b - a);  // no plane is known well
      corner[3] = farthest(all, (a + b + c) / 3, off);
      thickness = line ? 0 : off(points_[corner[3]]);
    }
    int side = 0;
    if (thickness > tolerance_)
      side = orientation(points_[corner[0]], points_[corner[1]], points_[corner[2]], points_[corner[3]]);
    if (side == 0)
      return input_error(
          "The %zu points lie in a plane, within %.3g m; a convex hull needs points on all sides of a "
          "volume.",
          all.size(), std::max(thickness, tolerance_));
    if (side > 0) std::swap(corner[1], corner[2]);  // the fourth is below the first three
    // Each face, and what is beyond its edges.
    constexpr std::uint32_t kSides[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    constexpr Triangle kBeside[4] = {{1, 2, 3}, {3, 2, 0}, {1, 3, 0}, {2, 1, 0}};
    for (std::uint32_t f = 0; f < 4; ++f) {
      HullFace face;
      for (std::uint32_t k = 0; k < 3; ++k) face.corners[k] = corner[kSides[f][k]];
      face.beside = kBeside[f];
      faces_.push_back(std::move(face));
    }
    hand_out(all, 0);
    return {};
  }

  /// Gives each point to the first face from `first` on that it sees; one that sees none is inside.
  void hand_out(const std::vector<std::uint32_t>& points, std::uint32_t first) {
    for (const std::uint32_t p : points)
      for (std::uint32_t f = first; f < faces_.size(); ++f)
        if (faces_[f].alive && sees(p, faces_[f])) {
          faces_[f].outside.push_back(p);
          break;
        }
    for (std::uint32_t f = first; f < faces_.size(); ++f)
      if (!faces_[f].outside.empty()) waiting_.push_back(f);
  }

  void grow_all() {
    while (!waiting_.empty()) {
      const std::uint32_t face = waiting_.back();
      if (faces_[face].alive && !faces_[face].outside.empty())
        grow(face);
      else
        waiting_.pop_back();
    }
  }

  /// Makes a corner of a point outside of a face, and drops points that lie in the hull's rounding.
  void grow(std::uint32_t face) {
    const Triangle& corners = faces_[face].corners;
    const Vec3d middle = (points_[corners[0]] + points_[corners[1]] + points_[corners[2]]) / 3;
    const auto above = [&](const Vec3d& p) { return height(faces_[face], p); };
    const std::uint32_t highest = farthest(faces_[face].outside, middle, above);
    if (above(points_[highest]) > tolerance_) return add(highest, seen_from(highest, face));
    // Where faces meet at a narrow angle a point may be far outside all the same, and so may one in a face's plane.
    std::vector<std::uint32_t> left;
    for (const std::uint32_t p : faces_[face].outside)
      if (distance(p, seen_from(p, face)) > tolerance_) left.push_back(p);
    faces_[face].outside = std::move(left);
    if (faces_[face].outside.empty()) return;
    const std::uint32_t next = farthest(faces_[face].outside, middle, above);
    add(next, seen_from(next, face));
  }

  std::vector<std::uint32_t> seen_from(std::uint32_t point, std::uint32_t face) {
    std::vector<std::uint32_t> seen{face};
    mark_.resize(faces_.size(), 0);
    ++epoch_;
    mark_[face] = epoch_;
    for (std::size_t k = 0; k < seen.size(); ++k)
      for (const std::uint32_t beside : faces_[seen[k]].beside)
        if (mark_[beside] != epoch_ && sees(point, faces_[beside])) {
          mark_[beside] = epoch_;
          seen.push_back(beside);
        }
    return seen;
  }

  double distance(std::uint32_t point, const std::vector<std::uint32_t>& seen) const {
    double least = HUGE_VAL;
    for (const std::uint32_t f : seen) {
      const Triangle& t = faces_[f].corners;
      least = std::min(
          least, closest_on_triangle(points_[point], points_[t[0]], points_[t[1]], points_[t[2]]).distance);
    }
    return least;
  }

  void add(std::uint32_t point, const std::vector<std::uint32_t>& seen) {
    std::vector<HorizonEdge> horizon;
    std::vector<std::uint32_t> orphans;
    for (const std::uint32_t f : seen) {
      HullFace& face = faces_[f];
      for (std::size_t k = 0; k < 3; ++k)
        if (mark_[face.beside[k]] != epoch_)
          horizon.push_back({face.corners[k], face.corners[(k + 1) % 3], face.beside[k], f});
      for (const std::uint32_t p : face.outside)
        if (p != point) orphans.push_back(p);
      face.alive = false;
      face.outside = {};
    }
    const auto first = static_cast<std::uint32_t>(faces_.size());
    for (const HorizonEdge& edge : horizon) {
      const auto made = static_cast<std::uint32_t>(faces_.size());
      from_[edge.from] = made;
      HullFace face;
      face.corners = {edge.from, edge.to, point};
      face.beside = {edge.beyond, kNoFace, kNoFace};
      for (std::uint32_t& beside : faces_[edge.beyond].beside)
        if (beside == edge.seen && shares(faces_[edge.beyond], edge, beside)) beside = made;
      faces_.push_back(std::move(face));
    }
    for (std::uint32_t f = first; f < faces_.size(); ++f) {
      const std::uint32_t after = from_[faces_[f].corners[1]];
      faces_[f].beside[1] = after;
      faces_[after].beside[2] = f;
    }
    hand_out(orphans, first);
  }

  /// Whether `beside`, an entry of the face's, stands for this edge: two faces may share two.
  static bool shares(const HullFace& face, const HorizonEdge& edge, const std::uint32_t& beside) {
    const auto k = static_cast<std::size_t>(&beside - face.beside.data());
    return face.corners[k] == edge.to && face.corners[(k + 1) % 3] == edge.from;
  }

  std::vector<std::uint32_t> facets() const;

  double tolerance_ = 0;
  std::vector<Vec3d> points_;
  std::vector<HullFace> faces_;
  std::vector<std::uint32_t> waiting_;  // faces that may have points outside
  std::vector<std::uint32_t> mark_;     // of each face: the last point that saw it
  std::uint32_t epoch_ = 0;
  std::vector<std::uint32_t> from_;  // the new face whose first corner this is
};

/// For each face the facet that it is part of: faces side by side in one plane.
std::vector<std::uint32_t> Quickhull::facets() const {
  std::vector<std::uint32_t> facet(faces_.size(), kNoFace);
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    if (!faces_[f].alive || facet[f] != kNoFace) continue;
    facet[f] = f;
    std::vector<std::uint32_t> stack{f};
    while (!stack.empty()) {
      const std::uint32_t at = stack.back();
      stack.pop_back();
      for (const std::uint32_t beside : faces_[at].beside) {
        if (facet[beside] != kNoFace) continue;
        const Triangle &t = faces_[f].corners, &other = faces_[beside].corners;
        const bool flat = std::all_of(other.begin(), other.end(), [&](std::uint32_t p) {
          return orientation(points_[t[0]], points_[t[1]], points_[t[2]], points_[p]) == 0;
        });
        if (!flat) continue;
        facet[beside] = f;
        stack.push_back(beside);
      }
    }
  }
  return facet;
}

std::vector<std::uint32_t> Quickhull::corners() const {
  std::vector<std::uint32_t> list;
  for (const HullFace& face : faces_)
    if (face.alive) list.insert(list.end(), face.corners.begin(), face.corners.end());
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// A point is handed to one of the faces that it sees, so the highest of a face may lie beside a corner to come, on an
/// edge that is not there yet: it is a corner then, of a bump that rounding made.
std::vector<std::uint32_t> Quickhull::needed() const {
  constexpr std::size_t kMostBeside = 12;  // triples of more are too many, and bumps have few
  std::vector<std::vector<std::uint32_t>> beside(points_.size());
  for (const HullFace& face : faces_)
    for (std::size_t k = 0; face.alive && k < 3; ++k)
      beside[face.corners[k]].push_back(face.corners[(k + 1) % 3]);
  std::vector<bool> stays(points_.size(), false);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t p = 0; p < points_.size(); ++p) {
    const std::vector<std::uint32_t>& around = beside[p];
    if (around.empty()) continue;
    bool bump = false;
    if (!stays[p] && around.size() <= kMostBeside)
      for (std::size_t i = 0; i < around.size(); ++i)
        for (std::size_t j = i + 1; j < around.size(); ++j)
          for (std::size_t k = j + 1; k < around.size() && !bump; ++k)
            bump = closest_on_triangle(points_[p], points_[around[i]], points_[around[j]], points_[around[k]])
                       .distance <= tolerance_;
    if (!bump) {
      corners.push_back(p);
      continue;
    }
    for (const std::uint32_t other : around) stays[other] = true;
  }
  return corners;
}

/// The triangles of a convex polygon. Halves it again and again: a fan would be all slivers.
void divide(std::span<const std::uint32_t> loop, std::vector<Triangle>& triangles) {
  if (loop.size() < 3) return;
  const std::size_t middle = loop.size() / 2;
  triangles.push_back({loop.front(), loop[middle], loop.back()});
  divide(loop.first(middle + 1), triangles);
  divide(loop.subspan(middle), triangles);
}

TriangleMesh Quickhull::mesh(std::span<const Vec3f> points) {
  const std::vector<std::uint32_t> facet = facets();
  // Of each facet the way around it, and of each point how many such ways pass it: a corner has three or more.
  std::vector<std::vector<std::uint32_t>> parts(faces_.size());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].alive) parts[facet[f]].push_back(f);
  std::vector<std::vector<std::uint32_t>> loops;
  std::vector<std::uint32_t> passed(points.size(), 0), next(points.size(), kNoFace);
  for (const std::vector<std::uint32_t>& part : parts) {
    std::uint32_t start = kNoFace;
    for (const std::uint32_t f : part)
      for (std::size_t k = 0; k < 3; ++k) {
        if (facet[faces_[f].beside[k]] == facet[f]) continue;
        if (start == kNoFace) start = faces_[f].corners[k];
        next[faces_[f].corners[k]] = faces_[f].corners[(k + 1) % 3];
      }
    if (start == kNoFace) continue;
    std::vector<std::uint32_t> loop;
    std::uint32_t at = start;
    do {
      loop.push_back(at);
      ++passed[at];
      at = next[at];
    } while (at != start);
    loops.push_back(std::move(loop));
  }
  TriangleMesh mesh;
  std::vector<std::uint32_t> number(points.size(), kNoFace);
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (passed[p] < 3) continue;
    number[p] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(points[p]);
  }
  for (const std::vector<std::uint32_t>& loop : loops) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t p : loop)
      if (number[p] != kNoFace) corners.push_back(number[p]);
    divide(corners, mesh.triangles);
  }
  return mesh;
}

}  // namespace

double hull_tolerance(std::span<const Vec3f> points) {
  float largest = 0;
  for (const Vec3f& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::ldexp(static_cast<double>(largest), -20);  // a unit is at most 2^-23 of it
}

Result<TriangleMesh> convex_hull(std::span<const Vec3f> points) {
  for (std::size_t p = 0; p < points.size(); ++p)
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(points[p][axis]))
        return input_error("Point %zu has the coordinate %g, which is not finite.", p,
                           static_cast<double>(points[p][axis]));
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  Quickhull hull(points);
  WEFT_CHECK(hull.run(all, {}));
  // Each round leaves out some: of two bumps side by side one stays for the next.
  constexpr int kMostRounds = 8;
  const std::vector<std::uint32_t> corners = hull.corners();
  for (int round = 0; round < kMostRounds; ++round) {
    const std::vector<std::uint32_t> before = hull.corners(), needed = hull.needed();
    if (needed.size() == before.size()) break;
    std::vector<std::uint32_t> left_out;
    std::set_difference(corners.begin(), corners.end(), needed.begin(), needed.end(),
                        std::back_inserter(left_out));
    Quickhull fewer(points);
    if (!fewer.run(needed, left_out) || fewer.corners().size() >= before.size()) break;
    hull = std::move(fewer);
  }
  TriangleMesh mesh = hull.mesh(points);
  if (mesh.positions.size() > kMostHullVertices)
    return make_error(ErrorKind::Limit, "The convex hull of %zu points has %zu corners, more than %zu.",
                      points.size(), mesh.positions.size(), kMostHullVertices);
  return mesh;
}

}  // namespace weft::mesh
