// Hundreds of nodes grabbed at once, as a hem is pinned: by every method, in every host's hands.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "method/method.hpp"
#include "reference/simulation.hpp"
#include "scene/names.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

constexpr std::uint32_t kWide = 40, kHigh = 30;

/// A sheet of 40 x 30 nodes, 1 m wide, whose uppermost row is y = 0.4 m.
scene::Scene sheet(const Method& method, const std::string& members = "", const std::string& cloth = "") {
  const std::string kind = scene::name_of(method.kind);
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "contact": {"method": "none"}, "drag": 1, "solver": {"kind": ")" + kind +
          R"("}, "cloths": [{"grid": [40, 30], "size": [1, 0.8], "density": 0.2, "damping": 0.01,
          "stiffness": {"structural": 400, "shear": 100, "bend": 2})" +
          cloth + "}]" + members + "}",
      "sheet.json");
  REQUIRE_OK(scene);
  return std::move(*scene);
}
std::string method_word(const Method& method) { return scene::name_of(method.kind); }
const Method& explicit_method() { return method_of(scene::SolverKind::MassSpring); }

std::vector<Vec3f> places(sim::World& world) {
  const auto snapshot = world.snapshot();
  REQUIRE_OK(snapshot);
  std::vector<Vec3f> places;
  for (const Vec4f& x : snapshot->position) places.push_back(x.xyz());
  return places;
}

/// Grabs nodes where they are.
void pin(sim::World& world, std::span<const std::uint32_t> nodes) {
  const std::vector<Vec3f> now = places(world);
  for (const std::uint32_t node : nodes) {
    const auto grabbed = world.grab(node, now[node].to<double>());
    REQUIRE_OK(grabbed);
  }
}

/// Every fourth node, three hundred of all rows.
std::vector<std::uint32_t> every_fourth() {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < kWide * kHigh; node += 4) nodes.push_back(node);
  return nodes;
}

/// The uppermost row, as grabs of a scene or as nodes.
std::vector<std::uint32_t> upper_row() {
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t i = 0; i < kWide; ++i) nodes.push_back(i);
  return nodes;
}

double farthest(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, length((a[n] - b[n]).to<double>()));
  return most;
}

}  // namespace

TEST_CASE(
    "of a sheet with 300 pinned nodes these stay to the bit by every method, and the others hang from them") {
  GpuFixture fixture;
  const std::vector<std::uint32_t> pinned = every_fourth();
  const std::set<std::uint32_t> held(pinned.begin(), pinned.end());
  for (const Method& method : methods()) {
    CAPTURE(method_word(method));
    auto world = world_of(fixture.device(), sheet(method));
    const std::vector<Vec3f> start = places(*world);
    pin(*world, pinned);
    advance(*world, 12);
    const std::vector<Vec3f> now = places(*world);
    std::size_t moved = 0, sunk = 0;
    for (std::uint32_t node = 0; node < now.size(); ++node) {
      if (held.count(node) != 0) moved += now[node] == start[node] ? 0 : 1;
      if (held.count(node) == 0) sunk += now[node].y < start[node].y ? 1 : 0;
    }
    CHECK(moved == 0);
    CHECK(sunk == 900);
    // Half of them are let go: they fall, and the other half stays.
    for (std::size_t k = 0; k < pinned.size(); k += 2) REQUIRE(world->release(pinned[k]));
    advance(*world, 5);
    const std::vector<Vec3f> later = places(*world);
    for (std::size_t k = 0; k < pinned.size(); ++k)
      CHECK((later[pinned[k]] == start[pinned[k]]) == (k % 2 == 1));
  }
}

TEST_CASE("a row that is grabbed where it is holds the sheet as the scene's own pins do, by every method") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(method_word(method));
    // As many substeps in both: "auto" counts on the pinned ones, and so on a slower network.
    const auto frames = [&](const std::string& cloth) {
      return sheet(method, R"(, "time": {"substeps": 40})", cloth);
    };
    auto by_scene = world_of(fixture.device(), frames(R"(, "pins": ["top"])"));
    auto by_hand = world_of(fixture.device(), frames(""));
    pin(*by_hand, upper_row());
    advance(*by_scene, 12);
    advance(*by_hand, 12);
    const std::vector<Vec3f> a = places(*by_scene), b = places(*by_hand);
    double way = 0;
    for (const Vec3f& place : a) way = std::max(way, 0.4 - static_cast<double>(place.y));
    MESSAGE(method_word(method), ": ", farthest(a, b), " m apart");
    CHECK(way > 0.8);
    // Kernels ask whether a node is held, not by what: the same bits. By "projective_dynamics" the host chooses the
    // rates of the sweeps by what is pinned, so there they are the same but for rounding.
    CHECK(farthest(a, b) <= (method.kind == scene::SolverKind::ProjectiveDynamics ? 1e-6 : 0));
  }
}

