#include <doctest/doctest.h>
#include <tiny_obj_loader.h>

#include "mesh/obj.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

// Polygons of random shape, forms and signs, with everything else that an OBJ file may hold between them.
std::string random_obj(std::uint32_t seed) {
  Random random(seed);
  std::string text = "# a file\nmtllib none.mtl\r\no thing\n";
  std::uint32_t vertices = 0;
  for (int block = 0; block < 4; ++block) {
    for (std::uint32_t i = 0, count = 4 + random.below(20); i < count; ++i, ++vertices) {
      text += random.below(4) == 0 ? " \tv" : "v";
      for (int axis = 0; axis < 3; ++axis) {
        char number[40];
        std::snprintf(number, sizeof number, random.below(2) == 0 ? " %.9g" : "\t%.6e",
                      random.uniform(-1000, 1000));
        text += number;
      }
      text += random.below(5) == 0 ? " 1.0\r\n" : "\n";
      text += "vt 0.5 0.5\nvn 0 1 0\n";
    }
    text += "g part" + std::to_string(block) + "\ns off\nusemtl #1\n\n";
    for (std::uint32_t i = 0, count = random.below(20); i < count; ++i) {
      text += "f";
      const std::uint32_t form = random.below(4);
      for (std::uint32_t corner = 0, corners = 3 + random.below(6); corner < corners; ++corner) {
        const std::uint32_t vertex = 1 + random.below(vertices);
        const std::string index =
            random.below(2) == 0 ? std::to_string(vertex) : "-" + std::to_string(vertices + 1 - vertex);
        const std::string tails[] = {"", "/1", "/1/1", "//1"};
        text += " " + index + tails[form];
      }
      text += "\n";
    }
  }
  return text + "f 1 2 3";  // at least one face, and no end of line
}

}  // namespace

TEST_CASE("random OBJ files are read as tinyobjloader reads them") {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const std::string text = random_obj(seed);
    tinyobj::ObjReader other;
    tinyobj::ObjReaderConfig config;
    config.triangulate = false;
    REQUIRE(other.ParseFromString(text, "", config));
    TriangleMesh expected;
    const auto& numbers = other.GetAttrib().vertices;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
      expected.positions.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    for (const auto& shape : other.GetShapes()) {
      std::size_t begin = 0;
      for (const std::size_t corners : shape.mesh.num_face_vertices) {
        const auto vertex = [&](std::size_t k) {
          return static_cast<std::uint32_t>(shape.mesh.indices[begin + k].vertex_index);
        };
        for (std::size_t k = 2; k < corners; ++k)
          expected.triangles.push_back({vertex(0), vertex(k - 1), vertex(k)});
        begin += corners;
      }
    }
    const auto mesh = read_obj(bytes_of(text));
    REQUIRE(mesh);
    CHECK(mesh->triangles == expected.triangles);
    REQUIRE(mesh->positions.size() == expected.positions.size());
    for (std::size_t i = 0; i < expected.positions.size();
         ++i)  // tinyobjloader's numbers are right to some 1e-7
      CHECK(length(mesh->positions[i] - expected.positions[i]) <= 1e-6F * length(expected.positions[i]));
  }
}

TEST_CASE("an OBJ file written and read back has the same bits") {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const auto back = read_obj(write_obj(mesh));
    REQUIRE(back);
    CHECK(same_bits(mesh, *back));
  }
  CHECK(text_of(write_obj({{{0, 0.1F, -1}, {1e-30F, 0, 0}, {1, 1, 1}}, {{0, 2, 1}}})) ==
        "v 0 0.1 -1\nv 1e-30 0 0\nv 1 1 1\nf 1 3 2\n");
}

TEST_CASE("a written OBJ has the texture coordinates and normals that there are") {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::string places = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", texture = "vt 0 0\nvt 0.5 0\nvt 0 0.25\n",
                    normals = "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\n";
  const VertexAttributes both{smooth_normals(mesh), {{0, 0}, {0.5F, 0}, {0, 0.25F}}};
  CHECK(text_of(write_obj(mesh, both)) == places + texture + normals + "f 1/1/1 2/2/2 3/3/3\n");
  CHECK(text_of(write_obj(mesh, {{}, both.texture})) == places + texture + "f 1/1 2/2 3/3\n");
  CHECK(text_of(write_obj(mesh, {both.normals, {}})) == places + normals + "f 1//1 2//2 3//3\n");
  const auto back = read_obj(write_obj(mesh, both));
  REQUIRE(back);
  CHECK(same_bits(mesh, *back));
}

TEST_CASE("OBJ lines may be continued, and end with LF, CR LF or CR") {
  for (const char* text :
       {"v 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\n 2 3\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3",
        "v 0 0 0\r\nv 1 0\\\r\n 0\r\nv 0 1 0 # v\r\nf 1 2 3 # 4\r\n",
        "vn 0 \\\nf 1 1 1\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0"}) {
    INFO(text);
    const auto mesh = read_obj(bytes_of(text));
    REQUIRE(mesh);
    CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}});
    CHECK(mesh->positions[1] == Vec3f{1, 0, 0});
  }
}

TEST_CASE("an error in an OBJ file gives its line, the value and the limit") {
  const auto message = [](const char* text) { return read_obj(bytes_of(text)).error().message; };
  CHECK(message("v 0 0 0\n\nf 1 1 2\n") == "Line 3 names vertex 2, which is not in 1 to 1.");
  CHECK(message("v 0 0 0\nf -1 -2 1\n") == "Line 2 names vertex -2, but only 1 vertices come before it.");
  CHECK(message("v 0 0\n") == "Line 1 has 2 coordinates, fewer than 3.");
  CHECK(message("v 0 0 1e39\n") ==
        "Line 1 has the coordinate 1e39, beyond the largest of single precision, 3.40282347e+38.");
  CHECK(message("v 0 0 0\nf 1 1\n") == "Line 2 has a face of 2 corners, fewer than 3.");
  CHECK(message("v 0 \\\n0 \\\n0\nf 1 1 x\n").find("Line 4 has the corner \"x\"") == 0);
}
