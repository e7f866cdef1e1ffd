#include "element/hinge/plate.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/sides.hpp"

namespace weft::hinge {
namespace {

using mesh::Side;

/// Writes a hinge into the facets of its triangles.
void enter(Plate& plate, const Side& side, double sign) {
  Facet& facet = plate.facets[side.triangle];
  facet.hinges[side.corner] = static_cast<std::uint32_t>(plate.hinges.size() - 1);
  facet.sign[side.corner] = sign;
}

/// Makes a hinge between two triangles, unless they turn against each other.
void join(const RestSheet& sheet, Plate& plate, const Side& first, const Side& second) {
  const mesh::Triangle &t = sheet.triangles[first.triangle], &u = sheet.triangles[second.triangle];
  const std::uint32_t a = t[(first.corner + 1) % 3], b = t[(first.corner + 2) % 3];
  if (u[(second.corner + 2) % 3] != a) return;
  plate.hinges.push_back({{a, b, t[first.corner], u[second.corner]}, {first.triangle, second.triangle}});
  enter(plate, first, 1);
  enter(plate, second, -1);
}

Plate joined(const RestSheet& sheet) {
  Plate plate;
  plate.facets.assign(sheet.triangles.size(), {{kNone, kNone, kNone}, {}, {}});
  const std::vector<Side> sides = mesh::sorted_sides(sheet.triangles);
  mesh::for_each_edge(sides, [&](std::span<const Side> of_edge) {
    if (of_edge.size() == 2) join(sheet, plate, of_edge[0], of_edge[1]);
  });
  return plate;
}

/// The hinge of a triangle that does not touch a node, or kNone.
std::uint32_t opposite(const RestSheet& sheet, const Plate& plate, std::uint32_t triangle,
                       std::uint32_t node) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sheet.triangles[triangle][i] == node) return plate.facets[triangle].hinges[i];
  return kNone;
}

/// Which of the sheet's places a node of a triangle has, as that was cut.
std::uint32_t cut_node(const RestSheet& sheet, std::uint32_t triangle, std::uint32_t node) {
  if (sheet.cut.empty()) return node;
  const mesh::Triangle& nodes = sheet.triangles[triangle];
  return sheet.cut[triangle][nodes[0] == node ? 0 : nodes[1] == node ? 1 : 2];
}
const Vec3d& place_in(const RestSheet& sheet, std::uint32_t triangle, std::uint32_t node) {
  return sheet.position[cut_node(sheet, triangle, node)];
}

/// How long the edge between two triangles is: at a seam as long as both sides in the mean.
double edge_length(const RestSheet& sheet, const Hinge& hinge) {
  const auto side = [&](std::uint32_t triangle) {
    return length(place_in(sheet, triangle, hinge.nodes[1]) - place_in(sheet, triangle, hinge.nodes[0]));
  };
  return (side(hinge.triangles[0]) + side(hinge.triangles[1])) / 2;
}

/// A linear form of curvature (K11, K22, 2 K12): what an angle is on a sheet that is curved evenly.
using Form = Vec3d;

Form square(const Vec3d& a) { return {a.x * a.x, a.y * a.y, a.x * a.y}; }
Form mixed(const Vec3d& a, const Vec3d& b) { return {a.x * b.x, a.y * b.y, (a.x * b.y + a.y * b.x) / 2}; }

/// The angle from a triangle, left of the way from p to q in the plane, to the sheet's own slope at that edge's middle:
/// the rise of a quadratic to the apex over its chord along the edge, by the height. Equation 13.
Form part(const Vec3d& p, const Vec3d& q, const Vec3d& apex) {
  const double span = length(q - p);
  const Vec3d along = (q - p) / span, inward{-along.y, along.x, 0}, way = apex - 0.5 * (p + q);
  const double s = dot(way, along), height = dot(way, inward);
  return (s * s - span * span / 4) / (2 * height) * square(along) + s * mixed(along, inward) +
         height / 2 * square(inward);
}

/// A sheet at rest, laid into a plane triangle by triangle.
class Unfolded {
 public:
  Unfolded(const RestSheet& sheet, const Plate& plate) : sheet_(sheet), plate_(plate) {}

  bool rigid(std::uint32_t triangle) const { return plate_.facets[triangle].rigid; }

