// Sheets for the tests of the multigrid reference: flat, wrinkled, random, of any size.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/random.hpp"
#include "method/multigrid/reference/implicit_step.hpp"
#include "scene/load.hpp"

namespace weft {

struct Sheet {
  Model model;
  reference::MassSpringSystem system;
  reference::ImplicitStepper stepper;

  /// A scene's `cloths`, and what else it says; with the mesh of each that is one.
  explicit Sheet(const std::string& members, std::vector<mesh::TriangleMesh> meshes = {})
      : Sheet(scene_of(members), std::move(meshes)) {}
  explicit Sheet(const scene::Scene& scene, std::vector<mesh::TriangleMesh> meshes = {})
      : model(model_of(scene, std::move(meshes))), stepper(model, 1.0 / 480) {
    system.position = model.start_position;
    system.velocity.resize(model.vertex_count());
    for (std::size_t node = 0; node < model.vertex_count(); ++node)
      system.inverse_mass.push_back(model.inverse_mass(node));
    for (const Spring s : model.springs())
      system.springs.push_back({s.node_a, s.node_b, static_cast<double>(s.rest_length),
                                static_cast<double>(s.stiffness), static_cast<double>(s.damping)});
    system.acceleration = {0, -9.81, 0};
  }

  /// The linear system of the next step, 1/480 s long by default.
  reference::LinearStep linearise(double dt = 1.0 / 480, double ratio = 1) const {
    return stepper.linearise(system, system.position, dt, ratio, 0);
  }
  /// The same for a cloth that is a mesh.
  reference::MeshStep linearise_mesh(double dt = 1.0 / 480, double ratio = 1) const {
    return stepper.linearise_mesh(system, system.position, dt, ratio, 0);
  }
  /// Where the kernels' cycles for the only cloth end, with steps of `dt`.
  multigrid::Bottom bottom(double dt = 1.0 / 480) const {
    const Body& body = model.bodies[0];
    if (body.grid) return multigrid::bottom_of(multigrid::grid_scales(model, body, dt), multigrid::kGridTail);
    const std::vector<MeshLevel> levels = mesh_levels(model, body, model.springs(body));
    return multigrid::bottom_of(multigrid::mesh_scales(model, {{&body, 1}}, levels, dt),
                                multigrid::kMeshTail);
  }
  /// How their finest level smooths.
  multigrid::Smoothing finest(double dt = 1.0 / 480) const {
    return multigrid::finest_smoothing(model, multigrid::kind_of(model.bodies[0]), dt);
  }
  void advance(double dt, int steps) {
    for (int s = 0; s < steps; ++s) stepper.advance({system, system.position, dt});
  }
  double mass(std::size_t node) const { return 1 / system.inverse_mass[node]; }

  /// Folds and small wrinkles out of the plane of a flat sheet of this size [m], and speeds.
  void wrinkle(double size, double amplitude) {
    Random random(7);
    double phase[6];
    for (double& p : phase) p = random.uniform(0, 6.28);
    for (std::size_t node = 0; node < system.position.size(); ++node) {
      if (system.inverse_mass[node] == 0) continue;
      Vec3d& x = system.position[node];
      const double s = 6.28 * x.x / size, t = 6.28 * x.z / size;
      x.y += amplitude * (std::sin(3 * s + phase[0]) + 0.3 * std::sin(11 * s + 4 * t + phase[1]) +
                          0.15 * std::sin(5 * s - 23 * t + phase[2]));
      system.velocity[node] = {0.3 * std::sin(2 * t + phase[3]), -1 + 0.5 * std::sin(4 * s + phase[4]),
                               0.3 * std::sin(7 * s + t + phase[5])};
    }
  }
  /// Moves free nodes by up to `amount` [m] a side, and gives them up to `speed` [m/s].
  void perturb(std::uint64_t seed, double amount, double speed) {
    Random random(seed);
    const auto draw = [&](double size) {
      const double x = random.uniform(-size, size), y = random.uniform(-size, size);
      return Vec3d{x, y, random.uniform(-size, size)};
    };
    for (std::size_t node = 0; node < system.position.size(); ++node) {
      const Vec3d move = draw(amount), push = draw(speed);
      if (system.inverse_mass[node] == 0) continue;
      system.position[node] += move;
      system.velocity[node] += push;
    }
  }

 private:
  static scene::Scene scene_of(const std::string& members) {
    auto scene = scene::parse_scene(
        R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"}, )" + members + "}", "test.json");
    REQUIRE_MESSAGE(scene, scene.error().message);
    return std::move(*scene);
  }
  static Model model_of(const scene::Scene& scene, std::vector<mesh::TriangleMesh> meshes) {
    meshes.resize(scene.cloths.size());
    auto made = build_model(scene, meshes);
    REQUIRE_MESSAGE(made, made.error().message);
    return std::move(*made);
  }
};

/// A thin fabric: 2 m by 2 m, 2000 N/m, pinned by two clips of 5 cm.
inline std::string thin_sheet(std::uint32_t nx, std::uint32_t ny, const std::string& more = "") {
  return R"("cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
         R"(], "size": [2, 2], "plane": "xz", "bump": 0.001, "density": 0.15, "damping": 0,
            "stiffness": {"structural": 1500, "shear": 750, "bend": 0, "bending": 1e-5},
            "pins": [{"near": {"point": [-1, 0, -1], "radius": 0.05}},
            {"near": {"point": [1, 0, -1], "radius": 0.05}}])" +
         more + "}]";
}

/// From node a to node b where their element is linearised: docs/solvers/multigrid.md, equation 5b.
inline Vec3d led_span(const reference::StepStart& step, std::size_t a, std::size_t b) {
  const Vec3d now = step.place[b] - step.place[a], way = step.start[b] - step.start[a];
  const double turn = 16 * dot(way, way) / dot(now, now);
  return step.leads ? now + std::max(0.0, 1 - turn * turn) * way : now;
}

inline double norm(const reference::Field& field) {
  double sum = 0;
  for (const Vec3d& v : field) sum += dot(v, v);
  return std::sqrt(sum);
}

}  // namespace weft
