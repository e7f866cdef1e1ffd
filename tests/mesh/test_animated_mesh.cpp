// Animations and skins of GLB files against closed forms; what is wrong in them is said.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "mesh/animated_mesh.hpp"
#include "mesh/deformation.hpp"
#include "mesh/glb.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

std::string floats(const std::vector<double>& values) {
  std::string bytes;
  for (const double value : values) {
    const auto single = static_cast<float>(value);
    bytes.append(reinterpret_cast<const char*>(&single), sizeof single);
  }
  return bytes;
}
std::string shorts(const std::vector<int>& values) {
  std::string bytes;
  for (const int value : values) {
    const auto word = static_cast<std::int16_t>(value);
    bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
  }
  return bytes;
}

const double kHalf = std::sqrt(0.5);

/// An arm along x of two joints a metre apart, whose skin is four vertices (0, 0), (1, 0), (2, 0), (0, 1), and a
/// triangle that a node of its own carries, 5 m up. Animations "bend" (the outer joint by a right angle about z in 2 s,
/// after half a second of rest), "hop" (the inner joint up by 1 m in a second, as a spline without slope at its ends),
/// "grow" (twice as large after a second, at once), "packed" ("bend" at once, in shorts), and "lift" (the triangle, by
/// 3 m along z in 1 s). One place of its JSON is replaced, wherever it is.
std::string arm(const std::string& from = "", const std::string& to = "", std::vector<double> weights = {}) {
  if (weights.empty()) weights = {1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};  // sums of 1 and of 2
  std::string binary, views, accessors;
  int count = 0;
  const auto add = [&](const std::string& bytes, int component, const char* type, int elements) {
    const std::string comma = count == 0 ? "" : ",";
    views += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(binary.size()) + R"(,"byteLength":)" +
             std::to_string(bytes.size()) + "}";
    accessors += comma + R"({"bufferView":)" + std::to_string(count) + R"(,"componentType":)" +
                 std::to_string(component) + R"(,"count":)" + std::to_string(elements) + R"(,"type":")" +
                 type + "\"}";
    binary += bytes;
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    return std::to_string(count++);
  };
  const std::string place = add(floats({0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0}), 5126, "VEC3", 4);
  const std::string joints = add(std::string("\0\0\0\0\0\1\0\0\1\0\0\0\0\0\0\0", 16), 5121, "VEC4", 4);
  const std::string weight = add(floats(weights), 5126, "VEC4", 4);
  const std::string corners = add(std::string("\0\1\3\1\2\3", 6), 5121, "SCALAR", 6);
  const std::string bind = add(floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  //
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1}),
                               5126, "MAT4", 2);
  const std::string alone = add(floats({0, 0, 0, 1, 0, 0, 0, 1, 0}), 5126, "VEC3", 3);
  const std::string bend_times = add(floats({0.5, 2.5}), 5126, "SCALAR", 2);
  const std::string bends = add(floats({0, 0, 0, 1, 0, 0, kHalf, kHalf}), 5126, "VEC4", 2);
  const std::string second = add(floats({0, 1}), 5126, "SCALAR", 2);
  const std::string hops =
      add(floats({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0}), 5126, "VEC3", 6);
  const std::string sizes = add(floats({1, 1, 1, 2, 2, 2}), 5126, "VEC3", 2);
  const std::string packed = add(shorts({0, 0, 0, 32767, 0, 0, 23170, 23170}), 5122, "VEC4", 2);
  const std::string lifts = add(floats({0, 5, 0, 0, 5, 3}), 5126, "VEC3", 2);
  const auto animation = [](const char* name, const std::string& input, const std::string& output,
                            const char* how, int node, const char* path) {
    return std::string(R"({"name":")") + name + R"(","channels":[{"sampler":0,"target":{"node":)" +
           std::to_string(node) + R"(,"path":")" + path + R"("}}],"samplers":[{"input":)" + input +
           R"(,"output":)" + output + R"(,"interpolation":")" + how + R"("}]})";
  };
  std::string json =
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1,3]}],"nodes":[{"mesh":0,"skin":0},{"children":[2]},)"
      R"({"translation":[1,0,0]},{"mesh":1,"translation":[0,5,0]},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],)"
      R"("skins":[{"joints":[1,2],"inverseBindMatrices":)" +
      bind + R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":)" + place + R"(,"JOINTS_0":)" +
      joints + R"(,"WEIGHTS_0":)" + weight + R"(},"indices":)" + corners +
      R"(}]},{"primitives":[{"attributes":{"POSITION":)" + alone + R"(}}]}],"animations":[)" +
      animation("bend", bend_times, bends, "LINEAR", 2, "rotation") + "," +
      animation("hop", second, hops, "CUBICSPLINE", 1, "translation") + "," +
      animation("grow", second, sizes, "STEP", 1, "scale") + "," +
      animation("packed", second, packed, "STEP", 2, "rotation") + "," +
      animation("lift", second, lifts, "LINEAR", 3, "translation") + R"(],"accessors":[)" + accessors +
      R"(],"bufferViews":[)" + views + R"(],"buffers":[{"byteLength":)" + std::to_string(binary.size()) +
      "}]}";
  if (!from.empty()) {
    const std::size_t at = json.find(from);
    REQUIRE(at != std::string::npos);
    json.replace(at, from.size(), to);
  }
  return glb_file(json, binary);
}

