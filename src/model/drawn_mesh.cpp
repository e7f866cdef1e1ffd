#include "model/drawn_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "mesh/subdivided_grid.hpp"

namespace weft {
namespace {

using SheetPlace = std::array<float, 2>;  // [m]

/// Places on a sheet as texture coordinates. On a grid the second one counts from its top, which a picture has above.
void append_texture(std::vector<std::array<float, 2>>& texture, std::span<const SheetPlace> places,
                    bool from_top) {
  float width = 0, height = 0;
  for (const auto& [x, y] : places) {
    width = std::max(width, x);
    height = std::max(height, y);
  }
  const float side = std::max(width, height);
  if (!(side > 0)) {
    texture.resize(texture.size() + places.size());
    return;
  }
  for (const auto& [x, y] : places) texture.push_back({x / side, (from_top ? height - y : y) / side});
}

std::vector<SheetPlace> places_of(const mesh::Grid& grid) {
  std::vector<SheetPlace> places;
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const mesh::RestPoint point = mesh::rest_point(grid, i, j);
      places.push_back({static_cast<float>(point.x), static_cast<float>(point.y)});
    }
  return places;
}

double linear(double encoded) {  // IEC 61966-2-1
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

DrawnMesh drawn_mesh(const Model& model, std::span<const Vec4f> positions, std::uint32_t level) {
  DrawnMesh drawn;
  mesh::TriangleMesh& shape = drawn.shape;
  if (level == 0) {
    for (const Vec4f& position : positions) shape.positions.push_back(position.xyz());
    shape.triangles = model.triangles;
  }
  for (const Body& body : model.bodies) {
    const std::span<const SheetPlace> places =
        std::span(model.uv).subspan(body.first_vertex, body.vertex_count);
    if (level == 0) {
      append_texture(drawn.attributes.texture, places, body.grid.has_value());
      continue;
    }
    assert(body.grid);
    const mesh::Grid fine = mesh::subdivided(*body.grid, level);
    append_texture(drawn.attributes.texture, places_of(fine), true);
    std::vector<Vec3d> nodes;
    for (const Vec4f& position : positions.subspan(body.first_vertex, body.vertex_count))
      nodes.push_back(position.xyz().to<double>());
    const auto first = static_cast<std::uint32_t>(shape.positions.size());
    for (const Vec3d& vertex : mesh::upsample(*body.grid, nodes, level))
      shape.positions.push_back(vertex.to<float>());
    for (const mesh::Triangle& t : mesh::grid_triangles(fine))
      shape.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  drawn.attributes.normals = mesh::smooth_normals(shape);
  return drawn;
}

std::vector<mesh::MeshPart> drawn_parts(const Model& model, std::uint32_t level) {
  std::vector<mesh::MeshPart> parts;
  for (const Body& body : model.bodies) {
    mesh::MeshPart part{"", body.vertex_count, body.triangle_count, {}};
    if (level > 0) {
      const mesh::Grid fine = mesh::subdivided(*body.grid, level);
      part.vertices = fine.nx * fine.ny;
      part.triangles = 2 * (fine.nx - 1) * (fine.ny - 1);
    }
    if (body.color) part.color = {linear(body.color->x), linear(body.color->y), linear(body.color->z)};
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace weft
