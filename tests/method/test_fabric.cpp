// Cloth of fabric by explicit steps: kernels beside the double reference, and laws that neither was written from.
#include <array>
#include <cmath>
#include <cstdio>

#include "element/reference/motion.hpp"
#include "gpu/gpu_fixture.hpp"
#include "hanging_strips.hpp"
#include "mesh/irregular_meshes.hpp"
#include "method/method.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", value);
  return buffer.data();
}

std::string grid_of(std::uint32_t nx, std::uint32_t ny, double cell) {
  return R"("grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) + R"(], "size": [)" +
         text(cell * (nx - 1)) + ", " + text(cell * (ny - 1)) + "]";
}

/// A cloth of this shape and fabric, without gravity.
scene::Scene fabric_scene(const std::string& shape, const std::string& fabric, const std::string& more = "",
                          const std::string& world = R"("gravity": [0, 0, 0])") {
  return scene_of(world + R"(, "solver": {"kind": "mass_spring"}, "cloths": [{)" + shape +
                  R"(, "density": 0.2, "fabric": {)" + fabric + "}" + more + "}]");
}

StepLimit limit_of(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& meshes) {
  auto model = build_model(scene, meshes);
  REQUIRE_OK(model);
  return method_of(scene::SolverKind::MassSpring).step_limit(scene, *model);
}

const std::string kWoven =
    R"("warp": 900, "weft": 300, "shear": 60, "poisson": 0.25, "bending_warp": 4e-4, "bending_weft": 1e-4,
      "damping": )";
const std::string kIsotropic =
    R"("energy": "neo_hookean", "warp": 500, "shear": 200, "poisson": 0.25, "bending_warp": 3e-4, "damping": )";

/// Of all nodes that move, what a step changes their velocities by, and how far from the reference's that is.
double error_of_step(SolverRig& rig) {
  reference::MassSpringSystem expected = rig.reference();
  const std::vector<Vec3d> before = expected.velocity;
  reference::advance(expected, rig.dt());
  rig.advance(1);
  const std::vector<Vec4f> found = rig.velocities();
  double most = 0, change = 0;
  for (std::size_t n = 0; n < found.size(); ++n) {
    most = std::max(most, length(found[n].xyz().to<double>() - expected.velocity[n]));
    change = std::max(change, length(expected.velocity[n] - before[n]));
  }
  REQUIRE(change > 0);
  return most / change;
}

/// RMS speed of the nodes that move [m/s].
double speed_of(SolverRig& rig) {
  double squares = 0;
  const std::vector<Vec4f> all = rig.velocities();
  for (const Vec4f& v : all) squares += dot(v.xyz().to<double>(), v.xyz().to<double>());
  return std::isfinite(squares) ? std::sqrt(squares / static_cast<double>(all.size())) : HUGE_VAL;
}

/// A mesh that is no plane at rest.
mesh::TriangleMesh curved_sheet() {
  mesh::TriangleMesh mesh = jittered_sheet(14, 11, 0.26, 0.2);
  for (Vec3f& p : mesh.positions) p.y = 1.5F * p.x * p.x - 0.8F * p.x * p.z;
  return mesh;
}

}  // namespace

TEST_CASE("membranes and hinges pull as in double") {
  GpuFixture fixture;
  const std::string on_mesh = R"("mesh": "m", "transform": {"rotate": [0, 0.6, 0, 0.8]})";
  for (const std::string damping : {"0", "0.002"})
    for (const std::string& fabric :
         {kWoven + damping, kWoven + damping + R"(, "energy": "green")", kIsotropic + damping}) {
      CAPTURE(fabric);
      for (const bool is_mesh : {false, true}) {
        const std::string pins = is_mesh ? R"(, "pins": [{"nodes": [0, 1, 14]}])" : R"(, "pins": ["top"])";
        const scene::Scene scene = fabric_scene(is_mesh ? on_mesh : grid_of(17, 12, 0.02), fabric, pins);
        std::vector<mesh::TriangleMesh> meshes(1);
        if (is_mesh) meshes[0] = curved_sheet();
        SolverRig rig(fixture.device(), scene, 1e-5, meshes);
        rig.perturb(5, 2e-3, 0.5);
        // Places of f32 err by 1e-8 m and are a tenth of a cell from rest, so that strains err by 1e-5 of themselves.
        CHECK(error_of_step(rig) < 2e-5);
      }
    }
}

TEST_CASE("fabric has the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  std::vector<std::vector<Vec4f>> positions;
  for (const std::uint32_t size : {64U, 64U, 256U}) {
    const scene::Scene scene = fabric_scene(grid_of(23, 19, 0.02), kWoven + "0.001");
    SolverRig rig(fixture.device(), scene, 1e-4, {}, size);
    rig.perturb(3, 2e-3, 0.5);
    rig.advance(40);
    positions.push_back(rig.positions());
    CHECK(std::memcmp(positions[0].data(), positions.back().data(), positions[0].size() * sizeof(Vec4f)) ==
          0);
  }
}

