// XPBD over fabric: kernels beside the same substep in double, and both beside laws that neither was written from.
#include <algorithm>
#include <cmath>

#include "fabric_rig.hpp"
#include "hanging_strips.hpp"
#include "method/projection/sag.hpp"

using namespace weft;

namespace {

scene::Scene xpbd_scene(const std::string& cloths, int iterations = 1,
                        const std::string& world = R"("gravity": [0, 0, 0])") {
  return scene_of(world + R"(, "solver": {"kind": "xpbd", "iterations": )" + std::to_string(iterations) +
                  R"(}, "cloths": [)" + cloths + "]");
}

}  // namespace

TEST_CASE("an xpbd substep of fabric equals the reference, on grids and meshes, with one sweep or three") {
  GpuFixture fixture;
  check_substeps(
      fixture.device(), [](const std::string& cloth, int sweeps) { return xpbd_scene(cloth, sweeps); },
      [](const SolverRig&, int) { return 0.0; });
}

TEST_CASE("fabric by xpbd has the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  check_bits(
      fixture.device(),
      xpbd_scene(fabric_cloth(kGrid, kWoven + "0.001") + ", " + fabric_cloth(kMesh, kIsotropic + "0.001"), 2),
      {{}, curved_sheet()});
}

TEST_CASE("many xpbd sweeps over fabric are backward Euler, but for what slopes turn in a step") {
  // The multipliers of sweeps before have pushed along the slopes of then ([X] after its equation 10): what is left is
  // of the order of the turn, which falls with the step.
  const mesh::TriangleMesh mesh = jittered_sheet(6, 5, 0.1, 0.08);
  for (const std::string damping : {"0", "0.0005"})
    for (const std::string& fabric : fabrics(damping)) {
      CAPTURE(fabric);
      double before = HUGE_VAL;
      for (const double h : {4e-5, 2e-5, 1e-5}) {
        Exact cloth(xpbd_scene(fabric_cloth(kMesh, fabric, R"(, "pins": [{"nodes": [0, 5]}])"), 400), {mesh});
        cloth.perturb(4, 1e-3, 0.3);
        const double left = left_of_backward_euler(cloth, h);
        MESSAGE("h " << h << " s: " << left << " of the forces are left");
        CHECK(left < 0.02);
        CHECK(left < 0.6 * before);
        before = left;
      }
    }
}

TEST_CASE("a free cloth of fabric keeps its momentum by xpbd, and its spin as the step shrinks") {
  const mesh::TriangleMesh mesh = jittered_sheet(8, 7, 0.14, 0.12);
  for (const std::string& fabric : fabrics("0.0005")) {
    CAPTURE(fabric);
    double before = HUGE_VAL;
    for (const double h : {1e-4, 5e-5, 2.5e-5}) {
      Exact cloth(xpbd_scene(fabric_cloth(kMesh, fabric)), {mesh});
      cloth.perturb(7, 5e-4, 0.1);
      for (std::size_t v = 0; v < cloth.system.position.size(); ++v)
        cloth.system.velocity[v] += cross(Vec3d{2, 1, 3}, cloth.system.position[v]);
      const Vec3d momentum = cloth.momentum(), spin = cloth.spin();
      cloth.advance(h, static_cast<int>(std::lround(0.02 / h)));
      double size = 0;
      for (std::size_t v = 0; v < cloth.system.position.size(); ++v)
        size += length(cloth.system.velocity[v]) / cloth.system.inverse_mass[v];
      // A step rounds some 24 pushes at each node, each of them a few ways long, to 1e-16.
      CHECK(length(cloth.momentum() - momentum) < 0.02 / h * 24 * 1e-15 * size);
      const double lost = length(cloth.spin() - spin) / length(spin);
      MESSAGE("h " << h << " s: spin off by " << lost);
      CHECK(lost < 0.7 * before);  // of first order: half
      before = lost;
    }
  }
}

