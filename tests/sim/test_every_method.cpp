// What a world must do with every method: a new row of method/table.cpp is tested here without a word. Each takes its
// own "auto" steps, unless it says otherwise.
#include <algorithm>
#include <cmath>

#include "contact_rig.hpp"
#include "method/method.hpp"
#include "reference/simulation.hpp"
#include "relative_error.hpp"
#include "scene/names.hpp"

using namespace weft;

namespace {

std::string word_of(const Method& method) { return scene::name_of(method.kind); }
/// Solved so far that what is left does not hide differences.
std::string by(const Method& method) {
  const bool solves = method.kind == scene::SolverKind::Multigrid;
  return R"("solver": {"kind": ")" + word_of(method) + (solves ? R"(", "residual": 1e-4}, )" : R"("}, )");
}

std::vector<Vec3d> places_of(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  std::vector<Vec3d> places;
  for (const Vec4f& x : snapshot->position) places.push_back(x.xyz().to<double>());
  return places;
}

/// How far a world and the reference have come apart, as a part of the way.
double apart(gpu::Device& device, const scene::Scene& scene, int frames, std::uint64_t least_contacts = 0) {
  auto world = world_of(device, scene);
  auto exact = reference::Simulation::create(scene, world->assets());
  REQUIRE_OK(exact);
  CHECK(exact->substeps() == world->substeps());
  const std::vector<Vec3d> start = exact->positions();
  advance(*world, static_cast<std::uint32_t>(frames));
  for (int frame = 0; frame < frames; ++frame) REQUIRE(exact->advance_frame());
  CHECK(world->totals().contacts >= least_contacts);
  return relative_error(places_of(*world), exact->positions(), start);
}

const std::string kSoft =
    R"("density": 0.2, "damping": 0.01, "stiffness": {"structural": 40, "shear": 10, "bend": 0.3})";

/// A sheet that falls on a ball and a floor.
scene::Scene falling(const Method& method, const std::string& members, const std::string& cloth = "") {
  return contact_scene(by(method) + members +
                       R"("contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
                       lying_cloth(12, "[0, 0.22, 0]", cloth) + R"(],
    "colliders": [{"kind": "sphere", "center": [0.01, 0.1, 0.02], "radius": 0.1},
                  {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
}

}  // namespace

TEST_CASE("frames of every method are the reference's, with wind, air, a motion and a hand") {
  GpuFixture fixture;
  for (const Method& method : methods())
    for (const char* air : {"", R"("air": {}, )"}) {
      CAPTURE(word_of(method));
      const scene::Scene scene = contact_scene(
          by(method) + air +
          R"("contact": {"method": "none"}, "drag": 0.5, "wind": {"velocity": [1, 0, 2], "gusts": 0.5},
        "cloths": [{"grid": [17, 13], "size": [1, 0.8], "pins": ["top_left"], )" +
          kSoft +
          R"(, "motions": [{"nodes": "top_right", "kind": "line", "direction": [-1, 0, 0], "speed": 0.5}],
          "grabs": [{"node": "bottom_left", "start": 0.05, "end": 0.1,
                     "path": [{"time": 0, "point": [0, 0.5, 1]}]}]}])");
      const double error = apart(fixture.device(), scene, 10);
      MESSAGE(word_of(method), ": ", error, " of the way apart");
      CHECK(error < 1e-3);  // of f32, where cloth folds and differences grow
    }
}

TEST_CASE("cloth of every method meets obstacles as the reference does") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    // Without friction: where it acts, a node may stick a substep sooner in f32 than in double. For three frames of
    // contact: what bounces multiplies a difference by two to five a frame (test_reference.cpp).
    const scene::Scene scene = falling(method, R"("drag": 0.5, )", R"(, "friction": 0)");
    const double error = apart(fixture.device(), scene, 6, 100);
    MESSAGE(word_of(method), ": ", error, " of the way apart");
    CHECK(error < 1e-3);
  }
}

TEST_CASE("a ball of gas of every method falls and breathes as the reference's, above an obstacle or none") {
  GpuFixture fixture;
  for (const Method& method : methods())
    for (const char* contact : {R"("none")", R"("proximity", "thickness": 0.001)"}) {
      CAPTURE(word_of(method));
      CAPTURE(contact);
      const scene::Scene scene = contact_scene(by(method) + R"("contact": {"method": )" + contact +
                                               R"(}, "drag": 0.5, "cloths": [{"mesh": "sphere",
            "transform": {"scale": 0.1, "translate": [0, 0.5, 0]}, )" +
                                               kSoft + R"(, "pressure": {"gauge": 300, "ambient": 3000}}],
          "colliders": [{"kind": "sphere", "center": [0.01, 0, 0.02], "radius": 0.1}])");
      // It does not arrive there, but methods that answer obstacles solve two systems a substep.
      const double error = apart(fixture.device(), scene, 8);
      MESSAGE(word_of(method), ": ", error, " of the way apart");
      CHECK(error < 1e-3);  // as of sheets
    }
}

