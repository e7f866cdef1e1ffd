#include "model/enclosed.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace weft {
namespace {

/// A side of a triangle.
struct Side {
  std::uint32_t low = 0, high = 0;  // its nodes
  std::uint32_t apex = 0;           // the triangle's third
  bool rises = false;               // whether the triangle goes from low to high
};

/// Of all triangles; those of an edge stand together.
std::vector<Side> sides_of(std::span<const mesh::Triangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const mesh::Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t[(k + 2) % 3], a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.rises, a.apex) < std::tie(b.low, b.high, b.rises, b.apex);
  });
  return sides;
}

Result<void> check_closed(const scene::Cloth& cloth, std::span<const mesh::Triangle> triangles) {
  const std::vector<Side> sides = sides_of(triangles);
  std::size_t edges = 0, open = 0, turned = 0;
  for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
    while (next < sides.size() && sides[next].low == sides[first].low &&
           sides[next].high == sides[first].high)
      ++next;
    ++edges;
    if (next - first != 2)
      ++open;
    else if (sides[first].rises == sides[first + 1].rises)
      ++turned;
  }
  if (open > 0)
    return input_error(
        "%s.pressure needs a closed mesh; %zu of the %zu edges of \"%s\" have not two triangles.",
        cloth.where.c_str(), open, edges, cloth.mesh.c_str());
  if (turned > 0)
    return input_error(
        "%s.pressure needs triangles that all face outward; at %zu of the %zu edges of \"%s\" two turn "
        "against each other.",
        cloth.where.c_str(), turned, edges, cloth.mesh.c_str());
  return {};
}

/// Six times by how much the volume grows as each node moves [m²].
std::vector<Vec3d> six_slopes(std::span<const mesh::Triangle> triangles, std::span<const Vec3d> places) {
  std::vector<Vec3d> slopes(places.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3d normal = cross(places[b] - places[a], places[c] - places[a]);
    for (const std::uint32_t node : {a, b, c}) slopes[node] += normal;
  }
  return slopes;
}

}  // namespace

Result<gas::Law> enclosed_gas(const scene::Cloth& cloth, std::span<const mesh::Triangle> triangles,
                              std::span<const Vec3d> places) {
  WEFT_CHECK(check_closed(cloth, triangles));
  const scene::Pressure& pressure = *cloth.pressure;
  const double volume = mesh::signed_volume(triangles, places);
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += length(cross(places[b] - places[a], places[c] - places[a])) / 2;
  constexpr double kFlat = 1e-6;  // by the area: what places in f32 give a cloth that has no inside
  if (volume < -kFlat * std::pow(area, 1.5))
    return input_error(
        "%s.pressure needs triangles that all face outward; those of \"%s\" face inward, "
        "around %g m³.",
        cloth.where.c_str(), cloth.mesh.c_str(), -volume);
  const bool changes = pressure.law == scene::GasLaw::Isothermal;
  if (changes && volume < kFlat * std::pow(area, 1.5))
    return input_error(
        "%s.pressure.law is \"isothermal\", and \"%s\" encloses only %g m³ at rest; \"constant\" "
        "needs no volume.",
        cloth.where.c_str(), cloth.mesh.c_str(), volume);
  return gas::Law{std::max(volume, 0.0), changes ? pressure.ambient + pressure.gauge : 0, pressure.gauge};
}

double gas_stiffness(const Model& model, const Body& body) {
  if (!body.gas) return 0;
  const std::vector<mesh::Triangle> triangles = own_triangles(model, body);
  const std::span<const Vec3d> places =
      std::span(model.rest_position).subspan(body.first_vertex, body.vertex_count);
  const std::vector<Vec3d> slopes = six_slopes(triangles, places);
  // Of the two triangles at an edge, what one end's slope changes by with the other end: the way between their third
  // nodes. A row's sum of |entries| bounds the eigenvalues.
  std::vector<double> rows(body.vertex_count);
  const std::vector<Side> sides = sides_of(triangles);
  for (std::size_t k = 0; k < sides.size(); k += 2) {
    const double across = length(places[sides[k].apex] - places[sides[k + 1].apex]) / 6;
    rows[sides[k].low] += across;
    rows[sides[k].high] += across;
  }
  double of_volume = 0, of_slopes = 0;
  for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
    const double inverse_mass = 1 / model.mass[body.first_vertex + node];
    of_volume += inverse_mass * dot(slopes[node], slopes[node]) / 36;
    of_slopes = std::max(of_slopes, inverse_mass * rows[node]);
  }
  const gas::Law& gas = *body.gas;
  return gas.stiffness(gas.rest_volume) * of_volume + std::abs(gas.rest_gauge) * of_slopes;
}

}  // namespace weft
