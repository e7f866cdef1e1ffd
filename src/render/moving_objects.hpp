#pragma once

#include <limits>
#include <vector>

#include "render/object_draws.hpp"

namespace weft::render {

/// Brings the obstacles that move or deform to where they are at a time. All room is taken at the start.
class MovingObjects {
 public:
  MovingObjects() = default;
  /// `colliders`: Inputs::colliders.
  MovingObjects(std::vector<MovingObject> objects, const std::vector<scene::Collider>* colliders);

  /// Writes  buffers.placement: three rows each; of those that deform position [m] and normal, where they
  ///         change. Before anything that is submitted later.
  void write(gpu::Device& device, const ObjectBuffers& buffers, double time);

 private:
  struct Moving {
    MovingObject object;             // its mesh is the shape as it was written last
    std::vector<Vec3f> first_shape;  // at time 0 [m]
    mesh::ShapeTimes::Moment written;
  };
  void deform(gpu::Device& device, const ObjectBuffers& buffers, std::size_t number, double time);

  std::vector<Moving> objects_;
  const std::vector<scene::Collider>* colliders_ = nullptr;
  bool given_ = false;                                         // a program moves one, at any time elsewhere
  double written_ = std::numeric_limits<double>::quiet_NaN();  // [s]
  std::vector<Vec4f> rows_;                                    // of all
  std::vector<Vec4f> positions_, normals_;                     // of one that deforms
  std::vector<Vec3d> sums_;
};

}  // namespace weft::render
