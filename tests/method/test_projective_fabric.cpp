// Projective dynamics over fabric: its energy beside the law of yarns and beside the bound that its matrix rests on,
// the kernels beside the same substep in double, and laws that neither was written from.
// Source: docs/solvers/projective_dynamics.md, Fabric.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fabric_rig.hpp"
#include "hanging_strips.hpp"
#include "method/projective_dynamics/bounded_yarns.hpp"
#include "method/projective_dynamics/node_pairs.hpp"
#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"
#include "model/fabric.hpp"

using namespace weft;

namespace {

using membrane::Axes;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

scene::Scene projective_scene(const std::string& cloths, int iterations = 20,
                              const std::string& world = R"("gravity": [0, 0, 0])") {
  return scene_of(world + R"(, "solver": {"kind": "projective_dynamics", "iterations": )" +
                  std::to_string(iterations) + R"(}, "cloths": [)" + cloths + "]");
}

mesh::TriangleMesh flat_sheet() { return jittered_sheet(14, 11, 0.26, 0.2); }

/// Of woven and knitted cloth, of cloth without a preferred direction, and of one that grows wider where it is pulled.
constexpr std::array kStiffnesses = {Stiffness{900, 25, 300, 60}, Stiffness{500, 160, 500, 170},
                                     Stiffness{40, 30, 60, 400}, Stiffness{200, -90, 150, 5}};

Axes axes_of(const Vector6& x) { return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}; }
Vector6 vector_of(const Axes& f) {
  return (Vector6() << f.warp.x, f.warp.y, f.warp.z, f.weft.x, f.weft.y, f.weft.z).finished();
}
Vector6 stress(const membrane::Law& law, const Vector6& x) {
  return vector_of(bounded_yarns::stress(law, axes_of(x), axes_of(x), 0));
}

/// Yarns of any lengths up to 2.5 and at any angle, also turned over.
Vector6 drawn(Random& random) {
  const auto column = [&] {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    return random.uniform(0.02, 2.5) / length(Vec3d{x, y, z}) * Vec3d{x, y, z};
  };
  const Vec3d warp = column();
  return vector_of({warp, column()});
}

/// The elastic energy of what the stepper moves, its membranes' and the quadratic one of bending [J].
double elastic_energy(const Model& model, const reference::FabricCloth& cloth,
                      const std::vector<Vec3d>& place) {
  double sum = 0;
  const membrane::Membranes& membranes = cloth.membranes;
  for (std::size_t t = 0; t < membranes.triangles.size(); ++t)
    sum += membranes.rests[t].area *
           bounded_yarns::energy(membranes.law.stiffness, membranes.deformation(t, place));
  for (const hinge::Coupling& c : hinge::isometric_matrix(cloth.plate, model.rest_position))
    sum += c.entry / 2 * dot(place[c.row], place[c.column]);
  return sum;
}

}  // namespace

