#include "method/method.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/words.hpp"
#include "method/blow_step.hpp"
#include "scene/names.hpp"

namespace weft {
namespace {

bool takes(const Method& method, ElementKind kind) {
  return std::find(method.takes.begin(), method.takes.end(), kind) != method.takes.end();
}

/// None in the list: all are taken.
template <class Energy>
bool takes_of(std::span<const Energy> energies, Energy energy) {
  return energies.empty() || std::find(energies.begin(), energies.end(), energy) != energies.end();
}

constexpr double kFlat = 0.01;  // what positions in f32 make of small triangles in a plane [rad]

/// The largest angle between the plane of a triangle and that of the largest one, of a body of fabric at rest [rad].
double curved_at_rest(const Model& model, const Body& body) {
  std::vector<Vec3d> areas;
  for (std::uint32_t t = body.first_triangle; t < body.first_triangle + body.triangle_count; ++t) {
    const auto& [a, b, c] = model.triangles[t];
    const Vec3d& at = model.rest_position[a];
    areas.push_back(cross(model.rest_position[b] - at, model.rest_position[c] - at));
  }
  const Vec3d plane = *std::max_element(areas.begin(), areas.end(),
                                        [](const Vec3d& x, const Vec3d& y) { return dot(x, x) < dot(y, y); });
  double most = 0;
  for (const Vec3d& area : areas)  // whichever way round it goes
    most = std::max(most, std::atan2(length(cross(area, plane)), std::abs(dot(area, plane))));
  return most;
}

/// "a", "a" or "b", "a", "b" or "c".
template <class Does>
std::string words_of_methods(const Does& does) {
  std::vector<std::string> words;
  for (const Method& method : methods())
    if (does(method)) words.push_back('"' + std::string(scene::name_of(method.kind)) + '"');
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string words_of_tethered() {
  return words_of_methods([](const Method& method) { return method.tethers; });
}

}  // namespace

const Method& method_of(scene::SolverKind kind) {
  const auto rows = methods();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const Method& method) { return method.kind == kind; });
  assert(row != rows.end());  // every kind of scenes but Auto has a row: tests/method/test_methods.cpp
  return *row;
}

bool takes_energy(const Method& method, scene::FabricEnergy energy) {
  return takes(method, ElementKind::Membrane) && takes_of(method.energies, energy);
}

