#include <doctest/doctest.h>

#include <algorithm>

#include "mesh/adjacency.hpp"
#include "mesh/primitives.hpp"
#include "mesh_files.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("every triangle is in the rows of its vertices, and a vertex without any has an empty row") {
  TriangleMesh mesh = cube();
  mesh.positions.push_back({5, 5, 5});
  const Adjacency at = triangle_adjacency(mesh.positions.size(), mesh.triangles);
  CHECK(at.entries.size() == 36);
  CHECK(at.row(8).empty());
  for (std::size_t vertex = 0; vertex < 8; ++vertex) {
    CHECK(std::is_sorted(at.row(vertex).begin(), at.row(vertex).end()));
    for (const auto t : at.row(vertex))
      CHECK(std::count(mesh.triangles[t].begin(), mesh.triangles[t].end(), vertex) == 1);
  }
  CHECK(triangle_adjacency(0, {}).row_count() == 0);
}

TEST_CASE("a mesh's edges are unique, sorted, and as many as Euler says") {
  const auto edges = mesh_edges(cube().triangles);
  CHECK(edges.size() == 18);  // V - E + F = 2
  CHECK(std::is_sorted(edges.begin(), edges.end()));
  CHECK(std::all_of(edges.begin(), edges.end(), [](const Edge& e) { return e[0] < e[1]; }));
  CHECK(mesh_edges(make_sphere(20, 20).triangles).size() == 382 + 760 - 2);
}
