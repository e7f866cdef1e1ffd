// Small scenes in which contact is held against mechanics, by both solvers, and what of them is compared. No number
// here comes from the contact law itself, but that it pushes apart what is too near at 0.5 m/s, and in position only.
#pragma once

#include <bit>

#include "contact_rig.hpp"
#include "method/method.hpp"
#include "scene/names.hpp"
#include "state/contact_pairs.hpp"

namespace weft {

inline constexpr const char* kSolvers[] = {"mass_spring", "multigrid"};
/// Of all methods.
inline std::vector<std::string> every_solver() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.push_back(scene::name_of(method.kind));
  return names;
}
inline const std::string kPlane = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]})";

/// What scenes here differ by.
struct Setting {
  std::string solver = "mass_spring";
  std::string gravity = "[0, -9.81, 0]";
  std::string contact = R"("thickness": 0.01)";
  int substeps = 0;  // of a frame; 0: as "auto" has for the implicit solver, and 8 for others
  int part = 1;      // a frame is this part of 1/60 s
  std::string cloths;
  std::string colliders;
};

inline scene::Scene scene_of(const Setting& s) {
  const int substeps = s.substeps != 0 ? s.substeps : s.solver == "multigrid" ? 6 : 8;
  return contact_scene(R"("gravity": )" + s.gravity + R"(, "time": {"frame": )" + text_of(1.0 / 60 / s.part) +
                       R"(, "substeps": )" + std::to_string(substeps) + R"(}, "solver": {"kind": ")" +
                       s.solver + R"("}, "contact": {"method": "proximity", )" + s.contact +
                       R"(}, "cloths": [)" + s.cloths + R"(], "colliders": [)" + s.colliders + "]");
}

inline std::unique_ptr<sim::World> world_on(gpu::Device& device, const Setting& setting, double cell = 0.05,
                                            double size = 0.6) {
  const scene::Scene scene = scene_of(setting);
  const auto assets = load_assets(scene, [&](const std::string&) -> Result<mesh::TriangleMesh> {
    return floor_of(cell, -0.5 * size, 0.5 * size, size);
  });
  return world_from(device, scene, assets);
}

inline double total(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

inline double highest(const Moment& now) {
  double most = -1e9;
  for (const Vec3d& p : now.position) most = std::max(most, p.y);
  return most;
}
inline double mean_height(const Moment& now, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t i = begin; i < end; ++i) sum += now.position[i].y;
  return sum / static_cast<double>(end - begin);
}

inline Vec3d momentum_of(const Moment& now) { return now.momentum(0, now.position.size()); }
/// About where the cloth began, far from nothing [kg·m²/s].
inline Vec3d spin_of(const Moment& now) {
  Vec3d sum;
  for (std::size_t i = 0; i < now.position.size(); ++i)
    sum += now.mass[i] * cross(now.position[i], now.velocity[i]);
  return sum;
}

/// Edges of cloth through triangles of cloth, by exact signs.
inline std::size_t tangles(const sim::World& world, const Moment& now) {
  return reference::self_crossings({now.position, world.model().host.triangles}).size();
}

/// The force of obstacles on cloth, and between cloths of `nodes` each, by the number of the upper one [N].
struct Forces {
  Vec3d ground;
  std::vector<double> up;  // of layer k on layer k + 1
};
inline Forces forces_of(sim::World& world, std::size_t nodes) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  Forces forces;
  forces.up.assign(snapshot->position.size() / nodes, 0);
  const std::vector<std::uint32_t>& words = snapshot->contact_forces;
  REQUIRE(words.size() % kKeptWords == 0);
  for (std::size_t at = 0; at < words.size(); at += kKeptWords) {
    const Vec3d on_a{std::bit_cast<float>(words[at + 4]), std::bit_cast<float>(words[at + 5]),
                     std::bit_cast<float>(words[at + 6])};
    const auto layer = [&](std::size_t role) { return (words[at + role] & kIdBits) / nodes; };
    const bool plane = (words[at + 1] & kPairFlag) != 0, edges = (words[at] & kPairFlag) != 0;
    const std::size_t b = edges ? 2 : 1;
    if ((words[at] & kColliderPoint) != 0)
      forces.ground -= on_a;
    else if (plane || (words[at + b] & kColliderPoint) != 0)
      forces.ground += on_a;
    else if (layer(0) != layer(b))
      forces.up[std::min(layer(0), layer(b))] += layer(0) > layer(b) ? on_a.y : -on_a.y;
  }
  return forces;
}

}  // namespace weft