TEST_CASE("fabric by xpbd hangs where Newton's method has it at rest, the nearer the more sweeps") {
  const mesh::TriangleMesh mesh = jittered_sheet(8, 7, 0.14, 0.12);
  for (const std::string& fabric : fabrics("0.001")) {
    CAPTURE(fabric);
    double before = HUGE_VAL;
    for (const int sweeps : {1, 4, 16, 64}) {
      const scene::Scene scene = xpbd_scene(fabric_cloth(kMesh, fabric, R"(, "pins": [{"nodes": [0, 7]}])"),
                                            sweeps, R"("gravity": [0, -9.81, 0], "drag": 30)");
      Exact cloth(scene, {mesh});
      const std::vector<Vec3d> rest = rest_of(cloth, scene, mesh, std::array<std::uint32_t, 2>{0, 7});
      cloth.system.position = rest;
      cloth.advance(1e-3, 400);  // drag takes e⁻⁶ of what swings
      const auto [apart, way] = from_rest(cloth, rest);
      MESSAGE(sweeps << " sweeps: " << apart << " m apart, after a way of " << way << " m");
      CHECK(apart < 0.5 * before);
      before = apart;
      if (sweeps == 64) CHECK(apart < 0.01 * way);
    }
  }
}

TEST_CASE(
    "a strip that hangs by xpbd stretches by its weight over its modulus, and narrows, in short steps") {
  GpuFixture fixture;
  for (const HangingStrip& strip : hanging_strips()) {
    CAPTURE(strip.fabric);
    const scene::Scene scene =
        xpbd_scene(fabric_cloth(R"("grid": [5, 21], "size": [0.08, 0.4])",
                                strip.fabric + R"(, "bending_warp": 1e-5, "damping": 0.0002)",
                                R"(, "pins": [{"nodes": [2]}])"),
                   1, R"("gravity": [0, -9.81, 0], "drag": 12)");
    SolverRig rig(fixture.device(), scene, 1e-4);
    rig.advance(12000);  // drag takes e⁻⁷ of what swings
    std::vector<Vec3d> end;
    for (const Vec4f& x : rig.positions()) end.push_back(x.xyz().to<double>());
    check_hanging(strip, end);
  }
}

TEST_CASE("a sheet of fabric that hangs by its edge is longer by auto's part of its length at most") {
  // w L²/2E and no more than kSag of L: equation 7.
  for (const std::string& fabric : fabrics("0.0005"))
    for (const int iterations : {1, 3}) {
      CAPTURE(fabric);
      CAPTURE(iterations);
      const mesh::TriangleMesh mesh = jittered_sheet(25, 9, 0.4, 0.4 / 3);
      std::string held;
      for (int j = 0; j < 9; ++j) held += (j > 0 ? ", " : "") + std::to_string(25 * j);
      const scene::Scene scene =
          xpbd_scene(fabric_cloth(kMesh, fabric, R"(, "pins": [{"nodes": [)" + held + "]}]"), iterations,
                     R"("gravity": [9.81, 0, 0], "drag": 12)");
      Exact cloth(scene, {mesh});
      const StepLimit limit = method_of(scene.solver.kind).step_limit(scene, cloth.model());
      const std::vector<Vec3d> rest = cloth.system.position;
      const double h = limit.longest_auto_step;
      cloth.advance(h, static_cast<int>(0.8 / h));  // drag takes e⁻⁵ of what swings
      const double longer = cloth.system.position[4 * 25 + 24].x - rest[4 * 25 + 24].x;
      const double exact = 0.2 * 9.81 * 0.4 * 0.4 / (2 * scene.cloths[0].fabric->warp);
      MESSAGE(h << " s: longer by " << longer / exact << " of w L²/2E, " << (longer - exact) / 0.4
                << " of L");
      CHECK(longer > exact);
      CHECK(longer - exact < kSag * 0.4);
    }
}

