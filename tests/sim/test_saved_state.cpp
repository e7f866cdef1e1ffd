// A world that goes on from saved bytes ends in the bits of the one that never stopped.
#include <algorithm>
#include <cstring>

#include "animated_box.hpp"
#include "base/random.hpp"
#include "base/state_hash.hpp"
#include "contact_rig.hpp"
#include "mesh/primitives.hpp"
#include "method/method.hpp"
#include "scene/names.hpp"

using namespace weft;

namespace {

constexpr std::uint32_t kBefore = 4, kAfter = 3;  // frames

struct Case {
  std::string contact;  // the word of contact.method
  std::string members;  // of the scene
};

/// A sheet that is moved at a corner, pulled at another, blown at in gusts, and folds over what moves below it.
std::string moved_sheet(const std::string& elements) {
  return R"({"grid": [11, 9], "size": [0.4, 0.4], "plane": "xz", )" + elements +
         R"(, "transform": {"translate": [0, 0.13, 0]},
    "motions": [{"nodes": "top_left", "kind": "rotation", "axis": [0, 0, 1], "center": [0, 0.13, 0], "speed": 2}],
    "grabs": [{"node": "bottom_right", "start": 0.04, "path": [{"time": 0, "point": [0, 0.3, 0]}]}]})";
}
const std::string kSprings =
    R"("density": 0.3, "damping": 0.01, "stiffness": {"structural": 40, "shear": 10, "bend": 0.3})";
const std::string kWeather =
    R"("drag": 0.3, "wind": {"velocity": [0.5, 0.2, 1], "gusts": 0.7, "wavelength": 0.2}, )";
const std::string kMovingBall = R"({"kind": "sphere", "center": [0.02, 0, 0.01], "radius": 0.12)";
const std::string kItsMotion =
    R"(, "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 0.2, "ramp": 0.02}})";
const std::string kAnimatedBox = R"({"kind": "mesh", "mesh": "box.glb", "animation": {"rate": 40}})";

std::vector<Case> sheet_cases(const std::string& elements) {
  const auto with = [&](const std::string& contact, const std::string& colliders) {
    const std::string more =
        contact == "proximity" ? R"(, "self": true, "thickness": 0.01)" : R"(, "thickness": 0.01)";
    return Case{contact, kWeather + R"("contact": {"method": ")" + contact + "\"" +
                             (contact == "none" ? "" : more) + R"(}, "cloths": [)" + moved_sheet(elements) +
                             R"(], "colliders": [)" + colliders + "]"};
  };
  return {with("none", ""), with("paper", kMovingBall + "}"), with("bvh", kMovingBall + "}"),
          with("proximity", kMovingBall + kItsMotion + ", " + kAnimatedBox)};
}

std::unique_ptr<sim::World> world_with_box(gpu::Device& device, const scene::Scene& scene) {
  return world_from(
      device, scene,
      load_assets(
          scene,
          [](const std::string&) -> Result<mesh::TriangleMesh> { return mesh::make_geodesic_sphere(3); },
          [](const std::string&) {
            return mesh::AnimatedMesh::read(
                animated_box({0.5, 0.1, 0.5}, {0, 0.05, 0.1}, {-0.1F, -0.07F, -0.1F}));
          }));
}

std::vector<std::byte> saved(sim::World& world) {
  const auto state = world.save("a build");
  REQUIRE_OK(state);
  return sim::write_saved_state(*state);
}

void open(sim::World& world, std::span<const std::byte> bytes) {
  const auto state = sim::read_saved_state(bytes);
  REQUIRE_OK(state);
  const auto opened = world.open(*state);
  REQUIRE_OK(opened);
}

/// All totals but those that depend on how long the lists were at first.
std::string totals_text(const sim::World& world) {
  std::string text;
  for_each(world.totals(), [&](const std::string& name, auto value) {
    if (name != "repeated_frames") text += name + " " + std::to_string(value) + "\n";
  });
  return text;
}

