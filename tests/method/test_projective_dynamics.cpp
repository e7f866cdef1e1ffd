// Projective dynamics over springs: the kernels against the same substep in double, that against Newton's method, and
// laws that hold without a computer. What its iterations leave: test_relaxation.cpp. What every method must do:
// test_every_method.cpp; in a world: tests/sim/test_every_method.cpp.
#include <Eigen/Dense>
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "hung_strip.hpp"
#include "mesh/primitives.hpp"
#include "method/method.hpp"
#include "three_substeps.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

std::string by(int iterations) {
  return R"("solver": {"kind": "projective_dynamics", "iterations": )" + std::to_string(iterations) + "}, ";
}
const std::string kLoose = R"("density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 500, "shear": 200, "bend": 20})";

// An iteration rounds each span (6 roundings of its length), the tension's difference (2) and a product and a sum of
// each (4), and takes of all springs of a node no more than their mean; its weight is below 2.
constexpr double kRoundingsOfIteration = 2 * 12;

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// A substep of backward Euler by Newton's method: velocities v' with m (v' - v)/h = m g + f(x + h v', v'), the force
/// of every spring k (l - l0) + c n·(v_b - v_a) along n. Directions in the damping are held in the matrix, which makes
/// the last steps linear; they go on until nothing is left that double can tell.
reference::MassSpringSystem backward_euler(reference::MassSpringSystem system, double h) {
  const std::size_t count = system.position.size();
  const auto part = [](const Vector& all, std::size_t node) -> Eigen::Vector3d {
    return all.segment<3>(3 * static_cast<Eigen::Index>(node));
  };
  Vector start(3 * count), aim(3 * count), way = Vector::Zero(3 * static_cast<Eigen::Index>(count));
  for (std::size_t node = 0; node < count; ++node)
    for (int axis = 0; axis < 3; ++axis) {
      const auto row = 3 * static_cast<Eigen::Index>(node) + axis;
      start[row] = system.position[node][axis];
      aim[row] = system.inverse_mass[node] == 0
                     ? 0
                     : h * (system.velocity[node][axis] + h * system.acceleration[axis]);
    }
  way = aim;
  double left = HUGE_VAL;
  for (int step = 0; step < 100; ++step) {
    Vector slope = aim - way;
    Matrix hessian = Matrix::Identity(slope.size(), slope.size());
    for (const auto& s : system.springs) {
      const Eigen::Vector3d turn = part(way, s.node_b) - part(way, s.node_a);
      const Eigen::Vector3d span = part(start, s.node_b) - part(start, s.node_a) + turn;
      const double length = span.norm();
      const Eigen::Vector3d n = span / length;
      const Eigen::Vector3d force =
          (s.stiffness * (length - s.rest_length) + s.damping / h * n.dot(turn)) * n;
      const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
      const Eigen::Matrix3d block =
          (s.stiffness + s.damping / h) * along + s.stiffness * (1 - s.rest_length / length) * across;
      for (const auto& [node, other, sign] :
           {std::tuple{s.node_a, s.node_b, 1.0}, {s.node_b, s.node_a, -1.0}}) {
        const auto a = 3 * static_cast<Eigen::Index>(node), b = 3 * static_cast<Eigen::Index>(other);
        const double mobility = h * h * system.inverse_mass[node];
        slope.segment<3>(a) += mobility * sign * force;
        hessian.block<3, 3>(a, a) += mobility * block;
        hessian.block<3, 3>(a, b) -= mobility * block;
      }
    }
    if (slope.norm() >= left && left < 1e-12) break;
    left = slope.norm();
    way += hessian.partialPivLu().solve(slope);
  }
  REQUIRE(left < 1e-12);
  for (std::size_t node = 0; node < count; ++node)
    for (int axis = 0; axis < 3; ++axis) {
      const double moved = way[3 * static_cast<Eigen::Index>(node) + axis];
      system.position[node][axis] += moved;
      system.velocity[node][axis] = moved / h;
    }
  return system;
}

Vec3d angular_momentum(const reference::MassSpringSystem& system) {
  Vec3d sum;
  for (std::size_t i = 0; i < system.position.size(); ++i)
    sum += 1 / system.inverse_mass[i] * cross(system.position[i], system.velocity[i]);
  return sum;
}

}  // namespace

