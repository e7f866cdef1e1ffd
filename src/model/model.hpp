// What does not change while a scene runs: rest shape, mass, topology, materials, pins. On the host: no room
// below needs a GPU, so the reference reads the same model.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/vec.hpp"
#include "element/gas/law.hpp"
#include "element/spring/build.hpp"
#include "mesh/grid.hpp"
#include "mesh/springs.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/triangle_mesh.hpp"
#include "model/elements.hpp"
#include "model/pattern.hpp"
#include "scene/grab.hpp"

namespace weft {

/// What one cloth or body of the scene became: a range of the nodes, triangles and elements of a Model.
struct Body {
  std::uint32_t first_vertex = 0, vertex_count = 0;
  std::uint32_t first_triangle = 0, triangle_count = 0;  // of a body with volume its surface
  std::optional<mesh::Grid>
      grid;  // in the world's metres; a hint for fast paths. A cloth without one is a mesh
  mesh::BoundaryWeights weights = mesh::BoundaryWeights::Area;
  scene::Stiffness stiffness;           // [N/m]
  double damping = 0;                   // [N·s/m]
  std::optional<double> strain_limit;   // how far edges are stretched at most, of their length
  std::optional<double> slack;          // of its tethers (model/tethers.hpp); none: it has none
  std::optional<scene::Fabric> fabric;  // then it has membranes and hinges, and no springs
  std::optional<scene::Solid> solid;    // then it has tetrahedra alone
  std::optional<gas::Law> gas;          // what it encloses, where the scene has a pressure
  std::optional<double> strength;       // what a node of it bears before it parts (tearing.hpp) [N/m]
  std::vector<mesh::Triangle> whole;    // before it tore, of nodes that count from 0; empty: it has not
  std::optional<CutPattern> pattern;    // what it is cut from, where it has seams
  std::vector<mesh::Tet> tets;          // of its nodes, which count from 0
  Vec3d warp{1, 0, 0};                  // the direction of its warp at rest, in the world
  std::vector<Vec3d> warps;             // of each of its triangles, where panels have their own; else empty
  std::optional<Vec3d> color;
  scene::Look look;

  /// Nodes of a row, where triangles have diagonals that shear lengthens; 0: every edge of a triangle is as structural
  /// as the others.
  std::uint32_t row() const { return grid ? grid->nx : 0; }
  SpringMaterial material() const { return {stiffness, damping, weights, strain_limit}; }
};

/// A grab of the scene, and the node that it means.
struct NodeGrab {
  std::uint32_t node = 0;
  scene::Grab grab;
};

/// Nodes that a program moves (scene::MotionGiven), at most: each has a motion of its own.
inline constexpr std::size_t kMostGivenNodes = 4096;

/// The model on the host. Vertices, triangles and elements are numbered through all bodies, one body after the
/// other.
struct Model {
  std::vector<Body> bodies;
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

  /// How many elements of a kind there are, or one of `cloths` has. Makes no table of a grid.
  std::uint64_t count(ElementKind kind) const;
  std::uint64_t count(ElementKind kind, const Body& body) const;
  /// All elements of a kind, or those of one of `bodies`, with the model's node numbers. Made once, when first asked
  /// for; the model's cloths, places and triangles stay as they are from then on.
  const ElementTable& elements(ElementKind kind) const;
  const ElementTable& elements(ElementKind kind, const Body& body) const;
  /// Node -> elements of one of `bodies`, by its own numbers of both.
  const mesh::Adjacency& incidence(ElementKind kind, const Body& body) const;
  /// Of a body of fabric, whose nodes count from 0; made once, as the tables.
  const hinge::Plate& plate(const Body& body) const;
  /// The triangles of all bodies of fabric that are too thin to bend as a sheet, and bend freely.
  std::uint64_t sliver_count() const;
  /// Of elements(kind).
  const Colors& colors(ElementKind kind) const;

  Springs springs() const { return Springs(elements(ElementKind::Spring)); }
  Springs springs(const Body& body) const { return Springs(elements(ElementKind::Spring, body)); }

 private:
  std::size_t number_of(const Body& body) const;
  ElementStore store_;
};

/// Places the scene's cloths and bodies in the world. `cloth_meshes[c]` is the mesh of cloth c, transformed (empty for
/// a grid or body); `solids[c]` the tetrahedra of a body that is no block, before its transform (empty for others).
/// Errors  Input: a cloth vertex has no area, a tetrahedron no volume, a selector selects nothing, a node is both
/// pinned and moved, a grab does not mean one free node or shares it with another. Limit: more than kMostGivenNodes.
/// Without attachments, for which colliders are needed: attachments.hpp.
Result<Model> build_model(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& cloth_meshes,
                          std::span<const mesh::TetMesh> solids = {});

/// Where the corners of one of a body's triangles are as it is at rest by itself [m]. Nodes where seams meet have one
/// place at rest_position, which is none of them.
std::array<Vec3d, 3> rest_corners(const Model& model, const Body& body, std::uint32_t triangle);

/// The triangles of a cloth, whose nodes count from 0.
std::vector<mesh::Triangle> own_triangles(const Model& model, const Body& body);

/// The mesh of a cloth, numbered from 0, at rest.
mesh::TriangleMesh cloth_mesh(const Model& model, const Body& body);

/// The stiffness of a grid cloth's triples along i and along j [N/m] (element/triple/triple.hpp); of a mesh 0.
std::array<double, 2> bending_stiffness(const Body& body);

}  // namespace weft
