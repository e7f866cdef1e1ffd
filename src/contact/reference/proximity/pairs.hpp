// The pairs of features that are near each other, as docs/contact.md defines them, in double.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/reference/box_tree.hpp"
#include "mesh/adjacency.hpp"
#include "scene/scene.hpp"

namespace weft::reference {

/// The vertices, edges and triangles of all cloths, or of all obstacles, as one.
struct Features {
  std::vector<Vec3d> positions;  // [m]
  std::vector<mesh::Triangle> triangles;
  std::vector<mesh::Edge> edges;          // first mesh_edges(triangles)
  std::vector<std::uint32_t> vertices;    // rising; a position that no triangle names is none, unless added
  std::vector<double> vertex_radius;      // of each position [m]; where the list ends: 0
  std::vector<double> edge_radius;        // of each edge [m]; where the list ends: 0
  mesh::Adjacency triangles_at;           // of each position; where the list ends: none
  std::vector<std::uint32_t> cloths{};    // contact_number of each position; empty: all of one cloth
  std::vector<std::uint32_t> balls{};     // positions of spheres
  std::vector<std::uint32_t> capsules{};  // edges
  double most_spare = 0;                  // of round ones, as in spare_of [m]

  double radius_of_vertex(std::uint32_t v) const { return v < vertex_radius.size() ? vertex_radius[v] : 0; }
  double radius_of_edge(std::uint32_t e) const { return e < edge_radius.size() ? edge_radius[e] : 0; }
  /// A capsule: an edge and its two ends with a radius. Call it after all triangles are in.
  void add_capsule(const Vec3d& a, const Vec3d& b, double radius);
  /// A sphere: a vertex with a radius.
  void add_sphere(const Vec3d& center, double radius);

 private:
  std::uint32_t add_round_vertex(const Vec3d& center, double radius);
};
/// By how much a round obstacle may come nearer to the inside of a triangle or an edge of cloth than to its ends, if
/// these are by `more` farther from it [m]: docs/contact.md, equation (1d). All of it up to `most`, then less.
double spare_of(double more, double most);
Features features_of(std::vector<Vec3d> positions, std::vector<mesh::Triangle> triangles);

/// In the order of a sorted list. A is named first; edges of one cloth with the lower number first.
enum class PairKind : std::uint8_t {
  VertexTriangle,        // both of cloth
  EdgeEdge,              // both of cloth
  VertexObjectTriangle,  // a vertex of cloth, a triangle of an obstacle
  ObjectVertexTriangle,  // a vertex of an obstacle, a triangle of cloth
  EdgeObjectEdge,        // an edge of cloth, an edge of an obstacle
  VertexBall,            // a vertex of cloth, a sphere
  VertexCapsule,         // a vertex of cloth, a capsule
  VertexPlane,           // a vertex of cloth, a plane
};

struct FeaturePair {
  PairKind kind = PairKind::VertexTriangle;
  std::uint32_t a = 0, b = 0;  // numbers in positions, edges, triangles, or of the plane
  double distance = 0;         // the gap d, of a round obstacle with what it spares [m]
  Vec3d direction;             // n
  // w of the vertices of A and of B in their order, with their signs; a plane has none.
  std::array<double, 3> weights_a{}, weights_b{};
  // Of edges: both closest points are inside. False also where (1b) leaves a pair out, and before a round obstacle
  // where an end of the cloth's feature is nearest, which has its own pair.
  bool inside = true;
  bool in_cones = true;  // cones.hpp; found by measured()
};
/// By kind, a, b: the identity of a pair.
bool operator<(const FeaturePair& x, const FeaturePair& y);
bool same_features(const FeaturePair& x, const FeaturePair& y);

/// The same features at the positions that they have now. Not for planes.
FeaturePair measured(const FeaturePair& pair, const Features& cloth, const Features& object);

/// Trees over features, each grown by its radius.
struct FeatureTrees {
  BoxTree vertices, edges, triangles;  // visit places in Features::vertices, edges, triangles
};
FeatureTrees trees_of(const Features& features);

/// All pairs of cloth with itself whose gap is below `reach` [m], each once, sorted. Features that are not
/// finite have none.
std::vector<FeaturePair> self_pairs(const Features& cloth, double reach);
/// The same of cloth with obstacles; `trees` are the obstacles'.
std::vector<FeaturePair> object_pairs(const Features& cloth, const Features& object,
                                      const FeatureTrees& trees, double reach);
std::vector<FeaturePair> plane_pairs(const Features& cloth, std::span<const scene::ColliderPlane> planes,
                                     double reach);
/// The same without trees, for tests of them and of others.
std::vector<FeaturePair> self_pairs_by_brute_force(const Features& cloth, double reach);
std::vector<FeaturePair> object_pairs_by_brute_force(const Features& cloth, const Features& object,
                                                     double reach);

}  // namespace weft::reference
