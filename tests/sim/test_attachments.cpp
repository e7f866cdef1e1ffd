// Cloth that is attached to colliders, against where their surfaces go.
#include <doctest/doctest.h>

#include <cmath>

#include "animated_box.hpp"
#include "model/attachments.hpp"
#include "scene/load.hpp"
#include "scene/motion.hpp"

using namespace weft;

namespace {

/// A door of one triangle in the plane xy, and the same turned by a right angle about y.
mesh::TriangleMesh door(bool open) {
  const auto at = [&](float x, float y) { return open ? Vec3f{0, y, -x} : Vec3f{x, y, 0}; };
  return {{at(0, 0), at(2, 0), at(0, 2)}, {{0, 1, 2}}};
}

Result<Model> built(const std::string& attachments, const std::string& colliders,
                    const std::string& more = "") {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"grid": [3, 3], "size": [0.02, 0.02], "density": 0.2,
          "transform": {"translate": [0.5, 0.5, 0.04]}, "attachments": [)" +
          attachments + "]" + more + R"(}], "colliders": [)" + colliders + "]}",
      "a.json");
  if (!scene) return scene.error();
  const auto read = [](const std::string& name) -> Result<mesh::TriangleMesh> {
    return door(name == "open.obj");
  };
  const auto animated = [](const std::string&) {
    return mesh::AnimatedMesh::read(animated_box({2, 2, 0.04}, {0, 0.5, 1}, {0, 1, 0}));
  };
  WEFT_TRY(assets, load_assets(*scene, read, animated));
  return build_model(*scene, assets);
}

/// Where a node is at a time.
Vec3d place(const Model& model, std::uint32_t node, double time) {
  const std::uint32_t motion = model.motion[node];
  REQUIRE(motion > 0);
  if (motion == 1) return model.rest_position[node];
  return scene::motion_at(model.motions[motion - 2], time)(model.rest_position[node]);
}

const std::string kAll = R"({"nodes": ["top", "bottom"], "collider": 0})";

std::string refusal(const Result<Model>& model) { return model ? "is built" : model.error().message; }

}  // namespace

TEST_CASE("nodes go up and down with the box that an animation lifts, round after round") {
  const auto model = built(kAll, R"({"kind": "mesh", "mesh": "box.glb", "animation": {"rate": 8}})");
  if (!model) FAIL(model.error().message);
  CHECK(model->motion[3] == 0);  // the middle row is free
  for (const std::uint32_t node : {0U, 2U, 7U})
    for (const auto& [time, height] :
         {std::pair{0.0, 0.0}, {0.125, 0.25}, {0.3, 0.6}, {0.5, 1.0}, {0.75, 0.5}, {1.0, 0.0}, {7.3, 0.6}}) {
      CAPTURE(time);
      const Vec3d moved = place(*model, node, time) - model->rest_position[node];
      CHECK(length(moved - Vec3d{0, height, 0}) < 1e-6);
    }
}

TEST_CASE("nodes beside a triangle that turns stay beside it, turned as it is") {
  const auto model =
      built(R"({"nodes": "top_left", "collider": 0})",
            R"({"kind": "mesh", "mesh": "shut.obj", "keyframes": [{"time": 2, "mesh": "open.obj"}]})");
  if (!model) FAIL(model.error().message);
  const Vec3d rest = model->rest_position[0];  // 0.04 in front of the door
  CHECK(length(place(*model, 0, 0) - rest) < 1e-12);
  CHECK(length(place(*model, 0, 2) - Vec3d{rest.z, rest.y, -rest.x}) < 1e-6);
  CHECK(length(place(*model, 0, 9) - Vec3d{rest.z, rest.y, -rest.x}) < 1e-6);
  CHECK(length(place(*model, 0, 1) - 0.5 * (rest + Vec3d{rest.z, rest.y, -rest.x})) <
        1e-6);  // straight between
}

TEST_CASE("nodes on a rigid collider have its motion, and stay with one that stays") {
  const std::string sphere = R"({"kind": "sphere", "center": [0.5, 0.5, 0], "radius": 0.03)";
  const auto turning = built(kAll, sphere + R"(, "motion": {"kind": "rotation", "axis": [0, 0, 1],
                                               "center": [0.5, 0.5, 0], "speed": 2}})");
  if (!turning) FAIL(turning.error().message);
  REQUIRE(turning->motions.size() == 1);
  const Vec3d arm = turning->rest_position[0] - Vec3d{0.5, 0.5, 0};
  const Vec3d there = place(*turning, 0, 0.5) - Vec3d{0.5, 0.5, 0};
  CHECK(there.x == doctest::Approx(std::cos(1) * arm.x - std::sin(1) * arm.y));
  CHECK(there.y == doctest::Approx(std::sin(1) * arm.x + std::cos(1) * arm.y));
  const auto still = built(kAll, sphere + "}");
  REQUIRE(still);
  CHECK(still->motion[0] == 1);
  CHECK(still->motion[4] == 0);
}

TEST_CASE("nodes on a convex hull have its motion, from where its nearest face is") {
  const std::string hull = R"({"kind": "convex", "points": [[0, 0, -1], [1, 0, -1], [0, 1, -1], [1, 1, -1],
      [0, 0, 0.01], [1, 0, 0.01], [0, 1, 0.01], [1, 1, 0.01], [0.4, 0.5, 0]],
      "motion": {"kind": "line", "direction": [0, 1, 0], "speed": 3}})";
  const auto moved = built(kAll, hull);
  if (!moved) FAIL(moved.error().message);
  CHECK(length(place(*moved, 0, 0.5) - moved->rest_position[0] - Vec3d{0, 1.5, 0}) < 1e-12);
  const auto far = built(R"({"nodes": "top", "collider": 0, "reach": 0.02})", hull);
  REQUIRE_FALSE(far);
  CHECK(far.error().message.find("is 0.03 m from the collider, more than the reach of 0.02 m") !=
        std::string::npos);
}

TEST_CASE("an attachment that cannot hold is refused with what is wrong") {
  const std::string plane = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 0, 1]})";
  CHECK(refusal(built(R"({"nodes": "top", "collider": 2})", plane)) ==
        "a.json: cloths[0].attachments[0].collider is 2, but the scene has 1 colliders, from 0.");
  CHECK(
      refusal(built(R"({"nodes": "top", "collider": 0, "reach": 0.01})", plane)) ==
      "a.json: cloths[0].attachments[0]: node 0 is 0.04 m from the collider, more than the reach of 0.01 m.");
  CHECK(refusal(built(kAll, plane, R"(, "pins": ["bottom_left"])")) ==
        "a.json: cloths[0].attachments[0] holds node 6, which is pinned or attached already.");
  CHECK(refusal(built(kAll + ", " + kAll, plane)) ==
        "a.json: cloths[0].attachments[1] holds node 0, which is pinned or attached already.");
  CHECK(refusal(built(kAll, R"({"kind": "mesh", "mesh": "box.glb", "animation": {},
                               "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 1}})")) ==
        "a.json: cloths[0].attachments[0].collider is 0, which deforms and has a motion; a node follows one "
        "of them.");
}
