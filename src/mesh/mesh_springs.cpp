#include <algorithm>
#include <array>
#include <cmath>
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

/// An edge of a sewn mesh, as it is in the triangle of one of its sides.
struct PatternEdge {
  std::array<std::uint32_t, 2> nodes{};  // of the pattern: those of the side's nodes, in their order
  std::uint32_t tip = 0;                 // of the pattern, opposite
  double length = 0, along = 0,
         height = 0;  // of the edge; of the tip from the first node, and over the edge [m]
};

PatternEdge pattern_edge(const TriangleMesh& pattern, std::span<const Triangle> sewn, const Side& side) {
  const Triangle &now = sewn[side.triangle], &cut = pattern.triangles[side.triangle];
  const bool turned = now[side.start()] != side.nodes[0];
  PatternEdge edge{{cut[(side.start() + (turned ? 1 : 0)) % 3], cut[(side.start() + (turned ? 0 : 1)) % 3]},
                   cut[side.corner]};
  edge.length = distance(pattern, edge.nodes[0], edge.nodes[1]);
  const Vec3d from = pattern.positions[edge.nodes[0]].to<double>();
  const Vec3d way = pattern.positions[edge.nodes[1]].to<double>() - from;
  const Vec3d tip = pattern.positions[edge.tip].to<double>() - from;
  edge.along = dot(tip, way) / edge.length;
  edge.height = length(cross(way, tip)) / edge.length;
  return edge;
}

// The springs of one edge of a sewn mesh.
void add_sewn_springs(const TriangleMesh& pattern, std::span<const Triangle> sewn,
                      std::span<const Side> sides, double boundary_weight,
                      std::vector<FoundSpring>& springs) {
  std::vector<PatternEdge> edges;
  double edge_length = 0;
  for (const Side& side : sides) {
    edges.push_back(pattern_edge(pattern, sewn, side));
    edge_length += edges.back().length / static_cast<double>(sides.size());
  }
  const bool is_whole = std::all_of(edges.begin(), edges.end(), [&](const PatternEdge& edge) {
    return std::minmax(edge.nodes[0], edge.nodes[1]) == std::minmax(edges[0].nodes[0], edges[0].nodes[1]);
  });
  const auto longest = [&](const Side& side, const PatternEdge& edge) {
    const Triangle& cut = pattern.triangles[side.triangle];
    return edge.length > kLonger * distance(pattern, cut[side.start()], cut[side.corner]) &&
           edge.length > kLonger * distance(pattern, cut[(side.start() + 1) % 3], cut[side.corner]);
  };
  const bool is_diagonal = is_whole && sides.size() == 2 && edges[0].tip != edges[1].tip &&
                           longest(sides[0], edges[0]) && longest(sides[1], edges[1]);
  const auto [a, b] = sides[0].nodes;
  springs.push_back({{a,
                      b,
                      is_diagonal ? SpringKind::Shear : SpringKind::Structural,
                      edge_length,
                      sides.size() == 1 ? boundary_weight : 1.0,
                      {sides[0].triangle, sides.back().triangle}},
                     sides[0].nodes});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const PatternEdge &one = edges[i - 1], &other = edges[i];
    const auto [low, high] = std::minmax(
        {sewn[sides[i - 1].triangle][sides[i - 1].corner], sewn[sides[i].triangle][sides[i].corner]});
    if (low == high) continue;
    const double across = is_whole ? distance(pattern, one.tip, other.tip)
                                   : std::hypot(one.along - other.along, one.height + other.height);
    springs.push_back({{low,
                        high,
                        is_diagonal ? SpringKind::Shear : SpringKind::Bend,
                        across,
                        1.0,
                        {sides[i - 1].triangle, sides[i].triangle}},
                       {low, high},
                       true});
  }
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

std::vector<MeshSpring> sewn_springs(const TriangleMesh& pattern, BoundaryWeights weights,
                                     std::span<const Triangle> sewn) {
  const std::vector<Side> sides = sorted_sides(sewn);
  std::vector<FoundSpring> springs;
  for_each_edge(sides, [&](std::span<const Side> of_edge) {
    add_sewn_springs(pattern, sewn, of_edge, weights == BoundaryWeights::Area ? 0.5 : 1.0, springs);
  });
  return chosen(std::move(springs));
}

}  // namespace weft::mesh
