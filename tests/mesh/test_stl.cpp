#include <doctest/doctest.h>

#include "mesh/adjacency.hpp"
#include "mesh/stl.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("corners of an STL file with equal bits become one vertex, in the order of appearance") {
  // The cube's vertices in the order in which its triangles name them first.
  const std::uint32_t order[] = {0, 2, 1, 3, 4, 5, 6, 7};
  for (const std::string& file :
       {text_stl(cube()), binary_stl(cube()), binary_stl(cube(), "solid but binary")}) {
    const auto mesh = read_stl(bytes_of(file));
    REQUIRE(mesh);
    REQUIRE(mesh->positions.size() == 8);
    CHECK(mesh->triangles.size() == 12);
    for (std::size_t i = 0; i < 8; ++i) CHECK(mesh->positions[i] == cube().positions[order[i]]);
    CHECK(signed_volume(*mesh) == doctest::Approx(1.0));
    CHECK(mesh_edges(mesh->triangles).size() == 18);
  }
}

TEST_CASE("an STL file in capitals, with several solids, without a name, or with -0 is read") {
  const auto mesh = read_stl(bytes_of(
      "SOLID\nFACET NORMAL 0 0 1 OUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP ENDFACET\n"
      "ENDSOLID\nsolid two\nendsolid two\nsolid three\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\n"
      "vertex 0 1 -0.0\nvertex -1 0 0\nendloop\nendfacet\nendsolid"));
  REQUIRE(mesh);
  CHECK(mesh->triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("random STL files, text and binary, hold the same corners") {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const TriangleMesh mesh = random_mesh(random);
    const auto text = read_stl(bytes_of(text_stl(mesh)));
    const auto binary = read_stl(bytes_of(binary_stl(mesh)));
    REQUIRE(text);
    REQUIRE(binary);
    CHECK(same_bits(*text, *binary));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(binary->positions[binary->triangles[t][k]] == mesh.positions[mesh.triangles[t][k]]);
  }
}

TEST_CASE("an error in an STL file gives what is due, or both sizes") {
  std::string file = binary_stl(cube());
  file.pop_back();
  CHECK(read_stl(bytes_of(file)).error().message ==
        "The file states 12 triangles, which take 684 bytes, but it has 683.");
  CHECK(read_stl(bytes_of("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nendloop"))
            .error()
            .message == "Line 6 has \"endloop\" where \"vertex\" is due.");
}
