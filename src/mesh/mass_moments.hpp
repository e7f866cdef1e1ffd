// Volume, centre and second moments of what a closed mesh encloses.
#pragma once

#include <span>

#include "base/mat3.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

struct MassMoments {
  double volume = 0;  // [m³]
  Vec3d center;       // mean place [m]
  Mat3 second;        // ∫ (x - center)(x - center)ᵀ dV [m⁵]
};

/// Of a closed mesh that faces outward: sums over the tetrahedra between its triangles and a point; exact.
/// Source  Tonon 2004, Explicit exact formulas for the 3-D tetrahedron inertia tensor.
MassMoments mass_moments(const TriangleMesh& mesh);

/// The inertia of unit density: trace(second) I - second [m⁵].
Mat3 inertia_of(const MassMoments& moments);

/// A symmetric matrix as V diag(values) Vᵀ, V a rotation whose columns are the axes; by Jacobi's rotations.
struct PrincipalAxes {
  Vec3d values;
  Mat3 axes;  // columns
};
PrincipalAxes principal_axes(const Mat3& symmetric);

}  // namespace weft::mesh
