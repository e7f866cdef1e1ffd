// Cloth that begins in a tangle comes apart: from itself, from other cloth, out of meshes, at a bounded
// speed.

#include "base/file.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact_rig.hpp"
#include "mesh/obj.hpp"
#include "mesh/primitives.hpp"
#include "temporary_folder.hpp"

using namespace weft;

namespace {

constexpr double kThickness = 0.01;  // m

/// A sheet of 0.4 m by 0.4 m, turned about z, soft enough for eight substeps.
std::string sheet(int side, const std::string& translate, double degrees = 0, const std::string& more = "") {
  const std::string count = std::to_string(side);
  const double half = degrees * std::acos(-1.0) / 360;
  return R"({"grid": [)" + count + "," + count +
         R"(], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {"translate": )" +
         translate + R"(, "rotate": [0, 0, )" + std::to_string(std::sin(half)) + "," +
         std::to_string(std::cos(half)) + "]}" + more + "}";
}

/// Without gravity, so that all that moves is moved by contact.
scene::Scene tangle(const std::string& cloths, const std::string& collider = "", const char* gravity = "0") {
  return contact_scene(std::string(R"("gravity": [0, )") + gravity +
                       R"(, 0], "time": {"substeps": 8},
    "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
                       cloths + "]" + (collider.empty() ? "" : R"(, "colliders": [)" + collider + "]"));
}

struct Untangled {
  std::uint32_t frames = 0;  // until nothing had passed through anything, three frames long
  double fastest = 0;        // m/s, of any frame
  double kinetic = 0;        // J, after the last
};

Untangled untangle(sim::World& world, std::uint32_t most) {
  Untangled run;
  const std::size_t start = passed(world);
  for (std::uint32_t clean = 0; clean < 3 && run.frames < most; ++run.frames) {
    advance(world, 1);
    const Moment now(world);
    REQUIRE(now.finite());
    clean = passed(world, now, world.assets().objects) == 0 ? clean + 1 : 0;
    run.fastest = std::max(run.fastest, now.largest_speed());
    run.kinetic = 0;
    for (std::size_t i = 0; i < now.mass.size(); ++i)
      run.kinetic += 0.5 * now.mass[i] * dot(now.velocity[i], now.velocity[i]);
  }
  MESSAGE(start, " passed at first, ", passed(world), " after ", run.frames, " frames; searches saw ",
          world.totals().crossings, ", then ", world.totals().crossings_left, "; fastest ", run.fastest,
          " m/s, kinetic ", run.kinetic, " J, stretch ", world.totals().max_stretch);
  return run;
}

/// Comes apart, and stays so: no faster than contact's own springs drive anything.
void check_separates(sim::World& world, std::uint32_t most) {
  REQUIRE(passed(world) > 0);
  const Untangled run = untangle(world, most);
  CHECK(passed(world) == 0);
  CHECK(world.totals().crossings > 0);
  CHECK(world.totals().crossings_left == 0);
  // Twice the speed of untangling in either direction: cloth that was stretched on its way out springs back.
  const double spring_speed = 2 * kUntanglePart * kThickness / world.step();
  CHECK(run.fastest < 3 * spring_speed);
  double mass = 0;
  for (const double m : Moment(world).mass) mass += m;
  CHECK(run.kinetic < 0.5 * mass * spring_speed * spring_speed);
}

std::string mesh_collider(const TemporaryFolder& folder, const mesh::TriangleMesh& mesh) {
  REQUIRE(write_file(folder.path("object.obj"), mesh::write_obj(mesh)));
  return R"({"kind": "mesh", "mesh": ")" + folder.path("object.obj") + "\"}";
}
mesh::TriangleMesh ball(float radius) {
  mesh::TriangleMesh made = mesh::make_sphere(16, 12);
  for (Vec3f& p : made.positions) p = radius * p;
  return made;
}
/// 0.3 m by 0.3 m in the plane x = 0, of eighteen triangles: it has a rim.
mesh::TriangleMesh plate() {
  mesh::TriangleMesh made;
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::uint32_t i = 0; i < 4; ++i)
      made.positions.push_back(
          {0, 0.1F * static_cast<float>(i) - 0.15F, 0.1F * static_cast<float>(j) - 0.15F});
  for (std::uint32_t j = 0; j < 3; ++j)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t a = 4 * j + i;
      made.triangles.push_back({a, a + 1, a + 4});
      made.triangles.push_back({a + 1, a + 5, a + 4});
    }
  return made;
}