TEST_CASE("the stress of bounded yarns is the slope of their energy, and their damping takes energy") {
  Random random(1);
  for (const Stiffness& c : kStiffnesses)
    for (int i = 0; i < 2000; ++i) {
      const Vector6 x = drawn(random);
      const Vector6 found = stress({membrane::Energy::Yarn, c, 0}, x);
      for (int k = 0; k < 6; ++k) {
        constexpr double kStep = 1e-6;
        const Vector6 by = kStep * Vector6::Unit(k);
        const double slope =
            (bounded_yarns::energy(c, axes_of(x + by)) - bounded_yarns::energy(c, axes_of(x - by))) /
            (2 * kStep);
        CHECK(std::abs(found[k] - slope) < 1e-5 * c.warp);
      }
      CHECK(bounded_yarns::energy(c, axes_of(x)) >= 0);
      // Over a short step damping takes power; a step that only turns the cloth is none.
      const Vector6 by = 1e-5 * drawn(random);
      const membrane::Law damped{membrane::Energy::Yarn, c, 0.01};
      const auto damping = [&](const Axes& end) -> Vector6 {
        return vector_of(bounded_yarns::stress(damped, end, axes_of(x), 100)) -
               stress(damped, vector_of(end));
      };
      CHECK(damping(axes_of(x + by)).dot(by) > -1e-9 * c.warp * by.norm());
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(random.uniform(0, 3), Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
      const Vector6 turned = (Vector6() << turn * x.head<3>(), turn * x.tail<3>()).finished();
      CHECK(damping(axes_of(turned)).norm() < 1e-12 * c.warp);
    }
}

TEST_CASE("bounded yarns are yarns where they are 1 to 1.5 times as long as at rest, and near to it below") {
  Random random(2);
  const auto placed = [&](double warp, double weft) {
    const double angle = random.uniform(0.5, 2.5);
    return Axes{{warp, 0, 0}, {weft * std::cos(angle), 0, weft * std::sin(angle)}};
  };
  for (const Stiffness& c : kStiffnesses) {
    const membrane::Law law{membrane::Energy::Yarn, c, 0};
    const auto apart = [&](const Axes& f) {
      return (stress(law, vector_of(f)) - vector_of(membrane::stress(law, f))).norm();
    };
    for (int i = 0; i < 1000; ++i) {
      CHECK(apart(placed(random.uniform(1, 1.5), random.uniform(1, 1.5))) < 1e-12 * c.warp);
      const double pressed = random.uniform(0, 0.1);
      const Axes f = placed(1 - pressed, 1 - pressed);
      const double angle = dot(f.warp, f.weft) / (length(f.warp) * length(f.weft));
      // To the second order of what is pressed: 3/2 of it in coupling, 6 in shear; to the first where sheared, 3.
      const double second = pressed * pressed, sheared = std::abs(angle);
      CHECK(apart(f) < std::sqrt(2) * (1.5 * std::abs(c.coupled) * second +
                                       c.shear * sheared * (7 * second + 3.5 * sheared * pressed)));
    }
  }
}

TEST_CASE("no second derivative of bounded yarns or their damping is above their bound, however they lie") {
  Random random(3);
  double nearest = 0;
  // Of damping alone: a delay so long that nothing else counts.
  for (const double delays : {0.0, 1e9})
    for (const Stiffness& c : kStiffnesses) {
      const membrane::Law law{membrane::Energy::Yarn, c, delays};
      const auto bound = delays > 0 ? bounded_yarns::damping_bound(c) : bounded_yarns::bound(c);
      const Vector6 scale = (Vector6() << Eigen::Vector3d::Constant(1 / std::sqrt(bound.warp * (1 + delays))),
                             Eigen::Vector3d::Constant(1 / std::sqrt(bound.weft * (1 + delays))))
                                .finished();
      for (int i = 0; i < 20000; ++i) {
        const Vector6 x = drawn(random), before = drawn(random);
        Matrix6 hessian;
        constexpr double kStep = 1e-5;
        for (int k = 0; k < 6; ++k) {
          const Vector6 by = kStep * Vector6::Unit(k);
          const auto at = [&](const Vector6& end) {
            return vector_of(bounded_yarns::stress(law, axes_of(end), axes_of(before), 1));
          };
          hessian.col(k) = (at(x + by) - at(x - by)) / (2 * kStep);
        }
        const Matrix6 scaled =
            scale.asDiagonal() * ((hessian + hessian.transpose()) / 2) * scale.asDiagonal();
        nearest = std::max(nearest, Eigen::SelfAdjointEigenSolver<Matrix6>(scaled).eigenvalues().maxCoeff());
      }
    }
  MESSAGE("at most " << nearest << " of the bound");
  CHECK(nearest < 1 + 1e-6);
  CHECK(nearest > 0.8);  // it is no bound of something else
}

TEST_CASE("projective_dynamics relaxes fabric by no less than the largest eigenvalue of its pairs") {
  for (const bool is_mesh : {false, true})
    for (const std::string& fabric :
         {kWoven + "0", std::string(R"("warp": 1, "shear": 0.1, "bending_warp": 0.1)")}) {
      Exact cloth(projective_scene(fabric_cloth(is_mesh ? kMesh : kGrid, fabric)),
                  {is_mesh ? flat_sheet() : mesh::TriangleMesh{}});
      const Model& model = cloth.model();
      const auto count = static_cast<Eigen::Index>(model.vertex_count());
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
      for (const NodePair& pair : fabric_node_pairs(model, model.bodies[0])) {
        const double a = std::sqrt(model.inverse_mass(pair.a)), b = std::sqrt(model.inverse_mass(pair.b));
        const double pull = pair.pull;
        matrix(pair.a, pair.a) += pull * a * a;
        matrix(pair.b, pair.b) += pull * b * b;
        matrix(pair.a, pair.b) -= pull * a * b;
        matrix(pair.b, pair.a) -= pull * a * b;
      }
      const auto eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
      const double exact = eigenvalues.maxCoeff(), rate = cloth_rates(model, model.bodies[0]).stiffness;
      MESSAGE("bound over eigenvalue: " << rate / exact);
      CHECK(eigenvalues.minCoeff() > -1e-9 * exact);
      CHECK(rate > exact * (1 - 1e-12));
      CHECK(rate < 2 * exact);
    }
}

TEST_CASE(
    "each projective_dynamics cycle brings down what a substep of fabric minimises, however long it is") {
  const mesh::TriangleMesh mesh = flat_sheet();
  for (const double stiffer : {1.0, 100.0})
    for (const double h : {1e-3, 1.0 / 120, 1.0}) {
      CAPTURE(stiffer);
      CAPTURE(h);
      scene::Scene scene =
          projective_scene(fabric_cloth(kMesh, kWoven + "0", R"(, "pins": [{"nodes": [0, 13]}])"));
      stiffen(scene, stiffer);
      Exact cloth(scene, {mesh});
      cloth.perturb(3, 0.02, 5);  // a cell
      const reference::MassSpringSystem start = cloth.system;
      const auto objective = [&](const std::vector<Vec3d>& end) {
        double sum = elastic_energy(cloth.model(), start.fabrics[0], end);
        for (std::size_t i = 0; i < end.size(); ++i) {
          if (start.inverse_mass[i] == 0) continue;
          const Vec3d off = end[i] - start.position[i] - h * start.velocity[i];
          sum += dot(off, off) / (2 * h * h * start.inverse_mass[i]);
        }
        return sum;
      };
      const auto after = [&](std::uint32_t iterations) {
        reference::MassSpringSystem system = start;
        reference::ProjectiveDynamicsStepper(cloth.model(), h, iterations)
            .advance({system, start.position, h});
        return objective(system.position);
      };
      std::vector<Vec3d> guess = start.position;
      for (std::size_t i = 0; i < guess.size(); ++i)
        if (start.inverse_mass[i] > 0) guess[i] += h * start.velocity[i];
      const double begin = objective(guess);
      for (std::uint32_t iterations = 1; iterations < 10; ++iterations) CHECK(after(iterations) < begin);
      double before = begin;
      for (std::uint32_t cycles = 1; cycles <= 20; ++cycles) {
        CAPTURE(cycles);
        const double now = after(10 * cycles);
        CHECK(now <= before * (1 + 1e-12));  // where nothing is left, it is rounded
        before = now;
      }
      MESSAGE(stiffer << " times the moduli, " << h << " s: " << begin << " J, after 20 cycles " << before);
    }
}

TEST_CASE(
    "a projective_dynamics substep of fabric equals the reference, on grids and meshes, with one iteration "
    "or three") {
  GpuFixture fixture;
  std::vector<std::string> woven = {R"("warp": 900, "shear": 60, "bending_warp": 0)"};
  for (const std::string damping : {"0", "0.002"})
    woven.insert(woven.end(),
                 {kWoven + damping, R"("warp": 400, "shear": 170, "poisson": 0.3, "bending_warp": 3e-4,
                                                    "damping": )" +
                                        damping});
  check_substeps(
      fixture.device(),
      [](const std::string& cloth, int iterations) { return projective_scene(cloth, iterations); },
      [](SolverRig&, int) { return 0.0; }, woven, flat_sheet());
}

