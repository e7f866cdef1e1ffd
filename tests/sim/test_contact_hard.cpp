// Contact by proximity under things that move, fast ones, and states that are bad from the start.
#include <fstream>

#include "base/random.hpp"
#include "contact_rig.hpp"
#include "mesh/primitives.hpp"
#include "temporary_folder.hpp"

using namespace weft;

namespace {

std::string contact_text(const std::string& thickness, int substeps = 8) {
  return R"("time": {"substeps": )" + std::to_string(substeps) +
         R"(}, "contact": {"method": "proximity", "thickness": )" + thickness + "}, ";
}

/// Runs frames and says in how many of them something had passed through something.
std::uint32_t bad_frames(sim::World& world, std::uint32_t frames) {
  std::uint32_t bad = 0;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    advance(world, 1);
    const std::size_t count = passed(world);
    if (count != 0 && bad++ == 0) MESSAGE("frame ", world.frame(), ": ", count, " have passed");
  }
  return bad;
}

/// A box of 0.1 m with its top at y = 0, which is raised by `lift`, and by `bulge` more where x > 0 [m].
void write_box(const std::string& path, double lift, double bulge) {
  mesh::TriangleMesh box = mesh::make_box({0.3, 0.1, 0.3});
  std::ofstream file(path);
  for (const Vec3f& p : box.positions) {
    const double y = static_cast<double>(p.y) - 0.05, top = p.y > 0 ? lift + (p.x > 0 ? bulge : 0) : 0;
    file << "v " << p.x << " " << y + top << " " << p.z << "\n";
  }
  for (const mesh::Triangle& t : box.triangles)
    file << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
}

}  // namespace

TEST_CASE("a box that moves carries the sheet that lies on it") {
  GpuFixture fixture;
  auto world = world_of(
      fixture.device(),
      contact_scene(
          contact_text("0.01") + R"("cloths": [)" + lying_cloth(6, "[0, 0.01, 0]") +
          R"(], "colliders": [{"kind": "box", "center": [0, -0.1, 0], "size": [1, 0.2, 1], "friction": 0.4,
      "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 0.3, "start": 0.1, "ramp": 0.2}}])"));
  advance(*world, 60);  // the ramp asks 1.5 m/s², friction gives 3.9 m/s²
  const Moment now(*world);
  for (const Vec3d& v : now.velocity) CHECK(length(v - Vec3d{0.3, 0, 0}) < 1e-3);
  CHECK(std::abs(now.mean_position().x - 0.3 * (1 - 0.1 - 0.1)) < 1e-3);
}

TEST_CASE("a box that is pulled away too fast leaves the sheet behind, by as much as friction says") {
  GpuFixture fixture;
  auto world = world_of(
      fixture.device(),
      contact_scene(
          contact_text("0.01") + R"("cloths": [)" + lying_cloth(6, "[0, 0.01, 0]") +
          R"(], "colliders": [{"kind": "box", "center": [0, -0.1, 0], "size": [4, 0.2, 1], "friction": 0.1,
      "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 2}}])"));
  advance(*world, 30);
  CHECK(Moment(*world).mean_velocity().x == doctest::Approx(0.1 * 9.81 * 0.5).epsilon(0.02).scale(0));
}

TEST_CASE("a sphere that spins under a sheet drags it along, and turns it no faster than itself") {
  GpuFixture fixture;
  const auto turned = [&](const std::string& friction) {
    auto world = world_of(
        fixture.device(),
        contact_scene(
            contact_text("0.01") + R"("cloths": [)" + lying_cloth(9, "[0, 0.31, 0]") +
            R"(], "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 0.3, "friction": )" +
            friction + R"(,
        "motion": {"kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 3, "ramp": 0.3}}])"));
    CHECK(bad_frames(*world, 40) == 0);
    const Moment now(*world);
    double rate = 0, moment = 0;
    for (std::size_t i = 0; i < now.position.size(); ++i) {
      const Vec3d &p = now.position[i], &v = now.velocity[i];
      rate += p.z * v.x - p.x * v.z;
      moment += p.x * p.x + p.z * p.z;
    }
    return rate / moment;
  };
  CHECK(turned("0") == doctest::Approx(0).epsilon(0.05));
  const double rate = turned("0.8");
  MESSAGE("turns at ", rate, " 1/s");
  CHECK(rate > 1.5);
  CHECK(rate < 3.3);
}

