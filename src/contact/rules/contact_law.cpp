#include "contact/rules/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/cloth_size.hpp"

namespace weft {
std::uint32_t contact_urgency(double gap, double thickness) {
  const double depth = std::clamp(1 - gap / thickness, 0.0, 1.0);
  return 1 + static_cast<std::uint32_t>(255 * depth * depth);
}

namespace {

constexpr std::uint32_t kLongStepIterations = 6, kMostIterations = 64;
constexpr double kHeavyRatio = 10;  // of densities, from which on impulses are iterated for it

/// Σ of the greatest density over that of each cloth that has a tenth of it or less.
double ratio_to_light(const Model& model) {
  std::vector<double> densities;  // of cloths at rest [kg/m²]
  for (const Body& body : model.bodies) {
    const double mass = mass_of(model, body), area = area_of(model, body);
    if (mass > 0 && area > 0) densities.push_back(mass / area);
  }
  if (densities.empty()) return 0;
  const double greatest = *std::max_element(densities.begin(), densities.end());
  double sum = 0;
  for (const double density : densities)
    if (greatest / density >= kHeavyRatio) sum += greatest / density;
  return sum;
}

}  // namespace

std::uint32_t contact_iterations(double step) {
  return step > 1e-3 ? kLongStepIterations : step > 5e-4 ? 2 : 1;
}

ImpulseRule impulse_rule(const Model& model, const scene::Contact& contact, double step) {
  const std::uint32_t usual = contact_iterations(step);
  if (usual == 1 && contact.self) return {usual, kLongStepIterations};
  if (usual < kLongStepIterations || !contact.self) return {usual, usual};
  const double wanted = std::ceil(4 * std::sqrt(ratio_to_light(model)));
  if (!(wanted > usual)) return {usual, usual};
  const auto most = static_cast<std::uint32_t>(std::min<double>(wanted, kMostIterations));
  return {most, most, true};
}

namespace {

double shortest_altitude(const Model& model, const Body& body, std::uint32_t triangle) {
  const auto [a, b, c] = rest_corners(model, body, triangle);
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  return longest > 0 ? length(cross(b - a, c - a)) / longest : 0;
}

/// b₁ where the shortest altitude is this [m].
double flat_slack(double altitude, double self_thickness) { return 0.5 * (0.95 * altitude - self_thickness); }

}  // namespace

double typical_altitude(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (const Body& body : model.bodies) {
    if (body.triangle_count == 0) continue;
    std::vector<double> altitudes;
    for (std::uint32_t t = 0; t < body.triangle_count; ++t)
      altitudes.push_back(shortest_altitude(model, body, t));
    const auto middle = altitudes.begin() + static_cast<std::ptrdiff_t>(altitudes.size() / 2);
    std::nth_element(altitudes.begin(), middle, altitudes.end());
    least = std::min(least, *middle);
  }
  return least;
}

double self_thickness(const Model& model, double thickness) {
  return std::min(thickness, 0.5 * typical_altitude(model));
}

double flat_reach(const Model& model, const scene::Contact& contact) {
  const double altitude = typical_altitude(model);
  if (!contact.self) return 0.5 * altitude;
  // h_s + 2b is below the altitude.
  return flat_slack(altitude, std::min(contact.thickness, 0.5 * altitude));
}

std::vector<double> most_slacks(const Model& model, double most_reach, double self_thickness) {
  std::vector<double> slacks(model.vertex_count(), most_reach);
  if (self_thickness == 0) return slacks;
  for (const Body& body : model.bodies)
    for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
      const double slack = flat_slack(shortest_altitude(model, body, t), self_thickness);
      const double own = std::clamp(slack, most_reach / 4, most_reach);
      for (const std::uint32_t vertex : model.triangles[body.first_triangle + t])
        slacks[vertex] = std::min(slacks[vertex], own);
    }
  return slacks;
}

}  // namespace weft