TEST_CASE("a stiff plate by xpbd swings as a rigid one, by one sweep") {
  // Sweeps in one direction alone push asymmetrically: bending of 5 N·m then shakes this plate by half its swing.
  constexpr double kLength = 0.4, kAngle = 0.1, kPi = 3.14159265358979323846;
  const scene::Scene scene =
      xpbd_scene(fabric_cloth(R"("grid": [5, 9], "size": [0.2, 0.4])",
                              R"("warp": 5000, "shear": 2000, "bending_warp": 5)", R"(, "pins": ["top"])"),
                 1, R"("gravity": [0, -9.81, 0])");
  Exact cloth(scene, {{}});
  std::vector<Vec3d>& place = cloth.system.position;
  const double top = place[0].y;
  for (Vec3d& x : place) x = {x.x, top - (top - x.y) * std::cos(kAngle), (top - x.y) * std::sin(kAngle)};
  const double period = 2 * kPi * std::sqrt(2 * kLength / (3 * 9.81)) * (1 + kAngle * kAngle / 16);
  const double h =
      period / 8 /
      std::ceil(period / 8 / method_of(scene.solver.kind).step_limit(scene, cloth.model()).longest_auto_step);
  for (int eighth = 1; eighth <= 8; ++eighth) {
    cloth.advance(h, static_cast<int>(std::lround(period / 8 / h)));
    CHECK(std::abs(place.back().z - kLength * kAngle * std::cos(eighth * kPi / 4)) < 0.02 * kLength * kAngle);
    CHECK(std::abs(place.back().z - 2 * place[22].z) < 0.02 * kLength * kAngle);  // it is straight
  }
}

TEST_CASE("fabric by xpbd comes to rest in long steps, from a heap or squeezed, at 100 times the stiffness") {
  GpuFixture fixture;
  for (const std::string& fabric : fabrics("0"))
    for (const int scale : {1, 100})
      for (const bool squeezed : {false, true}) {
        CAPTURE(fabric);
        CAPTURE(scale);
        const Settled energy =
            settled(fixture.device(), xpbd_scene(fabric_cloth(kMesh, fabric)), scale, squeezed);
        // A sweep leaves apart what it has moved before: what is squeezed and stiff has more energy at first.
        if (!squeezed) CHECK(energy.most < energy.start);
        CHECK(energy.end < 0.1 * energy.start);  // NaN is not
      }
}

TEST_CASE(
    "auto's xpbd steps follow equations 7 and 13: shorter where fabric that stands out resists bending") {
  const auto step_of = [](int cells, double size, double bending, int iterations = 1,
                          const std::string& world = R"("gravity": [0, -10, 0])") {
    const std::string nodes = std::to_string(cells + 1), side = std::to_string(size);
    const scene::Scene scene = xpbd_scene(
        fabric_cloth(R"("grid": [)" + nodes + ", " + nodes + R"(], "size": [)" + side + ", " + side + "]",
                     R"("warp": 900, "shear": 60, "bending_warp": )" + std::to_string(bending)),
        iterations, world);
    auto model = build_model(scene, {{}});
    REQUIRE_OK(model);
    const StepLimit limit = method_of(scene.solver.kind).step_limit(scene, *model);
    CHECK(limit.largest_step == 0);  // any is stable
    return limit.longest_auto_step;
  };
  const double by_length = 0.01 * std::sqrt(kSag / (10 * 0.32 * std::sqrt(2.0)));
  CHECK(step_of(32, 0.32, 0) == doctest::Approx(by_length));
  CHECK(step_of(32, 0.32, 1e-6) == doctest::Approx(by_length));  // it stands out by 8 mm: no cell
  // w = 2 N/m²: 2e-3 N·m stand out by 0.1 m, less than the sheet. Twice that is twice as stiff a spring at each hinge.
  const double h = step_of(32, 0.32, 2e-3);
  CHECK(h < 0.5 * by_length);
  CHECK(step_of(32, 0.32, 4e-3) == doctest::Approx(h / std::sqrt(2.0)));
  CHECK(step_of(32, 0.32, 2e-3, 4) == doctest::Approx(2 * h));
  // Half the cell: hinges are four times as near to nodes of a quarter of the mass. The rim counts half as much.
  CHECK(step_of(64, 0.32, 2e-3) == doctest::Approx(h / 4).epsilon(0.05));
  // A sheet that its bending holds out whole droops with the cube of its length, whatever that bending is.
  const double whole = step_of(8, 0.08, 10);
  CHECK(step_of(8, 0.08, 20) == doctest::Approx(whole));
  CHECK(step_of(8, 0.08, 10, 1, R"("gravity": [0, -40, 0])") == doctest::Approx(whole / 2));
  CHECK(step_of(32, 0.32, 2e-3, 1, R"("gravity": [0, 0, 0])") == doctest::Approx(kImplicitStep));
}