std::vector<Vec3f> posed(const char* name, double time) {
  const std::string file = arm();
  const auto mesh = AnimatedMesh::read(bytes_of(file));
  if (!mesh) FAIL(mesh.error().message);
  const auto animation = mesh->animation(name);
  if (!animation) FAIL(animation.error().message);
  const auto pose = mesh->posed(**animation, time);
  if (!pose) FAIL(pose.error().message);
  CHECK(pose->triangles.size() == 3);
  return pose->positions;
}

void check_at(const Vec3f& found, const Vec3d& expected) {
  CAPTURE(found.x);
  CAPTURE(found.y);
  CAPTURE(found.z);
  CHECK(length(found.to<double>() - expected) < 1e-6);
}

std::string refusal(const std::string& file) {
  const auto mesh = AnimatedMesh::read(bytes_of(file));
  if (!mesh) return mesh.error().message;
  return "is read";
}

}  // namespace

TEST_CASE(
    "a joint that turns evenly takes along what is bound to it, and half of what is bound to it by half") {
  for (const auto& [time, angle] :
       {std::pair{0.0, 0.0}, {0.5, 0.0}, {1.5, 45.0}, {2.0, 67.5}, {2.5, 90.0}, {9.0, 90.0}}) {
    CAPTURE(time);
    const std::vector<Vec3f> place = posed("bend", time);
    const double turn = angle * std::numbers::pi / 180;
    check_at(place[0], {0, 0, 0});
    check_at(place[1], {1, 0, 0});
    check_at(place[2], {1 + std::cos(turn), std::sin(turn), 0});
    check_at(place[3], {0, 1, 0});
    check_at(place[4], {0, 5, 0});  // where its node is
  }
}

TEST_CASE("splines, steps, packed numbers and nodes without a skin move as the specification says") {
  for (const double s : {0.0, 0.25, 0.5, 0.8, 1.0})
    check_at(posed("hop", s)[2], {2, 3 * s * s - 2 * s * s * s, 0});
  check_at(posed("grow", 0.999)[2], {2, 0, 0});
  check_at(posed("grow", 1)[2], {4, 0, 0});
  check_at(posed("packed", 0.5)[2], {2, 0, 0});
  check_at(posed("packed", 1)[2], {1, 1, 0});
  check_at(posed("lift", 0.25)[5], {1, 5, 0.75});
}

TEST_CASE(
    "a skin's triangles face as its joints turn them, whatever its own node does; a node's as it does") {
  const auto facing = [](const std::string& from, const std::string& to) {
    const std::string file = arm(from, to);
    const auto mesh = AnimatedMesh::read(bytes_of(file));
    if (!mesh) FAIL(mesh.error().message);
    const auto pose = mesh->posed(**mesh->animation("bend"), 0);
    if (!pose) FAIL(pose.error().message);
    std::vector<float> along;  // z, of the normals of the skin's first triangle and of the node's
    for (const std::size_t t : {0U, 2U}) {
      const auto& [a, b, c] = pose->triangles[t];
      const std::vector<Vec3f>& x = pose->positions;
      along.push_back(cross(x[b] - x[a], x[c] - x[a]).z);
    }
    return along;
  };
  const std::vector<float> plain = facing("", "");
  CHECK(plain[0] > 0);
  CHECK(plain[1] > 0);
  // Mirrored along x: triangles are turned, so that they face as before.
  CHECK(facing(R"({"mesh":0,"skin":0})", R"({"mesh":0,"skin":0,"scale":[-1,1,1]})") == plain);
  CHECK(facing(R"({"children":[2]})", R"({"children":[2],"scale":[-1,1,1]})")[0] > 0);
  CHECK(facing(R"({"mesh":1,)", R"({"mesh":1,"scale":[-1,1,1],)")[1] > 0);
}

TEST_CASE("an animation is found by its name, and the first without one") {
  const std::string file = arm();
  const auto mesh = AnimatedMesh::read(bytes_of(file));
  REQUIRE(mesh);
  CHECK((*mesh->animation(""))->name == "bend");
  CHECK((*mesh->animation("hop"))->duration == 1);
  CHECK(mesh->animation("run").error().message ==
        R"(The file has no animation "run"; it has "bend", "hop", "grow", "packed", "lift".)");
  const std::string still = text_of(write_glb(cube(), {smooth_normals(cube()), {}}));
  const auto without = AnimatedMesh::read(bytes_of(still));
  REQUIRE(without);
  CHECK(without->animation("").error().message == "The file has no animation.");
}

