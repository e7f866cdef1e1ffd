// Both formulations of the mass-spring step against each other, the reference, and themselves.
#include <algorithm>
#include <cmath>

#include "element/spring/spring_grid.hpp"
#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "method/mass_spring/fixed_point.hpp"
#include "method/mass_spring/spring_forces.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kUlp =
    1.0 / 16777216;  // 2^-24: half the spacing of f32 around 1, as a relative rounding error

std::string cloth(std::uint32_t nx, std::uint32_t ny, const char* forces, const char* more = "") {
  return R"("solver": {"kind": "mass_spring", "forces": ")" + std::string(forces) +
         R"("}, "cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
         R"(], "size": [1.0, 0.8], "density": 0.2, "damping": 0.02,
         "stiffness": {"structural": 500, "shear": 200, "bend": 20}, "pins": ["top_left", "top_right"])" +
         more + "}]";
}

/// How far the wind at a node may be from the reference.
double wind_tolerance(const reference::MassSpringSystem& system, std::size_t node) {
  double error = 4 * kUlp * length(system.wind.velocity);  // itself, two sums, and the slip
  for (const scene::WindWave& wave : system.wind.waves) {
    // The gradient, three products, three sums and the time's part round; a wave rises by 8 a turn at most.
    double turns = 1;
    for (int axis = 0; axis < 3; ++axis) turns += std::abs(wave.gradient[axis] * system.position[node][axis]);
    error += length(wave.gust) * (8 * 6 * kUlp * turns + 6 * kUlp);
  }
  return error;
}

/// How far the velocity of a grabbed node may be: the difference of two places, its length and the cut round.
double grab_tolerance(const reference::MassSpringSystem& system, std::size_t node) {
  double error = 0;
  if (const auto grabbed = system.grabs.find(static_cast<std::uint32_t>(node)); grabbed != system.grabs.end())
    error += system.grab_rate * kUlp *
             (length(grabbed->second) + 10 * length(grabbed->second - system.position[node]));
  return error;
}

/// How far a component of one step's velocity may be from the reference: the rounding of each spring's
/// tension and direction, of the sum, of the update, and for the fixed-point sum half a unit a spring.
std::vector<double> velocity_tolerance(const reference::MassSpringSystem& system, double dt,
                                       double force_unit) {
  std::vector<double> force(system.position.size(), 0.0);
  for (const auto& spring : system.springs) {
    const Vec3d span = system.position[spring.node_b] - system.position[spring.node_a];
    const Vec3d rate = system.velocity[spring.node_b] - system.velocity[spring.node_a];
    // length: the difference, three squares, two sums and a root round: within 6 of the span; direction 2
    // more; the two products and the sum 4 more. Positions themselves are f32 in both.
    const double tension =
        spring.stiffness * (length(span) + spring.rest_length) + spring.damping * length(rate);
    const double error = 12 * kUlp * tension + 0.5 * force_unit;
    force[spring.node_a] += error;
    force[spring.node_b] += error;
  }
  // Four differences of positions and three sums round, and the stiffness.
  for (const auto& triple : system.bending) {
    const Vec3d &a = system.position[triple.node_a], &b = system.position[triple.node_b],
                &c = system.position[triple.node_c];
    const double error = 16 * kUlp * triple.stiffness * (length(a - b) + length(c - b) + kUlp * length(b));
    force[triple.node_a] += error;
    force[triple.node_b] += 2 * error;
    force[triple.node_c] += error;
  }
  std::vector<double> tolerance(system.position.size());
  for (std::size_t i = 0; i < tolerance.size(); ++i)
    tolerance[i] = dt * system.inverse_mass[i] * (force[i] * 2) +
                   4 * kUlp * (length(system.velocity[i]) + dt * 20) + grab_tolerance(system, i) +
                   dt * system.drag * (wind_tolerance(system, i) + 4 * kUlp * length(system.velocity[i]));
  return tolerance;
}

