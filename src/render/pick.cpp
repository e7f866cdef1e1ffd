#include "render/pick.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::render {
namespace {

struct Hit {
  Vec3d weights;        // barycentric
  double distance = 0;  // [m]
};

/// The ray's own axes: corners are seen in them before anything is compared, so that a corner is the same
/// point for every triangle that has it.
struct RayFrame {
  Vec3d origin, right, up, forward;
};

RayFrame frame_of(const Ray& ray) {
  const Vec3d aside = std::abs(ray.direction.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d right = cross(ray.direction, aside) / length(cross(ray.direction, aside));
  return {ray.origin, right, cross(right, ray.direction), ray.direction};
}

/// right, up, forward.
Vec3d seen(const RayFrame& frame, const Vec3d& point) {
  const Vec3d p = point - frame.origin;
  return {dot(p, frame.right), dot(p, frame.up), dot(p, frame.forward)};
}

// Seen along the ray, the three signed areas between the ray and a side have one sign if and only if the ray
// passes through the triangle, and are as its barycentric coordinates. For a side that two triangles share
// they differ in sign only, to the bit, since a b' - a' b and a' b - a b' do in floating point too; and 0
// counts for both. So no ray passes between triangles, nor through a corner.
// Source: Woop, Benthin and Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013.
std::optional<Hit> hit(const std::array<Vec3d, 3>& corners) {
  const auto area = [](const Vec3d& p, const Vec3d& q) { return p.x * q.y - p.y * q.x; };
  const double of_a = area(corners[1], corners[2]), of_b = area(corners[2], corners[0]),
               of_c = area(corners[0], corners[1]);
  const bool inside = (of_a >= 0 && of_b >= 0 && of_c >= 0) || (of_a <= 0 && of_b <= 0 && of_c <= 0);
  const double sum = of_a + of_b + of_c;
  if (!inside || sum == 0) return std::nullopt;
  const double distance = (of_a * corners[0].z + of_b * corners[1].z + of_c * corners[2].z) / sum;
  if (distance < 0) return std::nullopt;
  return Hit{{of_a / sum, of_b / sum, of_c / sum}, distance};
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

std::vector<std::uint32_t> nodes_within(const Camera& camera, double aspect, const PickArea& area,
                                        std::span<const Vec4f> positions) {
  const auto [left, right] = std::minmax({area.ax, area.bx});
  const auto [low, high] = std::minmax({area.ay, area.by});
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < positions.size(); ++node) {
    const Projected at = project(camera, aspect, positions[node].xyz().to<double>());
    if (at.depth > 0 && at.x >= left && at.x <= right && at.y >= low && at.y <= high) nodes.push_back(node);
  }
  return nodes;
}

std::optional<PickedNode> pick_node(const Ray& ray, std::span<const Vec4f> positions,
                                    std::span<const mesh::Triangle> triangles) {
  const RayFrame frame = frame_of(ray);
  std::optional<PickedNode> nearest;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    std::array<Vec3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = positions[triangles[t][i]].xyz().to<double>();
    const std::optional<Hit> found =
        hit({seen(frame, corners[0]), seen(frame, corners[1]), seen(frame, corners[2])});
    if (!found || (nearest && found->distance >= nearest->distance)) continue;
    const Vec3d& w = found->weights;
    nearest = PickedNode{triangles[t][0], t, w.x * corners[0] + w.y * corners[1] + w.z * corners[2],
                         found->distance};
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
