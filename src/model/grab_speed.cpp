#include "model/grab_speed.hpp"

#include <algorithm>

namespace weft {

double grab_speed(const Model& model) {
  double largest = 0;
  for (const Body& body : model.bodies) {
    Vec3d low = model.rest_position[body.first_vertex], high = low;
    for (std::uint32_t v = 0; v < body.vertex_count; ++v) {
      low = min(low, model.rest_position[body.first_vertex + v]);
      high = max(high, model.rest_position[body.first_vertex + v]);
    }
    const Vec3d size = high - low;
    largest = std::max({largest, size.x, size.y, size.z});
  }
  return std::max(kGrabSpeed, kGrabLengths * largest);
}

}  // namespace weft