namespace {

Result<void> check_fabric(const scene::Cloth& cloth, const Model& model, const Body& body,
                          const Method& method) {
  const scene::FabricEnergy energy = body.fabric->energy;
  if (!takes_energy(method, energy))
    return input_error(
        "%s.fabric.energy is \"%s\", which solver.kind \"%s\" does not take; %s does.", cloth.where.c_str(),
        scene::kFabricEnergyNames[static_cast<std::size_t>(energy)], scene::name_of(method.kind),
        words_of_methods([&](const Method& other) { return takes_energy(other, energy); }).c_str());
  const scene::Fabric& fabric = *body.fabric;
  if (!method.flat_fabric || !fabric.bends()) return {};
  if (fabric.plastic)
    return input_error(
        "%s.fabric.plastic keeps bends, which solver.kind \"%s\" does not: it takes fabric that stays flat "
        "at rest; %s "
        "keeps them.",
        cloth.where.c_str(), scene::name_of(method.kind), words_of_methods([&](const Method& other) {
                                                            return takes_energy(other, energy) &&
                                                                   !other.flat_fabric;
                                                          }).c_str());
  const double curved = curved_at_rest(model, body);
  if (curved > kFlat)
    return input_error(
        "%s.fabric is curved by up to %.3g rad at rest, more than the %g that solver.kind \"%s\" takes; %s "
        "does.",
        cloth.where.c_str(), curved, kFlat, scene::name_of(method.kind),
        words_of_methods([&](const Method& other) {
          return takes_energy(other, energy) && !other.flat_fabric;
        }).c_str());
  return {};
}

bool takes_solid(const Method& method, scene::SolidEnergy energy) {
  return takes(method, ElementKind::Tet) && takes_of(method.solid_energies, energy);
}

Result<void> check_solid(const scene::Cloth& cloth, const Method& method) {
  const scene::SolidEnergy energy = cloth.solid->energy;
  if (takes_solid(method, energy)) return {};
  return input_error(
      "%s.material.energy is \"%s\", which solver.kind \"%s\" does not take; %s does.", cloth.where.c_str(),
      scene::kSolidEnergyNames[static_cast<std::size_t>(energy)], scene::name_of(method.kind),
      words_of_methods([&](const Method& other) { return takes_solid(other, energy); }).c_str());
}

Result<void> check_elements(const scene::Scene& scene, const Model& model, const Method& method) {
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    for (std::size_t k = 0; k < kElementKinds; ++k) {
      const auto kind = static_cast<ElementKind>(k);
      if (takes(method, kind) || model.count(kind, model.bodies[c]) == 0) continue;
      return input_error("%s has %s, which solver.kind \"%s\" does not take; %s does.",
                         scene.cloths[c].where.c_str(), kElementNames[k], scene::name_of(method.kind),
                         words_of_methods([&](const Method& other) { return takes(other, kind); }).c_str());
    }
    if (model.bodies[c].solid) WEFT_CHECK(check_solid(scene.cloths[c], method));
    if (model.bodies[c].fabric) WEFT_CHECK(check_fabric(scene.cloths[c], model, model.bodies[c], method));
    if (scene.cloths[c].fabric && !scene.cloths[c].seams.empty() && !method.sews_fabric)
      return input_error("%s has fabric and seams, and solver.kind \"%s\" sews no fabric; %s does.",
                         scene.cloths[c].where.c_str(), scene::name_of(method.kind),
                         words_of_methods([](const Method& other) { return other.sews_fabric; }).c_str());
    if (scene.cloths[c].strain_limit && !method.limits_strain)
      return input_error("%s.strain_limit is %g, and solver.kind \"%s\" keeps none; %s does.",
                         scene.cloths[c].where.c_str(), *scene.cloths[c].strain_limit,
                         scene::name_of(method.kind),
                         words_of_methods([](const Method& other) { return other.limits_strain; }).c_str());
    if (scene.cloths[c].tethers && !method.tethers)
      return input_error("%s.tethers has a slack of %g, and solver.kind \"%s\" keeps no tethers; %s does.",
                         scene.cloths[c].where.c_str(), scene.cloths[c].tethers->slack,
                         scene::name_of(method.kind), words_of_tethered().c_str());
  }
  return {};
}

/// Bodies that are dispatched together count once: grids of one size, one behind the other, as copies of a cloth are.
bool is_copy(const Model& model, std::size_t body) {
  if (body == 0) return false;
  if (model.bodies[body].fabric || model.bodies[body].solid) return false;
  const auto &grid = model.bodies[body].grid, &before = model.bodies[body - 1].grid;
  return grid && before && grid->nx == before->nx && grid->ny == before->ny;
}

/// A body's own, and what contact adds.
std::array<StepCost, 2> costs_of(const MethodCost& all, const Body& body) {
  if (body.fabric || body.solid) return {all.fabric, all.fabric_contact};  // of bodies nothing was measured
  if (body.grid) return {all.grid, all.grid_contact};
  return {all.mesh, all.mesh_contact};
}

/// How a method would step the scene, if it can. Errors  as choose_method.
Result<MethodChoice> choice_of(const scene::Scene& scene, const Model& model, const Method& method,
                               double lightest_rigid) {
  WEFT_CHECK(check_elements(scene, model, method));
  MethodChoice choice{&method, method.step_limit(scene, model)};
  if (lightest_rigid > 0 && method.blow_part > 0)
    choice.limit.longest_auto_step =
        std::min(choice.limit.longest_auto_step, blow_step(scene, model, lightest_rigid, method.blow_part));
  if (scene.time.substeps) {
    choice.substeps = *scene.time.substeps;
  } else {
    WEFT_SET(choice.substeps, method.auto_substeps(scene, choice.limit));
  }
  return choice;
}

std::string cost_of(const MethodChoice& choice, double milliseconds) {
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "%s %.2g ms in %s", scene::name_of(choice.method->kind),
                milliseconds, counted(choice.substeps, "substep", "substeps").c_str());
  return text.data();
}