TEST_CASE("projective_dynamics substeps equal the reference on grids, on meshes and on two cloths") {
  GpuFixture fixture;
  const std::string gusts = R"("drag": 3, "wind": {"velocity": [-2, 1.5, 6]}, )";
  const std::string grid = R"({"size": [1.0, 0.8], "pins": ["top_left"], )" + kLoose + R"(, "grid": )";
  for (const char* nodes : {"[2, 2]", "[7, 3]", "[13, 29]"})
    for (const int iterations : {1, 2, 7}) {
      CAPTURE(nodes);
      CAPTURE(iterations);
      const auto scene = scene_of(by(iterations) + gusts + R"("cloths": [)" + grid + nodes + "}]");
      SolverRig rig(fixture.device(), scene, 2e-3);
      rig.perturb(5, 0.008, 1.0);
      rig.hold(3, {0.3, 0.1, 0.2}, 20, 10);
      check_three_substeps(rig, scene, kRoundingsOfIteration * iterations);
    }
  const auto both =
      scene_of(by(4) + R"("cloths": [)" + grid + R"([9, 6]}, {"mesh": "a.obj", )" + kLoose + "}]");
  SolverRig rig(fixture.device(), both, 2e-3, {{}, mesh::make_sphere(12, 9)});
  rig.perturb(6, 0.008, 1.0);
  check_three_substeps(rig, both, kRoundingsOfIteration * 4);
}

TEST_CASE(
    "many projective_dynamics iterations are backward Euler by Newton's method, in double and in kernels") {
  GpuFixture fixture;
  for (const bool mesh : {false, true}) {
    CAPTURE(mesh);
    const auto scene =
        scene_of(by(1000) + R"("cloths": [{"pins": [{"nodes": [0]}], )" + kLoose +
                 (mesh ? R"(, "mesh": "a.obj"}])" : R"(, "grid": [5, 4], "size": [0.5, 0.4]}])"));
    constexpr double h = 1e-3;  // springs turn between cycles only: a hundred at 4 ms leave 3e-4 of a way
    SolverRig rig(fixture.device(), scene, h, {mesh ? mesh::make_sphere(5, 4) : mesh::TriangleMesh{}});
    rig.perturb(9, 0.008, 1.0);
    const reference::MassSpringSystem start = rig.reference(), newton = backward_euler(start, h);
    reference::MassSpringSystem system = start;
    reference::make_stepper(scene.solver, rig.model().host, h)->advance({system, start.position, h});
    rig.advance(1);
    const auto kernels = rig.positions();
    double way = 0, off = 0, kernels_off = 0, longest = 0;
    for (const auto& s : start.springs)
      longest = std::max(longest, length(start.position[s.node_b] - start.position[s.node_a]));
    for (std::size_t i = 0; i < start.position.size(); ++i) {
      way = std::max(way, length(newton.position[i] - start.position[i]));
      off = std::max(off, length(system.position[i] - newton.position[i]));
      kernels_off = std::max(kernels_off, length(kernels[i].xyz().to<double>() - newton.position[i]));
    }
    MESSAGE(start.position.size() << " nodes, way " << way << " m: double off by " << off << " m, kernels by "
                                  << kernels_off << " m");
    CHECK(off < 1e-9 * way);
    // At the end a spring's tension is off as if its length were, by a dozen roundings, and a node by as much as the
    // springs on a path to it together: fewer than there are nodes, halved as signs differ.
    CHECK(kernels_off < 12 * kUlp * longest * static_cast<double>(kernels.size()) / 2 + 4 * kUlp);
  }
}

TEST_CASE("projective_dynamics nodes without springs fall as backward Euler: y0 - g h² n (n + 1) / 2") {
  GpuFixture fixture;
  const double h = 1.0 / 256;  // exact in f32
  const int steps = 100;
  for (const int iterations : {1, 20}) {
    SolverRig rig(fixture.device(), scene_of(by(iterations) + R"("cloths": [{"grid": [2, 2], "size": [1, 1],
        "density": 0.2, "damping": 0, "stiffness": {"structural": 0, "shear": 0, "bend": 0}}])"),
                  h);
    const auto start = rig.positions();
    rig.advance(steps);
    const auto end = rig.positions();
    const double fall = kGravity * h * h * steps * (steps + 1) / 2;
    for (std::size_t i = 0; i < end.size();
         ++i)  // each step rounds a place below 1 m and a velocity below 4 m/s
      CHECK(std::abs(static_cast<double>(start[i].y) - fall - static_cast<double>(end[i].y)) <
            4 * steps * (2 * kUlp + h * 4 * 2 * kUlp));
  }
}

TEST_CASE("a projective_dynamics strip at rest hangs as its springs say, whatever its iterations have left") {
  GpuFixture fixture;
  for (const int iterations : {10, 20}) check_hung_strip(fixture.device(), by(iterations));
}