TEST_CASE("a free cloth of fabric keeps its momentum and spin, and loses energy only by its damping") {
  GpuFixture fixture;
  for (const bool damped : {false, true}) {
    const scene::Scene scene = fabric_scene(grid_of(15, 12, 0.02), kWoven + (damped ? "0.0005" : "0"));
    SolverRig rig(fixture.device(), scene, 0.25 * limit_of(scene, {{}}).largest_step);
    rig.perturb(7, 1e-3, 0.5);
    const auto of = [](const reference::MassSpringSystem& system) {
      std::array<Vec3d, 2> sums;  // momentum, spin
      for (std::size_t n = 0; n < system.position.size(); ++n) {
        sums[0] += system.velocity[n] / system.inverse_mass[n];
        sums[1] += cross(system.position[n], system.velocity[n]) / system.inverse_mass[n];
      }
      return sums;
    };
    const reference::MassSpringSystem begun = rig.reference();
    const double before = reference::energy(begun);
    double least = before, rise = 0, scale = 0;
    for (int turn = 0; turn < 20; ++turn) {
      rig.advance(25);
      const double energy = reference::energy(rig.reference());
      rise = std::max(rise, energy - least);
      least = std::min(least, energy);
    }
    const reference::MassSpringSystem ended = rig.reference();
    for (std::size_t n = 0; n < begun.position.size(); ++n)
      scale += length(begun.velocity[n]) / begun.inverse_mass[n];
    const auto first = of(begun), last = of(ended);
    MESSAGE("energy ", before, " to ", least, " J, rises by ", rise / before, "; momentum by ",
            length(last[0] - first[0]) / scale, ", spin by ", length(last[1] - first[1]) / (0.1 * scale));
    // f32 rounds each of 500 steps of 180 nodes by 6e-8, in all directions.
    CHECK(length(last[0] - first[0]) < 1e-5 * scale);
    CHECK(length(last[1] - first[1]) < 1e-5 * 0.2 * scale);
    // A symplectic step has a wrong energy of the order of (h ω)/2 of what swings at ω, here an eighth at the most.
    if (damped) CHECK(least < 0.5 * before);
    if (!damped) CHECK(least > 0.8 * before);
    CHECK(rise < 0.13 * before);
  }
}

TEST_CASE("the step limit of fabric is sharp: 3 % below it a flat sheet is stable, 5 % above it is not") {
  GpuFixture fixture;
  struct Case {
    std::string shape, fabric;
    bool is_mesh;
  };
  const std::string stiff_bending =
      R"("warp": 5, "shear": 2, "bending_warp": 5e-3, "damping": 0)";  // bending decides
  for (const Case& c :
       {Case{grid_of(24, 17, 0.02), kWoven + "0", false}, Case{grid_of(24, 17, 0.02), stiff_bending, false},
        Case{R"("mesh": "m")", kWoven + "0", true}}) {
    CAPTURE(c.fabric);
    const scene::Scene scene = fabric_scene(c.shape, c.fabric);
    std::vector<mesh::TriangleMesh> meshes(1);
    if (c.is_mesh) meshes[0] = jittered_sheet(14, 11, 0.26, 0.2);
    const double limit = limit_of(scene, meshes).largest_step;
    for (const double factor : {0.97, 1.05}) {
      SolverRig rig(fixture.device(), scene, factor * limit, meshes);
      rig.perturb(2, 1e-6, 0);  // so small that it stays linear
      rig.advance(1000);
      MESSAGE(factor, " of ", 1e3 * limit, " ms: ", speed_of(rig), " m/s");
      if (factor < 1)
        CHECK(speed_of(rig) < 0.1);
      else
        CHECK(speed_of(rig) > 1);
    }
  }
}

TEST_CASE("a strip that hangs stretches by its weight over its modulus, and narrows by Poisson's ratio") {
  GpuFixture fixture;
  for (const HangingStrip& strip : hanging_strips()) {
    CAPTURE(strip.fabric);
    const scene::Scene scene =
        fabric_scene(grid_of(5, 21, 0.02), strip.fabric + R"(, "bending_warp": 1e-5, "damping": 0.0002)",
                     R"(, "pins": [{"nodes": [2]}])", R"("gravity": [0, -9.81, 0], "drag": 12)");
    SolverRig rig(fixture.device(), scene, 0.6 * limit_of(scene, {{}}).largest_step);
    rig.advance(static_cast<std::uint32_t>(1.2 / rig.dt()));  // drag takes e⁻⁷ of what swings
    std::vector<Vec3d> end;
    for (const Vec4f& x : rig.positions()) end.push_back(x.xyz().to<double>());
    check_hanging(strip, end);
  }
}