TEST_CASE(
    "fabric by projective_dynamics has the same bits for every workgroup, beside springs, and on every run") {
  GpuFixture fixture;
  check_bits(fixture.device(),
             projective_scene(fabric_cloth(kGrid, kWoven + "0.001") +
                                  R"(, {"grid": [9, 7], "size": [0.2, 0.15], "density": 0.2}, )" +
                                  fabric_cloth(kMesh, kWoven + "0.001"),
                              11),
             {{}, {}, flat_sheet()});
}

TEST_CASE("fabric by projective_dynamics stays where Newton's method has it at rest") {
  const mesh::TriangleMesh mesh = jittered_sheet(8, 7, 0.14, 0.12);
  for (const double h : {2.5e-4, 1e-3, 1.0 / 480}) {
    CAPTURE(h);
    const scene::Scene scene =
        projective_scene(fabric_cloth(kMesh, kWoven + "0.001", R"(, "pins": [{"nodes": [0, 7]}])"), 20,
                         R"("gravity": [0, -9.81, 0], "drag": 3)");
    Exact cloth(scene, {mesh});
    const std::vector<Vec3d> rest = rest_of(cloth, scene, mesh, std::array<std::uint32_t, 2>{0, 7});
    cloth.system.position = rest;
    cloth.advance(h, 400);
    const auto [apart, way] = from_rest(cloth, rest);
    MESSAGE(h << " s: " << apart << " m apart, after a way of " << way << " m");
    CHECK(apart < 0.01 * way);
  }
}

