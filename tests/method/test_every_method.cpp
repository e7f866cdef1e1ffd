// What every method must do, whatever its equations: a new row of method/table.cpp is tested here without a word.
#include <algorithm>
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "method/method.hpp"
#include "method/stepper.hpp"
#include "scene/names.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

std::string word_of(const Method& method) { return scene::name_of(method.kind); }
std::string by(const Method& method) { return R"("solver": {"kind": ")" + word_of(method) + R"("}, )"; }

std::string sheet(const std::string& grid, const std::string& more = "") {
  return R"("cloths": [{"grid": )" + grid + R"(, "size": [1.0, 0.8], "density": 0.2, "damping": 0.02,
      "stiffness": {"structural": 500, "shear": 200, "bend": 20})" +
         more + "}]";
}

}  // namespace

TEST_CASE("a loose sheet of every method falls by g t²/2, within what one step makes of it") {
  GpuFixture fixture;
  const double h = 1.0 / 512;  // exact in f32
  const int steps = 128;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    SolverRig rig(fixture.device(), scene_of(by(method) + sheet("[6, 5]")), h);
    const auto start = rig.positions();
    rig.advance(steps);
    const auto end = rig.positions();
    const double time = steps * h, fall = 0.5 * kGravity * time * time;
    for (std::size_t i = 0; i < end.size(); ++i) {
      // A consistent step takes a velocity from one of its two ends: g h a step off, and g t h in all at most.
      CHECK(std::abs(static_cast<double>(start[i].y - end[i].y) - fall) < kGravity * time * h);
      // It goes nowhere else: each step rounds a place below 1 m by 2^-24, and springs give back as much at most.
      CHECK(std::abs(end[i].x - start[i].x) < 2 * steps * 0x1p-24F);
    }
  }
}

TEST_CASE(
    "drag that stops cloth within a step neither shakes it nor throws it, by every method that is stable") {
  GpuFixture fixture;
  const double h = 1.0 / 512, drag = 4000;  // 7.8 in a step
  const int steps = 128;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    const scene::Scene scene = scene_of(by(method) + R"("drag": 4000, )" + sheet("[6, 5]"));
    SolverRig rig(fixture.device(), scene, h);
    if (method.step_limit(scene, rig.model().host).largest_step > 0) continue;  // explicit steps
    const auto start = rig.positions();
    rig.advance(steps);
    const auto end = rig.positions();
    const double speed = kGravity / drag;  // which it has after some steps, and each rounds its place
    for (std::size_t i = 0; i < end.size(); ++i)
      CHECK(std::abs(static_cast<double>(start[i].y - end[i].y) - speed * steps * h) <
            4 * speed * h + steps * 0x1p-24);
  }
}

TEST_CASE(
    "drag bears nothing of what hangs at rest, by every method that has the stiffness of its elements") {
  GpuFixture fixture;
  const double h = 1.0 / 512, spacing = 0.1, stiffness = 500, density = 0.2;
  // Of a strip of three rows of cells: 2.5, 1.5 and 0.5 rows hang below them.
  const double sag = 4.5 * density * kGravity * spacing * spacing / stiffness;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    if (method.stiffening != nullptr) continue;
    const std::string sweeps = method.sweeps ? R"(, "iterations": 100)" : "";
    SolverRig rig(fixture.device(),
                  scene_of(R"("solver": {"kind": ")" + word_of(method) + "\"" + sweeps + R"(}, "drag": 100,
                           "cloths": [{"grid": [2, 4], "size": [0.1, 0.3], "plane": "xy", "density": 0.2,
                             "damping": 0, "pins": ["top"],
                             "stiffness": {"structural": 500, "shear": 0, "bend": 0}}])"),
                  h);
    const auto lowest = [&] {
      double least = HUGE_VAL;
      for (const Vec4f& place : rig.positions()) least = std::min(least, static_cast<double>(place.y));
      return least;
    };
    const double start = lowest();
    rig.advance(512);
    CHECK(start - lowest() == doctest::Approx(sag).epsilon(0.02).scale(0));
  }
}