constexpr const char* kPinned = R"(, "pins": ["top_left", "top_right"])";

/// Two sheets one above the other, with vertices of each pushed through the other.
std::unique_ptr<sim::World> pinched(gpu::Device& device, const sim::WorldOptions& options = {}) {
  auto world =
      world_of(device, tangle(sheet(10, "[0, 0, 0]") + "," + sheet(10, "[0.01, 0.012, 0.013]")), options);
  auto snapshot = world->snapshot();
  REQUIRE_OK(snapshot);
  snapshot->position[44].y += 0.03F;
  snapshot->position[144].y -= 0.02F;
  snapshot->position[145].y -= 0.03F;
  REQUIRE(world->restore(*snapshot));
  return world;
}

}  // namespace

TEST_CASE("a free sheet that begins right through a pinned one comes apart from it") {
  GpuFixture fixture;
  for (const char* at : {"[0, 0.1, 0]", "[0.03, 0, 0.02]", "[0.12, 0.03, 0.05]"}) {
    CAPTURE(at);
    auto world =
        world_of(fixture.device(), tangle(sheet(9, "[0, 0, 0]", 0, kPinned) + "," + sheet(8, at, 90)));
    check_separates(*world, 60);
  }
}

TEST_CASE("two free sheets that begin crossed at 30 degrees come apart, and keep their momentum") {
  GpuFixture fixture;
  for (const char* at : {"[0, 0.05, 0]", "[0.03, 0, 0.02]", "[0.12, 0.03, 0.05]"}) {
    CAPTURE(at);
    auto world = world_of(fixture.device(), tangle(sheet(9, "[0, 0, 0]") + "," + sheet(8, at, 30)));
    check_separates(*world, 60);
    const Moment now(*world);
    double mass = 0;
    for (const double m : now.mass) mass += m;
    MESSAGE("momentum ", length(now.momentum(0, now.mass.size())), " kg m/s, truncated ",
            world->totals().truncated);
    // Three roundings of 2^-23 of a velocity of about 1 m/s in a substep. What a plane truncates or its
    // reach, some vertices, loses what it had.
    if (world->totals().truncated == 0)
      CHECK(length(now.momentum(0, now.mass.size())) < world->frame() * 8 * 3 * 0x1p-23 * mass);
  }
}

TEST_CASE(
    "sheets whose vertices are pinched through each other come apart with the same bits in every group "
    "size") {
  GpuFixture fixture;
  std::string hash;
  for (const std::uint32_t size : {256U, 128U, 64U}) {
    auto world = pinched(fixture.device(), {.workgroup_size = size});
    check_separates(*world, 60);
    if (hash.empty()) hash = hash_of(*world);
    CHECK(hash_of(*world) == hash);
  }
}

TEST_CASE("lists that are too short for a tangle grow, and the bits are the same") {
  GpuFixture fixture;
  const scene::Scene crossed = tangle(sheet(9, "[0, 0, 0]") + "," + sheet(8, "[0.03, 0, 0.02]", 30));
  auto roomy = world_of(fixture.device(), crossed);
  auto tight = world_of(fixture.device(), crossed, {.contact_room = ContactRoom{8, 8, 8}});
  for (sim::World* world : {roomy.get(), tight.get()}) advance(*world, 6);
  CHECK(tight->totals().repeated_frames > 0);
  CHECK(tight->totals().crossings == roomy->totals().crossings);
  CHECK(roomy->totals().crossings > 10);
  CHECK(hash_of(*tight) == hash_of(*roomy));
}

