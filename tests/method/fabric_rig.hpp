// Cloths of fabric for tests of methods: on the GPU and in double, and what laws say of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "element/reference/equilibrium.hpp"
#include "gpu/gpu_fixture.hpp"
#include "mesh/irregular_meshes.hpp"
#include "method/method.hpp"
#include "method/perturb.hpp"
#include "method/stepper.hpp"
#include "solver_rig.hpp"

namespace weft {

inline std::string fabric_cloth(const std::string& shape, const std::string& fabric,
                                const std::string& more = "") {
  return "{" + shape + R"(, "density": 0.2, "fabric": {)" + fabric + "}" + more + "}";
}

inline const std::string kMesh = R"("mesh": "m")";
inline const std::string kGrid = R"("grid": [17, 12], "size": [0.32, 0.22])";
inline const std::string kWoven =
    R"("warp": 900, "weft": 300, "shear": 60, "poisson": 0.25, "bending_warp": 4e-4, "bending_weft": 1e-4,
      "damping": )";
inline const std::string kIsotropic =
    R"("energy": "neo_hookean", "warp": 500, "shear": 200, "poisson": 0.25, "bending_warp": 3e-4, "damping": )";

inline std::array<std::string, 3> fabrics(const std::string& damping) {
  return {kWoven + damping, kWoven + damping + R"(, "energy": "green")", kIsotropic + damping};
}

/// A mesh that is no plane at rest.
inline mesh::TriangleMesh curved_sheet() {
  mesh::TriangleMesh mesh = jittered_sheet(14, 11, 0.26, 0.2);
  for (Vec3f& p : mesh.positions) p.y = 1.5F * p.x * p.x - 0.8F * p.x * p.z;
  return mesh;
}

/// A scene's cloths by the substeps in double, without a GPU.
class Exact {
 public:
  Exact(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& meshes) : scene_(scene) {
    auto model = build_model(scene, meshes);
    REQUIRE_OK(model);
    model_ = std::make_unique<Model>(std::move(*model));
    for (std::size_t v = 0; v < model_->vertex_count(); ++v)
      system.inverse_mass.push_back(model_->inverse_mass(v));
    system.position = model_->start_position;
    system.velocity.resize(model_->vertex_count());
    system.fabrics = reference::fabric_cloths(*model_);
    system.acceleration = scene.gravity + scene.external_force;
    system.drag = scene.drag;
  }

  void advance(double dt, int steps) {
    const auto stepper = reference::make_stepper(scene_.solver, *model_, dt);
    for (int step = 0; step < steps; ++step) {
      const std::vector<Vec3d> places = system.position;  // held nodes stay
      stepper->advance({system, places, dt});
    }
  }
  void perturb(std::uint64_t seed, double amount, double speed) {
    weft::perturb(system, seed, amount, speed);
  }
  Vec3d momentum() const {
    Vec3d sum;
    for (std::size_t v = 0; v < system.position.size(); ++v)
      sum += system.velocity[v] / system.inverse_mass[v];
    return sum;
  }
  Vec3d spin() const {
    Vec3d sum;
    for (std::size_t v = 0; v < system.position.size(); ++v)
      sum += cross(system.position[v], system.velocity[v]) / system.inverse_mass[v];
    return sum;
  }
  const Model& model() const { return *model_; }

  reference::MassSpringSystem system;

 private:
  scene::Scene scene_;
  std::unique_ptr<Model> model_;
};

/// Where Newton's method has the cloth of a scene at rest: `mesh`, of 0.2 kg/m², with these nodes held.
inline std::vector<Vec3d> rest_of(const Exact& cloth, const scene::Scene& scene,
                                  const mesh::TriangleMesh& mesh, std::span<const std::uint32_t> held) {
  reference::Sheet sheet;
  sheet.rest = cloth.model().rest_position;
  sheet.triangles = mesh.triangles;
  sheet.held.assign(sheet.rest.size(), 0);
  for (const std::uint32_t node : held) sheet.held[node] = 1;
  sheet.membrane = cloth.system.fabrics[0].membranes.law;
  const scene::Fabric& woven = *scene.cloths[0].fabric;
  sheet.bending = {woven.bending_warp, 0, woven.bending_weft, woven.bending_twist};
  sheet.density = 0.2;
  sheet.gravity = scene.gravity;
  const auto rest = reference::equilibrium(reference::SheetEnergy(sheet), sheet.rest);
  REQUIRE_OK(rest);
  CHECK(rest->stable);
  return rest->position;
}

/// How far a cloth is from `rest`, and how far that is from where the model begins, at its farthest node [m].
struct FromRest {
  double apart = 0, way = 0;
};
inline FromRest from_rest(const Exact& cloth, const std::vector<Vec3d>& rest) {
  FromRest most;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    most.apart = std::max(most.apart, length(cloth.system.position[v] - rest[v]));
    most.way = std::max(most.way, length(rest[v] - cloth.model().rest_position[v]));
  }
  return most;
}

/// Multiplies the moduli of a scene's first cloth.
inline void stiffen(scene::Scene& scene, double scale) {
  scene::Fabric& woven = *scene.cloths[0].fabric;
  for (double* modulus : {&woven.warp, &woven.weft, &woven.shear, &woven.bending_warp, &woven.bending_weft,
                          &woven.bending_twist})
    *modulus *= scale;
}