TEST_CASE("with every method a pinned node stays to the bit while the sheet moves") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    SolverRig rig(fixture.device(),
                  scene_of(by(method) + sheet("[6, 6]", R"(, "pins": ["top_left", "top_right"])")), 1e-3);
    const auto before = rig.positions();
    rig.advance(40);
    const auto after = rig.positions();
    for (const std::size_t pinned : {0UL, 5UL})
      CHECK(std::memcmp(&before[pinned], &after[pinned], sizeof(Vec4f)) == 0);
    CHECK(length(after[20].xyz() - before[20].xyz()) >
          1e-4F);  // g t² / 2 is 8 mm; by pbd no spring stretches
  }
}

TEST_CASE(
    "a hundred steps of every method have the same bits for workgroups of 64, 128 and 256, and on every "
    "run") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    std::vector<Vec4f> position, velocity;
    for (const std::uint32_t workgroup : {64U, 128U, 256U, 256U}) {
      CAPTURE(workgroup);
      SolverRig rig(fixture.device(), scene_of(by(method) + sheet("[37, 28]", R"(, "pins": ["top_left"])")),
                    2e-4, {}, workgroup);
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

TEST_CASE("every method's row says what its solver allocates for a grid, within 10 %") {
  GpuFixture fixture;
  gpu::Device& device = fixture.device();
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    const auto scene = scene_of(by(method) + sheet("[128, 128]"));
    auto host = build_model(scene, {{}});
    REQUIRE_OK(host);
    auto model = GpuModel::create(device, std::move(*host));
    REQUIRE_OK(model);
    auto state = State::create(device, model->host, 1);
    REQUIRE_OK(state);
    const auto contacts = Contacts::create_pairs(device, model->host, {1000, 1000}, {method.holds_obstacles});
    REQUIRE_OK(contacts);
    const std::uint64_t before = device.allocated_bytes();
    device.take_largest_buffer();
    const auto solver = make_solver(scene.solver, {device, *model, *state, 1.0 / 480, &*contacts});
    REQUIRE_OK(solver);
    const double found = static_cast<double>(device.allocated_bytes() - before) / model->vertex_count();
    const double largest = static_cast<double>(device.take_largest_buffer()) / model->vertex_count();
    const SolverMemory memory = method.memory(scene.solver);
    CHECK(std::abs(found - memory.node) < 0.1 * found + 1);  // 1: blocks of 256 bytes
    if (largest > 16)
      CHECK(std::abs(largest - memory.largest_buffer) < 0.1 * largest);  // 16: the state's own
  }
}

TEST_CASE("a cloth with elements that a method does not take is refused, and the methods that do are named") {
  auto bent = scene_of(R"("cloths": [{"grid": [4, 4], "size": [1, 1], "density": 0.2},
      {"grid": [4, 4], "size": [1, 1], "density": 0.2, "stiffness": {"bending": 1e-4}}])");
  auto model = build_model(bent, {{}, {}});
  REQUIRE_OK(model);
  std::size_t takers = 0;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    const bool takes =
        std::find(method.takes.begin(), method.takes.end(), ElementKind::Triple) != method.takes.end();
    bent.solver.kind = method.kind;
    const auto checked = choose_method(bent, *model);
    CHECK(static_cast<bool>(checked) == takes);
    if (takes) ++takers;
    if (checked) continue;
    CHECK(checked.error().kind == ErrorKind::Input);
    CHECK(checked.error().message ==
          "test.json: cloths[1] has bending of grids (stiffness.bending), which solver.kind \"" +
              word_of(method) + "\" does not take; \"multigrid\", \"mass_spring\" or \"fem\" does.");
  }
  CHECK(takers == 3);  // those that the sentence names
}
