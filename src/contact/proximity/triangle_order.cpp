#include "contact/proximity/triangle_order.hpp"

#include "mesh/morton_order.hpp"

namespace weft::contact {
namespace {

void append_sorted(std::span<const Vec3d> centres, std::uint32_t first, std::vector<std::uint32_t>& order) {
  for (const std::uint32_t t : mesh::morton_order(centres)) order.push_back(first + t);
}

}  // namespace

std::vector<std::uint32_t> cloth_order(const Model& model) {
  std::vector<std::uint32_t> order;
  for (const Body& body : model.bodies) {
    std::vector<Vec3d> centres;
    for (std::uint32_t t = 0; t < body.triangle_count; ++t) {
      Vec3d centre;
      for (const std::uint32_t vertex : model.triangles[body.first_triangle + t])
        centre += Vec3d{model.uv[vertex][0], model.uv[vertex][1], 0};
      centres.push_back(centre);
    }
    append_sorted(centres, body.first_triangle, order);
  }
  return order;
}

std::vector<std::uint32_t> mesh_order(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> centres;
  for (const mesh::Triangle& t : mesh.triangles) {
    Vec3d centre;
    for (const std::uint32_t vertex : t) centre += mesh.positions[vertex].to<double>();
    centres.push_back(centre);
  }
  std::vector<std::uint32_t> order;
  append_sorted(centres, 0, order);
  return order;
}

}  // namespace weft::contact
