// Picking: the point under a pointer.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "render/camera.hpp"
#include "weft/view.hpp"

namespace weft::render {

using weft::Ray;

/// Of unit direction, from the eye through a place in the picture: x to the right, y upwards, each from -1 to 1.
Ray pick_ray(const Camera& camera, double aspect, double x, double y);

/// A point's place in the picture, as pick_ray has it, and how far before the eye it lies; where that is not
/// positive, the point is not seen and has no place.
struct Projected {
  double x = 0, y = 0;
  double depth = 0;  // along the view, not along the ray [m]
};
Projected project(const Camera& camera, double aspect, const Vec3d& point);

/// A rectangle of the picture between two corners, in any order, as pick_ray has them.
struct PickArea {
  double ax = 0, ay = 0, bx = 0, by = 0;
};
/// The nodes before the eye whose places are in the area, whether they are seen or hidden, in rising order.
std::vector<std::uint32_t> nodes_within(const Camera& camera, double aspect, const PickArea& area,
                                        std::span<const Vec4f> positions);

struct PickedNode {
  std::uint32_t node = 0;      // the corner of `triangle` nearest to `point`
  std::uint32_t triangle = 0;  // the first that the ray meets
  Vec3d point;                 // where [m]
  double distance = 0;         // from the ray's origin [m]
};
/// The first triangle that a ray of unit direction meets, from either side, and its corner nearest to there. A
/// ray through a side that two triangles share meets one of them; a ray within a triangle's plane does not meet it.
std::optional<PickedNode> pick_node(const Ray& ray, std::span<const Vec4f> positions,
                                    std::span<const mesh::Triangle> triangles);

}  // namespace weft::render
