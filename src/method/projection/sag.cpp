#include "method/projection/sag.hpp"

#include <algorithm>
#include <cmath>

#include "model/solid.hpp"
#include "scene/wind.hpp"

namespace weft {
namespace {

/// How many elements in a row reach across a cloth, and what these weigh.
struct Span {
  double extent = 0;   // diagonal of the box around it at rest [m]
  double spacing = 0;  // of its nodes: a triangle is half a square of that side [m]
  double density = 0;  // [kg/m²]
};

Span span_of(const Model& model, const Body& cloth) {
  double area = 0;
  Vec3d low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -1.0 * low;
  for (std::uint32_t t = 0; t < cloth.triangle_count; ++t) {
    const auto [x, y, z] = rest_corners(model, cloth, t);
    area += 0.5 * length(cross(y - x, z - x));
    for (const Vec3d& corner : {x, y, z})
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
  }
  double mass = 0;
  for (std::uint32_t v = cloth.first_vertex; v < cloth.first_vertex + cloth.vertex_count; ++v)
    mass += model.mass[v];
  return {length(high - low), std::sqrt(2 * area / cloth.triangle_count), mass / area};
}

/// The most that pulls at a cloth of this density [kg/m²] at rest, by its mass [m/s²]: `air` pushes at a triangle of
/// area A with at most ½ ρ A U² ((C_D + (C_D² + C_L²)^½) / 2 + C_F), over all angles to the wind.
double most_pull(const scene::Scene& scene, double density) {
  const scene::WindField wind = scene::wind_field(scene.wind);
  double speed = length(wind.velocity);
  for (const scene::WindWave& wave : wind.waves) speed += length(wave.gust);
  double pull = length(scene.gravity + scene.external_force) + scene.drag * speed;
  if (scene.air) {
    const scene::Air& air = *scene.air;
    const double along = (air.pressure + std::hypot(air.pressure, air.lift)) / 2 + air.friction;
    pull += 0.5 * air.density * speed * speed * along / density;
  }
  return pull;
}

/// By what part of itself, over h², one sweep lets a cloth of fabric be softer than its bending says [1/s²]:
/// k̄ Σ w |∂θ/∂x|², the mean of its hinges.
double softening(const Model& model, const Body& cloth) {
  const hinge::Plate& plate = model.plate(cloth);
  const std::vector<double> resistance = hinge::stiffness_bounds(plate);
  const FabricSheet sheet = fabric_sheet(model, cloth);
  double sum = 0, count = 0;
  for (std::size_t h = 0; h < plate.hinges.size(); ++h) {
    if (resistance[h] == 0) continue;
    const std::optional<hinge::Corners> corners = hinge::rest_corners(sheet.rest(), plate.hinges[h]);
    if (!corners) continue;
    const hinge::Corners slope = hinge::angle_slope(*corners);
    for (std::size_t i = 0; i < 4; ++i)
      sum += resistance[h] * model.inverse_mass(cloth.first_vertex + plate.hinges[h].nodes[i]) *
             dot(slope[i], slope[i]);
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Of a body with volume.
struct Bulk {
  double longest = 0, shortest = 0, diagonal = 0;  // of the box around it at rest [m]
  double density = 0;                              // by volume [kg/m³]
  double surface_density = 0;                      // by its surface [kg/m²]
  double softening = 0;  // of one sweep, over h²: the mean of V Σ w |n|² / 3 [m/kg]
};

Bulk bulk_of(const Model& model, const Body& body) {
  const tet::Tets tets = body_tets(model, body);
  Bulk bulk;
  double volume = 0, mass = 0;
  for (std::size_t t = 0; t < tets.tets.size(); ++t) {
    const tet::Rest& rest = tets.rests[t];
    for (std::size_t k = 0; k < 4; ++k)
      bulk.softening += rest.volume * rest.volume * model.inverse_mass(body.first_vertex + tets.tets[t][k]) *
                        dot(rest.slope[k], rest.slope[k]) / 3;
    volume += rest.volume;
  }
  Vec3d low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = -1.0 * low;
  for (std::uint32_t v = body.first_vertex; v < body.first_vertex + body.vertex_count; ++v) {
    mass += model.mass[v];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], model.rest_position[v][axis]);
      high[axis] = std::max(high[axis], model.rest_position[v][axis]);
    }
  }
  const Vec3d size = high - low;
  bulk.longest = std::max({size.x, size.y, size.z});
  bulk.shortest = std::min({size.x, size.y, size.z});
  bulk.diagonal = length(size);
  bulk.density = mass / volume;
  bulk.surface_density = span_of(model, body).density;
  bulk.softening /= volume;
  return bulk;
}

/// Equation (18) of docs/solvers/xpbd.md: the longest step of a body.
double solid_step(const scene::Scene& scene, const Model& model, const Body& body) {
  const Bulk bulk = bulk_of(model, body);
  const double weight = bulk.density * most_pull(scene, bulk.surface_density) * bulk.diagonal / 2;  // [Pa]
  const double slender = bulk.longest / bulk.shortest;
  const double load = std::min(body.solid->young, weight * std::max(1.0, 3 * slender * slender));
  if (load * bulk.softening == 0) return HUGE_VAL;
  return std::sqrt(scene.solver.iterations * kSag / (bulk.softening * load));
}

}  // namespace

StepLimit sag_limit(const scene::Scene& scene, const Model& model) {
  double step = kImplicitStep;
  for (const Body& cloth : model.bodies) {
    if (cloth.solid) {
      step = std::min(step, solid_step(scene, model, cloth));
      continue;
    }
    const Span span = span_of(model, cloth);
    const double gauge = cloth.gas ? std::abs(cloth.gas->rest_gauge) : 0;
    const double pull = most_pull(scene, span.density) + gauge / span.density;
    if (pull == 0) continue;
    step = std::min(step, span.spacing * std::sqrt(scene.solver.iterations * kSag / (pull * span.extent)));
    if (!cloth.fabric) continue;
    const double soft = softening(model, cloth);
    if (soft == 0) continue;
    const double bending = std::max(cloth.fabric->bending_warp, cloth.fabric->bending_weft);
    const double load = span.density * pull * span.extent * span.extent * span.extent / bending;  // w L³/B
    step = std::min(step, std::sqrt(8 * scene.solver.iterations * kSag / (soft * std::min(1.0, load))));
  }
  StepLimit limit;
  limit.longest_auto_step = step;
  return with_gas(limit, model, kMostOfGas);
}

}  // namespace weft
