// A coarser mesh from the nodes of another, and linear interpolation from it.
#include <doctest/doctest.h>

#include <algorithm>

#include "irregular_meshes.hpp"
#include "mesh/coarse_mesh.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

Network network_of(const TriangleMesh& mesh) {
  Network network;
  for (const Vec3f& x : mesh.positions) network.positions.push_back(x.to<double>());
  network.triangles = mesh.triangles;
  network.edges = mesh_edges(mesh.triangles);
  return network;
}

/// The interpolation of these values of coarse nodes.
Vec3d value_at(const CoarseMesh& coarse, std::size_t node, const std::vector<Vec3d>& values) {
  Vec3d sum;
  for (const Share& tap : coarse.taps[node]) sum += static_cast<double>(tap.weight) * values[tap.index];
  return sum;
}

std::vector<TriangleMesh> meshes() {
  return {jittered_sheet(23, 17, 2, 1.5),
          shuffled(jittered_sheet(23, 17, 2, 1.5, 0.45)),
          tube(24, 15, 0.3, 1),
          sphere_skin(9, 0.5),
          jittered_sheet(40, 2, 2, 0.05),
          folded(jittered_sheet(21, 12, 2, 1, 0)),
          both(jittered_sheet(6, 9, 1, 1), tube(9, 7, 0.2, 0.5), {1, 0, 0})};
}

}  // namespace

TEST_CASE("no two nodes that stay are joined, and every other node is joined to one that stays") {
  for (const TriangleMesh& mesh : meshes())
    for (Network fine = network_of(mesh); fine.positions.size() > 4;) {
      const CoarseMesh coarse = coarsened(fine);
      std::vector<bool> stays(fine.positions.size(), false), near(stays);
      for (const std::uint32_t node : coarse.of) stays[node] = near[node] = true;
      for (const Edge& e : fine.edges) {
        CHECK_FALSE((stays[e[0]] && stays[e[1]]));
        if (stays[e[0]] || stays[e[1]]) near[e[0]] = near[e[1]] = true;
      }
      CHECK(std::count(near.begin(), near.end(), false) == 0);
      REQUIRE(coarse.network.positions.size() < fine.positions.size());
      for (const Triangle& t : coarse.network.triangles)
        for (const std::uint32_t node : t) REQUIRE(node < coarse.of.size());
      if (coarse.network.edges.empty()) break;
      fine = coarse.network;
    }
}

TEST_CASE("interpolation keeps constants everywhere, and takes of a node that stays its own value") {
  for (const TriangleMesh& mesh : meshes()) {
    const CoarseMesh coarse = coarsened(network_of(mesh));
    for (const auto& taps : coarse.taps) {
      float sum = 0;
      for (const Share& tap : taps) {
        CHECK(tap.weight >= 0);
        CHECK(tap.index < coarse.of.size());
        sum += tap.weight;
      }
      CHECK(std::abs(sum - 1) < 3e-7F);
    }
    for (std::uint32_t k = 0; k < coarse.of.size(); ++k) {
      CHECK(coarse.taps[coarse.of[k]][0].index == k);
      CHECK(coarse.taps[coarse.of[k]][0].weight == 1);
    }
  }
}

TEST_CASE("interpolation on a flat sheet is linear in place, but for less than a coarse cell at the rim") {
  for (const double jitter : {0.0, 0.3, 0.45}) {
    const TriangleMesh mesh = jittered_sheet(31, 31, 3, 3, jitter);  // cells of 0.1 m
    Network fine = network_of(mesh);
    double cell = 0.1;
    for (int level = 0; level < 3; ++level) {
      const CoarseMesh coarse = coarsened(fine);
      std::size_t inside = 0;
      for (std::size_t node = 0; node < fine.positions.size(); ++node) {
        const Vec3d apart = value_at(coarse, node, coarse.network.positions) - fine.positions[node];
        const Vec3d& x = fine.positions[node];
        const bool inner = std::max(std::abs(x.x), std::abs(x.z)) < 1.5 - 2 * cell;
        if (inner) CHECK(length(apart) < 1e-6);
        CHECK(length(apart) < 2 * cell);
        inside += inner ? 1 : 0;
      }
      CHECK(inside > 0);
      fine = coarse.network;
      cell *= 2;
    }
  }
}

TEST_CASE(
    "a coarse sheet is a triangulation: it has the sheet's area and no edge of more than two triangles") {
  const Network fine = network_of(jittered_sheet(41, 41, 2, 2));
  const CoarseMesh coarse = coarsened(fine);
  double area = 0;
  std::vector<Edge> sides;
  for (const Triangle& t : coarse.network.triangles) {
    const auto& x = coarse.network.positions;
    area += 0.5 * length(cross(x[t[1]] - x[t[0]], x[t[2]] - x[t[0]]));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high});
    }
  }
  CHECK(area < 4 + 1e-6);      // it has no folds
  CHECK(area > 4 - 8 * 0.05);  // less at most a cell all around
  for (const Edge& e : coarse.network.edges) CHECK(std::count(sides.begin(), sides.end(), e) <= 2);
}