/// A world of these members with 9 substeps a frame, so that each frame ends in the other buffer, stops in the middle.
void check_goes_on(gpu::Device& device, const std::string& members) {
  const scene::Scene scene = contact_scene(R"("time": {"substeps": 9}, )" + members);
  auto world = world_with_box(device, scene);
  advance(*world, kBefore);
  const std::vector<std::byte> bytes = saved(*world);
  const std::vector<Vec4f> creases =
      world->snapshot()->creases;  // of cloth that keeps bends, and has kept some
  CHECK((creases.empty() ||
         std::any_of(creases.begin(), creases.end(), [](const Vec4f& c) { return c.w > 0; })));
  CHECK(bytes.size() <=
        sim::most_saved_bytes(world->model().vertex_count(), world->state().creases.size(), 0));
  advance(*world, kAfter);
  auto other = world_with_box(device, scene);
  open(*other, bytes);
  CHECK(other->frame() == kBefore);
  CHECK(saved(*other) == bytes);
  advance(*other, kAfter);
  CHECK(hash_of(*other) == hash_of(*world));
  CHECK(totals_text(*other) == totals_text(*world));
}

constexpr std::size_t kLength = 16, kChecksum = 24,
                      kContentAt = 32;  // bytes before these, and before the content

template <class Value>
void put_at(std::vector<std::byte>& bytes, std::size_t at, Value value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}
/// With the length and the checksum that these bytes would have if they were meant.
std::vector<std::byte> sealed(std::vector<std::byte> bytes) {
  put_at(bytes, kLength, std::uint64_t{bytes.size()});
  put_at(bytes, kChecksum, bytes_hash(std::span(bytes).subspan(kContentAt)));
  return bytes;
}
std::string refusal(std::span<const std::byte> bytes) {
  const auto state = sim::read_saved_state(bytes);
  REQUIRE(!state);
  CHECK(state.error().kind == ErrorKind::Input);
  return state.error().message;
}

/// Three by three nodes in still air.
scene::Scene small(const std::string& members, const std::string& of_cloth = R"("density": 0.2)") {
  return contact_scene(members + R"("contact": {"method": "none"},
      "cloths": [{"grid": [3, 3], "size": [0.2, 0.2], "pins": ["top_left"], )" +
                       of_cloth + "}]");
}

bool takes(const Method& method, ElementKind kind) {
  return std::find(method.takes.begin(), method.takes.end(), kind) != method.takes.end();
}
std::string word(const Method& method) { return scene::name_of(method.kind); }
std::string solver_of(const Method& method) { return R"("solver": {"kind": ")" + word(method) + R"("}, )"; }

}  // namespace

TEST_CASE("cloth of springs by every method and contact goes on from saved bytes to the same bits") {
  GpuFixture fixture;
  for (const Method& method : methods())
    for (const Case& one : sheet_cases(kSprings)) {
      CAPTURE(word(method));
      CAPTURE(one.contact);
      check_goes_on(fixture.device(), solver_of(method) + one.members);
    }
}

TEST_CASE(
    "fabric by every method that takes it goes on from saved bytes to the same bits, in air and contact") {
  GpuFixture fixture;
  const std::string fabric = R"("density": 0.3, "fabric": {"warp": 40, "weft": 30, "shear": 8, "poisson": 0.2,
      "bending_warp": 1e-4, "bending_weft": 1e-4, "bending_twist": 1e-4)";
  for (const Method& method : methods())
    if (takes(method, ElementKind::Membrane)) {
      CAPTURE(word(method));
      // It keeps what bends it by more than 0.08 rad a cell.
      const std::string plastic = method.flat_fabric ? "}" : R"(, "plastic": {"yield_curvature": 2}})";
      check_goes_on(fixture.device(),
                    solver_of(method) + R"("air": {}, )" + sheet_cases(fabric + plastic).back().members);
    }
}

TEST_CASE("bodies by every method that takes them go on from saved bytes to the same bits") {
  GpuFixture fixture;
  for (const Method& method : methods())
    if (takes(method, ElementKind::Tet)) {
      CAPTURE(word(method));
      const bool corotated = method.kind == scene::SolverKind::ProjectiveDynamics;  // it takes no other
      check_goes_on(fixture.device(), solver_of(method) +
                                          R"("contact": {"method": "proximity", "thickness": 0.01},
          "bodies": [{"block": [2, 2, 2], "size": [0.16, 0.16, 0.16], "density": 500,
                      "material": {"young": 2e3, "poisson": 0.45, "energy": ")" +
                                          (corotated ? "corotated" : "neo_hookean") + R"("},
                      "transform": {"translate": [0, 0.1, 0]}}],
          "colliders": [)" + kMovingBall + kItsMotion +
                                          "]");
    }
}

