#include "contact/rules/max_push.hpp"

#include <algorithm>

namespace weft {

double max_push(const Model& model, double thickness) {
  double longest = 0;
  for (const mesh::Triangle& triangle : model.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(
          longest, length(model.rest_position[triangle[(k + 1) % 3]] - model.rest_position[triangle[k]]));
  return thickness + 2 * longest;
}

}  // namespace weft