TEST_CASE("a strip one cell wide becomes a path, and pieces stay apart down to a node each") {
  const Network narrow = network_of(jittered_sheet(60, 2, 3, 0.05));
  const CoarseMesh strip = coarsened(narrow);
  for (std::size_t node = 0; node < narrow.positions.size(); ++node) {
    const Vec3d& x = narrow.positions[node];
    if (std::abs(x.x) < 1.3)  // but for the ends, which the path does not reach
      CHECK(length(value_at(strip, node, strip.network.positions) - x) < 0.0501);  // its width
  }
  const TriangleMesh two = both(jittered_sheet(7, 7, 1, 1), jittered_sheet(6, 8, 1, 1), {0, 0.01F, 0});
  Network network = network_of(two);
  std::vector<int> piece(network.positions.size(), 0);
  std::fill(piece.begin() + 49, piece.end(), 1);
  while (!network.edges.empty()) {
    const CoarseMesh coarse = coarsened(network);
    std::vector<int> next;
    for (const std::uint32_t node : coarse.of) next.push_back(piece[node]);
    for (std::size_t node = 0; node < piece.size(); ++node)
      for (const Share& tap : coarse.taps[node])
        if (tap.weight > 0) CHECK(next[tap.index] == piece[node]);
    piece = next;
    network = coarse.network;
  }
  CHECK(piece == std::vector<int>{0, 1});
}

TEST_CASE("coarse nodes that lie on each other leave no weight undefined") {
  // A path and a triangle, folded: nodes 0 and 2, 3 and 5 stay, and lie on each other.
  Network network;
  network.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {3, 0, 0}, {4, 0, 0}, {3, 0, 0}, {3, 1, 0}};
  network.edges = {{0, 1}, {1, 2}, {3, 4}, {4, 5}, {4, 6}};
  network.triangles = {};
  const CoarseMesh coarse = coarsened(network);
  CHECK(coarse.of == std::vector<std::uint32_t>{0, 2, 3, 5, 6});
  for (const std::size_t node : {1U, 4U}) {
    float sum = 0;
    for (const Share& tap : coarse.taps[node]) {
      CHECK(tap.weight >= 0);
      sum += tap.weight;
    }
    CHECK(sum == 1);
  }
}

TEST_CASE(
    "a coarse body: constants everywhere, its surface on its surface, and linear in place where it has "
    "volume") {
  constexpr std::uint32_t kCells = 12;
  constexpr double kCell = 1.0 / kCells;
  const TetMesh mesh = block({kCells, kCells, kCells}, {1, 1, 1});
  Network fine;
  for (const Vec3f& x : mesh.positions) fine.positions.push_back(x.to<double>());
  fine.triangles = boundary(mesh.tets);
  fine.tets = mesh.tets;
  for (const Tet& t : mesh.tets)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        fine.edges.push_back({std::min(t[i], t[j]), std::max(t[i], t[j])});
  std::sort(fine.edges.begin(), fine.edges.end());
  fine.edges.erase(std::unique(fine.edges.begin(), fine.edges.end()), fine.edges.end());
  double cell = kCell;
  for (int level = 0; level < 2; ++level) {
    const CoarseMesh coarse = coarsened(fine);
    REQUIRE(!coarse.network.tets.empty());
    CHECK(coarse.of.size() < fine.positions.size() / 3);
    std::size_t linear = 0, inner = 0;
    for (std::size_t node = 0; node < fine.positions.size(); ++node) {
      float sum = 0;
      for (const Share& tap : coarse.taps[node]) {
        CHECK(tap.weight >= 0);
        sum += tap.weight;
      }
      CHECK(std::abs(sum - 1) < 4e-7F);
      const double off = length(value_at(coarse, node, coarse.network.positions) - fine.positions[node]);
      CHECK(off < 2 * cell);
      const Vec3d& x = fine.positions[node];
      if (std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}) > 0.5 - 1.5 * cell) continue;
      ++inner;
      linear += off < 1e-6 ? 1 : 0;
    }
    // Coarse tetrahedra leave gaps where more than four regions meet in a fine one's neighbourhood.
    CHECK(10 * linear > 9 * inner);
    CHECK(inner > 0);
    for (const Triangle& t :
         coarse.network.triangles) {  // of a cube each lies in a side, or goes round an edge
      Vec3d least{1, 1, 1}, most{-1, -1, -1};
      for (const std::uint32_t node : t)
        for (int axis = 0; axis < 3; ++axis) {
          least[axis] = std::min(least[axis], std::abs(coarse.network.positions[node][axis]));
          most[axis] = std::max(most[axis], std::abs(coarse.network.positions[node][axis]));
        }
      CHECK(std::max({most.x, most.y, most.z}) > 0.5 - 1e-9);
    }
    fine = coarse.network;
    cell *= 2;
  }
}
