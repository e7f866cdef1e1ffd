#include <doctest/doctest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "mesh/adjacency.hpp"
#include "mesh/glb.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

std::string bits(float value) { return {reinterpret_cast<const char*>(&value), sizeof value}; }
std::string bits(const Vec3f& p) { return bits(p.x) + bits(p.y) + bits(p.z); }

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  T value;
  REQUIRE(offset + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// A file of positions and bytes for indices, with these nodes and these keys of its primitive.
std::string file_of(const std::vector<Vec3f>& points, const std::string& corners, const std::string& nodes,
                    const std::string& primitive = "") {
  std::string binary;
  for (const Vec3f& p : points) binary += bits(p);
  const std::string size = std::to_string(binary.size()), count = std::to_string(corners.size());
  return glb_file(
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
          R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" + primitive +
          R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" +
          std::to_string(points.size()) + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":)" +
          count + R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)" + size +
          R"(},{"buffer":0,"byteOffset":)" + size + R"(,"byteLength":)" + count +
          R"(}],"buffers":[{"byteLength":)" + std::to_string(binary.size() + corners.size()) + "}]}",
      binary + corners);
}

std::string corners_of(const TriangleMesh& mesh) {
  std::string corners;
  for (const Triangle& t : mesh.triangles)
    for (const auto vertex : t) corners += static_cast<char>(vertex);
  return corners;
}

std::string message(const std::string& file) {
  const auto mesh = read_glb(bytes_of(file));
  REQUIRE_FALSE(mesh);
  return mesh.error().message;
}

}  // namespace

TEST_CASE("a GLB file written and read back has the same bits") {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const auto back = read_glb(write_glb(mesh, {smooth_normals(mesh), {}}));
    INFO((back ? "" : back.error().message));
    REQUIRE(back);
    CHECK(same_bits(mesh, *back));
  }
}

// Read by nothing of ours: header, JSON through another parser, arrays at the offsets that it gives.
TEST_CASE("a written GLB file is laid out as glTF asks, with bounds and unit normals") {
  const std::string file = text_of(write_glb(cube(), {smooth_normals(cube()), {}}));
  CHECK(file.substr(0, 4) == "glTF");
  CHECK(at<std::uint32_t>(file, 4) == 2);
  CHECK(at<std::uint32_t>(file, 8) == file.size());
  const std::size_t json_size = at<std::uint32_t>(file, 12);
  CHECK(json_size % 4 == 0);
  const auto json = nlohmann::json::parse(file.substr(20, json_size));
  CHECK(at<std::uint32_t>(file, 20 + json_size) + 28 + json_size == file.size());
  CHECK(file.substr(24 + json_size, 4) == std::string("BIN\0", 4));
  const std::string binary = file.substr(28 + json_size);
  CHECK(json["buffers"][0]["byteLength"] == binary.size());
  CHECK(json["materials"][0]["doubleSided"] == true);
  const auto offset = [&](int accessor) -> std::size_t {
    const auto& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
    CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
    return view["byteOffset"];
  };
  const auto& primitive = json["meshes"][0]["primitives"][0];
  CHECK(json["accessors"][0]["min"] == nlohmann::json({0, 0, 0}));
  CHECK(json["accessors"][0]["max"] == nlohmann::json({1, 1, 1}));
  REQUIRE(json["accessors"][0]["count"] == 8);
  REQUIRE(json["accessors"][2]["count"] == 36);
  for (std::size_t v = 0; v < 8; ++v) {
    const auto position = at<Vec3f>(binary, offset(primitive["attributes"]["POSITION"]) + 12 * v);
    const auto normal = at<Vec3f>(binary, offset(primitive["attributes"]["NORMAL"]) + 12 * v);
    CHECK(position == cube().positions[v]);
    CHECK(length(normal) == doctest::Approx(1.0));
    CHECK(dot(normal, position - Vec3f{0.5F, 0.5F, 0.5F}) > 0.4F);  // outward
  }
  for (std::size_t i = 0; i < 36; ++i)
    CHECK(at<std::uint32_t>(binary, offset(primitive["indices"]) + 4 * i) == cube().triangles[i / 3][i % 3]);
}

TEST_CASE("texture coordinates of a written GLB file count from the upper edge, as glTF's do") {
  const std::string file =
      text_of(write_glb(cube(), {{}, std::vector<std::array<float, 2>>(8, {0.25F, 0.125F})}));
  const std::size_t json_size = at<std::uint32_t>(file, 12);
  const auto json = nlohmann::json::parse(file.substr(20, json_size));
  const auto& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  CHECK(!attributes.contains("NORMAL"));
  const auto& accessor = json["accessors"][attributes["TEXCOORD_0"].get<std::size_t>()];
  CHECK(accessor["type"] == "VEC2");
  CHECK(accessor["count"] == 8);
  const std::size_t begin = json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"];
  const std::string binary = file.substr(28 + json_size);
  for (std::size_t v = 0; v < 8; ++v) {
    CHECK(at<float>(binary, begin + 8 * v) == 0.25F);
    CHECK(at<float>(binary, begin + 8 * v + 4) == 0.875F);
  }
}

