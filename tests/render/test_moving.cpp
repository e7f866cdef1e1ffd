// Obstacles that move or deform, in pictures.
#include "mesh/primitives.hpp"
#include "picture/offscreen.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"
#include "scene/motion.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image, picture::Offscreen;

namespace {

using scene::ColliderMotion;

const ColliderMotion kLine = scene::MotionLine{{0.6, 0.8, 0}, 0.5};
const ColliderMotion kTurn = scene::MotionRotation{{0, 0.6, 0.8}, {0.1, 0, 0}, 1.25};

struct Drawn {
  GpuFixture fixture;
  Sheet sheet{fixture.device(), 12, [](double u, double v) { return Vec3d{u - 0.5, -0.7, 0.5 - v}; }};

  Offscreen offscreen(Inputs inputs, View view = View::Textured) {
    inputs.cloth = sheet.draw();
    Settings settings;
    settings.width = 160;
    settings.height = 120;
    settings.view = view;
    settings.bounds = {{-1, -1, -1}, {1, 1, 1}};
    return value_of(Offscreen::create(fixture.device(), settings, inputs));
  }
  Image still(const Inputs& inputs) { return value_of(offscreen(inputs).draw(0)); }
};

Image at(Offscreen& offscreen, double time) {
  offscreen.set_time(time);
  return value_of(offscreen.draw(0));
}

/// Places are rounded in another order on the GPU: a pixel on a silhouette may differ, few do.
void check_alike(const Image& a, const Image& b) { CHECK(difference(a, b, 12) <= 6); }

}  // namespace

TEST_CASE("a sphere, a capsule and a box that move are drawn, with their shadows, as still ones there") {
  Drawn drawn;
  const double time = 0.75;
  Inputs moving, there;
  moving.spheres = {{{-0.5, -0.2, 0}, 0.2, {}, kLine}};
  moving.capsules = {{{0.2, 0, 0}, {0.6, 0.1, 0.2}, 0.1, {}, kTurn}};
  moving.boxes = {{{-0.2, -0.5, 0.3}, {0.3, 0.2, 0.1}, {0, 0, 0, 1}, {}, kTurn}};
  const scene::RigidTransform line = motion_at(kLine, time), turn = motion_at(kTurn, time);
  there.spheres = {{line({-0.5, -0.2, 0}), 0.2}};
  there.capsules = {{turn({0.2, 0, 0}), turn({0.6, 0.1, 0.2}), 0.1}};
  const double half = 0.5 * 1.25 * time;  // of the angle
  there.boxes = {{turn({-0.2, -0.5, 0.3}),
                  {0.3, 0.2, 0.1},
                  {0, 0.6 * std::sin(half), 0.8 * std::sin(half), std::cos(half)}}};
  Inputs start = moving;
  start.spheres[0].motion.reset();
  start.capsules[0].motion.reset();
  start.boxes[0].motion.reset();

  Offscreen offscreen = drawn.offscreen(moving);
  const std::uint64_t bytes = drawn.fixture.device().allocated_bytes();
  const Image first = value_of(offscreen.draw(0));
  check_alike(first, drawn.still(start));
  const Image later = at(offscreen, time);
  check_alike(later, drawn.still(there));
  CHECK(difference(first, later, 12) > 500);
  CHECK(at(offscreen, 0).rgba == first.rgba);
  CHECK(drawn.fixture.device().allocated_bytes() == bytes);
}

TEST_CASE("a mesh deforms straight between its keyframes and stays after the last, moved as a whole") {
  Drawn drawn;
  mesh::TriangleMesh body = mesh::make_sphere(24, 16);
  for (Vec3f& p : body.positions) p = 0.3F * p;
  const auto shaped = [&](double tall, double wide) {
    mesh::TriangleMesh shape = body;
    for (Vec3f& p : shape.positions)
      p = {p.x * static_cast<float>(wide), p.y * static_cast<float>(tall), p.z};
    return shape;
  };
  Inputs moving;
  moving.objects = {{body, {{{0.5, 1.5}}, {shaped(2, 1).positions, shaped(2, 3).positions}}, kLine}};
  moving.spheres = {{{0.7, 0.5, 0}, 0.2}};  // still ones beside it keep their place
  Offscreen offscreen = drawn.offscreen(moving);
  for (const auto& [time, tall, wide] : {std::tuple{0.0, 1.0, 1.0},
                                         {0.25, 1.5, 1.0},
                                         {0.5, 2.0, 1.0},
                                         {1.0, 2.0, 2.0},
                                         {1.5, 2.0, 3.0},
                                         {2.0, 2.0, 3.0},
                                         {0.25, 1.5, 1.0}}) {  // and back, as a world does that is reset
    mesh::TriangleMesh there = shaped(tall, wide);
    for (Vec3f& p : there.positions) p = motion_at(kLine, time)(p.to<double>()).to<float>();
    Inputs still;
    still.objects = {{there}};
    still.spheres = moving.spheres;
    CAPTURE(time);
    check_alike(at(offscreen, time), drawn.still(still));
  }
}

TEST_CASE("a floor that rises is drawn where it has risen to") {
  Drawn drawn;
  Inputs moving, there;
  moving.planes = {{{0, -1, 0}, {0, 1, 0}, {}, scene::MotionLine{{0, 1, 0}, 0.5}}};
  there.planes = {{{0, -0.8, 0}, {0, 1, 0}}};
  Offscreen offscreen = drawn.offscreen(moving);
  const Image first = value_of(offscreen.draw(0));
  const Image later = at(offscreen, 0.4);
  check_alike(later, drawn.still(there));
  CHECK(difference(first, later, 12) > 200);
}

TEST_CASE("every view shows what moves") {
  Drawn drawn;
  Inputs moving;
  moving.boxes = {{{0, 0, 0}, {0.5, 0.5, 0.5}, {0, 0, 0, 1}, {}, kLine}};
  for (const View view : {View::Textured, View::Wireframe, View::Normals, View::Stretch, View::Velocity}) {
    Offscreen offscreen = drawn.offscreen(moving, view);
    const Image first = value_of(offscreen.draw(0));
    CAPTURE(scene::name_of(view));
    CHECK(difference(at(offscreen, 1), first, 12) > 200);
  }
}

TEST_CASE("the place at time 0 is that of a path which begins elsewhere") {
  Drawn drawn;
  Inputs moving, there;
  moving.spheres = {{{0, 0, 0}, 0.3, {}, scene::MotionPath{{{0, {0.25, 0.5, 0}}, {1, {0, 0, 0}}}}}};
  there.spheres = {{{0.25, 0.5, 0}, 0.3}};
  check_alike(drawn.still(moving), drawn.still(there));
}