TEST_CASE("a sheet that swings by two corners goes where implicit steps by Newton's method take it") {
  GpuFixture fixture;
  const mesh::TriangleMesh mesh = jittered_sheet(12, 9, 0.3, 0.2);
  const scene::Scene scene = fabric_scene(
      R"("mesh": "m")",
      R"("warp": 60, "weft": 40, "shear": 15, "poisson": 0.2, "bending_warp": 2e-4, "bending_weft": 1e-4,
         "damping": 0)",
      R"(, "pins": [{"nodes": [0, 11]}])", R"("gravity": [0, -9.81, 0])");
  SolverRig rig(fixture.device(), scene, 0.2 * limit_of(scene, {mesh}).largest_step, {mesh});
  const auto steps = static_cast<std::uint32_t>(0.15 / rig.dt());
  const std::vector<Vec4f> start = rig.positions();
  rig.advance(steps);
  const std::vector<Vec4f> end = rig.positions();

  reference::Sheet sheet;
  for (const Vec3f& p : mesh.positions) sheet.rest.push_back(p.to<double>());
  sheet.triangles = mesh.triangles;
  sheet.held.assign(sheet.rest.size(), 0);
  sheet.held[0] = sheet.held[11] = 1;
  sheet.membrane = {membrane::Energy::Yarn, Stiffness::of({60, 40, 0.2, 15}), 0};
  sheet.bending = {2e-4, 0, 1e-4, 0.5 * std::sqrt(2e-8)};
  sheet.density = 0.2;
  sheet.gravity = {0, -9.81, 0};
  const std::vector<Vec3d> still(sheet.rest.size());
  reference::Motion motion(sheet, {sheet.rest, still, 0}, reference::Scheme::Midpoint);
  constexpr int kImplicitSteps = 300;
  for (int step = 0; step < kImplicitSteps; ++step) {
    const auto moved = motion.advance(steps * rig.dt() / kImplicitSteps);
    REQUIRE_OK(moved);
  }

  double apart = 0, way = 0;
  for (std::size_t n = 0; n < end.size(); ++n) {
    const Vec3d there = motion.state().position[n];
    apart = std::max(apart, length(end[n].xyz().to<double>() - there));
    way = std::max(way, length(there - start[n].xyz().to<double>()));
  }
  // Explicit steps are a step's gravity off, h g t / 2 = 3e-5 m, and both cut what swings in a few steps.
  MESSAGE("at most ", apart, " m apart after ", way, " m");
  CHECK(way > 0.05);
  CHECK(apart < 5e-3 * way);
}

TEST_CASE(
    "a heavy strip of fabric clamped at one end hangs as the elastica does, on a grid and on any mesh") {
  GpuFixture fixture;
  // G = w L³ / B = 20: the end of an inextensible strip hangs 0.830 L lower (test_strips.cpp has the closed form).
  constexpr double kLength = 0.26, kDensity = 0.2, kPull = 9.81, kDrop = 0.830;
  const double bending = kDensity * kPull * kLength * kLength * kLength / 20;
  const std::string fabric =
      R"("warp": 300, "shear": 100, "damping": 0.0001, "bending_warp": )" + text(bending);
  mesh::TriangleMesh irregular = jittered_sheet(15, 4, 0.28, 0.06);
  for (std::size_t j = 0; j < 4; ++j)
    irregular.positions[15 * j + 1].x = -0.12F;  // the clamp's edge is straight
  for (const bool is_mesh : {false, true}) {
    const std::uint32_t rows = is_mesh ? 4 : 3;
    std::string held;  // two columns, so that a whole cell is held
    for (std::uint32_t j = 0; j < rows; ++j)
      held += (j > 0 ? ", " : "") + std::to_string(15 * j) + ", " + std::to_string(15 * j + 1);
    const std::string shape = is_mesh ? R"("mesh": "m")" : grid_of(15, 3, 0.02) + R"(, "plane": "xz")";
    const scene::Scene scene = fabric_scene(shape, fabric, R"(, "pins": [{"nodes": [)" + held + "]}]",
                                            R"("gravity": [0, -9.81, 0], "drag": 12)");
    std::vector<mesh::TriangleMesh> meshes(1);
    if (is_mesh) meshes[0] = irregular;
    SolverRig rig(fixture.device(), scene, 0.6 * limit_of(scene, meshes).largest_step, meshes);
    rig.advance(static_cast<std::uint32_t>(1.5 / rig.dt()));  // e⁻⁹
    const double drop = -static_cast<double>(rig.positions()[15 * (rows / 2) + 14].y) / kLength;
    MESSAGE((is_mesh ? "mesh: " : "grid: "), drop, " of its length, the elastica ", kDrop);
    CHECK(drop == doctest::Approx(kDrop).epsilon(0.02).scale(0));
  }
}
