#include "contact/reference/pushes/gjk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::reference {
namespace {

constexpr double kUnit = 0.5 * std::numeric_limits<double>::epsilon();  // of rounding; 2^-24 in the kernel
constexpr double kGap = 8 * kUnit;                                      // of the pair's size: close enough
/// Of the pair's size. A nearest point is rounded by some kUnit of the size, so the direction to one at a distance d is
/// wrong by kUnit / d, and a search along it may end with a point that is as much too far: more than d itself where d
/// is below the root of kUnit.
const double kTouch = 4 * std::sqrt(kUnit);
constexpr double kNear = 1.0 / 64;  // of the pair's size: nearer, a face's normal tells its direction better
constexpr double kDoubt = 48 * kUnit;  // of the pair's size: further, another way must tell
constexpr std::uint32_t kMostIterations = 64;
constexpr std::size_t kScan = 32;  // points: more are climbed

double largest_part(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A corner of the triangle less a point of the body.
struct Vertex {
  Vec3d at;  // [m]
  std::size_t corner = 0;
  std::uint32_t point = 0;
};

struct Simplex {
  std::array<Vertex, 4> vertices;
  std::array<double, 4> weights{};
  std::size_t count = 0;
  Vec3d nearest;  // its point nearest to 0: the sum of weights * vertices [m]
};

/// Takes the nearest point of all features of a simplex: what rounding does to one of them another makes good.
class NearestOfSimplex {
 public:
  explicit NearestOfSimplex(const Simplex& simplex) : s_(simplex) {}

  /// The simplex without the vertices of weight 0.
  Simplex run() {
    for (std::size_t i = 0; i < s_.count; ++i) take({i}, {1});
    for (std::size_t i = 0; i < s_.count; ++i)
      for (std::size_t j = i + 1; j < s_.count; ++j) take_edge(i, j);
    for (std::size_t i = 0; i < s_.count; ++i)
      for (std::size_t j = i + 1; j < s_.count; ++j)
        for (std::size_t k = j + 1; k < s_.count; ++k) take_face(i, j, k);
    Simplex kept;
    kept.nearest = nearest_;
    for (std::size_t i = 0; i < s_.count; ++i) {
      if (!(weights_[i] > 0)) continue;
      kept.vertices[kept.count] = s_.vertices[i];
      kept.weights[kept.count++] = weights_[i];
    }
    return kept;
  }

  /// Whether 0 is inside of a simplex of four, beyond doubt.
  bool inside() const {
    if (s_.count < 4) return false;
    for (std::size_t apex = 0; apex < 4; ++apex) {
      const Vec3d &a = at((apex + 1) % 4), &b = at((apex + 2) % 4), &c = at((apex + 3) % 4);
      const Vec3d e1 = b - a, e2 = c - a, n = cross(e1, e2), to_apex = at(apex) - a;
      const double of_origin = -dot(n, a), of_apex = dot(n, to_apex);
      const double tolerance = 64 * kUnit * largest_part(e1) * largest_part(e2);
      if (!(std::abs(of_origin) > tolerance * largest_part(a)) ||
          !(std::abs(of_apex) > tolerance * largest_part(to_apex)))
        return false;
      if ((of_origin > 0) != (of_apex > 0)) return false;
    }
    return true;
  }

 private:
  const Vec3d& at(std::size_t vertex) const { return s_.vertices[vertex].at; }

  void take(const std::array<std::size_t, 3>& vertices, const std::array<double, 3>& weights) {
    Vec3d point;
    for (std::size_t k = 0; k < 3; ++k) point += weights[k] * at(vertices[k]);
    const double square = dot(point, point);
    if (!(square < square_)) return;
    square_ = square;
    nearest_ = point;
    weights_ = {};
    for (std::size_t k = 0; k < 3; ++k) weights_[vertices[k]] += weights[k];
  }

  void take_edge(std::size_t i, std::size_t j) {
    const Vec3d e = at(j) - at(i);
    const double square = dot(e, e);
    if (!(square > 0)) return;
    double t = -dot(at(i), e) / square;
    t -= dot(at(i) + t * e, e) / square;  // once more, from where it is: what is left is short
    if (t > 0 && t < 1) take({i, j, i}, {1 - t, t, 0});
  }

  void take_face(std::size_t i, std::size_t j, std::size_t k) {
    const Vec3d &a = at(i), e1 = at(j) - a, e2 = at(k) - a, n = cross(e1, e2);
    const double square = dot(n, n);
    if (!(square > 0)) return;
    double s = 0, t = 0;
    for (int round = 0; round < 2; ++round) {
      const Vec3d v = a + s * e1 + t * e2;
      s -= dot(n, cross(v, e2)) / square;
      t -= dot(n, cross(e1, v)) / square;
    }
    if (s > 0 && t > 0 && s + t < 1) take({i, j, k}, {1 - s - t, s, t});
  }

  const Simplex& s_;
  std::array<double, 4> weights_{};
  Vec3d nearest_;
  double square_ = HUGE_VAL;
};

class Gjk {
 public:
  Gjk(const TrianglePoints& triangle, const ConvexBody& body)
      : corners_{triangle.a, triangle.b, triangle.c}, body_(body), size_(pair_size(triangle, body)) {}

  GjkContact run() {
    GjkContact made;
    search();
    made.iterations = iterations_;
    const double distance = length(simplex_.nearest);
    if (!inside_ && distance > kTouch * size_ && gap_ <= kDoubt * size_) {
      made.contact = contact(simplex_.nearest / distance, distance);
      return made;
    }
    const TrianglePoints triangle{corners_[0], corners_[1], corners_[2]};
    const Separation apart = separation(triangle, body_);  // no more than the distance
    const bool overlap = inside_ || apart.distance <= 0;
    if (!overlap && distance - apart.distance > kDoubt * size_) {
      made.by_features = true;
      made.contact = contact_by_features(triangle, body_);
      return made;
    }
    if (!overlap && distance > kTouch * size_) {
      made.contact = contact(simplex_.nearest / distance, distance);
      return made;
    }
    for (Vec3d& corner : corners_) corner += (0.25 * size_ - apart.distance) * apart.axis;
    search();
    made.contact = contact(apart.axis, overlap ? apart.distance : distance);
    made.iterations = iterations_;
    return made;
  }

 private:
  /// The corner lowest along v, and the point highest.
  Vertex support(const Vec3d& v) {
    Vertex found;
    for (std::size_t k = 1; k < 3; ++k)
      if (dot(v, corners_[k] - corners_[found.corner]) < 0) found.corner = k;
    found.point = body_.points.size() <= kScan ? scan(v) : climb(v);
    highest_ = found.point;
    found.at = corners_[found.corner] - body_.points[found.point];
    return found;
  }
  std::uint32_t scan(const Vec3d& v) const {
    std::uint32_t best = 0;
    for (std::uint32_t p = 1; p < body_.points.size(); ++p)
      if (dot(v, body_.points[p] - body_.points[best]) > 0) best = p;
    return best;
  }
  std::uint32_t climb(const Vec3d& v) const {
    std::uint32_t at = highest_;
    for (std::size_t step = 0; step < body_.points.size(); ++step) {
      std::uint32_t next = at;
      double most = 0;
      for (const std::uint32_t p : body_.beside.row(at)) {
        const Vec3d way = body_.points[p] - body_.points[at];
        const double rise = dot(v, way);
        if (rise > most && rise > 4 * kUnit * largest_part(v) * largest_part(way)) most = rise, next = p;
      }
      if (next == at) break;
      at = next;
    }
    return at;
  }

  void search() {
    simplex_ = {};
    inside_ = false;
    Vec3d v = corners_[0] - body_.points[highest_];
    if (v == Vec3d{}) v = {0, 1, 0};
    for (std::uint32_t round = 0; round < kMostIterations; ++round) {
      ++iterations_;
      const Vec3d way = direction(v);
      const Vertex next = support(way);
      gap_ = dot(way, v - next.at);
      if (simplex_.count > 0 && (gap_ <= kGap * size_ || has(next))) return;
      simplex_.vertices[simplex_.count++] = next;
      NearestOfSimplex nearest(simplex_);
      inside_ = nearest.inside();
      if (inside_) return;
      Simplex reduced = nearest.run();
      if (round > 0 && !(dot(reduced.nearest, reduced.nearest) < dot(v, v))) {
        --simplex_.count;  // rounding allows no more
        return;
      }
      simplex_ = reduced;
      v = simplex_.nearest;
      if (v == Vec3d{}) return;
    }
  }
  /// From 0 to its nearest point. Where that is too near to have one, the normal of the face that it lies in.
  Vec3d direction(const Vec3d& v) const {
    const double distance = length(v);
    if (simplex_.count == 3 && distance <= kNear * size_) {
      const Vec3d& a = simplex_.vertices[0].at;
      const Vec3d n = cross(simplex_.vertices[1].at - a, simplex_.vertices[2].at - a);
      if (length(n) > 0) return (dot(n, a) < 0 ? -1 : 1) * n / length(n);
    }
    return v / distance;
  }
  bool has(const Vertex& vertex) const {
    for (std::size_t k = 0; k < simplex_.count; ++k)
      if (simplex_.vertices[k].corner == vertex.corner && simplex_.vertices[k].point == vertex.point)
        return true;
    return false;
  }

  ConvexContact contact(const Vec3d& normal, double distance) const {
    ConvexContact made{{}, {}, normal, distance};
    for (std::size_t k = 0; k < simplex_.count; ++k) {
      made.weights[simplex_.vertices[k].corner] += simplex_.weights[k];
      made.point += simplex_.weights[k] * body_.points[simplex_.vertices[k].point];
    }
    return made;
  }

  std::array<Vec3d, 3> corners_;
  const ConvexBody& body_;
  double size_ = 0;  // [m]
  Simplex simplex_;
  bool inside_ = false;
  double gap_ = 0;             // the distance is at most so much too long [m]
  std::uint32_t highest_ = 0;  // the point found last
  std::uint32_t iterations_ = 0;
};

}  // namespace

GjkContact contact_by_gjk(const TrianglePoints& triangle, const ConvexBody& body) {
  return Gjk(triangle, body).run();
}

}  // namespace weft::reference