void check_one_step(SolverRig& rig, double force_unit) {
  reference::MassSpringSystem expected = rig.reference();
  const std::vector<double> tolerance = velocity_tolerance(expected, rig.dt(), force_unit);
  reference::advance(expected, rig.dt());
  rig.advance(1);
  const auto position = rig.positions(), velocity = rig.velocities();
  double worst = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double dv = std::abs(static_cast<double>(velocity[i].xyz()[axis]) - expected.velocity[i][axis]);
      const double dx = std::abs(static_cast<double>(position[i].xyz()[axis]) - expected.position[i][axis]);
      worst =
          std::max({worst, dv / tolerance[i],
                    dx / (rig.dt() * tolerance[i] + 2 * kUlp * (1 + std::abs(expected.position[i][axis])))});
    }
  }
  CHECK_MESSAGE(worst <= 1, "error / tolerance = ", worst);
}

}  // namespace

TEST_CASE("the springs of a grid have the stiffness of each kind, and its damping where there is any") {
  Body body;
  body.grid = mesh::Grid{5, 4, 1.0, 0.75};
  body.stiffness.structural = 50;
  body.stiffness.shear = 0;
  body.stiffness.bend = 7;
  body.damping = 0.5;
  const SpringGrid params = spring_grid(*body.grid, body.material(), body.first_vertex);
  const auto numbers = [](const Vec4f& v) { return std::array{v.x, v.y, v.z, v.w}; };
  CHECK(numbers(params.stiffness) == std::array{50.0F, 0.0F, 7.0F, 0.0F});
  CHECK(numbers(params.damping) == std::array{0.5F, 0.0F, 0.5F, 0.0F});
}

TEST_CASE("all formulations equal the reference within the rounding of one step, for grids of any size") {
  GpuFixture fixture;
  for (const auto& [nx, ny] : {std::pair{2U, 2U}, {2U, 5U}, {7U, 3U}, {13U, 29U}, {40U, 31U}}) {
    for (const char* forces : {"node_centric", "spring_centric", "spring_blocks"}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        CAPTURE(nx);
        CAPTURE(ny);
        CAPTURE(forces);
        CAPTURE(seed);
        SolverRig rig(fixture.device(), scene_of(cloth(nx, ny, forces)), 1e-4);
        rig.perturb(seed, 0.3 / nx, 1.0);
        const bool spring_centric = std::string(forces) != "node_centric";
        const auto fixed_point = force_fixed_point(rig.model().host.springs(), rig.model().vertex_count());
        check_one_step(rig, spring_centric ? 1 / static_cast<double>(fixed_point.scale) : 0);
      }
    }
  }
}

TEST_CASE(
    "bending equals the reference within the rounding of one step, on cells of any shape and along the "
    "boundary") {
  GpuFixture fixture;
  for (const auto& [nx, ny] : {std::pair{2U, 2U}, {3U, 4U}, {4U, 3U}, {23U, 40U}, {65U, 9U}})
    for (const char* mass : {R"("density": 0.2)", R"("node_mass": 0.001)"}) {
      CAPTURE(nx);
      CAPTURE(mass);
      const std::string sheet = R"("cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
                                R"(], "size": [1.0, 0.8], "damping": 0.01, "pins": ["top_left"],
        "stiffness": {"structural": 50, "shear": 20, "bend": 0, "bending": 0.02}, )" +
                                mass + "}]";
      SolverRig rig(fixture.device(), scene_of(sheet), 1e-4);
      rig.perturb(7, 0.3 / nx, 0.5);
      check_one_step(rig, 0);
    }
}