/// Of a substep, what is left of the forces at its end, by their size: m (u - u₀) - h² f(x + u, u/h) by h² f, where u₀
/// is the way without elements. Backward Euler leaves nothing. `more` adds what the forces have beside those of
/// elements.md by the places where the substep began.
template <class More>
double left_of_backward_euler(Exact& cloth, double h, const More& more) {
  const std::vector<Vec3d> start = cloth.system.position, speed = cloth.system.velocity;
  cloth.advance(h, 1);
  const auto& end = cloth.system;
  std::vector<Vec3d> force(start.size());
  end.fabrics[0].add_forces(end.position, end.velocity, force);
  more(end, start, force);
  double left = 0, size = 0;
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (end.inverse_mass[v] == 0) continue;
    const Vec3d impulse = (end.velocity[v] - speed[v]) / (h * end.inverse_mass[v]);
    left += dot(impulse - force[v], impulse - force[v]);
    size += dot(force[v], force[v]);
  }
  return std::sqrt(left / size);
}

inline double left_of_backward_euler(Exact& cloth, double h) {
  return left_of_backward_euler(cloth, h, [](const auto&, const auto&, const auto&) {});
}

/// One substep from where the rig stands, in double.
inline reference::MassSpringSystem exact_after(SolverRig& rig, const scene::Scene& scene) {
  reference::MassSpringSystem system = rig.reference();
  const auto stepper = reference::make_stepper(scene.solver, rig.model().host, rig.dt());
  const std::vector<Vec3d> places = system.position;  // pinned nodes stay
  stepper->advance({system, places, rig.dt()});
  return system;
}

/// How far a substep is from the one in double, by the farthest that elements have moved a node.
inline double error_of_substep(SolverRig& rig, const scene::Scene& scene) {
  const reference::MassSpringSystem before = rig.reference(), exact = exact_after(rig, scene);
  rig.advance(1);
  const std::vector<Vec4f> found = rig.velocities();
  double most = 0, change = 0;
  for (std::size_t n = 0; n < found.size(); ++n) {
    most = std::max(most, length(found[n].xyz().to<double>() - exact.velocity[n]));
    change = std::max(change, length(exact.velocity[n] - before.velocity[n]));
  }
  REQUIRE(change > 0);
  return most / change;
}

/// All energies, damped or not, and one whose hinges hold nothing.
inline std::vector<std::string> varied_fabrics() {
  std::vector<std::string> all = {R"("warp": 900, "shear": 60, "bending_warp": 0)"};
  for (const std::string damping : {"0", "0.002"})
    for (const std::string& fabric : fabrics(damping)) all.push_back(fabric);
  return all;
}

/// A substep of cloths of fabric, of one sweep or three, beside that in double: a grid, and a mesh of 14 x 11 nodes.
/// `scene_with` makes a method's scene of a cloth and sweeps; `room` is the error that a rig's substep may have beside
/// that of places.
template <class SceneWith, class Room>
void check_substeps(gpu::Device& device, const SceneWith& scene_with, const Room& room,
                    const std::vector<std::string>& fabrics = varied_fabrics(),
                    const mesh::TriangleMesh& mesh = curved_sheet()) {
  for (const std::string& fabric : fabrics)
    for (const int iterations : {1, 3})
      for (const bool is_mesh : {false, true}) {
        CAPTURE(fabric);
        CAPTURE(iterations);
        CAPTURE(is_mesh);
        const std::string pins = is_mesh ? R"(, "pins": [{"nodes": [0, 1, 14]}])" : R"(, "pins": ["top"])";
        const scene::Scene scene =
            scene_with(fabric_cloth(is_mesh ? kMesh : kGrid, fabric, pins), iterations);
        SolverRig rig(device, scene, 1e-3, {is_mesh ? mesh : mesh::TriangleMesh{}});
        rig.perturb(5, 2e-3, 0.5);
        // Places of f32 err by 1e-8 m and are a tenth of a cell from rest, so that strains err by 1e-5 of themselves.
        const double most = 2e-5 + room(rig, iterations);
        const double error = error_of_substep(rig, scene);
        MESSAGE(error << " of " << most);
        CHECK(error < most);
      }
}

/// Cloths of a scene, whose places after 40 steps must not depend on the workgroups, nor on the run.
inline void check_bits(gpu::Device& device, const scene::Scene& scene,
                       const std::vector<mesh::TriangleMesh>& meshes) {
  std::vector<Vec4f> first;
  for (const std::uint32_t size : {64U, 64U, 256U}) {
    SolverRig rig(device, scene, 1e-3, meshes, size);
    rig.perturb(3, 2e-3, 0.5);
    rig.advance(40);
    if (first.empty()) first = rig.positions();
    CHECK(same_bits(rig.positions(), first));
  }
}

/// The energy of a sheet of fabric with so many times its moduli that begins as a heap (its nodes put off by half a
/// cell) or squeezed to a twentieth, in steps of 1/120 s [J].
struct Settled {
  double start = 0, most = 0, end = 0;
};
inline Settled settled(gpu::Device& device, scene::Scene scene, int scale, bool squeezed,
                       const mesh::TriangleMesh& mesh = curved_sheet()) {
  stiffen(scene, scale);
  SolverRig rig(device, scene, 1.0 / 120, {mesh});
  rig.perturb(9, squeezed ? 1e-3 : 0.01, 0);
  std::vector<Vec4f> position = rig.positions();
  if (squeezed)
    for (Vec4f& x : position) x = {0.05F * x.x, x.y, 0.05F * x.z, x.w};
  rig.set(position, std::vector<Vec4f>(position.size()));
  Settled energy{reference::energy(rig.reference())};
  for (int turn = 0; turn < 25; ++turn) {
    rig.advance(turn < 20 ? 1 : 96);
    energy.end = reference::energy(rig.reference());
    energy.most = std::max(energy.most, energy.end);
  }
  MESSAGE(std::string(squeezed ? "squeezed: " : "a heap: ")
          << energy.start << " J, at most " << energy.most << ", at the end " << energy.end);
  return energy;
}

}  // namespace weft
