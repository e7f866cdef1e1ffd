#include <doctest/doctest.h>

#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/texture.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

VertexAttributes attributes_of(Random& random) {
  VertexAttributes attributes{smooth_normals(cube()), {}};
  for (std::size_t v = 0; v < 8; ++v)
    attributes.texture.push_back(
        {static_cast<float>(random.uniform(-1, 2)), static_cast<float>(random.uniform(0, 1e-6))});
  return attributes;
}

}  // namespace

TEST_CASE(
    "texture coordinates of a written OBJ or PLY file are read to the same bits, and none where there are "
    "none") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const VertexAttributes attributes = attributes_of(random);
    for (const auto& [name, file] : {std::pair{"a.obj", write_obj(cube(), attributes)},
                                     std::pair{"a.OBJ", write_obj(cube(), {{}, attributes.texture})},
                                     std::pair{"a.ply", write_ply(cube(), {}, attributes)},
                                     std::pair{"a.ply", write_ply(cube(), {}, {{}, attributes.texture})}}) {
      const auto back = read_texture(file, name, 8);
      REQUIRE_MESSAGE(back, back.error().message);
      CHECK(back.value() == attributes.texture);
      CHECK(read_texture(file, name, 9).value().empty());  // some program's, whose vertices have several
    }
  }
  CHECK(read_texture(write_obj(cube()), "a.obj", 8).value().empty());
  CHECK(read_texture(write_ply(cube()), "a.ply", 8).value().empty());
}

TEST_CASE("texture coordinates that are wrong are refused with the line, the byte or the value") {
  CHECK(read_texture(bytes_of("v 0 0 0\nvt 1\n"), "a.obj", 1).error().message ==
        "Line 2 has \"vt\" without two numbers.");
  CHECK(read_texture(bytes_of("vt 1e99 0\n"), "a.obj", 1).error().message ==
        "The texture coordinates (inf, 0) of vertex 0 are not finite.");
  Random random(6);
  const std::string file = text_of(write_ply(cube(), {}, attributes_of(random)));
  const std::size_t data = file.find("end_header\n") + 11;
  CHECK(read_texture(bytes_of(file.substr(0, data + 8 * 32)), "a.ply", 8).value().size() ==
        8);  // the vertices
  for (std::size_t size = 0; size < data + 8 * 32; ++size)
    CHECK_FALSE(read_texture(bytes_of(file.substr(0, size)), "a.ply", 8));
}