TEST_CASE(
    "a GLB file of another program is read: strides, bytes for indices, a tree of nodes, another scene") {
  const auto mesh = read_glb(bytes_of(elaborate_glb()));
  REQUIRE(mesh);
  CHECK(same_bits(*mesh, cube()));
}

TEST_CASE("the nodes of a GLB file put its mesh where they say, each within its parent") {
  // Scaled by (1, 2, 3), turned a quarter about z (x to y, y to -x), moved by (10, 0, 0); then all twice as
  // large, by a matrix.
  const std::string nodes =
      R"([{"children":[1],"matrix":[2,0,0,0, 0,2,0,0, 0,0,2,0, 0,1,0,1]},)"
      R"({"mesh":0,"scale":[1,2,3],"rotation":[0,0,0.70710678118654752,0.70710678118654752],"translation":[10,0,0]}])";
  const auto mesh = read_glb(bytes_of(file_of(cube().positions, corners_of(cube()), nodes)));
  REQUIRE(mesh);
  CHECK(mesh->triangles == cube().triangles);
  for (std::size_t v = 0; v < 8; ++v) {
    const Vec3f p = cube().positions[v];
    const Vec3f expected{2 * (10 - 2 * p.y), 2 * p.x + 1, 6 * p.z};
    for (int axis = 0; axis < 3; ++axis) CHECK(mesh->positions[v][axis] == doctest::Approx(expected[axis]));
  }
}

TEST_CASE("a mesh that two nodes use stands twice, and one that is mirrored still faces outward") {
  const auto mesh = read_glb(bytes_of(file_of(cube().positions, corners_of(cube()),
                                              R"([{"mesh":0,"children":[1]},{"mesh":0,"scale":[-1,1,1],)"
                                              R"("translation":[-1,0,0]}])")));
  REQUIRE(mesh);
  CHECK(mesh->positions.size() == 16);
  CHECK(mesh->triangles.size() == 24);
  CHECK(signed_volume(*mesh) == doctest::Approx(2.0));
  CHECK(bounds(*mesh).low.x == -2.0F);
}

TEST_CASE("lists, strips and fans of a GLB file are the same square") {
  const std::vector<Vec3f> ring = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Vec3f> rows = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}, {1, 2, 0}};
  const std::string node = R"([{"mesh":0}])";
  const auto list = read_glb(bytes_of(file_of(ring, std::string("\0\1\2\0\2\3", 6), node)));
  const auto fan = read_glb(bytes_of(file_of(ring, std::string("\0\1\2\3", 4), node, R"(,"mode":6)")));
  REQUIRE(list);
  REQUIRE(fan);
  CHECK(same_bits(*list, *fan));
  CHECK(list->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
  // Every triangle of a strip faces the same way; those that name a vertex twice lead on.
  const auto strip =
      read_glb(bytes_of(file_of(rows, std::string("\0\1\2\3\3\2\2\3\4\5", 10), node, R"(,"mode":5)")));
  REQUIRE(strip);
  CHECK(strip->triangles.size() == 4);
  for (const Triangle& t : strip->triangles) {
    const Vec3f a = strip->positions[t[0]];
    CHECK(cross(strip->positions[t[1]] - a, strip->positions[t[2]] - a) == Vec3f{0, 0, 1});
  }
}

TEST_CASE("a GLB cube with corners of its own for each side is closed again") {
  std::vector<Vec3f> points;
  std::string corners;
  for (const Triangle& t : cube().triangles)
    for (const auto vertex : t) {
      corners += static_cast<char>(points.size());
      points.push_back(cube().positions[vertex]);
    }
  const auto mesh = read_glb(bytes_of(file_of(points, corners, R"([{"mesh":0}])")));
  REQUIRE(mesh);
  CHECK(mesh->positions.size() == 8);
  CHECK(mesh_edges(mesh->triangles).size() == 18);
  CHECK(signed_volume(*mesh) == doctest::Approx(1.0));
}

TEST_CASE("an error in a GLB file gives its place, the value and the limit") {
  const std::vector<Vec3f> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::string corners("\0\1\2", 3), node = R"([{"mesh":0}])";
  const std::string good = file_of(points, corners, node);
  REQUIRE(read_glb(bytes_of(good)));
  CHECK(message(good.substr(0, 100)) ==
        "The header states " + std::to_string(good.size()) + " bytes, but the file has 100.");
  CHECK(message(file_of(points, std::string("\0\1\3", 3), node)) ==
        "meshes[0].primitives[0] names vertex 3, but has 3, from 0.");
  CHECK(message(file_of(points, corners, R"([{"mesh":1}])")) ==
        "nodes[0].mesh is 1, but the file has 1 meshes.");
  CHECK(message(file_of(points, corners, R"([{"mesh":0,"children":[0]}])")) ==
        "nodes[0] is reached twice; the nodes of a scene are trees.");
  CHECK(
      message(file_of(points, corners, node, R"(,"mode":1)")) ==
      "meshes[0].primitives[0].mode is 1, points or lines; triangles (4), strips (5) and fans (6) are read.");
  CHECK(message(file_of(points, corners, R"([{"mesh":0,"scale":[1e39,1,1]}])")) ==
        "Vertex 1 of accessors[0], where nodes[0] puts it, has the coordinate 1e+39, which is not finite in "
        "single precision, where the largest is 3.40282347e+38.");
}
