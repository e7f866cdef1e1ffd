#include "render/object_mesh.hpp"

#include <cmath>

#include "mesh/primitives.hpp"
#include "mesh/sheet_rim.hpp"

namespace weft::render {
namespace {

constexpr int kColumns = 96, kRows = 48;  // of a sphere; a capsule's ends are its halves

struct Part {
  ObjectDraw draw;
  bool closed = false;
  bool moves = draw.motion.has_value() || draw.rigid.has_value() || !draw.deformation.empty();
};

mesh::TriangleMesh placed(mesh::TriangleMesh mesh, const scene::ColliderSphere& sphere) {
  for (Vec3f& p : mesh.positions) p = (sphere.center + sphere.radius * p.to<double>()).to<float>();
  return mesh;
}

mesh::TriangleMesh mesh_of(const scene::ColliderCapsule& capsule) {
  const Vec3d span = capsule.b - capsule.a, middle = 0.5 * (capsule.a + capsule.b);
  const double size = length(span);
  mesh::TriangleMesh mesh = mesh::make_capsule(size, capsule.radius, kColumns, kRows / 2);
  const Vec3d y = span / size, helper = std::abs(y.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
  const Vec3d z = cross(helper, y) / length(cross(helper, y)), x = cross(y, z);
  for (Vec3f& p : mesh.positions) {
    const Vec3d q = p.to<double>();
    p = (middle + q.x * x + q.y * y + q.z * z).to<float>();
  }
  return mesh;
}

/// No two triangles share a vertex, so that the edges are sharp.
mesh::TriangleMesh sharp(const mesh::TriangleMesh& shared) {
  mesh::TriangleMesh mesh;
  for (const mesh::Triangle& triangle : shared.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const std::uint32_t vertex : triangle) mesh.positions.push_back(shared.positions[vertex]);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

mesh::TriangleMesh mesh_of(const scene::ColliderBox& box) {
  return sharp(mesh::transformed(mesh::make_box(box.size), 1, box.rotate, box.center));
}

/// In all of its shapes.
bool stays_closed(const ObjectDraw& object) {
  bool closed = is_closed(object.mesh);
  for (const std::vector<Vec3f>& shape : object.deformation.shapes)
    closed = closed && mesh::signed_volume({shape, object.mesh.triangles}) > 0;
  return closed;
}

std::vector<Part> parts_of(const Inputs& inputs) {
  std::vector<Part> parts;
  const auto rigid = [&](const auto& shape, const std::vector<std::size_t>& colliders, std::size_t k) {
    return shape.rigid && inputs.rigid.words != nullptr ? std::optional(colliders[k]) : std::nullopt;
  };
  const auto given = [&](const auto& shape, const std::vector<std::size_t>& colliders, std::size_t k) {
    const bool moved = inputs.colliders != nullptr && shape.motion &&
                       std::holds_alternative<scene::MotionCarried>(*shape.motion);
    return moved ? std::optional(colliders[k]) : std::nullopt;
  };
  if (!inputs.spheres.empty()) {
    const mesh::TriangleMesh unit = mesh::make_sphere(kColumns, kRows);
    for (std::size_t k = 0; k < inputs.spheres.size(); ++k) {
      const scene::ColliderSphere& sphere = inputs.spheres[k];
      parts.push_back({{placed(unit, sphere),
                        {},
                        sphere.motion,
                        rigid(sphere, inputs.sphere_colliders, k),
                        given(sphere, inputs.sphere_colliders, k),
                        sphere.material},
                       true});
    }
  }
  for (std::size_t k = 0; k < inputs.capsules.size(); ++k) {
    const scene::ColliderCapsule& capsule = inputs.capsules[k];
    parts.push_back({{mesh_of(capsule),
                      {},
                      capsule.motion,
                      rigid(capsule, inputs.capsule_colliders, k),
                      given(capsule, inputs.capsule_colliders, k),
                      capsule.material},
                     true});
  }
  for (std::size_t k = 0; k < inputs.boxes.size(); ++k) {
    const scene::ColliderBox& box = inputs.boxes[k];
    parts.push_back({{mesh_of(box),
                      {},
                      box.motion,
                      rigid(box, inputs.box_colliders, k),
                      given(box, inputs.box_colliders, k),
                      box.material},
                     true});
  }
  for (const ObjectDraw& hull : inputs.hulls)
    parts.push_back({{sharp(hull.mesh), {}, hull.motion, hull.rigid, hull.given, hull.material}, true});
  for (const ObjectDraw& object : inputs.objects) parts.push_back({object, stays_closed(object)});
  return parts;
}

void append(const mesh::TriangleMesh& mesh, float w, scene::Material material, ObjectMesh& all) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  for (const Vec3f& position : mesh.positions) all.positions.push_back(Vec4f::from(position, w));
  for (const Vec3f& normal : vertex_normals(mesh))
    all.normals.push_back(Vec4f::from(normal, static_cast<float>(material)));
  for (const mesh::Triangle& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) all.indices.push_back(first + vertex);
}

}  // namespace

void write_vertex_normals(const mesh::TriangleMesh& mesh, std::vector<Vec3d>& sums, std::span<Vec4f> normals,
                          scene::Material material) {
  sums.assign(mesh.positions.size(), {});
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d pa = mesh.positions[a].to<double>();
    const Vec3d n = cross(mesh.positions[b].to<double>() - pa, mesh.positions[c].to<double>() - pa);
    for (const std::uint32_t vertex : {a, b, c}) sums[vertex] += n;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double size = length(sums[i]);
    normals[i] =
        Vec4f::from(size > 0 ? (sums[i] / size).to<float>() : Vec3f{0, 1, 0}, static_cast<float>(material));
  }
}

std::vector<Vec3f> vertex_normals(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> sums;
  std::vector<Vec4f> wide(mesh.positions.size());
  write_vertex_normals(mesh, sums, wide);
  std::vector<Vec3f> normals;
  for (const Vec4f& normal : wide) normals.push_back(normal.xyz());
  return normals;
}

bool is_closed(const mesh::TriangleMesh& mesh) {
  std::vector<Vec3d> positions;
  for (const Vec3f& p : mesh.positions) positions.push_back(p.to<double>());
  return faces_outward(positions, mesh.triangles);
}

ObjectMesh join_objects(const Inputs& inputs) {
  std::vector<Part> parts = parts_of(inputs);
  ObjectMesh all;
  for (ObjectGroup& group : all.groups) {
    group.first_index = static_cast<std::uint32_t>(all.indices.size());
    for (Part& part : parts) {
      if (part.moves != group.moves || part.closed != group.closed) continue;
      const std::size_t first_vertex = all.positions.size();
      append(part.draw.mesh, static_cast<float>(all.moving.size()), part.draw.material, all);
      if (group.moves) all.moving.push_back({first_vertex, std::move(part.draw)});
    }
    group.index_count = static_cast<std::uint32_t>(all.indices.size()) - group.first_index;
  }
  return all;
}

}  // namespace weft::render
