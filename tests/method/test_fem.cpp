// Newton's method over elements: the kernels against the same substep in double, and against the balance of forces that
// it promises. What every method must do: test_every_method.cpp; in a world: tests/sim/test_every_method.cpp.
#include <algorithm>
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

std::string fem(int steps, double residual) {
  return R"("solver": {"kind": "fem", "iterations": )" + std::to_string(steps) + R"(, "residual": )" +
         std::to_string(residual) + "}, ";
}
const std::string kSprings = R"("density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 500, "shear": 200, "bend": 20})";
const std::string kFabric =
    R"("density": 0.2, "fabric": {"warp": 900, "weft": 300, "shear": 60, "poisson": 0.25,
    "bending_warp": 4e-4, "bending_weft": 1e-4, "damping": 0.001})";
const std::string kSheet = R"({"grid": [13, 9], "size": [0.6, 0.4], "pins": ["top_left"], )";
const std::string kBall = R"({"mesh": "a.obj", "pins": [{"nodes": [0]}], )";

std::vector<mesh::TriangleMesh> meshes_of(const std::string& shape) {
  return {shape == kBall ? mesh::make_sphere(12, 9) : mesh::TriangleMesh{}};
}

/// What backward Euler lacks at the end of a substep, m (v' - v)/h - m g - f(x', v') of a node, by the largest f.
double lack(const reference::MassSpringSystem& before, const reference::MassSpringSystem& after, double h) {
  const std::vector<Vec3d> force = reference::spring_forces(after);  // and of fabric
  double left = 0, most = 0;
  for (std::size_t n = 0; n < force.size(); ++n) {
    if (after.inverse_mass[n] == 0) continue;
    const Vec3d pull = (after.velocity[n] - before.velocity[n]) / h - after.acceleration;
    left = std::max(left, length(pull / after.inverse_mass[n] - force[n]));
    most = std::max(most, length(force[n]));
  }
  return left / most;
}

}  // namespace

TEST_CASE(
    "fem substeps equal the reference, of springs and of fabric, on grids and meshes, with few steps or "
    "many") {
  GpuFixture fixture;
  for (const std::string& shape : {kSheet, kBall})
    for (const std::string& cloth : {kSprings, kFabric})
      for (const int steps : {1, 2, 8}) {
        CAPTURE(shape);
        CAPTURE(cloth);
        CAPTURE(steps);
        const auto scene = scene_of(fem(steps, 1e-3) + R"("cloths": [)" + shape + cloth + "}]");
        SolverRig rig(fixture.device(), scene, 2e-3, meshes_of(shape));
        rig.perturb(5, 0.004, 1.0);
        const reference::MassSpringSystem before = rig.reference(), exact = exact_after(rig, scene, 1);
        rig.advance(1);
        const auto position = rig.positions();
        double way = 0, worst = 0;
        for (std::size_t n = 0; n < position.size(); ++n) {
          way = std::max(way, length(exact.position[n] - before.position[n]));
          worst = std::max(worst, length(position[n].xyz().to<double>() - exact.position[n]));
        }
        MESSAGE(worst << " m of " << way << " m");
        CHECK(worst < 1e-4 * way);  // both take the same iterations
      }
}

TEST_CASE("a fem substep is backward Euler: inertia, weight and the forces at its end balance") {
  GpuFixture fixture;
  for (const std::string& shape : {kSheet, kBall})
    for (const std::string& cloth : {kSprings, kFabric}) {
      CAPTURE(shape);
      CAPTURE(cloth);
      const auto left_by = [&](const std::string& solver) {
        SolverRig rig(fixture.device(), scene_of(solver + R"("cloths": [)" + shape + cloth + "}]"), 4e-3,
                      meshes_of(shape));
        rig.perturb(6, 0.004, 1.0);
        const reference::MassSpringSystem before = rig.reference();
        rig.advance(1);
        return lack(before, rig.reference(), rig.dt());
      };
      const double left = left_by(fem(30, 1e-4)), once = left_by(R"("solver": {"kind": "multigrid"}, )");
      MESSAGE(left << " of the largest force, by one linear system " << once);
      CHECK(left < 0.01);
      CHECK(once > 5 * left);
    }
}
