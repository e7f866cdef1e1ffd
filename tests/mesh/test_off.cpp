#include <doctest/doctest.h>

#include "mesh/off.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("an OFF file is read to the same bits") {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const auto back = read_off(bytes_of(text_off(mesh)));
    REQUIRE(back);
    CHECK(same_bits(mesh, *back));
  }
}

TEST_CASE("OFF files with polygons, colours, normals, comments and empty lines are read") {
  for (const char* text :
       {"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3",
        "OFF 4 1 0 # counts beside the keyword\n\n0 0 0\n# a comment\n1 0 0\n1 1 0\n0 1 0\n\n4 0 1 2 3 255 0 "
        "0\n",
        "# first\nCOFF\n4 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n1 1 0 1 1 1 1\n0 1 0 1 1 1 1\n4 0 1 2 3 0.5 "
        "0.5\n",
        "STCNOFF\r\n4 1\r\n0 0 0 0 0 1\r\n1 0 0 0 0 1\r\n1 1 0 0 0 1\r\n0 1 0 0 0 1\r\n4 0 1 2 3\r\n"}) {
    INFO(text);
    const auto mesh = read_off(bytes_of(text));
    REQUIRE(mesh);
    CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
    CHECK(mesh->positions[2] == Vec3f{1, 1, 0});
  }
}

TEST_CASE("an error in an OFF file gives its line, the value and the limit") {
  const auto message = [](const char* text) { return read_off(bytes_of(text)).error().message; };
  CHECK(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n") ==
        "Line 6 names vertex \"3\", but the mesh has 3 vertices, from 0.");
  CHECK(
      message("OFF\n9 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").find("Line 2 announces 9 vertices, more than") ==
      0);
  CHECK(message("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n") == "Line 6 has 3 corners instead of 4.");
  CHECK(message("OFF\n3 2 0\n0.0 0 0\n1.0 0 0\n0 1 0\n3 0 1 2\n") == "The file ends after 1 of 2 faces.");
}