TEST_CASE("a strip that hangs by projective_dynamics stretches by its weight over its modulus, and narrows") {
  GpuFixture fixture;
  const HangingStrip strip = hanging_strips().front();  // of yarns
  const scene::Scene scene =
      projective_scene(fabric_cloth(R"("grid": [5, 21], "size": [0.08, 0.4])",
                                    strip.fabric + R"(, "bending_warp": 1e-5, "damping": 0.0002)",
                                    R"(, "pins": [{"nodes": [2]}])"),
                       20, R"("gravity": [0, -9.81, 0], "drag": 12)");
  SolverRig rig(fixture.device(), scene, 1e-3);
  rig.advance(1500);  // drag takes e⁻⁹ of what swings
  std::vector<Vec3d> end;
  for (const Vec4f& x : rig.positions()) end.push_back(x.xyz().to<double>());
  check_hanging(strip, end);
}

TEST_CASE(
    "fabric by projective_dynamics gains no energy in long steps, from a heap or squeezed, at 100 times the "
    "stiffness") {
  GpuFixture fixture;
  for (const int scale : {1, 100})
    for (const bool squeezed : {false, true}) {
      CAPTURE(scale);
      CAPTURE(squeezed);
      const Settled energy = settled(fixture.device(), projective_scene(fabric_cloth(kMesh, kWoven + "0")),
                                     scale, squeezed, flat_sheet());
      CHECK(energy.most < energy.start);
      CHECK(energy.end < 0.1 * energy.start);  // NaN is not
    }
}

TEST_CASE("projective_dynamics refuses fabric whose energy or rest shape its matrix cannot hold") {
  const auto refusal = [](const std::string& fabric, const mesh::TriangleMesh& mesh) {
    const scene::Scene scene = projective_scene(fabric_cloth(kMesh, fabric));
    const auto model = build_model(scene, {mesh});
    REQUIRE_OK(model);
    const auto choice = choose_method(scene, *model);
    REQUIRE_FALSE(choice);
    CHECK(choice.error().kind == ErrorKind::Input);
    return choice.error().message;
  };
  CHECK(refusal(kWoven + R"(0, "energy": "green")", flat_sheet()) ==
        "test.json: cloths[0].fabric.energy is \"green\", which solver.kind \"projective_dynamics\" does not "
        "take; "
        "\"multigrid\", \"mass_spring\", \"xpbd\", \"pbd\", \"vbd\" or \"fem\" does.");
  const std::string curved =
      " rad at rest, more than the 0.01 that solver.kind \"projective_dynamics\" takes; ";
  CHECK(refusal(kWoven + "0", curved_sheet()).find(curved) != std::string::npos);
  CHECK(refusal(kWoven + "0", tube(662, 3, 0.2, 0.005)).find(curved) !=
        std::string::npos);  // 0.0095 rad an edge
  const scene::Scene limp =
      projective_scene(fabric_cloth(kMesh, R"("warp": 900, "shear": 60, "bending_warp": 0)"));
  const auto model = build_model(limp, {curved_sheet()});
  REQUIRE_OK(model);
  CHECK(choose_method(limp, *model));
}