TEST_CASE("a ball of gas by every method goes on from saved bytes to the same bits") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word(method));
    check_goes_on(fixture.device(), solver_of(method) +
                                        R"("contact": {"method": "proximity", "thickness": 0.01},
          "cloths": [{"mesh": "ball.ply", "density": 0.3, "pressure": {"gauge": 100, "ambient": 2000},
                      "damping": 0.01, "stiffness": {"structural": 20, "shear": 0, "bend": 1},
                      "transform": {"scale": 0.1, "translate": [0, 0.24, 0]}}],
          "colliders": [)" + kMovingBall +
                                        kItsMotion + "]");
  }
}

TEST_CASE("a rigid body by every method goes on from saved bytes to the same bits") {
  GpuFixture fixture;
  for (const Method& method : methods()) {
    CAPTURE(word(method));
    check_goes_on(fixture.device(), solver_of(method) +
                                        R"("contact": {"method": "proximity", "thickness": 0.01},
          "cloths": [{"grid": [9, 9], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "pins": ["corners"],
                      "damping": 0.01, "stiffness": {"structural": 20, "shear": 8, "bend": 1}}],
          "colliders": [{"kind": "box", "center": [0.01, 0.07, 0], "size": [0.1, 0.08, 0.1],
                         "rigid": {"mass": 0.03, "velocity": [0, -1, 0], "spin": [3, 1, 2]}}])");
  }
}

TEST_CASE("what a hand holds and air that was changed go on from saved bytes too") {
  GpuFixture fixture;
  const std::string sheet = R"("contact": {"method": "none"}, "cloths": [)" + moved_sheet(kSprings) + "]";
  auto world = world_of(fixture.device(), contact_scene(kWeather + sheet));
  const scene::Scene changed =
      contact_scene(R"("drag": 0.6, "wind": {"velocity": [1, 0, -2], "gusts": 0.4}, )" + sheet);
  advance(*world, 2);
  REQUIRE(world->change(changed));
  REQUIRE(world->grab(50, {0.1, 0.4, 0.1}));
  advance(*world, 2);
  const std::vector<std::byte> bytes = saved(*world);
  auto other = world_of(fixture.device(), changed);
  open(*other, bytes);
  advance(*other, kAfter);
  advance(*world, kAfter);
  CHECK(hash_of(*other) == hash_of(*world));
  open(*world, bytes);  // what it went on to is forgotten
  advance(*world, kAfter);
  CHECK(hash_of(*other) == hash_of(*world));
  CHECK(other->release(50));  // it holds it
}

TEST_CASE("a saved state fits a scene that moves in the same way, and no other") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), small(""));
  advance(*world, 2);
  const auto state = world->save("a build");
  REQUIRE_OK(state);
  for (const std::string members : {R"("title": "b", "time": {"frames": 7}, )",
                                    R"("render": {"size": [64, 32]}, )", R"("gravity": [0, -9.81, 0], )"}) {
    CAPTURE(members);
    CHECK(world_of(fixture.device(), small(members))->open(*state));
  }
  CHECK(world_of(fixture.device(), small("", R"("density": 0.2, "color": [1, 0, 0], "name": "b")"))
            ->open(*state));
  for (const scene::Scene& scene : {small(R"("gravity": [0, -9.8, 0], )"), small("", R"("density": 0.3)"),
                                    small(R"("time": {"substeps": 12}, )")}) {
    auto other = world_of(fixture.device(), scene);
    advance(*other, 1);
    const std::string before = hash_of(*other);
    const auto opened = other->open(*state);
    REQUIRE(!opened);
    CHECK(opened.error().kind == ErrorKind::Input);
    CHECK(opened.error().message.find("The saved state is of another scene: its hash is ") == 0);
    CHECK(hash_of(*other) == before);
    CHECK(other->frame() == 1);
  }
  sim::SavedState heavier = *state;
  heavier.snapshot.position[4].w *= 2;
  CHECK(world->open(heavier).error().message.find("Node 4 of the saved state has an inverse mass of ") == 0);
  sim::SavedState shorter = *state;
  shorter.snapshot.velocity.pop_back();
  CHECK(world->open(shorter).error().message ==
        "The snapshot has 9 positions and 8 velocities; this scene has 9 nodes.");
  sim::SavedState elsewhere = *state;
  elsewhere.snapshot.position[0].y += 1;  // it is pinned
  CHECK(world->open(elsewhere).error().message.find("Node 0 of the snapshot is 1 m from where") == 0);
  sim::SavedState holding = *state;
  holding.grabs.push_back({0, {}});
  CHECK(world->open(holding).error().message == "Node 0 cannot be grabbed: it is pinned.");
  advance(*world, 1);
  CHECK(world->frame() == 3);  // as if none of them had been tried
}