TEST_CASE("a sheet that is folded through itself comes apart") {
  GpuFixture fixture;
  for (const bool dented : {false, true}) {
    CAPTURE(dented);
    auto world = world_of(fixture.device(), tangle(sheet(12, "[0, 0, 0]")));
    auto snapshot = world->snapshot();
    REQUIRE_OK(snapshot);
    // Folded over at x = 0 on a half circle; then the upper half leans down through the lower, or is dented.
    for (Vec4f& p : snapshot->position) {
      if (!(p.x > 0)) continue;
      const double radius = dented ? 0.014 : 0.03, lean = dented ? 0 : 0.75, x = p.x, z = p.z;  // m, rad
      const double turn = std::min(x / radius, std::acos(-1.0) + lean), flat = x - turn * radius;
      const double from_dent = (flat - 0.08) * (flat - 0.08) + z * z;
      p.x = static_cast<float>(radius * std::sin(turn) + flat * std::cos(turn));
      p.y = static_cast<float>(radius * (1 - std::cos(turn)) + flat * std::sin(turn) -
                               (dented ? 0.045 * std::exp(-from_dent / 0.004) : 0));
    }
    REQUIRE(world->restore(*snapshot));
    check_separates(*world, 60);
  }
}

TEST_CASE("triangles of one cloth that touch at rest are no tangle when they cross; others are") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  for (const float apart : {1e-5F, 2e-3F}) {  // m, at rest; 0.2 mm are a fiftieth of the thickness
    CAPTURE(apart);
    mesh::TriangleMesh pair;
    pair.positions = {{-0.2F, 0, -0.2F}, {0.2F, 0, -0.2F}, {0, 0, 0.2F}};
    for (std::size_t k = 0; k < 3; ++k)
      pair.positions.push_back({0.3F * pair.positions[k].x, apart, 0.3F * pair.positions[k].z});
    pair.triangles = {{0, 1, 2}, {3, 4, 5}};
    REQUIRE(write_file(folder.path("pair.obj"), mesh::write_obj(pair)));
    auto world = world_of(fixture.device(),
                          tangle(R"({"mesh": ")" + folder.path("pair.obj") + R"(", "density": 0.3})"));
    change_state(*world, [](std::size_t node, Vec3d& x, Vec3d&) {
      if (node == 3) x.y = -2e-3;
    });
    REQUIRE(passed(*world) > 0);
    advance(*world, 1);
    CHECK((world->totals().crossings > 0) == (apart > 1e-3F));
  }
}

TEST_CASE("a sheet that begins through a ball that is a mesh comes out of it, even from its middle") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  const std::string object = mesh_collider(folder, ball(0.1F));
  for (const char* at : {"[0.003, 0.012, 0.002]", "[0.003, 0.031, 0.001]", "[0, 0, 0]"}) {
    CAPTURE(at);
    auto world = world_of(fixture.device(), tangle(sheet(12, at), object));
    check_separates(*world, 40);
    CHECK(reference::inside_mesh(Moment(*world).position, world->assets().objects[0]).count == 0);
  }
}

TEST_CASE("a sheet that begins through a box comes out of it, over its top, its side and its corner") {
  GpuFixture fixture;
  for (const char* at : {"[0, 0.06, 0.01]", "[0.21, 0, 0.02]", "[0.25, 0.03, 0.2]"}) {
    CAPTURE(at);
    auto world =
        world_of(fixture.device(),
                 tangle(sheet(12, at), R"({"kind": "box", "center": [0, 0, 0], "size": [0.2, 0.2, 0.2]})"));
    check_separates(*world, 40);
    CHECK(reference::inside_mesh(Moment(*world).position, world->assets().objects[0]).count == 0);
  }
}

