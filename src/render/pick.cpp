#include "render/pick.hpp"

#include <array>
#include <cmath>

namespace weft::render {
namespace {

struct Hit {
  Vec3d point;          // from the ray's origin [m]
  double distance = 0;  // [m]
};

//        c          The volumes of the tetrahedra (direction, side) have one sign if and only if the ray's
//        line
//       / \         passes through the triangle, and are as its barycentric coordinates. For a side that two
//      / . \        triangles share they differ in sign only, to the bit: cross(a, b) = -cross(b, a) in
//      floating
//     a --- b       point too. So no ray passes between the two. Source: Kensler and Shirley, "Optimizing
//                   ray-triangle intersection via automated search", 2006.
std::optional<Hit> hit(const Ray& ray, const std::array<Vec3d, 3>& corners) {
  const Vec3d a = corners[0] - ray.origin, b = corners[1] - ray.origin, c = corners[2] - ray.origin;
  const double of_a = dot(ray.direction, cross(b, c)), of_b = dot(ray.direction, cross(c, a)),
               of_c = dot(ray.direction, cross(a, b));
  const bool inside = (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
  const double sum = of_a + of_b + of_c;
  if (!inside || sum == 0) return std::nullopt;
  const Vec3d point = (of_a / sum) * a + (of_b / sum) * b + (of_c / sum) * c;
  const double distance = dot(point, ray.direction);
  if (distance < 0) return std::nullopt;
  return Hit{point, distance};
}

}  // namespace

Ray pick_ray(const Camera& camera, double aspect, double x, double y) {
  const Basis basis = basis_of(camera);
  const double t = half_height(camera);
  const Vec3d direction = x * aspect * t * basis.right + y * t * basis.up - basis.back;
  return {camera.eye, direction / length(direction)};
}

Projected project(const Camera& camera, double aspect, const Vec3d& point) {
  const Basis basis = basis_of(camera);
  const Vec3d p = point - camera.eye;
  const double depth = -dot(p, basis.back);
  const double half = depth * half_height(camera);
  return {dot(p, basis.right) / (half * aspect), dot(p, basis.up) / half, depth};
}

std::optional<PickedNode> pick_node(const Ray& ray, std::span<const Vec4f> positions,
                                    std::span<const mesh::Triangle> triangles) {
  std::optional<PickedNode> nearest;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = positions[triangles[t][i]].xyz().to<double>();
    const std::optional<Hit> found = hit(ray, corners);
    if (!found || (nearest && found->distance >= nearest->distance)) continue;
    nearest = PickedNode{triangles[t][0], t, ray.origin + found->point, found->distance};
    double reach = length(corners[0] - nearest->point);
    for (std::size_t i = 1; i < 3; ++i)
      if (const double other = length(corners[i] - nearest->point); other < reach) {
        reach = other;
        nearest->node = triangles[t][i];
      }
  }
  return nearest;
}

}  // namespace weft::render
