// What projective dynamics' iterations leave: their bound against the eigenvalues, their weights against a polynomial's
// bounds, and what a substep brings down, in double. Source: docs/solvers/projective_dynamics.md, equations 6 to 10.
#include <Eigen/Dense>
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

/// The largest eigenvalue of M⁻¹ L of free nodes, L the Laplacian of the springs' stiffness.
double exact_rate(const Model& model) {
  const auto count = static_cast<Eigen::Index>(model.mass.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  for (const Spring spring : model.springs()) {
    const std::array nodes = {spring.node_a, spring.node_b};
    for (const std::uint32_t i : nodes)
      for (const std::uint32_t j : nodes)
        matrix(i, j) += (i == j ? 1 : -1) * static_cast<double>(spring.stiffness) *
                        std::sqrt(model.inverse_mass(i) * model.inverse_mass(j));
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues().maxCoeff();
}

}  // namespace

TEST_CASE(
    "projective_dynamics relaxes by no less than the largest eigenvalue, pinned or free, grid or mesh") {
  for (const char* cloth : {R"("grid": [9, 7], "size": [1, 0.7])", R"("grid": [2, 12], "size": [0.1, 3])",
                            R"("mesh": "a.obj")", R"("mesh": "a.obj", "pins": [{"nodes": [1, 5]}])"})
    for (const char* stiffness :
         {R"("structural": 500, "shear": 200, "bend": 20)", R"("structural": 1, "shear": 0, "bend": 900)"}) {
      CAPTURE(cloth);
      CAPTURE(stiffness);
      const auto scene = scene_of(std::string(R"("cloths": [{"density": 0.2, "stiffness": {)") + stiffness +
                                  "}, " + cloth + "}]");
      auto model = build_model(scene, {mesh::make_sphere(9, 6)});
      REQUIRE_OK(model);
      const double exact = exact_rate(*model), rate = cloth_rates(*model, model->bodies[0]).stiffness;
      MESSAGE("bound over eigenvalue: " << rate / exact);
      CHECK(rate > exact * (1 - 1e-12));
      // Gershgorin's bound, with which it begins, is twice the largest entry of the diagonal, and the largest
      // eigenvalue is not below that entry.
      CHECK(rate < 2 * exact * (1 + 1e-12));
    }
}

TEST_CASE(
    "a cycle of Chebyshev's weights leaves a tenth of what it reaches, turns no more, and adds to nothing") {
  for (const std::uint32_t iterations : {1U, 2U, 5U, 13U, 20U, 1000U})
    for (const double rate : {0.0, 0.1, 3.0, 1e3, 1e12}) {
      CAPTURE(iterations);
      CAPTURE(rate);
      const Relaxation relaxation = make_relaxation(rate, iterations);
      std::size_t count = 0;
      for (const std::vector<double>& weights : relaxation.cycles) count += 1 + weights.size();
      REQUIRE(count == iterations);
      for (const std::vector<double>& weights : relaxation.cycles)
        for (int i = 0; i <= 1000; ++i) {
          const double eigenvalue = 1 + rate * i / 1000, gain = relaxation.gain(rate);
          double left = 1 - gain * eigenvalue, before = 1;
          for (const double weight : weights) {
            const double next = left - weight * gain * eigenvalue * left + (weight - 1) * (left - before);
            before = left;
            left = next;
          }
          CHECK(left > -0.1 * (1 + 1e-9));
          CHECK(left < 1);
          if (rate <= reached_rate(iterations)) CHECK(left < 0.1 * (1 + 1e-9));
          if (rate <= 0.1 && weights.size() >= 9)
            CHECK(std::abs(left) < 1e-6);  // it knows how little is to be done
        }
    }
}

TEST_CASE(
    "each projective_dynamics cycle brings a substep's inertia and energy down, however long the step") {
  GpuFixture fixture;
  // Of 10 iterations each; cycles of fewer, which have other weights, are compared with the start alone.
  for (const double stiffer : {1.0, 100.0})
    for (const double h : {1e-3, 1.0 / 120, 1.0}) {
      CAPTURE(stiffer);
      CAPTURE(h);
      const auto scene =
          scene_of(R"("cloths": [{"grid": [24, 17], "size": [0.46, 0.32], "pins": ["top"],
          "damping": 0, "density": 0.2, "stiffness": {"structural": )" +
                   std::to_string(500 * stiffer) + R"(, "shear": )" + std::to_string(200 * stiffer) +
                   R"(, "bend": )" + std::to_string(20 * stiffer) + "}}]");
      SolverRig rig(fixture.device(), scene, h);
      rig.perturb(3, 0.02, 5);  // a cell
      const reference::MassSpringSystem start = rig.reference();
      /// Φ of the ways to these places [J].
      const auto objective = [&](const std::vector<Vec3d>& end) {
        double sum = 0;
        for (std::size_t i = 0; i < end.size(); ++i) {
          if (start.inverse_mass[i] == 0) continue;
          const Vec3d off = end[i] - start.position[i] - h * (start.velocity[i] + h * start.acceleration);
          sum += dot(off, off) / (2 * h * h * start.inverse_mass[i]);
        }
        for (const auto& s : start.springs) sum += spring::energy(end[s.node_b] - end[s.node_a], s.law());
        return sum;
      };
      const auto after = [&](std::uint32_t iterations) {
        reference::MassSpringSystem system = start;
        reference::ProjectiveDynamicsStepper(rig.model().host, h, iterations)
            .advance({system, start.position, h});
        return objective(system.position);
      };
      std::vector<Vec3d> guess = start.position;
      for (std::size_t i = 0; i < guess.size(); ++i)
        if (start.inverse_mass[i] > 0) guess[i] += h * (start.velocity[i] + h * start.acceleration);
      double before = objective(guess);
      for (std::uint32_t iterations = 1; iterations < 10; ++iterations) {
        CAPTURE(iterations);
        CHECK(after(iterations) < before);
      }
      for (std::uint32_t cycles = 1; cycles <= 20; ++cycles) {
        CAPTURE(cycles);
        const double now = after(10 * cycles);
        CHECK(now <= before * (1 + 1e-12));  // where nothing is left, it is rounded
        before = now;
      }
    }
}