TEST_CASE(
    "a free projective_dynamics sheet keeps its momentum and its angular momentum, however long the step") {
  GpuFixture fixture;
  // One iteration gives less than all of a spring's pull, until κ is small.
  for (const auto& [iterations, longest] : {std::pair{1, 2.5e-4}, {20, 2e-3}}) {
    for (const double h : {longest, longest / 2, longest / 4}) {
      SolverRig rig(fixture.device(), scene_of(by(iterations) + R"("gravity": [0, 0, 0], "cloths": [{
          "grid": [14, 11], "size": [1.0, 0.8], "density": 0.2, "damping": 0.002,
          "stiffness": {"structural": 50, "shear": 20, "bend": 2}}])"),
                    h);
      auto position = rig.positions();
      for (Vec4f& x : position) x = {1.1F * x.x, 1.05F * x.y, x.z, x.w};
      std::vector<Vec4f> velocity;
      for (const Vec4f& x : position)
        velocity.push_back({0.4F - 3 * x.y, 3 * x.x, 0.2F, 0});  // it turns, and drifts
      rig.set(position, velocity);
      const auto start = rig.reference();
      const int steps = static_cast<int>(std::lround(0.1 / h));
      rig.advance(static_cast<std::uint32_t>(steps));
      const auto end = rig.reference();
      Vec3d change;
      double size = 0;
      for (std::size_t i = 0; i < end.position.size(); ++i) {
        change += 1 / end.inverse_mass[i] * (end.velocity[i] - start.velocity[i]);
        size += 1 / end.inverse_mass[i] * length(start.velocity[i]);
      }
      // A spring pulls both ends alike to the bit; each node then rounds what it takes of twelve, in each iteration,
      // and its way divided by h.
      CHECK(length(change) < std::sqrt(steps) * 14 * 2 * kUlp * size * iterations);
      const double lost =
          length(angular_momentum(end) - angular_momentum(start)) / length(angular_momentum(start));
      MESSAGE(iterations << " iterations, h " << h << " s: momentum off by " << length(change) / size
                         << ", angular momentum by " << lost);
      CHECK(lost < 1e-5);
    }
  }
}

TEST_CASE(
    "a free, crumpled projective_dynamics sheet gains no energy, 100 times as stiff, of a hundredth of the "
    "weight") {
  GpuFixture fixture;
  for (const int iterations : {1, 2, 20, 50})
    for (const double stiffer : {1.0, 100.0})
      for (const double lighter : {1.0, 100.0}) {
        CAPTURE(iterations);
        CAPTURE(stiffer);
        CAPTURE(lighter);
        const auto scene = scene_of(
            by(iterations) + R"("gravity": [0, 0, 0], "cloths": [{"grid": [24, 17], "size": [0.46, 0.32],
            "damping": 0, "density": )" +
            std::to_string(0.25 / lighter) + R"(, "stiffness": {"structural": )" +
            std::to_string(500 * stiffer) + R"(, "shear": )" + std::to_string(200 * stiffer) +
            R"(, "bend": )" + std::to_string(20 * stiffer) + "}}]");
        SolverRig rig(fixture.device(), scene,
                      1.0 / 120);    // 22 to 2,200 times the longest stable explicit one
        rig.perturb(7, 0.004, 0.5);  // a fifth of a cell
        const double start = reference::energy(rig.reference());
        double end = start;
        for (int round = 0; round < 30; ++round) {
          rig.advance(10);
          end = reference::energy(rig.reference());
          CHECK(end <= start);  // also false for NaN
        }
        MESSAGE("left after 300 steps: " << end / start);
      }
}

TEST_CASE("projective_dynamics cloth survives a corner dragged at 100 m/s, and calms down as its drag says") {
  GpuFixture fixture;
  for (const double stiffer : {1.0, 100.0})
    for (const double lighter : {1.0, 100.0}) {
      CAPTURE(stiffer);
      CAPTURE(lighter);
      const auto scene = scene_of(
          by(20) + R"("drag": 2, "cloths": [{"grid": [24, 17], "size": [0.46, 0.32], "pins": ["top_left"],
          "damping": 0, "density": )" +
          std::to_string(0.25 / lighter) + R"(, "stiffness": {"structural": )" +
          std::to_string(500 * stiffer) + R"(, "shear": )" + std::to_string(200 * stiffer) + R"(, "bend": )" +
          std::to_string(20 * stiffer) + "}}]");
      SolverRig rig(fixture.device(), scene, 1.0 / 480);
      const std::uint32_t corner = 24 * 17 - 1;
      rig.hold(corner, {3, 2, 4}, 200, 100);
      rig.advance(48);
      CHECK(length(rig.positions()[corner].xyz() - Vec3f{3, 2, 4}) <
            0.01F);  // it is there, and the sheet ten times as long
      rig.let_go();
      const double start = reference::energy(rig.reference());
      double now = start;
      for (int round = 0; round < 30; ++round) {
        rig.advance(48);
        now = reference::energy(rig.reference());
        CHECK(now <= start);  // also false for NaN
      }
      double speed = 0;
      for (const Vec4f& v : rig.velocities()) speed = std::max(speed, static_cast<double>(length(v.xyz())));
      MESSAGE("left after 3 s: " << now / start << ", largest speed " << speed << " m/s");
      CHECK(now < std::exp(-2.0 * 3) *
                      start);  // of a vibration, whose motion is half of its energy, by a drag of 2/s
    }
}
