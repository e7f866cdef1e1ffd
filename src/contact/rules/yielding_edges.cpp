#include "contact/rules/yielding_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "contact/rules/contact_law.hpp"
#include "model/cloth_size.hpp"
#include "model/sheet_moduli.hpp"
#include "model/solid.hpp"

namespace weft {

namespace {

std::vector<const Body*> cloths_of(const Model& model) {
  std::vector<const Body*> cloths;
  for (const Body& body : model.bodies)
    if (!body.solid && body.triangle_count > 0) cloths.push_back(&body);
  return cloths;
}

}  // namespace

double pull_time(const Model& model) {
  double slowness = std::numeric_limits<double>::infinity();  // of a pull [s/m]
  for (const Body* body : cloths_of(model)) {
    const Moduli stretch = sheet_moduli(model, *body).stretch;
    const double density = mass_of(model, *body) / area_of(model, *body);
    slowness = std::min(slowness, std::sqrt(density / std::max(stretch.warp, stretch.weft)));
  }
  return std::isinf(slowness) ? slowness : typical_altitude(model) * slowness;
}

double pull_time_of_bodies(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (const Body& body : model.bodies) {
    if (!body.solid) continue;
    const double volume = volume_of(model, body);
    const double slowness = std::sqrt(mass_of(model, body) / volume / body.solid->young);
    least = std::min(least, std::cbrt(volume / body.vertex_count) * slowness);
  }
  return least;
}

PushTimes push_times(const Model& model) {
  return {std::min(kOwnPushPulls * pull_time(model), kAnyTime),
          std::min(kOwnPushPulls * pull_time_of_bodies(model), kAnyTime)};
}

YieldingEdges yielding_edges(const Model& model, double substep) {
  YieldingEdges made{{}, pull_time(model)};
  if (!(made.time < substep)) return {};
  for (const Body* cloth : cloths_of(model)) {
    const std::vector<mesh::Edge> edges =
        mesh::mesh_edges(std::span(model.triangles).subspan(cloth->first_triangle, cloth->triangle_count));
    made.edges.insert(made.edges.end(), edges.begin(), edges.end());
  }
  return made;
}

}  // namespace weft
