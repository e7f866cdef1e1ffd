#include "method/multigrid/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "element/hinge/plate.hpp"
#include "model/cloth_size.hpp"

namespace weft::multigrid {
namespace {

/// No eigenvalue of elements exceeds the number of their nodes; nor that of bending's second differences 8/3, inside.
constexpr double kOfSprings = 2, kOfDifferences = 8.0 / 3, kOfMembranes = 3, kOfHinges = 4;

/// Between two bounds, by the part that the second one's elements have in a diagonal with inertia.
double between(double first, double second, double stiffness, double inertia) {
  return first + (second - first) * stiffness / (stiffness + inertia);
}

/// The inertia of a node in the diagonal, without a history, which has the least of it [N/m].
double inertia_of(const Model& model, const Body& body, double step) {
  return mass_of(model, body) / (step * step) / body.vertex_count;
}

double grid_bound(const Model& model, const Body& body, double step) {
  const auto [along_i, along_j] = bending_stiffness(body);
  return between(kOfSprings, kOfDifferences, 6 * (along_i + along_j), inertia_of(model, body, step));
}

/// How far the corners of a hinge move as it bends by a radian, at most [1/m]: each triangle's part, as it is at rest.
std::array<double, 4> most_slopes(const Model& model, const Body& body,
                                  std::span<const mesh::Triangle> triangles, const hinge::Hinge& hinge) {
  std::array<double, 4> most{};
  for (const std::size_t side : {0, 1}) {
    const std::uint32_t triangle = hinge.triangles[side];
    const std::array<Vec3d, 3> corners = rest_corners(model, body, triangle);
    const auto place = [&](std::uint32_t node) {
      const mesh::Triangle& nodes = triangles[triangle];
      return corners[static_cast<std::size_t>(std::find(nodes.begin(), nodes.end() - 1, node) -
                                              nodes.begin())];
    };
    const Vec3d a = place(hinge.nodes[0]), c = place(hinge.nodes[2 + side]), edge = place(hinge.nodes[1]) - a;
    const double slope = length(edge) / length(cross(edge, c - a)), foot = dot(c - a, edge) / dot(edge, edge);
    most[0] += std::abs(foot - 1) * slope;
    most[1] += std::abs(foot) * slope;
    most[2 + side] = slope;
  }
  return most;
}

/// Where hinges have the greatest part in a node. They may become so much stiffer as triangles are pressed.
double fabric_bound(const Model& model, const Body& body, double step) {
  constexpr double kPressed = 2;
  const hinge::Plate& plate = model.plate(body);
  const std::vector<double> bounds = hinge::stiffness_bounds(plate);
  const std::vector<mesh::Triangle> triangles = own_triangles(model, body);
  const double damped = 1 + body.fabric->damping / step;
  std::vector<double> stiffness(body.vertex_count, 0);
  for (std::size_t h = 0; h < bounds.size(); ++h) {
    const std::array<double, 4> slopes = most_slopes(model, body, triangles, plate.hinges[h]);
    for (std::size_t k = 0; k < slopes.size(); ++k)
      stiffness[plate.hinges[h].nodes[k]] += kPressed * damped * bounds[h] * slopes[k] * slopes[k];
  }
  double bound = kOfMembranes;
  for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
    const double inertia = model.mass[body.first_vertex + node] / (step * step);
    bound = std::max(bound, between(kOfMembranes, kOfHinges, stiffness[node], inertia));
  }
  return bound;
}

}  // namespace

Sweep sweep_of(const Smoothing& smoothing, std::uint32_t number) {
  const double middle = (smoothing.high + smoothing.low) / 2, half = (smoothing.high - smoothing.low) / 2;
  Sweep sweep{0, 1 / middle};
  double rho = half / middle;
  for (std::uint32_t k = 0; k < number; ++k) {
    const double next = 1 / (2 * middle / half - rho);
    sweep = {next * rho, 2 * next / half};
    rho = next;
  }
  return sweep;
}

CycleKind kind_of(const Body& body) {
  if (body.solid) return CycleKind::Tets;
  if (body.fabric) return CycleKind::Fabric;
  return body.grid ? CycleKind::Grid : CycleKind::Springs;
}

Smoothing finest_smoothing(const Model& model, CycleKind kind, double step) {
  if (kind == CycleKind::Tets) return {};
  double bound = kOfSprings;
  for (const Body& body : model.bodies) {
    if (kind_of(body) != kind) continue;
    if (kind == CycleKind::Fabric)
      bound = std::max(bound, kElementDiagonalPart * fabric_bound(model, body, step));
    else if (kind == CycleKind::Grid)
      bound = std::max(bound, grid_bound(model, body, step));
  }
  return kind == CycleKind::Grid ? Smoothing{2, bound / 8, bound} : Smoothing{4, bound / 30, bound};
}

}  // namespace weft::multigrid