  /// A triangle beside the way from p to q, where its nodes a and b lie: its third corner, left of the way.
  Vec3d apex(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, std::uint32_t third, const Vec3d& p,
             const Vec3d& q) const {
    const Vec3d from = place_in(sheet_, triangle, a), edge = place_in(sheet_, triangle, b) - from,
                way = place_in(sheet_, triangle, third) - from;
    const double span = length(edge);
    const Vec3d along = (q - p) / length(q - p);
    return p + dot(way, edge) / span * along + length(cross(edge, way)) / span * Vec3d{-along.y, along.x, 0};
  }

  /// Of the part of an angle that falls to a triangle. What does not bend takes none.
  Form part_of(std::uint32_t triangle, const Vec3d& p, const Vec3d& q, const Vec3d& third) const {
    return rigid(triangle) ? Form{} : part(p, q, third);
  }

  /// Of the angle at another edge of a triangle, from node a to b, which lie at p and q.
  Form angle(std::uint32_t hinge, std::uint32_t triangle, std::uint32_t a, std::uint32_t b, const Vec3d& p,
             const Vec3d& q, const Vec3d& third) const {
    const Hinge& h = plate_.hinges[hinge];
    const std::size_t beyond = h.triangles[0] == triangle ? 1 : 0;
    const Vec3d far = apex(h.triangles[beyond], b, a, h.nodes[beyond == 1 ? 3 : 2], q, p);
    return part_of(triangle, p, q, third) + part_of(h.triangles[beyond], q, p, far);
  }

 private:
  const RestSheet& sheet_;
  const Plate& plate_;
};

/// The least weights by squares with which the angles make what the first triangle's part is more than half of the
/// hinge's angle, whatever the curvature. `slack` of the trace makes the matrix invertible where angles do not tell all
/// curvatures apart.
std::array<double, 5> least_weights(const std::array<Form, 5>& forms, const Form& wanted, double slack) {
  Mat3 normal;
  for (const Form& form : forms) normal += Mat3::outer(form, form);
  const double trace = normal.x.x + normal.y.y + normal.z.z;
  const Vec3d solved = inverse(normal + Mat3::identity(slack * trace)) * wanted;
  std::array<double, 5> weights;
  for (std::size_t k = 0; k < 5; ++k) weights[k] = dot(forms[k], solved);
  return weights;
}

bool is_held(const RestSheet& sheet, const mesh::Triangle& triangle) {
  return !sheet.held.empty() && std::all_of(triangle.begin(), triangle.end(),
                                            [&](std::uint32_t node) { return sheet.held[node] != 0; });
}

/// The weights that make what the first triangle's part is more than half of the hinge's angle. Three angles at a
/// corner of the rim may hardly tell curvatures apart: exact weights would be tens to hundreds. With more angles they
/// are below one but beside slivers, and an error of 1e-6 is all that it takes; there the error is as large as it must
/// be.
std::array<double, 5> bounded_weights(const std::array<Form, 5>& forms, const Form& wanted, bool few) {
  constexpr double kMost = 1, kMostSlack = 1e3;
  std::array<double, 5> weights{};
  for (double slack = few ? 1e-2 : 1e-7; slack < kMostSlack; slack *= 10) {
    weights = least_weights(forms, wanted, slack);
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return std::abs(w) < kMost; })) break;
  }
  return weights;
}

/// A sliver is a triangle to which even curvature gives so much more of an angle than to its neighbour: its heights are
/// so much smaller that it zigzags over the sheet. Of meshes whose triangles are alike, however long, one has 10 times
/// as much at most.
constexpr double kSliver = 12;

void split(const RestSheet& sheet, Plate& plate, Hinge& hinge) {
  const Unfolded unfolded(sheet, plate);
  const auto [a, b, c, d] = hinge.nodes;
  const auto [first, second] = hinge.triangles;
  hinge.others = {opposite(sheet, plate, first, a), opposite(sheet, plate, first, b),
                  opposite(sheet, plate, second, b), opposite(sheet, plate, second, a)};
  if (unfolded.rigid(first) || unfolded.rigid(second)) {
    hinge.shift = {unfolded.rigid(first) ? -0.5 : 0.5, 0, 0, 0, 0};
    return;
  }
  const Vec3d p{}, q{edge_length(sheet, hinge), 0, 0};
  const Vec3d r = unfolded.apex(first, a, b, c, p, q), s = unfolded.apex(second, b, a, d, q, p);
  const Form to_first = part(p, q, r), to_second = part(q, p, s);
  std::array<Form, 5> forms = {to_first + to_second};
  const auto form = [&](std::size_t k, std::uint32_t triangle, std::uint32_t from, std::uint32_t to,
                        const Vec3d& at, const Vec3d& end, const Vec3d& third) {
    if (hinge.others[k] != kNone)
      forms[k + 1] = unfolded.angle(hinge.others[k], triangle, from, to, at, end, third);
  };
  form(0, first, b, c, q, r, p);
  form(1, first, c, a, r, p, q);
  form(2, second, a, d, p, s, q);
  form(3, second, d, b, s, q, p);
  const bool few = std::count(hinge.others.begin(), hinge.others.end(), kNone) > 1;
  hinge.shift = bounded_weights(forms, 0.5 * (to_first - to_second), few);
  if (length(to_first) > kSliver * length(to_second)) plate.facets[first].sliver = true;
  if (length(to_second) > kSliver * length(to_first)) plate.facets[second].sliver = true;
}

