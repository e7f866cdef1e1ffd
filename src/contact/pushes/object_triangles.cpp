#include "contact/pushes/object_triangles.hpp"

#include <cmath>

namespace weft::contact {

Box box_of(const ObjectTriangle& t) {
  return {min(min(t.a.xyz(), t.b.xyz()), t.c.xyz()), max(max(t.a.xyz(), t.b.xyz()), t.c.xyz())};
}

Box united(const Box& a, const Box& b) { return {min(a.low, b.low), max(a.high, b.high)}; }

Result<std::vector<ObjectTriangle>> object_triangles(std::span<const mesh::TriangleMesh> objects) {
  std::vector<ObjectTriangle> triangles;
  for (std::size_t object = 0; object < objects.size(); ++object) {
    const mesh::TriangleMesh& mesh = objects[object];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const mesh::Triangle& corners = mesh.triangles[i];
      const Vec3f a = mesh.positions[corners[0]], b = mesh.positions[corners[1]],
                  c = mesh.positions[corners[2]];
      // In double: differences of f32 and their products neither overflow nor vanish.
      const Vec3d normal = cross(b.to<double>() - a.to<double>(), c.to<double>() - a.to<double>());
      const double area = length(normal);
      if (!std::isfinite(area))
        return input_error("Triangle %zu of collider mesh %zu has a coordinate that is not finite.", i,
                           object);
      if (area == 0) return input_error("Triangle %zu of collider mesh %zu has no area.", i, object);
      const Vec3f n = (normal / area).to<float>();
      triangles.push_back({Vec4f::from(a, n.x), Vec4f::from(b, n.y), Vec4f::from(c, n.z)});
    }
  }
  return triangles;
}

}  // namespace weft::contact
