// Position-based dynamics: the kernels against the same substep in double, and laws that hold without a computer. What
// every method must do: test_every_method.cpp; in a world: tests/sim/test_every_method.cpp.
#include <cmath>
#include <cstring>

#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "method/method.hpp"
#include "three_substeps.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

std::string solved_by(const std::string& kind, int iterations) {
  return R"("solver": {"kind": ")" + kind + R"(", "iterations": )" + std::to_string(iterations) + "}, ";
}
std::string pbd(int iterations) { return solved_by("pbd", iterations); }

const std::string kLoose = R"("density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 500, "shear": 200, "bend": 20})";
const std::string kFabric =
    R"("density": 0.2, "fabric": {"warp": 900, "weft": 300, "shear": 60, "poisson": 0.25,
    "bending_warp": 4e-4, "bending_weft": 1e-4, "damping": 0.001})";
const std::string kGusts = R"("drag": 3, "wind": {"velocity": [-2, 1.5, 6]}, )";

std::string sheet(const std::string& nodes, const std::string& cloth) {
  return R"({"size": [1.0, 0.8], "pins": ["top_left"], "grid": )" + nodes + ", " + cloth + "}";
}

// A projection rounds its element's span (6 roundings of its length), the tension's difference (2), quotient and
// product (4) and two sums of ways: 16 of its length at most, of which roundings of as many sweeps add up.
constexpr double kRoundingsOfSweep = 16;

/// By how much nodes hang below their rest, a boundary spring each: half of 100 N/m, and a quarter of 0.4 kg.
constexpr double kNodeStiffness = 50, kNodeMass = 0.1;
constexpr double kDrag = 10;  // [1/s]

double hung(gpu::Device& device, double step, int iterations) {
  SolverRig rig(device, scene_of(pbd(iterations) + R"("drag": 10, "cloths": [{"grid": [2, 2], "size": [1, 1],
      "density": 0.4, "pins": ["top"], "stiffness": {"structural": 100, "shear": 0, "bend": 0}, "damping": 0}])"),
                step);
  const double start = static_cast<double>(rig.positions()[2].y);
  rig.advance(static_cast<std::uint32_t>(std::lround(3 / step)));
  return start - static_cast<double>(rig.positions()[2].y);
}

}  // namespace

TEST_CASE(
    "pbd substeps equal the reference on grids and meshes of springs and of fabric, with few sweeps or "
    "many") {
  GpuFixture fixture;
  for (const std::string& cloth : {kLoose, kFabric})
    for (const int iterations : {1, 6}) {
      CAPTURE(iterations);
      const auto scene =
          scene_of(pbd(iterations) + kGusts + R"("cloths": [)" + sheet("[13, 9]", cloth) + "]");
      SolverRig rig(fixture.device(), scene, 2e-3);
      rig.perturb(5, 0.008, 1.0);
      check_three_substeps(rig, scene, kRoundingsOfSweep * iterations);
      const auto both = scene_of(pbd(iterations) + kGusts + R"("cloths": [)" + sheet("[9, 6]", cloth) +
                                 R"(, {"mesh": "a.obj", )" + cloth + "}]");
      SolverRig two(fixture.device(), both, 2e-3, {{}, mesh::make_sphere(12, 9)});
      two.perturb(6, 0.008, 1.0);
      check_three_substeps(two, both, kRoundingsOfSweep * iterations);
    }
}

TEST_CASE("one sweep of pbd over springs is one of xpbd, whose multipliers begin at 0: the same bits") {
  GpuFixture fixture;
  std::vector<std::vector<Vec4f>> ends;
  for (const char* kind : {"pbd", "xpbd"}) {
    SolverRig rig(fixture.device(),
                  scene_of(solved_by(kind, 1) + kGusts + R"("cloths": [)" + sheet("[13, 9]", kLoose) + "]"),
                  2e-3);
    rig.perturb(5, 0.008, 1.0);
    rig.advance(20);
    ends.push_back(rig.positions());
  }
  CHECK(std::memcmp(ends[0].data(), ends[1].data(), ends[0].size() * sizeof(Vec4f)) == 0);
}

TEST_CASE(
    "a pbd node hangs by g h² / ((1 + h² k/m)^n - 1), drag in m: stiffer with each sweep, and as steps "
    "grow") {
  GpuFixture fixture;
  for (const double step : {2e-3, 8e-3})
    for (const int iterations : {1, 2, 10}) {
      CAPTURE(step);
      CAPTURE(iterations);
      const double with_drag = 1 + step * kDrag;
      const double pull = step * step * kNodeStiffness / (kNodeMass * with_drag);
      const double expected = kGravity * step * step / with_drag / std::expm1(iterations * std::log1p(pull));
      CHECK(hung(fixture.device(), step, iterations) == doctest::Approx(expected).epsilon(2e-3).scale(0));
    }
  // What a user sees of it: weight hangs from a tenth, or a thirtieth, of what the spring says.
  CHECK(hung(fixture.device(), 2e-3, 10) < 0.11 * kNodeMass * kGravity / kNodeStiffness);
}

TEST_CASE("weft check's stiffening of a pbd spring is the weight that it carries by what it stretches") {
  const auto scene = scene_of(pbd(7) + R"("cloths": [{"grid": [2, 2], "size": [1, 1], "density": 0.4,
      "pins": ["top"], "stiffness": {"structural": 100, "shear": 0, "bend": 0}, "damping": 0}])");
  auto model = build_model(scene, {{}});
  REQUIRE_OK(model);
  constexpr double kStep = 4e-3;
  const StiffeningRange times =
      method_of(scene.solver.kind).stiffening(scene.solver, *model, model->bodies[0], kStep);
  GpuFixture fixture;
  const double found = kNodeMass * kGravity / (kNodeStiffness * hung(fixture.device(), kStep, 7));
  CHECK(times.least ==
        doctest::Approx(found).epsilon(2e-3));  // of the upright springs, whose upper node is held
  CHECK(times.most > times.least);              // the free one below has both its nodes
}