/// Moments by parts of angles: curvature is their sum over the edges, n nᵀ times length by area (the mean of the
/// sheet's slopes around the triangle), and an edge at the rim turns as it likes. Equations 11 and 12. With them the
/// square of that curvature's size, K11² + 2 K12² + K22².
void set_stiffness(const std::array<MaterialPoint, 3>& corners, Facet& facet, const Stiffness& d) {
  std::array<Vec3d, 3> strain;  // K11, K22, 2 K12 by each part, times the area
  std::array<std::array<double, 3>, 3> m{};
  double area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const MaterialPoint &from = corners[(i + 1) % 3], &to = corners[(i + 2) % 3];
    const double x = to.warp - from.warp, y = to.weft - from.weft, span = std::hypot(x, y);
    strain[i] = {y * y / span, x * x / span, -2 * x * y / span};
    area += (from.warp * to.weft - from.weft * to.warp) / 2;
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3d &a = strain[i], &b = strain[j];
      m[i][j] = (d.warp * a.x * b.x + d.coupled * (a.x * b.y + a.y * b.x) + d.weft * a.y * b.y +
                 d.shear * a.z * b.z) /
                area;
    }
  for (std::size_t free = 0; free < 3; ++free) {
    if (facet.hinges[free] != kNone) continue;
    const auto row = m[free];
    for (std::size_t i = 0; i < 3; ++i)
      if (i != free && row[free] > 0) strain[i] += -row[i] / row[free] * strain[free];
    strain[free] = {};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) m[i][j] -= row[free] > 0 ? row[i] * row[j] / row[free] : 0;
    for (std::size_t i = 0; i < 3; ++i) m[i][free] = m[free][i] = 0;
  }
  facet.stiffness = {{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
  const auto square = [&](std::size_t i, std::size_t j) {
    const Vec3d &a = strain[i], &b = strain[j];
    return (a.x * b.x + a.y * b.y + a.z * b.z / 2) / (area * area);
  };
  facet.curving = {{square(0, 0), square(0, 1), square(0, 2)},
                   {square(1, 0), square(1, 1), square(1, 2)},
                   {square(2, 0), square(2, 1), square(2, 2)}};
}

}  // namespace

std::optional<Corners> rest_corners(const RestSheet& sheet, const Hinge& hinge) {
  const auto [a, b, c, d] = hinge.nodes;
  const auto [first, second] = hinge.triangles;
  if (cut_node(sheet, first, a) != cut_node(sheet, second, a)) return std::nullopt;
  if (cut_node(sheet, first, b) != cut_node(sheet, second, b)) return std::nullopt;
  return Corners{place_in(sheet, first, a), place_in(sheet, first, b), place_in(sheet, first, c),
                 place_in(sheet, second, d)};
}

Plate build_plate(const RestSheet& sheet, const Stiffness& bending) {
  Plate plate = joined(sheet);
  for (std::uint32_t t = 0; t < plate.facets.size(); ++t)
    plate.facets[t].rigid = is_held(sheet, sheet.triangles[t]);
  for (Hinge& hinge : plate.hinges) {
    const std::optional<Corners> corners = rest_corners(sheet, hinge);
    hinge.rest_angle = corners ? angle(*corners) : 0;
  }
  for (Hinge& hinge : plate.hinges) split(sheet, plate, hinge);
  for (std::uint32_t t = 0; t < plate.facets.size(); ++t) {
    if (plate.facets[t].rigid || plate.facets[t].sliver) continue;
    set_stiffness(sheet.places(t), plate.facets[t], bending);
  }
  return plate;
}

}  // namespace weft::hinge
