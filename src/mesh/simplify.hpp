// Fewer triangles for the same shape. A target of its own, weft_simplify: it needs libmeshoptimizer.
#pragma once

#include <cstddef>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// The mesh with at most `target_triangles` triangles, by edge collapses that move no vertex; vertices that
/// no triangle uses are removed. A mesh that is small enough keeps its triangles. The mesh passes check_mesh.
/// Errors  Failure: its topology does not allow so few.
/// Source  meshoptimizer, meshopt_simplify (quadric error, Garland and Heckbert 1997).
Result<TriangleMesh> simplify(const TriangleMesh& mesh, std::size_t target_triangles);

/// The mesh without the vertices that no triangle uses; the others keep their order.
TriangleMesh without_unused_vertices(const TriangleMesh& mesh);

}  // namespace weft::mesh