TEST_CASE("cloth of every method drapes over a ball, passes through nothing, and has the same bits again") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word_of(method));
    const scene::Scene scene =
        falling(method, R"("time": {"substeps": 9}, )");  // it ends in the other buffer
    auto world = world_of(fixture.device(), scene);
    std::size_t through = 0;
    for (int frame = 0; frame < 20; ++frame) {
      advance(*world, 1);
      through += passed(*world);
    }
    CHECK(through == 0);
    CHECK(world->totals().contacts > 500);
    const std::string hash = hash_of(*world);
    REQUIRE(world->reset());
    advance(*world, 20);
    CHECK(hash_of(*world) == hash);
    auto small = world_of(fixture.device(), scene, {.workgroup_size = 64});
    advance(*small, 20);
    CHECK(hash_of(*small) == hash);
  }
}

TEST_CASE(
    "every method that says it is stable at any step survives 500 of 100 times the stiffness, and jerked "
    "pins") {
  GpuFixture fixture;
  const std::string jump = R"("motions": [{"nodes": "top", "kind": "path",
      "points": [[0.1, [0, 0, 0]], [0.1167, [1, 0, 0]], [0.5, [1, 0, 0]], [0.5167, [0, 0.5, -0.5]]]}])";
  for (const Method& method : methods()) {
    const auto sheet = [&](const std::string& stiffness, const std::string& more) {
      return contact_scene(by(method) + R"("time": {"substeps": 8}, "contact": {"method": "none"},
          "cloths": [{"grid": [33, 25], "size": [2, 1.5], "density": 0.2, "damping": 0.01,
                      "stiffness": {)" +
                           stiffness + "}, " + more + "}]");
    };
    const std::string stiff = R"("structural": 5e5, "shear": 2e5, "bend": 5e4)";
    for (const auto& scene : {sheet(stiff, R"("pins": ["top_left", "top_right"])"), sheet(stiff, jump)}) {
      CAPTURE(word_of(method));
      auto world = world_of(fixture.device(), scene);
      if (world->plan().limit().largest_step > 0) continue;
      advance(*world, 63);  // a node that is not finite ends it
      const Moment end(*world);
      for (const Vec3d& x : end.position) CHECK(length(x) < 5);
      CHECK(end.largest_speed() < 60);  // a pin goes at 60 m/s
    }
  }
}

namespace {

/// A cloth of so many nodes a side.
std::string square(int side, const char* x, const char* more = "") {
  return R"({"grid": [)" + std::to_string(side) + ", " + std::to_string(side) +
         R"(], "size": [1, 1], "plane": "xz",
      "density": 0.2, "stiffness": {"structural": 10, "shear": 2, "bend": 0.1}, "transform": {"translate": [)" +
         x + ", 0.011, 0]}" + more + "}";
}

struct Equal {
  std::vector<Vec3d> places;
  std::size_t dispatches;  // of a frame
};
Equal run_equal(gpu::Device& device, const std::string& members, const std::string& cloths,
                const sim::WorldOptions& options) {
  auto world = world_of(device, contact_scene(members + R"("cloths": [)" + cloths + "]"), options);
  advance(*world, 2);
  return {places_of(*world), world->frame_commands(0, world->substeps()).dispatch_count()};
}

}  // namespace

TEST_CASE("cloths that are equal, which may share dispatches, have the bits that they have among others") {
  GpuFixture fixture;
  // The first hangs, the second falls to the floor. 70 a side: two levels of a cycle are no part of its tail.
  constexpr std::size_t kNodes = 70 * 70, kOthers = 20 * 20;
  const std::string hangs = square(70, "0", R"(, "pins": ["left", "right"])"), falls = square(70, "4"),
                    other = square(20, "-4");
  for (const Method& method : methods()) {
    for (const bool contact : {true, false}) {
      CAPTURE(word_of(method));
      CAPTURE(contact);
      const std::string members =
          by(method) + (contact ? R"("contact": {"method": "proximity", "thickness": 0.01},
            "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}], )"
                                : R"("contact": {"method": "none"}, )");
      const sim::WorldOptions options{.two_steps =
                                          true};  // the solver that can does so where nothing touches
      const Equal together = run_equal(fixture.device(), members, other + "," + hangs + "," + falls, options),
                  apart = run_equal(fixture.device(), members, hangs + "," + other + "," + falls, options);
      REQUIRE(together.places.size() == 2 * kNodes + kOthers);
      std::size_t differ = 0, moved = 0;
      for (std::size_t node = 0; node < kNodes; ++node) {
        const Vec3d& one = together.places[kOthers + node];
        const Vec3d& two = together.places[kOthers + kNodes + node];
        differ += one != apart.places[node] ? 1 : 0;
        differ += two != apart.places[kNodes + kOthers + node] ? 1 : 0;
        moved += length(two - one - Vec3d{4, 0, 0}) > 1e-4 ? 1 : 0;
      }
      CHECK(differ == 0);
      CHECK(moved > 100);  // they are two
      CHECK(together.dispatches <= apart.dispatches);
      if (!method.sweeps) CHECK(together.dispatches < apart.dispatches);
    }
  }
}