TEST_CASE("all formulations equal the reference on a mesh of any shape") {
  GpuFixture fixture;
  for (const char* forces : {"node_centric", "spring_centric", "spring_blocks"}) {
    for (const auto& mesh : {mesh::make_sphere(12, 9), sheet_mesh(9, 14, 1, 1.5)}) {
      CAPTURE(forces);
      const auto scene = scene_of(R"("solver": {"kind": "mass_spring", "forces": ")" + std::string(forces) +
                                  R"("}, "cloths": [{"mesh": "a.obj", "density": 0.3, "damping": 0.01,
                                  "stiffness": {"structural": 300, "shear": 100, "bend": 30},
                                  "pins": [{"nodes": [3]}]}])");
      SolverRig rig(fixture.device(), scene, 1e-4, {mesh});
      rig.perturb(5, 0.03, 0.5);
      const auto fixed_point = force_fixed_point(rig.model().host.springs(), rig.model().vertex_count());
      check_one_step(rig,
                     std::string(forces) != "node_centric" ? 1 / static_cast<double>(fixed_point.scale) : 0);
    }
  }
}

TEST_CASE("in gusts of any direction all three paths equal the reference") {
  GpuFixture fixture;
  const char* winds[] = {R"("velocity": [3, 0, 0])", R"("velocity": [-2, 1.5, 6], "wavelength": 0.13)",
                         R"("velocity": [0, -9, 0], "wavelength": 40)"};
  for (const char* wind : winds) {
    const std::string air = R"("drag": 7, "wind": {"gusts": 0.9, )" + std::string(wind) + "}, ";
    CAPTURE(wind);
    SolverRig grid(fixture.device(), scene_of(air + cloth(17, 11, "node_centric")), 1e-4);
    grid.perturb(3, 0.02, 1.0);
    check_one_step(grid, 0);
    SolverRig springs(fixture.device(), scene_of(air + cloth(17, 11, "spring_centric")), 1e-4);
    springs.perturb(4, 0.02, 1.0);
    const auto fixed_point =
        force_fixed_point(springs.model().host.springs(), springs.model().vertex_count());
    check_one_step(springs, 1 / static_cast<double>(fixed_point.scale));
    SolverRig mesh(
        fixture.device(),
        scene_of(air + R"("cloths": [{"mesh": "a.obj", "density": 0.3, "pins": [{"nodes": [3]}]}])"), 1e-4,
        {sheet_mesh(9, 14, 1, 1.5)});
    mesh.perturb(5, 0.02, 1.0);
    check_one_step(mesh, 0);
  }
}

TEST_CASE("with grabbed nodes all three paths equal the reference, and a pinned node cannot be grabbed") {
  GpuFixture fixture;
  const auto check = [](SolverRig& rig, double force_unit) {
    rig.perturb(6, 0.02, 1.0);
    rig.hold(20, {0.3, 0.1, 0.2}, 20, 10);
    rig.hold(0, {0.3, 0.1, 0.2}, 20, 10);  // pinned
    rig.hold(31, {5, -2, 0.2}, 20, 10);    // cut to the speed
    rig.hold(33, {-0.1, 0, 0}, 20, 10);
    const Vec4f pinned = rig.positions()[0];
    check_one_step(rig, force_unit);
    CHECK(rig.positions()[0] == pinned);
    CHECK(length(rig.velocities()[31].xyz()) == doctest::Approx(10));
  };
  SolverRig grid(fixture.device(), scene_of(cloth(9, 11, "node_centric")), 1e-4);
  check(grid, 0);
  SolverRig springs(fixture.device(), scene_of(cloth(9, 11, "spring_centric")), 1e-4);
  const auto fixed_point = force_fixed_point(springs.model().host.springs(), springs.model().vertex_count());
  check(springs, 1 / static_cast<double>(fixed_point.scale));
  SolverRig mesh(fixture.device(),
                 scene_of(R"("cloths": [{"mesh": "a.obj", "density": 0.3, "pins": [{"nodes": [0]}]}])"), 1e-4,
                 {sheet_mesh(9, 11, 1, 0.8)});
  check(mesh, 0);
}

