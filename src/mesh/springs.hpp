// The springs of a cloth, from a grid or from any triangle mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

enum class SpringKind : std::uint32_t { Structural, Shear, Bend };

struct MeshSpring {
  std::uint32_t node_a = 0, node_b = 0;  // node_a < node_b
  SpringKind kind = SpringKind::Structural;
  double rest_length = 0.0;  // m
  double weight = 1.0;       // of the material's stiffness
  std::array<std::uint32_t, 2>
      triangles{};  // of a mesh: those of the edge that it is or crosses; at a rim one, twice
};

/// How much of a material's stiffness a spring on the boundary has.
enum class BoundaryWeights {
  Area,     ///< half: there is cloth on one side only, so that stiffness does not depend on the grid
  Uniform,  ///< all of it, as in Sung et al.
};

/// (nx-1) ny + nx (ny-1) structural, 2 (nx-1) (ny-1) shear and (nx-2) ny + nx (ny-2) bend springs.
std::uint64_t grid_spring_count(const Grid& grid);

/// The springs of a grid, ordered by the quad's or spring's node (i, j), row by row, and there:
///
///     (i,j)──1──(i+1,j)        1, 2  structural
///       │ ╲ ╱                  3, 4  shear: (i,j)-(i+1,j+1), then (i+1,j)-(i,j+1)
///       2  3 4                 5, 6  bend: (i,j)-(i+2,j), then (i,j)-(i,j+2)
///       │ ╱ ╲
///    (i,j+1)    (i+1,j+1)
///
/// Weights are 1 but for structural and bend springs along a boundary row or column.
std::vector<MeshSpring> grid_springs(const Grid& grid, BoundaryWeights weights);

/// The springs of any triangle mesh that passed check_mesh, non-manifold or in several pieces, sorted by
/// (node_a, node_b), no pair twice; rest lengths are the mesh's distances. Every edge is a spring:
/// - Where exactly two triangles meet and their edge is longer by 1e-3 than all their others, the two
///   are taken for a quad and the edge for its diagonal: it is Shear, and so is the other diagonal, between
///   the opposite vertices.
/// - All other edges are Structural. Where two or more triangles meet, the vertices opposite to the edge in
///   triangles that follow each other (by index) are joined by a Bend spring, unless a spring joins them.
/// Weights are 1 but for the edges of a single triangle.
std::vector<MeshSpring> mesh_springs(const TriangleMesh& mesh, BoundaryWeights weights);

/// The same once it has torn: `torn` has the mesh's triangles in their order, each with the nodes that it has now. An
/// edge whose triangles have parted is a spring of each of them, of the same kind and with its share of the weight, and
/// nothing crosses it any more: no spring is new, and what the springs hold together never grows.
std::vector<MeshSpring> torn_springs(const TriangleMesh& mesh, BoundaryWeights weights,
                                     std::span<const Triangle> torn);

/// The same once it is sewn: `sewn` has the pattern's triangles in their order, each with the nodes that it has now. An
/// edge at a seam is as long as it is in its triangles in the mean; what crosses it is as long as these are wide, laid
/// into a plane.
std::vector<MeshSpring> sewn_springs(const TriangleMesh& pattern, BoundaryWeights weights,
                                     std::span<const Triangle> sewn);

}  // namespace weft::mesh