TEST_CASE("a mesh that deforms pushes a sheet up and does not come through") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  write_box(folder.path("low.obj"), 0, 0);
  write_box(folder.path("high.obj"), 0.15, 0.1);
  auto world = world_of(
      fixture.device(),
      contact_scene(contact_text("0.01") + R"("cloths": [)" + lying_cloth(10, "[0.02, 0.01, 0.01]") +
                    R"(], "colliders": [{"kind": "mesh", "mesh": ")" + folder.path("low.obj") +
                    R"(", "keyframes": [{"time": 0.3, "mesh": ")" + folder.path("high.obj") + "\"}]}]"));
  std::uint32_t bad = 0;
  for (int frame = 1; frame <= 24; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    mesh::TriangleMesh object = world->assets().objects[0];
    const mesh::TriangleMesh last{world->assets().deformations[0].shapes[0],
                                  world->assets().objects[0].triangles};
    const float part = std::min(1.0F, static_cast<float>(world->time() / 0.3));
    for (std::size_t i = 0; i < object.positions.size(); ++i)
      object.positions[i] = object.positions[i] + part * (last.positions[i] - object.positions[i]);
    if (passed(*world, now, {object}) != 0) ++bad;
  }
  CHECK(bad == 0);
  const Moment now(*world);
  double highest = 0;
  for (const Vec3d& p : now.position) highest = std::max(highest, p.y);
  CHECK(highest > 0.2);  // the raised side stands at 0.25 m
}

TEST_CASE("a ball that flies at one, ten and a hundred thicknesses a substep does not get through a sheet") {
  GpuFixture fixture;
  for (const double times : {1.0, 10.0, 100.0}) {
    CAPTURE(times);
    const double thickness = 0.01, step = 1.0 / 60 / 8, speed = times * thickness / step;
    const std::string text = std::to_string(speed), start = std::to_string(1.5 / 60);
    const double from = -0.25;  // it sets off at 1.5 frames and goes 0.6 m
    const scene::Scene scene =
        shipped_scene("shot", {{"cloths.0.grid", "[12,12]"},
                               {"contact.thickness", std::to_string(thickness)},
                               {"time.substeps", "8"},
                               {"colliders.0.center", "[0.08, 0, " + std::to_string(from) + "]"},
                               {"colliders.0.motion.speed", text},
                               {"colliders.0.motion.start", start},
                               {"colliders.0.motion.ramp", "0"},
                               {"colliders.0.motion.distance", "0.6"}});
    auto world = world_of(fixture.device(), scene);
    CHECK(bad_frames(*world, times > 1 ? 6 : 36) == 0);
    // The sheet is ahead of the ball wherever it is within its radius.
    const Moment now(*world);
    std::uint32_t near = 0;
    for (const Vec3d& p : now.position) {
      if (std::hypot(p.x - 0.08, p.y) > 0.1) continue;
      ++near;
      CHECK(p.z > from + 0.6);
    }
    MESSAGE("truncated ", world->totals().truncated, ", nodes ahead ", near, ", largest speed ",
            now.largest_speed());
    CHECK(near > 0);
  }
}

namespace {

/// Of the upper sheet's nodes that are `kRim` cells or more from its rim, those above and below the lower one, along y.
struct Sides {
  int above = 0, below = 0;
};
Sides sides_of_upper(const Moment& now, int side) {
  constexpr int kRim = 2;
  const auto of_lower = [&](int row, int column) { return now.position[row * side + column]; };
  const auto twice_area = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  };
  Sides sides;
  for (int i = kRim; i < side - kRim; ++i)
    for (int j = kRim; j < side - kRim; ++j) {
      const Vec3d& node = now.position[side * side + i * side + j];
      for (int row = 0; row + 1 < side; ++row)
        for (int column = 0; column + 1 < side; ++column)
          for (const int corner : {0, 1}) {
            const Vec3d a = of_lower(row + corner, column + corner), b = of_lower(row, column + 1),
                        c = of_lower(row + 1, column);
            const double u = twice_area(node, b, c), v = twice_area(a, node, c), w = twice_area(a, b, node);
            if (!(u >= 0 && v >= 0 && w >= 0) && !(u <= 0 && v <= 0 && w <= 0)) continue;
            const double height = (u * a.y + v * b.y + w * c.y) / (u + v + w);
            ++(node.y > height ? sides.above : sides.below);
          }
    }
  return sides;
}

}  // namespace

