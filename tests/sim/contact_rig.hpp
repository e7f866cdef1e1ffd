// Worlds of contact for tests: scenes by text, states set and read in double, the audit of a state.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/reference/proximity/audit.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "reference/simulation.hpp"
#include "scene/motion.hpp"
#include "world_rig.hpp"

namespace weft {

/// Of mass_spring where the members name no solver.
inline scene::Scene contact_scene(const std::string& members) {
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", )" + members + "}", "contact.json");
  REQUIRE_OK(scene);
  if (scene->solver.kind == scene::SolverKind::Auto) scene->solver.kind = scene::SolverKind::MassSpring;
  return std::move(*scene);
}

/// A cloth of 0.4 m by 0.4 m that lies at a height [m]; soft enough for eight substeps.
inline std::string lying_cloth(int side, const std::string& translate, const std::string& more = "") {
  const std::string count = std::to_string(side);
  return R"({"grid": [)" + count + "," + count +
         R"(], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {"translate": )" +
         translate + "}" + more + "}";
}

/// A flat floor of right triangles with legs of `cell`, from x = `begin` to `end` and this wide [m].
inline mesh::TriangleMesh floor_of(double cell, double begin, double end, double width) {
  mesh::TriangleMesh floor;
  const auto nx = static_cast<std::uint32_t>(std::lround((end - begin) / cell));
  const auto nz = static_cast<std::uint32_t>(std::lround(width / cell));
  for (std::uint32_t j = 0; j <= nz; ++j)
    for (std::uint32_t i = 0; i <= nx; ++i)
      floor.positions.push_back(Vec3d{begin + i * cell, 0, (j - 0.5 * nz) * cell}.to<float>());
  for (std::uint32_t j = 0; j < nz; ++j)
    for (std::uint32_t i = 0; i < nx; ++i) {
      const std::uint32_t at = j * (nx + 1) + i, over = at + nx + 1;
      floor.triangles.push_back({at, over, at + 1});
      floor.triangles.push_back({at + 1, over, over + 1});
    }
  return floor;
}

inline constexpr double kGravity = 9.81;  // [m/s²]

inline std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

struct Moment {
  std::vector<Vec3d> position, velocity;  // [m], [m/s]
  std::vector<double> mass;               // 0: kinematic [kg]

  explicit Moment(sim::World& world) {
    const auto snapshot = world.snapshot();
    REQUIRE_OK(snapshot);
    for (const Vec4f& p : snapshot->position) {
      position.push_back(p.xyz().to<double>());
      mass.push_back(p.w > 0 ? 1 / static_cast<double>(p.w) : 0);
    }
    for (const Vec4f& v : snapshot->velocity) velocity.push_back(v.xyz().to<double>());
  }
  Vec3d momentum(std::size_t begin, std::size_t end) const {
    Vec3d sum;
    for (std::size_t i = begin; i < end; ++i) sum += mass[i] * velocity[i];
    return sum;
  }
  Vec3d spin() const {
    Vec3d sum;
    for (std::size_t i = 0; i < mass.size(); ++i) sum += mass[i] * cross(position[i], velocity[i]);
    return sum;
  }
  Vec3d mean_position() const { return mean(position); }
  Vec3d mean_velocity() const { return mean(velocity); }
  double largest_speed() const {
    double largest = 0;
    for (const Vec3d& v : velocity) largest = std::max(largest, length(v));
    return largest;
  }
  bool finite() const {
    return std::all_of(position.begin(), position.end(), [](const Vec3d& p) {
      return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    });
  }

 private:
  static Vec3d mean(const std::vector<Vec3d>& values) {
    Vec3d sum;
    for (const Vec3d& value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
};

/// Puts in what `change` makes of each node's place [m] and velocity [m/s].
template <class Change>
void change_state(sim::World& world, const Change& change) {
  auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  for (std::size_t i = 0; i < snapshot->position.size(); ++i) {
    Vec3d x = snapshot->position[i].xyz().to<double>(), v = snapshot->velocity[i].xyz().to<double>();
    change(i, x, v);
    snapshot->position[i] = Vec4f::from(x.to<float>(), snapshot->position[i].w);
    snapshot->velocity[i] = Vec4f::from(v.to<float>(), 0);
  }
  const auto restored = world.restore(*snapshot);
  REQUIRE_OK(restored);
}

/// Gives nodes from `begin` to before `end` a velocity [m/s].
inline void push(sim::World& world, std::size_t begin, std::size_t end, const Vec3d& velocity) {
  change_state(world, [&](std::size_t node, Vec3d&, Vec3d& v) {
    if (node >= begin && node < end) v = velocity;
  });
}

/// The world's springs and masses with the state `now`; its energy is kinetic, elastic and gravitational.
inline reference::MassSpringSystem system_of(const sim::World& world, const Moment& now) {
  reference::MassSpringSystem system;
  system.position = now.position;
  system.velocity = now.velocity;
  for (const double mass : now.mass) system.inverse_mass.push_back(mass > 0 ? 1 / mass : 0);
  system.springs = reference::spring_links(world.model().host);
  system.fabrics = reference::fabric_cloths(world.model().host);
  system.solids = reference::solid_bodies(world.model().host);
  system.acceleration = world.scene().gravity;
  return system;
}
inline double energy_of(const sim::World& world, const Moment& now) {
  return reference::energy(system_of(world, now));  // [J]
}

/// Everything that has passed through anything: cloth through cloth, through meshes and boxes as `objects`
/// has them now, and vertices inside spheres and below planes.
inline std::size_t passed(const sim::World& world, const Moment& now,
                          const std::vector<mesh::TriangleMesh>& objects) {
  const reference::Surfaces cloth{now.position, world.model().host.triangles};
  std::size_t count = reference::self_crossings(cloth).size();
  for (const mesh::TriangleMesh& object : objects) {
    const std::vector<Vec3d> corners = reference::widened(object.positions);
    count += reference::crossings(cloth, {corners, object.triangles}).size();
  }
  for (const scene::Collider& collider : world.scene().colliders) {
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider))
      count += reference::below_plane(now.position, *plane).count;
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      const Vec3d center =
          sphere->motion ? scene::motion_at(*sphere->motion, world.time())(sphere->center) : sphere->center;
      count += reference::inside_capsule(now.position, center, center, sphere->radius).count;
    }
  }
  return count;
}
inline std::size_t passed(sim::World& world) {
  const Moment now(world);
  REQUIRE(now.finite());
  return passed(world, now, world.assets().objects);
}

}  // namespace weft
