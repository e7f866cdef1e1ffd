// Shapes that a mesh comes to at times.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// Times of shapes after the one at time 0, rising from above 0 [s]. Between two of them all goes straight; after the
/// last it stays, or begins anew where the last shape is that at 0.
struct ShapeTimes {
  std::vector<double> times;
  bool loops = false;

  /// Between which shapes a time is (0: the mesh itself, k: the one at times[k - 1]), and how far from the first to
  /// the second, in [0, 1).
  struct Moment {
    std::size_t from = 0, to = 0;
    double part = 0;
    bool operator==(const Moment&) const = default;
  };
  Moment at(double time) const;
};

/// Of all shapes of a scene together: kernels number their vertices in f32, which has whole numbers up to there.
inline constexpr std::size_t kMostShapeVertices = std::size_t{1} << 24U;

/// How a mesh deforms: other positions of its vertices.
struct Deformation {
  ShapeTimes times;
  std::vector<std::vector<Vec3f>> shapes;  // one for each time [m]

  bool empty() const { return shapes.empty(); }
};

}  // namespace weft::mesh