TEST_CASE("sheets that fly at each other at one, ten and a hundred thicknesses a substep do not pass") {
  GpuFixture fixture;
  for (const double times : {1.0, 10.0, 100.0}) {
    CAPTURE(times);
    constexpr int kSide = 10;
    constexpr std::uint32_t kNodes = kSide * kSide;
    auto world =
        world_of(fixture.device(), contact_scene(R"("gravity": [0, 0, 0], )" + contact_text("0.01") +
                                                 R"("cloths": [)" + lying_cloth(kSide, "[0, 0, 0]") + "," +
                                                 lying_cloth(kSide, "[0.013, 0.05, 0.017]") + "]"));
    const double speed = 0.5 * times * 0.01 / world->step();
    push(*world, 0, kNodes, {0, speed, 0});
    push(*world, kNodes, 2 * kNodes, {0, -speed, 0});
    // They meet in the first frame; later they may slide off each other, and which is above says nothing then.
    CHECK(bad_frames(*world, 1) == 0);
    const Sides sides = sides_of_upper(Moment(*world), kSide);
    CHECK(sides.above > 0);
    CHECK(sides.below == 0);
    CHECK(bad_frames(*world, 7) == 0);
    MESSAGE("truncated ", world->totals().truncated, ", above ", sides.above, ", largest speed ",
            Moment(*world).largest_speed());
  }
}

TEST_CASE("a fine sheet at rest that another one strikes goes along with it, and momentum is kept") {
  GpuFixture fixture;
  // Flat cloth of this grid has a slack of 1 mm, and is given 2 and 4 mm a substep.
  constexpr int kSide = 65;
  constexpr std::uint32_t kNodes = kSide * kSide;
  for (const double speed : {2.0, 4.0}) {
    CAPTURE(speed);
    auto world =
        world_of(fixture.device(),
                 contact_scene(R"("solver": {"kind": "multigrid"}, "gravity": [0, 0, 0], )" +
                               contact_text("0.003") + R"("cloths": [)" + lying_cloth(kSide, "[0, 0, 0]") +
                               "," + lying_cloth(kSide, "[0.0013, 0.006, 0.0017]") + "]"));
    push(*world, kNodes, 2 * kNodes, {0, -speed, 0});
    const Moment start(*world);
    CHECK(bad_frames(*world, 3) == 0);
    const Moment now(*world);
    const double given = length(start.momentum(0, 2 * kNodes));
    MESSAGE("of the momentum the lower has ", -now.momentum(0, kNodes).y / given, ", lost ",
            length(now.momentum(0, 2 * kNodes) - start.momentum(0, 2 * kNodes)) / given, ", truncated ",
            world->totals().truncated);
    CHECK(world->totals().truncated < 1e-3 * 2 * kNodes * 8 * 3);  // no more is said of a run
    CHECK(-now.momentum(0, kNodes).y > 0.4 * given);
    CHECK(length(now.momentum(0, 2 * kNodes) - start.momentum(0, 2 * kNodes)) < 1e-3 * given);
  }
}

