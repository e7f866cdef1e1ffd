#include <doctest/doctest.h>

#include "mesh/merge.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE(
    "vertices with equal bits become one, in the order of their first appearance, and the others stay") {
  TriangleMesh mesh{{{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 0}, {1, 1, 0}, {9, 9, 9}},
                    {{0, 1, 3}, {2, 5, 4}}};
  merge_vertices(mesh);
  CHECK(mesh.positions == std::vector<Vec3f>{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {9, 9, 9}});
  CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}});
}

TEST_CASE("a random mesh whose triangles stand apart is put together as it was") {
  Random random(21);
  for (int i = 0; i < 100; ++i) {
    TriangleMesh whole = random_mesh(random);
    drop_unused_vertices(whole);
    TriangleMesh apart;
    for (const Triangle& t : whole.triangles) {
      const auto first = static_cast<std::uint32_t>(apart.positions.size());
      for (const std::uint32_t vertex : t) apart.positions.push_back(whole.positions[vertex]);
      apart.triangles.push_back({first, first + 1, first + 2});
    }
    merge_vertices(apart);
    CHECK(apart.positions.size() == whole.positions.size());
    for (std::size_t t = 0; t < whole.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(apart.positions[apart.triangles[t][k]] == whole.positions[whole.triangles[t][k]]);
  }
}

TEST_CASE("vertices that no triangle names are removed, and the others keep their order") {
  TriangleMesh mesh{{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {0, 1, 0}}, {{4, 1, 2}}};
  CHECK(drop_unused_vertices(mesh) == 2);
  CHECK(mesh.positions == std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.triangles == std::vector<Triangle>{{2, 0, 1}});
  CHECK(drop_unused_vertices(mesh) == 0);
}