TEST_CASE("a saved state with 300 pinned nodes goes on to the same bits, in its own world and in another") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), sheet(explicit_method()));
  pin(*world, every_fourth());
  advance(*world, 3);
  const auto state = world->save("a build");
  REQUIRE_OK(state);
  CHECK(state->grabs.size() == 300);
  const std::vector<std::byte> bytes = sim::write_saved_state(*state);
  advance(*world, 4);
  const std::string hash = hash_of(*world);
  const auto read = sim::read_saved_state(bytes);
  REQUIRE_OK(read);
  auto other = world_of(fixture.device(), sheet(explicit_method()));
  for (sim::World* goes_on : {world.get(), other.get()}) {
    REQUIRE(goes_on->open(*read));
    CHECK(goes_on->grabbed().size() == 300);
    advance(*goes_on, 4);
    CHECK(hash_of(*goes_on) == hash);
  }
}

TEST_CASE("beyond 1024 grabbed nodes one more is refused, in a saved state too") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), sheet(explicit_method()));
  std::vector<std::uint32_t> nodes(scene::kMaxGrabs);
  for (std::uint32_t node = 0; node < nodes.size(); ++node) nodes[node] = node;
  pin(*world, nodes);
  const auto refused = world->grab(1100, {});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message ==
        "Node 1100 cannot be grabbed: 1024 nodes are grabbed and the scene's own grabs need 0; the limit is "
        "1024 at once.");
  const std::vector<Vec3f> start = places(*world);
  advance(*world, 2);
  const std::vector<Vec3f> now = places(*world);
  CHECK(std::equal(now.begin(), now.begin() + 1024, start.begin()));
  CHECK(now[1100] != start[1100]);
  auto state = world->save("a build");
  REQUIRE_OK(state);
  state->grabs.push_back({1100, {}});
  const auto read = sim::read_saved_state(sim::write_saved_state(*state));
  REQUIRE_FALSE(read);
  CHECK(read.error().message == "The saved state has 1025 grabbed nodes; the limit is 1024.");
}

TEST_CASE(
    "many grabs of a scene, a node that two hold within a frame, and a hand's besides are the reference's") {
  GpuFixture fixture;
  // The nodes of the upper row are held in turn, each for 0.06 s, and drawn forward. Node 100 goes from one place to
  // another in the middle of a frame.
  std::string grabs =
      R"({"node": {"nodes": [100]}, "end": 0.041, "path": [{"time": 0, "point": [0.01, 0.34, 0.02]}]},
    {"node": {"nodes": [100]}, "start": 0.041, "path": [{"time": 0, "point": [0.01, 0.34, -0.02]}]})";
  const auto number = [](double value) { return std::to_string(value); };
  for (std::uint32_t i = 0; i < kWide; ++i) {
    const std::string x = number(-0.5 + i / 39.0);
    grabs += R"(, {"node": {"nodes": [)" + std::to_string(i) + R"(]}, "start": )" + number(0.0007 * i) +
             R"(, "end": )" + number(0.06 + 0.0007 * i) + R"(, "path": [{"time": 0, "point": [)" + x +
             R"(, 0.4, 0]}, {"time": 0.1, "point": [)" + x + ", 0.4, 0.05]}]}";
  }
  const auto course = [&](const std::string& more, std::span<const std::uint32_t> by_hand) {
    const auto scene = [&](const std::string& all) {
      return sheet(explicit_method(), "", R"(, "grabs": [)" + all + "]");
    };
    auto world = world_of(fixture.device(), scene(grabs));
    auto exact = reference::Simulation::create(scene(grabs + more), world->assets());
    REQUIRE_OK(exact);
    pin(*world, by_hand);
    double drawn = 0;
    for (int frame = 0; frame < 6; ++frame) {
      advance(*world, 1);
      REQUIRE(exact->advance_frame());
      const std::vector<Vec3f> now = places(*world);
      double apart = 0;
      for (std::size_t n = 0; n < now.size(); ++n)
        apart = std::max(apart, length(now[n].to<double>() - exact->positions()[n]));
      CHECK(apart < 1e-5);  // of f32 over places of up to 0.5 m
      drawn = std::max(drawn, exact->positions()[20].z);
    }
    CHECK(drawn > 0.005);
  };
  course("", {});
  // A hand at the far corner has a slot of its own; the reference has it as one more of the scene's.
  course(R"(, {"node": "bottom_right", "path": [{"time": 0, "point": [0.5, -0.4, 0]}]})",
         std::array{kWide * kHigh - 1});
}