TEST_CASE("a sheet that another one strikes does not get through a floor that it flew along") {
  GpuFixture fixture;
  // The floor is 1.3 thicknesses below: in the first step no pair with it is near, until the lower sheet is struck.
  const std::string floors[] = {
      R"("kind": "plane", "point": [0, -0.0039, 0], "normal": [0, 1, 0])",
      R"("kind": "box", "center": [0, -0.1039, 0], "size": [4, 0.2, 4])",
      R"("kind": "capsule", "a": [-2, -2.0039, 0], "b": [2, -2.0039, 0], "radius": 2)"};
  for (const std::string& floor : floors)
    for (const double times : {3.0, 5.0, 50.0}) {
      CAPTURE(floor);
      CAPTURE(times);
      auto world = world_of(
          fixture.device(),
          contact_scene(
              R"("gravity": [0, 0, 0], "time": {"frame": 0.002, "substeps": 1}, "contact": {"method": "proximity", )"
              R"("thickness": 0.003}, "cloths": [)" +
              lying_cloth(10, "[0, 0, 0]") + "," + lying_cloth(10, "[0.013, 0.004, 0.017]") +
              R"(], "colliders": [{)" + floor + "}]"));
      const double thickness = 0.003 / world->step();  // [m/s]
      push(*world, 0, 100, {0.3 * thickness, 0, 0});   // so fast that it may go far before the next search
      push(*world, 100, 200, {0.3 * thickness, -times * thickness, 0});
      CHECK(bad_frames(*world, 6) == 0);
      CHECK(world->totals().contacts > 500);
    }
}

TEST_CASE(
    "a flag whose patches fly apart at one, ten and a hundred thicknesses a substep passes nowhere through "
    "itself") {
  GpuFixture fixture;
  constexpr std::uint32_t kSide = 24, kPatch = 6;
  for (const double times : {1.0, 10.0, 100.0}) {
    CAPTURE(times);
    auto world = world_of(fixture.device(), shipped_scene("flag", {{"cloths.0.grid", "[24,24]"}}));
    auto snapshot = world->snapshot();
    REQUIRE_OK(snapshot);
    const double speed = times * world->scene().contact.thickness / world->step();
    Random random(7);
    std::vector<Vec3d> ways;
    for (std::uint32_t k = 0; k < (kSide / kPatch) * (kSide / kPatch); ++k) {
      const Vec3d way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      ways.push_back(way / length(way));
    }
    for (std::uint32_t j = 0; j < kSide; ++j)
      for (std::uint32_t i = 0; i < kSide; ++i) {
        const std::uint32_t node = j * kSide + i;
        if (snapshot->position[node].w == 0) continue;  // pinned
        const Vec3d& way = ways[(j / kPatch) * (kSide / kPatch) + i / kPatch];
        snapshot->velocity[node] = Vec4f::from((speed * way).to<float>(), 0);
      }
    REQUIRE(world->restore(*snapshot));
    CHECK(bad_frames(*world, 8) == 0);
    CHECK(world->totals().crossings == 0);
    if (times > 1)
      CHECK(world->totals().contacts > 0);  // a slow patch stretches its neighbours' springs only
    MESSAGE("truncated ", world->totals().truncated, ", contacts ", world->totals().contacts, ", stretch ",
            world->totals().max_stretch);
  }
}

TEST_CASE("a spike comes up under a coarse triangle, far from its vertices, and lifts it") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  {
    std::ofstream file(folder.path("spike.obj"));  // 2 mm wide at its foot, 0.3 m high
    file << "v -0.001 -0.3 -0.001\nv 0.001 -0.3 -0.001\nv 0 -0.3 0.001\nv 0 0 0\n"
            "f 1 2 3\nf 2 1 4\nf 3 2 4\nf 1 3 4\n";
  }
  auto world = world_of(
      fixture.device(),
      contact_scene(
          R"("gravity": [0, 0, 0], )" + contact_text("0.01") + R"("cloths": [)" +
          lying_cloth(3, "[0.03, 0.03, 0.05]") + R"(], "colliders": [{"kind": "mesh", "mesh": ")" +
          folder.path("spike.obj") +
          R"(", "motion": {"kind": "line", "direction": [0, 1, 0], "speed": 1, "distance": 0.2}}])"));
  std::uint32_t bad = 0;
  for (int frame = 1; frame <= 16; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    mesh::TriangleMesh spike = world->assets().objects[0];
    for (Vec3f& p : spike.positions) p.y += static_cast<float>(std::min(0.2, world->time()));
    if (passed(*world, now, {spike}) != 0) ++bad;
  }
  CHECK(bad == 0);
  CHECK(Moment(*world).mean_velocity().y > 0.1);
}

