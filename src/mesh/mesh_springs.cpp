#include <algorithm>
#include <span>

#include "mesh/sides.hpp"
#include "mesh/springs.hpp"

namespace weft::mesh {
namespace {

constexpr double kLonger =
    1.001;  // a diagonal is longer than its quad's sides by more than rounding of coordinates

double distance(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return length(mesh.positions[b].to<double>() - mesh.positions[a].to<double>());
}

std::uint32_t opposite(const TriangleMesh& mesh, const Side& side) {
  return mesh.triangles[side.triangle][side.corner];
}

bool is_longest(const TriangleMesh& mesh, const Side& side, double edge_length) {
  return edge_length > kLonger * distance(mesh, side.nodes[0], opposite(mesh, side)) &&
         edge_length > kLonger * distance(mesh, side.nodes[1], opposite(mesh, side));
}

// The springs of one edge: itself, and those across it.
void add_springs(const TriangleMesh& mesh, std::span<const Side> sides, double boundary_weight,
                 std::vector<MeshSpring>& springs) {
  const Side& first = sides[0];
  const double edge_length = distance(mesh, first.nodes[0], first.nodes[1]);
  const bool is_diagonal = sides.size() == 2 && opposite(mesh, first) != opposite(mesh, sides[1]) &&
                           is_longest(mesh, first, edge_length) && is_longest(mesh, sides[1], edge_length);
  springs.push_back({first.nodes[0], first.nodes[1], is_diagonal ? SpringKind::Shear : SpringKind::Structural,
                     edge_length, sides.size() == 1 ? boundary_weight : 1.0});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto [low, high] = std::minmax({opposite(mesh, sides[i - 1]), opposite(mesh, sides[i])});
    if (low == high) continue;
    springs.push_back(
        {low, high, is_diagonal ? SpringKind::Shear : SpringKind::Bend, distance(mesh, low, high), 1.0});
  }
}

}  // namespace

std::vector<MeshSpring> mesh_springs(const TriangleMesh& mesh, BoundaryWeights weights) {
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  const double boundary_weight = weights == BoundaryWeights::Area ? 0.5 : 1.0;
  std::vector<MeshSpring> springs;
  springs.reserve(sides.size() + sides.size() / 4);
  for_each_edge(sides, [&](std::span<const Side> of_edge) {
    if (of_edge[0].nodes[0] != of_edge[0].nodes[1]) add_springs(mesh, of_edge, boundary_weight, springs);
  });
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
