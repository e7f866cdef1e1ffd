// Vertex block descent over springs: the kernels against the same substep in double, and laws that hold without a
// computer. What every method must do: test_every_method.cpp; in a world: tests/sim/test_every_method.cpp.
#include <algorithm>
#include <cmath>
#include <set>

#include "gpu/gpu_fixture.hpp"
#include "hung_strip.hpp"
#include "mesh/primitives.hpp"
#include "method/vbd/node_colors.hpp"
#include "method/vbd/reference/vbd_stepper.hpp"
#include "three_substeps.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

std::string vbd(int iterations) {
  return R"("solver": {"kind": "vbd", "iterations": )" + std::to_string(iterations) + "}, ";
}
const std::string kLoose = R"("density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 500, "shear": 200, "bend": 20})";

// A descent rounds each span of its node (6 roundings of its length), the tension's difference (2) and a product and a
// sum of each (4): twelve a spring of up to its length, of which a step of Newton's method makes a way of as much. What
// a neighbour is off moves a node by no more than that, so the roundings of a node's sweeps add up.
constexpr double kRoundingsOfSweep = 12;

}  // namespace

TEST_CASE(
    "vbd substeps equal the reference on grids, on meshes and on two cloths, with one sweep or several") {
  GpuFixture fixture;
  const std::string gusts = R"("drag": 3, "wind": {"velocity": [-2, 1.5, 6]}, )";
  const std::string grid = R"({"size": [1.0, 0.8], "pins": ["top_left"], )" + kLoose + R"(, "grid": )";
  for (const char* nodes : {"[2, 2]", "[7, 3]", "[13, 29]"})
    for (const int iterations : {1, 10}) {
      CAPTURE(nodes);
      CAPTURE(iterations);
      const auto scene = scene_of(vbd(iterations) + gusts + R"("cloths": [)" + grid + nodes + "}]");
      SolverRig rig(fixture.device(), scene, 2e-3);
      rig.perturb(5, 0.008, 1.0);
      check_three_substeps(rig, scene, kRoundingsOfSweep * iterations);
    }
  const auto both =
      scene_of(vbd(4) + R"("cloths": [)" + grid + R"([9, 6]}, {"mesh": "a.obj", )" + kLoose + "}]");
  SolverRig rig(fixture.device(), both, 2e-3, {{}, mesh::make_sphere(12, 9)});
  rig.perturb(6, 0.008, 1.0);
  check_three_substeps(rig, both, kRoundingsOfSweep * 4);
}

TEST_CASE("one vbd node is backward Euler: v' = (v + h (g - k x / m)) / (1 + h² k / m) in every substep") {
  GpuFixture fixture;
  constexpr double kStiffness = 50, kMass = 0.1, kStep = 1e-3;  // half of 100 N/m, and a quarter of 0.4 kg
  SolverRig rig(
      fixture.device(),
      scene_of(vbd(1) + R"("cloths": [{"grid": [2, 2], "size": [1, 1], "density": 0.4, "pins": ["top"],
                    "stiffness": {"structural": 100, "shear": 0, "bend": 0}, "damping": 0}])"),
      kStep);
  const double top = static_cast<double>(rig.positions()[0].y);
  double x = top - static_cast<double>(rig.positions()[2].y) - 1, v = 0;
  const int steps = 400;  // nearly a swing and a half
  for (int step = 0; step < steps; ++step) {
    v = (v + kStep * (kGravity - kStiffness * x / kMass)) / (1 + kStep * kStep * kStiffness / kMass);
    x += kStep * v;
  }
  rig.advance(steps);
  // A step rounds the span of 1 m four times, of which h² k/m goes into its way and is carried on n²/2 times if it is
  // always the same; and it rounds a place of 1 m.
  const double allowed =
      4 * kUlp * 0.5 * steps * steps * kStep * kStep * kStiffness / kMass + 2 * steps * kUlp;
  for (const std::size_t node : {2UL, 3UL})
    CHECK(std::abs(top - static_cast<double>(rig.positions()[node].y) - 1 - x) < allowed);
}

TEST_CASE("a vbd strip at rest hangs as its springs say, whatever its sweeps have left to do in a substep") {
  GpuFixture fixture;
  for (const int iterations : {10, 20}) check_hung_strip(fixture.device(), vbd(iterations));
}

TEST_CASE("no spring joins two nodes of one vbd colour, and every node has one") {
  for (const char* cloth :
       {R"({"grid": [17, 11], "size": [1, 1], "density": 0.2})", R"({"mesh": "a.obj", "density": 0.2})"}) {
    const auto scene = scene_of(
        std::string(R"("cloths": [{"grid": [3, 3], "size": [1, 1], "density": 0.2}, )") + cloth + "]");
    auto model = build_model(scene, {{}, mesh::make_sphere(14, 9)});
    REQUIRE_OK(model);
    std::vector<std::uint32_t> color_of(model->rest_position.size(), ~0U);
    std::size_t most_springs = 0;
    for (const Body& body : model->bodies) {
      const NodeColors colors = color_nodes(*model, body);
      for (std::uint32_t color = 0; color < colors.count(); ++color)
        for (std::uint32_t at = colors.starts[color]; at < colors.starts[color + 1]; ++at) {
          CHECK(color_of[colors.nodes[at]] == ~0U);
          color_of[colors.nodes[at]] = color;
        }
      const auto& incidence = model->incidence(ElementKind::Spring, body);
      for (std::size_t row = 0; row < incidence.row_count(); ++row)
        most_springs = std::max(most_springs, incidence.row(row).size());
    }
    for (const Spring& spring : model->springs()) CHECK(color_of[spring.node_a] != color_of[spring.node_b]);
    CHECK(*std::max_element(color_of.begin(), color_of.end()) <= most_springs);
  }
}

TEST_CASE(
    "a free sheet thrown at random gains nothing by ten vbd sweeps in steps of a frame, by one it does") {
  GpuFixture fixture;
  const auto scene = scene_of(
      R"("gravity": [0, 0, 0], "cloths": [{"grid": [9, 8], "size": [0.4, 0.35], "density": 0.2, "damping": 0,
         "stiffness": {"structural": 500, "shear": 200, "bend": 50}}])");
  SolverRig rig(fixture.device(), scene, 1.0 / 60);
  for (const std::uint32_t sweeps : {1U, 2U, 4U, 10U, 30U}) {
    double most = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      reference::MassSpringSystem sheet = rig.reference();
      Random random(seed);
      for (Vec3d& v : sheet.velocity)
        for (int axis = 0; axis < 3; ++axis) v[axis] = random.uniform(-5, 5);
      const double begun = reference::energy(sheet);
      reference::VbdStepper stepper(rig.model().host, sweeps);
      for (int frame = 0; frame < 60; ++frame) {
        const std::vector<Vec3d> places = sheet.position;
        stepper.advance({sheet, places, rig.dt()});
        most = std::max(most, reference::energy(sheet) / begun);
      }
    }
    MESSAGE(sweeps << " sweeps: at most " << most << " of what it began with");
    if (sweeps >= 10) CHECK(most < 1);
    if (sweeps == 1) CHECK(most > 1);  // what its page says under Limits
  }
}