/// "auto" takes none of the methods that keep tethers: what it would take of the scene without them.
Error auto_keeps_none(const scene::Scene& scene, const Model& model, double lightest_rigid,
                      const scene::Cloth& cloth) {
  scene::Scene without = scene;
  for (scene::Cloth& other : without.cloths) other.tethers.reset();
  const auto choice = choose_method(without, model, lightest_rigid);
  if (!choice) return choice.error();
  return input_error(
      "%s.tethers has a slack of %g, and solver.kind \"auto\", which takes \"%s\" here, keeps no tethers; %s "
      "does.",
      cloth.where.c_str(), cloth.tethers->slack, scene::name_of(choice->method->kind),
      words_of_tethered().c_str());
}

}  // namespace

double predicted_frame(const scene::Scene& scene, const Model& model, const Method& method,
                       std::uint32_t substeps) {
  double step = 0, contact = 0;  // contact has one set of dispatches for all cloths
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body& body = model.bodies[b];
    const auto [cost, more] = costs_of(*method.cost, body);
    step += cost.node * body.vertex_count + (is_copy(model, b) ? 0 : cost.step);
    if (scene.contact.method != scene::ContactMethod::Proximity) continue;
    step += more.node * body.vertex_count;
    contact = std::max(contact, more.step);
  }
  return substeps * (step + contact);
}

Result<MethodChoice> choose_method(const scene::Scene& scene, const Model& model, double lightest_rigid) {
  if (scene.solver.kind != scene::SolverKind::Auto)
    return choice_of(scene, model, method_of(scene.solver.kind), lightest_rigid);
  for (const scene::Cloth& cloth : scene.cloths)
    if (cloth.tethers) return auto_keeps_none(scene, model, lightest_rigid, cloth);
  std::optional<Error> refused;
  std::optional<MethodChoice> best, steadiest;  // the latter where no one is stable: the one that needs least
  double least = HUGE_VAL;
  std::string costs;
  for (const Method& method : methods()) {
    if (method.cost == nullptr) continue;
    Result<MethodChoice> choice = choice_of(scene, model, method, lightest_rigid);
    if (!choice) {
      refused = choice.error();
      continue;
    }
    if (!unstable_step(choice->limit, scene.time.frame, choice->substeps).empty()) {
      if (!steadiest || choice->limit.largest_step > steadiest->limit.largest_step)
        steadiest = std::move(*choice);
      continue;
    }
    const double cost = predicted_frame(scene, model, method, choice->substeps);
    costs += (costs.empty() ? "" : ", ") + cost_of(*choice, cost);
    if (cost >= least) continue;
    least = cost;
    best = std::move(*choice);
  }
  if (!best && steadiest) {
    steadiest->reason = "no method is stable in these steps";
    return std::move(*steadiest);
  }
  if (!best) return *refused;
  best->reason = "a frame is predicted to take " + costs;
  return std::move(*best);
}

namespace {

/// Whether there is what the method holds in its matrix or its sweeps, where nothing takes it out of them.
bool could_hold(const scene::Scene& scene, const Method& method) {
  return method.holds_obstacles && scene.contact.method == scene::ContactMethod::Proximity &&
         (!scene.colliders.empty() || scene.contact.self);
}

}  // namespace

SolvedContact solved_contact(const scene::Scene& scene, const Method& method) {
  // A force of the solver on an obstacle would not move a rigid body: impulses answer all then.
  const bool solves = could_hold(scene, method) && !leaves_obstacles(scene, method);
  const bool has_bodies = std::any_of(scene.cloths.begin(), scene.cloths.end(),
                                      [](const scene::Cloth& cloth) { return cloth.solid.has_value(); });
  return {solves, solves && method.holds_pairs && scene.contact.self, method.order > 1,
          method.bounds_nodes && has_bodies, solves && method.holds_pairs};
}

bool leaves_obstacles(const scene::Scene& scene, const Method& method) {
  return could_hold(scene, method) &&
         ((scene.contact.restitution > 0 && method.holds_pairs) || scene::has_rigid(scene));
}

}  // namespace weft
