#include <algorithm>
#include <span>

#include "mesh/springs.hpp"

namespace weft::mesh {
namespace {

constexpr double kLonger =
    1.001;  // a diagonal is longer than its quad's sides by more than rounding of coordinates

/// One triangle at an edge.
struct Side {
  std::uint32_t node_a, node_b;  // the edge, node_a < node_b
  std::uint32_t triangle;
  std::uint32_t opposite;  // the triangle's third vertex
};

// Sorted by edge and there by triangle, so that the sides of an edge lie together in a fixed order.
std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k];
      const std::uint32_t b = mesh.triangles[t][(k + 1) % 3];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), t, mesh.triangles[t][(k + 2) % 3]});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.node_a != b.node_a) return a.node_a < b.node_a;
    return a.node_b != b.node_b ? a.node_b < b.node_b : a.triangle < b.triangle;
  });
  return sides;
}

double distance(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return length(mesh.positions[b].to<double>() - mesh.positions[a].to<double>());
}

bool is_longest(const TriangleMesh& mesh, const Side& side, double edge_length) {
  return edge_length > kLonger * distance(mesh, side.node_a, side.opposite) &&
         edge_length > kLonger * distance(mesh, side.node_b, side.opposite);
}

// The springs of one edge: itself, and those across it.
void add_springs(const TriangleMesh& mesh, std::span<const Side> sides, double boundary_weight,
                 std::vector<MeshSpring>& springs) {
  const Side& first = sides[0];
  const double edge_length = distance(mesh, first.node_a, first.node_b);
  const bool is_diagonal = sides.size() == 2 && first.opposite != sides[1].opposite &&
                           is_longest(mesh, first, edge_length) && is_longest(mesh, sides[1], edge_length);
  springs.push_back({first.node_a, first.node_b, is_diagonal ? SpringKind::Shear : SpringKind::Structural,
                     edge_length, sides.size() == 1 ? boundary_weight : 1.0});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto [low, high] = std::minmax(sides[i - 1].opposite, sides[i].opposite);
    if (low == high) continue;
    springs.push_back(
        {low, high, is_diagonal ? SpringKind::Shear : SpringKind::Bend, distance(mesh, low, high), 1.0});
  }
}

}  // namespace

std::vector<MeshSpring> mesh_springs(const TriangleMesh& mesh, BoundaryWeights weights) {
  const std::vector<Side> sides = sorted_sides(mesh);
  const double boundary_weight = weights == BoundaryWeights::Area ? 0.5 : 1.0;
  std::vector<MeshSpring> springs;
  springs.reserve(sides.size() + sides.size() / 4);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].node_a == sides[begin].node_a &&
           sides[end].node_b == sides[begin].node_b)
      ++end;
    add_springs(mesh, std::span<const Side>(sides).subspan(begin, end - begin), boundary_weight, springs);
  }
  // Of the springs between two nodes the first kind stays: an edge before what only crosses one. Springs that
  // agree in all three are equal, so the order of the sort does not matter.
  std::sort(springs.begin(), springs.end(), [](const MeshSpring& a, const MeshSpring& b) {
    if (a.node_a != b.node_a) return a.node_a < b.node_a;
    return a.node_b != b.node_b ? a.node_b < b.node_b : a.kind < b.kind;
  });
  const auto end = std::unique(springs.begin(), springs.end(), [](const MeshSpring& a, const MeshSpring& b) {
    return a.node_a == b.node_a && a.node_b == b.node_b;
  });
  springs.erase(end, springs.end());
  return springs;
}

}  // namespace weft::mesh