TEST_CASE("a world that has diverged goes on from a saved state") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), small(""));
  advance(*world, 2);
  const std::vector<std::byte> bytes = saved(*world);
  advance(*world, 2);
  const std::string hash = hash_of(*world);
  world->set_node(4, {NAN, 0, 0, 1}, {});
  REQUIRE(world->advance_frame());
  CHECK(world->finish().error().kind == ErrorKind::Diverged);
  open(*world, bytes);
  advance(*world, 2);
  CHECK(hash_of(*world) == hash);
  CHECK(world->totals().frames == 4);
}

TEST_CASE("a saved state that was cut off or spoiled is refused at every byte, in a sentence") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), small(R"("solver": {"kind": "multigrid"}, )"));
  advance(*world, 2);
  REQUIRE(world->grab(8, {0, 1, 0}));
  const std::vector<std::byte> whole = saved(*world);
  REQUIRE(sim::read_saved_state(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::span<const std::byte> part = std::span(whole).first(size);
    const std::string said = refusal(part);
    CHECK(said.find(size < kContentAt ? "A saved state begins with 32 bytes; here there are "
                                      : "The saved state should have ") == 0);
    if (size >= kContentAt)
      CHECK(refusal(sealed({part.begin(), part.end()})).find("The saved state ends within ") == 0);
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::vector<std::byte> spoiled = whole;
    spoiled[at] ^= std::byte{0x10};
    CHECK(refusal(spoiled) != "");
  }
  std::vector<std::byte> other = whole;
  other.push_back({});
  CHECK(refusal(sealed(other)) == "The saved state has 1 bytes behind its end.");
  other = whole;
  put_at(other, 0, 'W');
  CHECK(refusal(other) == "This is no saved state of weft: it does not begin with \"weftsave\".");
  other = whole;
  put_at(other, 8, std::uint32_t{6});
  CHECK(refusal(other) == "The saved state is of version 6; this weft reads version 5.");
}

TEST_CASE(
    "bytes of a saved state that lie, with the checksum that fits, are refused or go on, and break nothing") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), small(R"("solver": {"kind": "multigrid"}, )"));
  advance(*world, 2);
  REQUIRE(world->grab(8, {0, 1, 0}));
  const std::vector<std::byte> whole = saved(*world);
  Random random(7);
  int opened = 0;
  for (int k = 0; k < 20000; ++k) {
    std::vector<std::byte> bytes = whole;
    const std::size_t at =
        kContentAt + random.below(static_cast<std::uint32_t>(bytes.size() - kContentAt - 8));
    if (k % 3 == 0) put_at(bytes, at, std::uint64_t{1} << random.below(64));
    if (k % 3 == 1) put_at(bytes, at, static_cast<std::uint8_t>(random.below(256)));
    if (k % 3 == 2) put_at(bytes, at, ~std::uint64_t{0});
    const auto state = sim::read_saved_state(sealed(std::move(bytes)));
    if (!state) {
      CHECK(state.error().kind == ErrorKind::Input);
    } else if (world->open(*state)) {
      ++opened;
    }
  }
  CHECK(opened > 0);  // what a node's speed was, say
  const auto finished = world->finish();
  REQUIRE_OK(finished);
}
