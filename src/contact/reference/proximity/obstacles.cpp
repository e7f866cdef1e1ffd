#include "contact/reference/proximity/obstacles.hpp"

#include <algorithm>

#include "contact/reference/proximity/audit.hpp"

namespace weft::reference {
namespace {

Vec3d turned(const scene::RigidTransform& transform, const Vec3d& direction) {
  return transform(direction) - transform.translation;
}

}  // namespace

Obstacles::Obstacles(const scene::Scene& scene, std::span<const mesh::TriangleMesh> objects,
                     std::span<const mesh::Deformation> deformations) {
  // Meshes first: the edges of features are those of triangles, then capsules.
  std::vector<Vec3d> positions;
  std::vector<mesh::Triangle> triangles;
  std::size_t object = 0;
  for (std::uint32_t c = 0; c < scene.colliders.size(); ++c) {
    const scene::Collider& collider = scene.colliders[c];
    frictions_.push_back(scene::friction_of(collider));
    motions_.push_back(scene::motion_of(collider));
    if (motions_.back() || scene::rigid_of(collider) != nullptr) still_ = false;
    if (!std::holds_alternative<scene::ColliderMesh>(collider) &&
        !std::holds_alternative<scene::ColliderBox>(collider) &&
        !std::holds_alternative<scene::ColliderConvex>(collider))
      continue;
    const mesh::TriangleMesh& mesh = objects[object];
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3d& p : widened(mesh.positions)) positions.push_back(p);
    for (mesh::Triangle triangle : mesh.triangles) {
      for (std::uint32_t& vertex : triangle) vertex += first;
      triangles.push_back(triangle);
    }
    collider_of_vertex_.resize(positions.size(), c);
    curvatures_.resize(positions.size());
    if (object < deformations.size() && !deformations[object].empty()) {
      Deforming one{first, deformations[object].times, {widened(mesh.positions)}};
      for (const std::vector<Vec3f>& shape : deformations[object].shapes)
        one.shapes.push_back(widened(shape));
      deforming_.push_back(std::move(one));
      still_ = false;
    } else {
      const std::vector<mesh::Curvature> own =
          mesh::vertex_curvatures(std::span(positions).subspan(first), mesh.triangles);
      std::copy(own.begin(), own.end(), curvatures_.begin() + first);
    }
    ++object;
  }
  features_ = features_of(std::move(positions), std::move(triangles));
  for (std::uint32_t c = 0; c < scene.colliders.size(); ++c) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&scene.colliders[c]))
      features_.add_sphere(sphere->center, sphere->radius);
    if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&scene.colliders[c]))
      features_.add_capsule(capsule->a, capsule->b, capsule->radius);
    collider_of_vertex_.resize(features_.positions.size(), c);
    curvatures_.resize(features_.positions.size());
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&scene.colliders[c])) {
      planes_.push_back(*plane);
      collider_of_plane_.push_back(c);
    }
  }
}

void Obstacles::deform(const Deforming& deforming, double time, std::vector<Vec3d>& positions) const {
  const mesh::ShapeTimes::Moment moment = deforming.times.at(time);
  const std::vector<Vec3d>&from = deforming.shapes[moment.from], &to = deforming.shapes[moment.to];
  for (std::size_t v = 0; v < from.size(); ++v)
    positions[deforming.first + v] = from[v] + moment.part * (to[v] - from[v]);
}

Obstacles::Placed Obstacles::at(double time,
                                std::span<const std::optional<scene::RigidTransform>> rigid) const {
  Placed placed{{}, features_.positions, planes_};
  for (const Deforming& one : deforming_) deform(one, time, placed.positions);
  const auto is_rigid = [&](std::size_t c) { return c < rigid.size() && rigid[c].has_value(); };
  for (std::size_t c = 0; c < motions_.size(); ++c)
    placed.transforms.push_back(is_rigid(c)   ? *rigid[c]
                                : motions_[c] ? scene::motion_at(*motions_[c], time)
                                              : scene::RigidTransform{});
  for (std::size_t v = 0; v < placed.positions.size(); ++v)
    if (motions_[collider_of_vertex_[v]] || is_rigid(collider_of_vertex_[v]))
      placed.positions[v] = placed.transforms[collider_of_vertex_[v]](placed.positions[v]);
  for (std::size_t p = 0; p < placed.planes.size(); ++p) {
    const scene::RigidTransform& transform = placed.transforms[collider_of_plane_[p]];
    if (!motions_[collider_of_plane_[p]]) continue;
    placed.planes[p].point = transform(placed.planes[p].point);
    placed.planes[p].normal = turned(transform, placed.planes[p].normal);
  }
  return placed;
}

Vec3d carried(const Vec3d& point, const scene::RigidTransform& start, const scene::RigidTransform& end) {
  const Vec3d d = point - start.translation;
  const double* r = start.rotation;  // its transpose is its inverse
  return end(Vec3d{r[0] * d.x + r[3] * d.y + r[6] * d.z, r[1] * d.x + r[4] * d.y + r[7] * d.z,
                   r[2] * d.x + r[5] * d.y + r[8] * d.z});
}

}  // namespace weft::reference
