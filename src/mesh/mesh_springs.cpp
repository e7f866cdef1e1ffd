#include <algorithm>
#include <array>
#include <span>
#include <tuple>

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

/// The nodes that a side has once the mesh has torn, the lower first.
std::array<std::uint32_t, 2> present(std::span<const Triangle> torn, const Side& side) {
  const Triangle& t = torn[side.triangle];
  const auto [low, high] = std::minmax(t[side.start()], t[(side.start() + 1) % 3]);
  return {low, high};
}

/// A spring with what it was before the mesh tore.
struct FoundSpring {
  MeshSpring spring;                      // with the nodes that it has now
  std::array<std::uint32_t, 2> origin{};  // and had, the lower first
  bool crosses = false, parted = false;   // an edge; and that edge's triangles have parted
};

// The springs of one edge: itself, and those across it.
void add_springs(const TriangleMesh& mesh, std::span<const Triangle> torn, std::span<const Side> sides,
                 double boundary_weight, std::vector<FoundSpring>& springs) {
  const Side& first = sides[0];
  const double edge_length = distance(mesh, first.nodes[0], first.nodes[1]);
  const bool is_diagonal = sides.size() == 2 && opposite(mesh, first) != opposite(mesh, sides[1]) &&
                           is_longest(mesh, first, edge_length) && is_longest(mesh, sides[1], edge_length);
  const double whole = sides.size() == 1 ? boundary_weight : 1.0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::array<std::uint32_t, 2> nodes = present(torn, sides[i]);
    const auto shared = [&](const Side& side) { return present(torn, side) == nodes; };
    if (std::any_of(sides.begin(), sides.begin() + std::ptrdiff_t(i), shared)) continue;
    const auto& other = *std::find_if(sides.rbegin(), sides.rend(), shared);
    const auto share = static_cast<double>(std::count_if(sides.begin(), sides.end(), shared));
    springs.push_back({{nodes[0],
                        nodes[1],
                        is_diagonal ? SpringKind::Shear : SpringKind::Structural,
                        edge_length,
                        whole * (share / static_cast<double>(sides.size())),
                        {sides[i].triangle, other.triangle}},
                       first.nodes});
  }
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const auto [low, high] = std::minmax({opposite(mesh, sides[i - 1]), opposite(mesh, sides[i])});
    if (low == high) continue;
    const auto [a, b] = std::minmax(
        {torn[sides[i - 1].triangle][sides[i - 1].corner], torn[sides[i].triangle][sides[i].corner]});
    springs.push_back({{a,
                        b,
                        is_diagonal ? SpringKind::Shear : SpringKind::Bend,
                        distance(mesh, low, high),
                        1.0,
                        {sides[i - 1].triangle, sides[i].triangle}},
                       {low, high},
                       true,
                       present(torn, sides[i - 1]) != present(torn, sides[i])});
  }
}

/// Of the springs between two nodes of the whole mesh the first kind stays, an edge before what only crosses one, and
/// of what crosses edges one alone; nothing takes the place of a spring that has parted. Springs that agree in all of
/// these are equal, so the order of the sort does not matter.
std::vector<MeshSpring> chosen(std::vector<FoundSpring> found) {
  const auto key = [](const FoundSpring& one) {
    return std::tuple(one.origin, one.crosses, one.spring.kind, one.parted, one.spring.node_a,
                      one.spring.node_b);
  };
  std::sort(found.begin(), found.end(),
            [&](const FoundSpring& a, const FoundSpring& b) { return key(a) < key(b); });
  std::vector<MeshSpring> springs;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool first = k == 0 || found[k].origin != found[k - 1].origin;
    if (found[k].crosses && (!first || found[k].parted)) continue;
    springs.push_back(found[k].spring);
  }
  std::sort(springs.begin(), springs.end(), [](const MeshSpring& a, const MeshSpring& b) {
    return std::tie(a.node_a, a.node_b) < std::tie(b.node_a, b.node_b);
  });
  return springs;
}

}  // namespace

std::vector<MeshSpring> mesh_springs(const TriangleMesh& mesh, BoundaryWeights weights) {
  return torn_springs(mesh, weights, mesh.triangles);
}

std::vector<MeshSpring> torn_springs(const TriangleMesh& mesh, BoundaryWeights weights,
                                     std::span<const Triangle> torn) {
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  const double boundary_weight = weights == BoundaryWeights::Area ? 0.5 : 1.0;
  std::vector<FoundSpring> springs;
  springs.reserve(sides.size() + sides.size() / 4);
  for_each_edge(sides, [&](std::span<const Side> of_edge) {
    if (of_edge[0].nodes[0] != of_edge[0].nodes[1])
      add_springs(mesh, torn, of_edge, boundary_weight, springs);
  });
  return chosen(std::move(springs));
}

}  // namespace weft::mesh
