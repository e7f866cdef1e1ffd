#include "contact/rules/yielding_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "contact/rules/contact_law.hpp"
#include "model/cloth_size.hpp"
#include "model/sheet_moduli.hpp"

namespace weft {

namespace {

constexpr double kAnyTime = 1e9;  // longer than any substep [s]

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

double own_push_time(const Model& model, bool held) {
  return held ? std::min(kOwnPushPulls * pull_time(model), kAnyTime) : kAnyTime;
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
