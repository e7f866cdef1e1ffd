#include "gpu/gpu_fixture.hpp"
#include "mesh/primitives.hpp"
#include "render/scene_inputs.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;

namespace {

/// Two cloths of one triangle each; the second is moved by 2 m along x in every second.
Model two_triangles() {
  scene::MotionLine line;
  line.direction = {1, 0, 0};
  line.speed = 2;
  Model model;
  model.bodies.resize(2);
  model.bodies[0].vertex_count = model.bodies[1].vertex_count = model.bodies[1].first_vertex = 3;
  model.bodies[0].triangle_count = model.bodies[1].triangle_count = model.bodies[1].first_triangle = 1;
  model.bodies[1].color = Vec3d{0.1, 0.2, 0.3};
  model.rest_position = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0.5, 1}};
  model.start_position = model.rest_position;
  model.uv = {{0, 0}, {1, 0}, {0, 0.5F}, {0, 0}, {1, 0}, {0, 1.5F}};
  model.mass.assign(6, 0.1);
  model.motion = {0, 0, 0, 2, 2, 2};
  model.triangles = {{0, 1, 2}, {3, 4, 5}};
  model.motions = {scene::Motion{"", {}, line}};
  return model;
}

scene::Scene one_second() {
  scene::Scene scene;
  scene.gravity = {0, -9.81, 0};
  scene.time.frame = 0.1;
  scene.time.frames = 10;
  return scene;
}

}  // namespace

TEST_CASE("a scene's bounds hold the sheet at rest, hanging, and where a motion takes it") {
  const mesh::Bounds bounds = scene_bounds(two_triangles(), one_second(), {});
  CHECK(bounds.low == Vec3f{0, -1.5F, 0});  // the longest sheet has 1.5 m
  CHECK(bounds.high.x == doctest::Approx(3));
  CHECK(bounds.high.y == 0.5F);
  CHECK(bounds.high.z == 1);
}

TEST_CASE("a scene's bounds hold meshes, spheres and capsules, and no plane") {
  scene::Scene scene = one_second();
  scene.colliders = {scene::ColliderSphere{{-5, 0, 0}, 0.5},
                     scene::ColliderCapsule{{0, 0, 0}, {6, 0, 0}, 0.25},
                     scene::ColliderPlane{{0, -9, 0}, {0, 1, 0}}};
  const mesh::TriangleMesh object{{{0, 7, 0}, {0, 8, 0}, {0, 8, 4}}, {{0, 1, 2}}};
  const mesh::Bounds bounds = scene_bounds(two_triangles(), scene, {object});
  CHECK(bounds.low == Vec3f{-5.5F, -1.5F, -0.5F});
  CHECK(bounds.high.x == 6.25F);
  CHECK(bounds.high.y == 8);
  CHECK(bounds.high.z == 4);
}

TEST_CASE("a picture of a scene is drawn from the buffers of its state, cloth by cloth") {
  GpuFixture fixture;
  scene::Scene scene = one_second();
  const scene::ColliderMotion line = scene::MotionLine{{1, 0, 0}, 2};
  scene.colliders = {scene::ColliderBox{{0, 0, 0}, {1, 2, 3}},
                     scene::ColliderPlane{{0, -9, 0}, {0, 1, 0}},
                     scene::ColliderConvex{"", "c.obj", {}, {}, {}, line},
                     scene::ColliderSphere{{-5, 0, 0}, 0.5, {}, line},
                     scene::ColliderMesh{"", "a.obj", {}, {{0.5, "b.obj"}}, {}, {}, line},
                     scene::ColliderCapsule{{0, 0, 0}, {1, 0, 0}, 0.5}};
  const GpuModel model = value_of(GpuModel::create(fixture.device(), two_triangles()));
  const State state = value_of(State::create(fixture.device(), model.host, 1));
  const auto stretch = value_of(gpu::Buffer<float>::create(fixture.device(), 6, "stretch"));
  const mesh::TriangleMesh box = mesh::make_box({1, 2, 3});
  const mesh::TriangleMesh object{{{0, 7, 0}, {0, 8, 0}, {0, 8, 4}}, {{0, 1, 2}}};
  const mesh::TriangleMesh hull{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const mesh::TriangleMesh bent{{{0, 7, 0}, {0, 9, 0}, {0, 8, 4}}, {{0, 1, 2}}};
  const Inputs inputs = inputs_of(model, state, {model.rest_position, stretch}, scene, {box, hull, object},
                                  {{}, {}, {{{0.5}}, {bent.positions}}});
  CHECK(inputs.cloth.position[1] == &state.position[1]);
  CHECK(inputs.cloth.normal == &model.rest_position);
  CHECK(inputs.cloth.stretch == &stretch);
  REQUIRE(inputs.cloth.ranges.size() == 2);
  CHECK(inputs.cloth.ranges[1].first_triangle == 1);
  CHECK(inputs.cloth.ranges[1].triangle_count == 1);
  CHECK(inputs.cloth.ranges[1].color == Vec3d{0.1, 0.2, 0.3});
  CHECK(inputs.cloth.ranges[0].sheet_size == 1);
  CHECK(inputs.cloth.ranges[1].sheet_size == 1.5);
  REQUIRE(inputs.objects.size() == 1);  // the box is drawn from its size
  CHECK(inputs.objects[0].mesh.positions == object.positions);
  REQUIRE(inputs.objects[0].deformation.shapes.size() == 1);
  CHECK(inputs.objects[0].deformation.times.at(0.25).part == 0.5);
  CHECK(inputs.objects[0].deformation.shapes[0] == bent.positions);
  CHECK(inputs.objects[0].motion == line);
  CHECK(inputs.boxes.size() == 1);
  REQUIRE(inputs.hulls.size() == 1);
  CHECK(inputs.hulls[0].mesh.positions == hull.positions);
  CHECK(inputs.hulls[0].motion == line);
  CHECK(inputs.capsules.size() == 1);
  REQUIRE(inputs.spheres.size() == 1);
  CHECK(inputs.spheres[0].motion == line);
  CHECK(inputs.planes.size() == 1);
}