TEST_CASE("two strips that cross edge on edge do not pass") {
  GpuFixture fixture;
  // Narrow strips of one cell's width at right angles, which meet in the middle of long edges.
  const auto strip = [](const std::string& grid, const std::string& size, const std::string& at) {
    return R"({"grid": )" + grid + R"(, "size": )" + size +
           R"(, "plane": "xz", "density": 0.3, "damping": 0.01,
      "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {"translate": )" +
           at + "}}";
  };
  auto world = world_of(fixture.device(),
                        contact_scene(R"("gravity": [0, 0, 0], )" + contact_text("0.01") + R"("cloths": [)" +
                                      strip("[4,2]", "[0.6,0.05]", "[0, 0, 0]") + "," +
                                      strip("[2,4]", "[0.05,0.6]", "[0.011, 0.05, 0.007]") + "]"));
  push(*world, 8, 16, {0, -1, 0});
  CHECK(bad_frames(*world, 20) == 0);
  const Moment now(*world);
  CHECK(now.momentum(0, 8).y < 0.4 * now.momentum(0, 16).y);
}

TEST_CASE("a pinned node inside a ball pulls nothing apart") {
  GpuFixture fixture;
  auto world = world_of(
      fixture.device(),
      contact_scene(contact_text("0.01") + R"("cloths": [)" +
                    lying_cloth(8, "[0, 0.1, 0]", R"(, "pins": ["top_left"])") +
                    R"(], "colliders": [{"kind": "sphere", "center": [-0.2, 0.1, -0.2], "radius": 0.1}])"));
  double fastest = 0;
  for (int frame = 0; frame < 30; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    fastest = std::max(fastest, now.largest_speed());
  }
  MESSAGE("largest speed ", fastest, ", stretch ", world->totals().max_stretch);
  // A push's speed and a fall's, and what the springs that the ball holds stretched give a node of 0.75 g.
  const double stretched = (world->totals().max_stretch - 1) * 0.4 / 7;
  CHECK(fastest < 0.25 * 0.01 / world->step() + 9.81 * 0.5 + std::sqrt(40 / 7.5e-4) * stretched);
  CHECK(world->totals().max_stretch < 2.5);
}

TEST_CASE("a sheet that begins inside a ball comes out of it and is not flung") {
  GpuFixture fixture;
  auto world =
      world_of(fixture.device(),
               contact_scene(contact_text("0.01") + R"("cloths": [)" + lying_cloth(8, "[0, 0.05, 0]") +
                             R"(], "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 0.1}])"));
  double fastest = 0;
  for (int frame = 0; frame < 30; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    fastest = std::max(fastest, now.largest_speed());
  }
  MESSAGE("largest speed ", fastest, ", inside ", passed(*world), ", stretch ", world->totals().max_stretch);
  CHECK(passed(*world) == 0);
  CHECK(fastest < 0.25 * 0.01 / world->step() + 9.81 * 0.5);
}

TEST_CASE("a node that is not finite is reported where there is contact, and a reset thaws the world") {
  GpuFixture fixture;
  for (const float bad : {NAN, INFINITY}) {
    auto world =
        world_of(fixture.device(),
                 contact_scene(contact_text("0.01") + R"("cloths": [)" + lying_cloth(6, "[0, 0.012, 0]") +
                               R"(], "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]},
        {"kind": "box", "center": [0, 0.1, 0], "size": [0.1, 0.1, 0.1]}])"));
    advance(*world, 3);
    const std::string good = hash_of(*world);
    world->set_node(14, {0, bad, 0, 1}, {});
    REQUIRE(world->advance_frame());
    const auto finished = world->finish();
    REQUIRE_FALSE(finished);
    CHECK(finished.error().kind == ErrorKind::Diverged);
    CHECK(finished.error().message.find("In frame 3 ") != std::string::npos);
    CHECK(hash_of(*world) == good);
    REQUIRE(world->reset());
    advance(*world, 3);
    CHECK(hash_of(*world) == good);
  }
}