TEST_CASE("a grid and the same sheet as a mesh of springs move alike") {
  GpuFixture fixture;
  // Without bend springs (a triangle mesh has other ones) and with nodes of equal mass, the two have the same
  // springs.
  const char* common =
      R"("node_mass": 0.001, "damping": 0.02, "stiffness": {"structural": 500, "shear": 200, "bend": 0})";
  SolverRig grid(fixture.device(),
                 scene_of(R"("cloths": [{"grid": [9, 12], "size": [0.8, 1.1], "plane": "xz", )" +
                          std::string(common) + R"(, "transform": {"translate": [0.4, 0, 0.55]}}])"),
                 1e-4);
  SolverRig mesh(fixture.device(), scene_of(R"("cloths": [{"mesh": "a.obj", )" + std::string(common) + "}]"),
                 1e-4, {sheet_mesh(9, 12, 0.8, 1.1)});
  grid.perturb(9, 0.01, 0.2);
  mesh.set(grid.positions(), grid.velocities());
  grid.advance(50);
  mesh.advance(50);
  const auto a = grid.positions(), b = mesh.positions();
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(length(a[i].xyz() - b[i].xyz()) < 2e-6F);
}

TEST_CASE("spring-centric forces of any cloth sum to exactly zero") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  for (std::uint64_t seed = 0; seed < 50; ++seed) {  // sizes are random, seldom a multiple of the workgroup
    Random random(seed);
    const auto count = 2 + random.below(400);
    Model host;
    host.rest_position.resize(count);
    host.start_position.resize(count);
    host.mass.assign(count, 1.0);
    host.motion.assign(count, 0);
    auto state = State::create(device, host, 1);
    REQUIRE_OK(state);
    std::vector<Vec4f> position(count), velocity(count);
    const auto draw = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
    for (Vec4f& x : position) x = {draw(1), draw(1), draw(1), 1};
    for (Vec4f& v : velocity) v = {draw(10), draw(10), draw(10), 0};
    ElementTable table{ElementKind::Spring, {}, {}, {}};
    for (std::uint32_t s = 0; s < 5 * count; ++s) {
      const std::uint32_t a = random.below(count), b = random.below(count);
      if (a != b)
        append(table, {a, b, 0.1F + draw(0.1), 100.0F * static_cast<float>(1 + random.below(100)), 1.0F});
    }
    const Springs springs(table);
    auto force = gpu::Buffer<std::int32_t>::create(device, 3UL * count, "force");
    REQUIRE_OK(force);
    const ForceFixedPoint fixed_point = force_fixed_point(springs, count);
    StepBlock params;
    params.nodes.count = count;
    params.method.spring_count = static_cast<std::uint32_t>(springs.size());
    params.method.force_scale = fixed_point.scale;
    params.method.force_limit = fixed_point.limit;
    state->steps.write(device, std::span(&params, 1));
    state->position[0].write(device, position);
    state->velocity[0].write(device, velocity);
    auto kernel = SpringForces::create(device, *state, springs, *force, 256);
    REQUIRE_OK(kernel);
    gpu::CommandList list;
    {
      gpu::ComputePass pass(list, "forces");
      kernel->record(pass);
    }
    const auto submitted = device.submit(list);
    REQUIRE_OK(submitted);
    const auto forces = gpu::download(device, *force);
    REQUIRE_OK(forces);
    std::int64_t sum[3] = {}, absolute = 0;
    for (std::size_t i = 0; i < forces->size(); ++i) {
      sum[i / count] += (*forces)[i];
      absolute += std::abs(static_cast<std::int64_t>((*forces)[i]));
    }
    CHECK(sum[0] == 0);
    CHECK(sum[1] == 0);
    CHECK(sum[2] == 0);
    CHECK(absolute > 0);
  }
}