TEST_CASE("a sheet that begins through a plate, a mesh with a rim, comes apart from it") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  const std::string object = mesh_collider(folder, plate());
  for (const char* at : {"[0, 0.05, 0]", "[0.1, 0.01, 0.02]", "[0.15, 0.02, 0.03]"}) {
    CAPTURE(at);
    auto world = world_of(fixture.device(), tangle(sheet(12, at), object));
    check_separates(*world, 60);
  }
}

TEST_CASE("long: a sheet that begins through the head and the arms of the armadillo comes out of it") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(),
                        shipped_scene("drape-armadillo", {{"cloths.0.grid", "[24,24]"},
                                                          {"gravity", "[0, 0, 0]"},
                                                          {"cloths.0.transform.translate", "[0, 1, 0]"}}));
  const std::size_t before = passed(*world);
  advance(*world, 45);
  MESSAGE(before, " passed at first, ", passed(*world), " after");
  CHECK(passed(*world) == 0);
  CHECK(world->totals().crossings_left == 0);
}

TEST_CASE("cloth whose pins keep it in a tangle neither flies apart nor moves faster than it is pulled") {
  GpuFixture fixture;
  // Both are pinned at their corners, which no way apart can bring past each other.
  auto world = world_of(
      fixture.device(),
      tangle(
          sheet(9, "[0, 0, 0]", 0, R"(, "pins": ["top_left", "top_right", "bottom_left", "bottom_right"])") +
              "," +
              sheet(8, "[0.03, 0, 0.02]", 90,
                    R"(, "pins": ["top_left", "top_right", "bottom_left", "bottom_right"])"),
          "", "-9.81"));
  const Untangled run = untangle(*world, 90);
  CHECK(world->totals().crossings > 0);
  CHECK(run.fastest < 4 * kUntanglePart * kThickness / world->step() + 9.81 * 0.5);
  CHECK(world->totals().max_stretch < 2);
}

TEST_CASE("crossings without a size or a side, and states that are not finite, neither hang nor explode") {
  GpuFixture fixture;
  // In one plane, one at the other's middle line, and folded to a line.
  for (int kind = 0; kind < 3; ++kind) {
    CAPTURE(kind);
    auto world = world_of(fixture.device(),
                          tangle(sheet(7, "[0, 0, 0]") + "," +
                                 sheet(7, kind == 0 ? "[0.05, 0, 0.03]" : "[0, 0, 0]", kind == 1 ? 90 : 0)));
    auto snapshot = world->snapshot();
    REQUIRE_OK(snapshot);
    if (kind == 2)
      for (std::size_t i = 49; i < 98; ++i) snapshot->position[i].x = snapshot->position[i].y = 0.01F;
    REQUIRE(world->restore(*snapshot));
    double fastest = 0;  // the root mean square of all
    for (int frame = 0; frame < 20; ++frame) {
      advance(*world, 1);
      const Moment now(*world);
      REQUIRE(now.finite());
      double sum = 0;
      for (const Vec3d& v : now.velocity) sum += dot(v, v);
      fastest = std::max(fastest, std::sqrt(sum / static_cast<double>(now.velocity.size())));
    }
    MESSAGE("fastest ", fastest, " m/s, left ", world->totals().crossings_left);
    if (kind == 1) {
      advance(*world, 30);
      CHECK(passed(*world) == 0);
    }
    // Twice the speed at which crossings come apart. Of single vertices, which several crossings drive and springs
    // throw back, chance decides: sheets that differ by 1 % in density have 2 to 12 times that speed.
    if (kind != 2) CHECK(fastest < 2 * kUntanglePart * kThickness / world->step());
  }
  auto world = pinched(fixture.device());
  world->set_node(45, {0, NAN, 0, 1}, {});
  REQUIRE(world->advance_frame());
  const auto finished = world->finish();
  REQUIRE_FALSE(finished);
  CHECK(finished.error().kind == ErrorKind::Diverged);
}
