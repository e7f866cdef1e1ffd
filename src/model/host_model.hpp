// What does not change while a scene runs: rest shape, mass, topology, materials, pins. On the host: no room
// below needs a GPU, so the reference reads the same model.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "mesh/grid.hpp"
#include "mesh/springs.hpp"
#include "mesh/triangle_mesh.hpp"
#include "scene/grab.hpp"

namespace weft {

/// One spring, as the kernels read it (src/element/spring/packed_spring.wgsl).
struct Spring {
  std::uint32_t node_a = 0, node_b = 0;
  float rest_length = 0;  // [m]
  float stiffness = 0;    // [N/m]
  float damping = 0;      // [N·s/m]
};
static_assert(sizeof(Spring) == 20);

/// Three nodes of a grid in a row: resistance to bending has the energy k/2 |x_a - 2 x_b + x_c|².
struct BendTriple {
  std::uint32_t node_a = 0, node_b = 0, node_c = 0;
  double stiffness = 0;  // k [N/m]
};

/// The part of the model that one cloth of the scene became.
struct ClothModel {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_triangle = 0, triangle_count = 0;
  std::optional<mesh::Grid> grid;  // in the world's metres; a cloth without one is a mesh
  mesh::BoundaryWeights weights = mesh::BoundaryWeights::Area;
  scene::Stiffness stiffness;  // [N/m]
  double damping = 0;          // [N·s/m]
  std::optional<Vec3d> color;
};

/// A grab of the scene, and the node that it means.
struct NodeGrab {
  std::uint32_t node = 0;
  scene::Grab grab;
};

/// The model on the host. Vertices, triangles and springs of all cloths are numbered through, cloth after
/// cloth.
struct HostModel {
  std::vector<ClothModel> cloths;
  std::vector<Vec3d> rest_position;      // in the world [m]
  std::vector<Vec3d> start_position;     // where nodes begin: there, but for the bump of a grid [m]
  std::vector<std::array<float, 2>> uv;  // place on the sheet [m], for the weave
  std::vector<double> mass;              // [kg]
  std::vector<std::uint32_t> motion;     // 0: free; 1: pinned; 1 + k: moved by motions[k - 1]
  std::vector<mesh::Triangle> triangles;
  std::vector<scene::Motion> motions;
  std::vector<NodeGrab> grabs;

  std::size_t vertex_count() const { return rest_position.size(); }
  bool kinematic(std::size_t vertex) const { return motion[vertex] != 0; }
  /// 1/mass, and 0 for a node that is pinned or moved [1/kg].
  double inverse_mass(std::size_t vertex) const { return kinematic(vertex) ? 0.0 : 1.0 / mass[vertex]; }
};

/// Places the scene's cloths in the world. `cloth_meshes[c]` is the mesh of cloth c, transformed (empty for a
/// grid). Errors  Input: a cloth vertex has no area, a selector selects nothing, a node is both pinned and
/// moved, a grab does not mean one free node or shares it with another.
Result<HostModel> build_model(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& cloth_meshes);

/// The springs of one cloth in the order of mesh/springs.hpp, with the model's node numbers.
std::vector<Spring> build_springs(const HostModel& model, const ClothModel& cloth);
/// The springs of all cloths.
std::vector<Spring> build_springs(const HostModel& model);

/// The stiffness of a grid cloth's triples along i and along j: B dj / di³ and B di / dj³ [N/m], where B is
/// stiffness.bending [N·m]. Triples along the boundary count as its springs do.
std::array<double, 2> bending_stiffness(const ClothModel& cloth);
/// The triples of one cloth, row by row, then column by column; none without stiffness.bending.
std::vector<BendTriple> build_bending(const ClothModel& cloth);

}  // namespace weft