TEST_CASE("springs in blocks end in the bits of springs one by one, on sheets and on any mesh") {
  GpuFixture fixture;
  const std::string mesh = R"(, "cloths": [{"mesh": "a.obj", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 300, "shear": 100, "bend": 30}}])";
  const auto solver = [](const char* forces) {
    return R"("solver": {"kind": "mass_spring", "forces": ")" + std::string(forces) + "\"}";
  };
  const auto check = [](SolverRig one_by_one, SolverRig blocks) {
    for (SolverRig* rig : {&one_by_one, &blocks}) {
      rig->perturb(9, 0.004, 1.0);
      rig->advance(20);
    }
    CHECK(same_bits(one_by_one.positions(), blocks.positions()));
    CHECK(same_bits(one_by_one.velocities(), blocks.velocities()));
  };
  gpu::Device& device = fixture.device();
  for (const auto& [nx, ny] : {std::pair{3U, 2U}, {47U, 53U}}) {  // one block, and some fifteen
    CAPTURE(nx);
    check({device, scene_of(cloth(nx, ny, "spring_centric")), 1e-4},
          {device, scene_of(cloth(nx, ny, "spring_blocks")), 1e-4});
  }
  const mesh::TriangleMesh sphere = mesh::make_sphere(40, 31);
  check({device, scene_of(solver("spring_centric") + mesh), 1e-4, {sphere}},
        {device, scene_of(solver("spring_blocks") + mesh), 1e-4, {sphere}});
}

TEST_CASE("a force buffer of the wrong size is a shape error with both sizes") {
  GpuFixture fixture;
  Model host;
  host.rest_position.resize(8);
  host.start_position.resize(8);
  host.mass.assign(8, 1.0);
  host.motion.assign(8, 0);
  auto state = State::create(fixture.device(), host, 1);
  auto force = gpu::Buffer<std::int32_t>::create(fixture.device(), 12, "force");
  ElementTable table{ElementKind::Spring, {}, {}, {}};
  append(table, {0, 1, 1, 1, 0});
  const auto made = SpringForces::create(fixture.device(), *state, Springs(table), *force, 256);
  REQUIRE_FALSE(made);
  CHECK(made.error().message == "Buffer force (12) is not three times buffer position (8).");
}

TEST_CASE("the fixed-point scale is the largest power of two for which the worst sum fits") {
  // A hub with 12 springs that all pull along x at the limit.
  ElementTable table{ElementKind::Spring, {}, {}, {}};
  for (std::uint32_t s = 1; s <= 12; ++s) append(table, {0, s, 0.02F, 1000, 0});
  const ForceFixedPoint fixed_point = force_fixed_point(Springs(table), 13);
  const double largest = 12 * std::round(static_cast<double>(fixed_point.scale * fixed_point.limit));
  CHECK(fixed_point.limit == doctest::Approx(20));
  CHECK(largest < 2147483648.0);
  CHECK(2 * largest >= 2147483648.0);
  CHECK(std::exp2(std::round(std::log2(static_cast<double>(fixed_point.scale)))) ==
        static_cast<double>(fixed_point.scale));
}

TEST_CASE("the state has the same bits for workgroups of 64, 128 and 256, and on every run") {
  GpuFixture fixture;
  for (const char* forces : {"node_centric", "spring_centric", "spring_blocks"}) {
    std::vector<Vec4f> position, velocity;
    for (const std::uint32_t workgroup : {64U, 128U, 256U, 256U}) {
      CAPTURE(forces);
      CAPTURE(workgroup);
      SolverRig rig(fixture.device(), scene_of(cloth(37, 28, forces)), 2e-4, {}, workgroup);
      rig.perturb(3, 0.005, 1.0);
      rig.advance(100);
      if (position.empty()) {
        position = rig.positions();
        velocity = rig.velocities();
      }
      CHECK(same_bits(rig.positions(), position));
      CHECK(same_bits(rig.velocities(), velocity));
    }
  }
}

TEST_CASE("a pinned node stays to the bit while the sheet moves") {
  GpuFixture fixture;
  SolverRig rig(fixture.device(), scene_of(cloth(6, 6, "node_centric")), 1e-3);
  const auto before = rig.positions();
  rig.advance(40);
  const auto after = rig.positions();
  for (const std::size_t pinned : {0UL, 5UL})
    CHECK(std::memcmp(&before[pinned], &after[pinned], sizeof(Vec4f)) == 0);
  CHECK(length(after[20].xyz() - before[20].xyz()) > 0.001F);
}