TEST_CASE("what is wrong with skins and animations is said with its place") {
  const auto with = [](const char* from, const char* to) { return refusal(arm(from, to)); };
  REQUIRE(refusal(arm()) == "is read");
  CHECK(with(R"("joints":[1,2])", R"("joints":[1,4])") ==
        "skins[0].joints[1] is 4, which is no node of the scene.");
  CHECK(with(R"("joints":[1,2])", R"("joints":[1])") ==
        "Vertex 1 of accessors[0] names joint 1, but skins[0] has 1, from 0.");
  CHECK(with(R"("joints":[1,2])", R"("joints":[1,1.7])") ==
        "skins[0].joints[1] is 1.7, which is no node of the scene.");
  CHECK(with(R"("joints":[1,2])", R"("joints":[])") == "skins[0].joints is empty or missing.");
  CHECK(with(R"("skin":0)", R"("skin":7)") == "nodes[0].skin is 7, but the file has 1 skins.");
  CHECK(with(R"("JOINTS_0":1,)", "") == "meshes[0].primitives[0].attributes.JOINTS_0 is missing.");
  CHECK(with(R"("JOINTS_0":1)", R"("JOINTS_0":1,"JOINTS_1":1)") ==
        "meshes[0].primitives[0].attributes.JOINTS_1: more than four joints at a vertex are not read.");
  CHECK(with(R"("JOINTS_0":1)", R"("JOINTS_0":2)").find("joints are read from bytes") != std::string::npos);
  CHECK(with(R"("interpolation":"STEP")", R"("interpolation":"JUMP")") ==
        "animations[2].samplers[0].interpolation is the text \"JUMP\"; it must be \"LINEAR\", \"STEP\" or "
        "\"CUBICSPLINE\".");
  CHECK(with(R"("interpolation":"CUBICSPLINE")", R"("interpolation":"LINEAR")") ==
        "animations[1].samplers[0] has 2 times and 6 values; it must have one at least, and 1 values for "
        "each.");
  CHECK(with(R"("path":"scale")", R"("path":"colour")")
            .find("animations[2].channels[0].target.path is the text \"colour\"") == 0);
  CHECK(with(R"({"sampler":0,"target":{"node":2)", R"({"sampler":3,"target":{"node":2)") ==
        "animations[0].samplers[3] is none of the 1 samplers.");
  CHECK(with(R"([0,1,3]}])", R"([0,1,3,4]}])") == "is read");
  CHECK(refusal(arm("", "", {1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}))
            .find("the weights of vertex 1 are all 0.") != std::string::npos);
  CHECK(refusal(arm("", "", {1, 0, 0, 0, 2, -1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}))
            .find("weight 1 of vertex 1 is -1") != std::string::npos);
}

TEST_CASE(
    "bytes of an animated file that are changed at random are refused with a sentence, or move as they say") {
  const std::string good = arm();
  Random random(11);
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string file = good;
    const int changes = 1 + static_cast<int>(random.uniform(0, 4));
    for (int change = 0; change < changes; ++change)
      file[static_cast<std::size_t>(random.uniform(20, static_cast<double>(file.size())))] =
          static_cast<char>(random.uniform(0, 256));
    const auto mesh = AnimatedMesh::read(bytes_of(file));
    if (!mesh) {
      ++refused;
      CHECK(mesh.error().kind == ErrorKind::Input);
      CHECK(mesh.error().message.size() > 10);
      continue;
    }
    const auto animation = mesh->animation("");
    if (!animation) continue;
    for (const double time : {0.0, 0.7, 1e5}) {
      const auto pose = mesh->posed(**animation, time);
      if (!pose) continue;
      for (const Vec3f& p : pose->positions)
        CHECK((std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)));
    }
  }
  CHECK(refused > 5000);
}

TEST_CASE("between shapes all goes straight; after the last it stays, or begins anew") {
  const ShapeTimes once{{1, 3}}, again{{1, 3}, true};
  using Moment = ShapeTimes::Moment;
  CHECK(once.at(0) == Moment{0, 1, 0});
  CHECK(once.at(0.25) == Moment{0, 1, 0.25});
  CHECK(once.at(1) == Moment{1, 2, 0});
  CHECK(once.at(2.5) == Moment{1, 2, 0.75});
  CHECK(once.at(3) == Moment{2, 2, 0});
  CHECK(once.at(1e9) == Moment{2, 2, 0});
  CHECK(again.at(2.5) == once.at(2.5));
  CHECK(again.at(3) == Moment{0, 1, 0});
  CHECK(again.at(3 * 7 + 0.25) == Moment{0, 1, 0.25});
  CHECK(ShapeTimes{}.at(5) == Moment{0, 0, 0});
}
