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
                     std::span<const std::vector<mesh::TriangleMesh>> keyframes) {
  // Meshes first: the edges of features are those of triangles, then capsules.
  std::vector<Vec3d> positions;
  std::vector<mesh::Triangle> triangles;
  std::size_t object = 0;
  for (std::uint32_t c = 0; c < scene.colliders.size(); ++c) {
    const scene::Collider& collider = scene.colliders[c];
    frictions_.push_back(scene::friction_of(collider));
    motions_.push_back(scene::motion_of(collider));
    if (motions_.back()) still_ = false;
    const auto* deforming = std::get_if<scene::ColliderMesh>(&collider);
    if (!deforming && !std::holds_alternative<scene::ColliderBox>(collider)) continue;
    const mesh::TriangleMesh& mesh = objects[object];
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3d& p : widened(mesh.positions)) positions.push_back(p);
    for (mesh::Triangle triangle : mesh.triangles) {
      for (std::uint32_t& vertex : triangle) vertex += first;
      triangles.push_back(triangle);
    }
    collider_of_vertex_.resize(positions.size(), c);
    curvatures_.resize(positions.size());
    if (deforming && object < keyframes.size() && !keyframes[object].empty()) {
      Keyframes frames{first, {}, {}};
      for (std::size_t k = 0; k < keyframes[object].size(); ++k) {
        frames.times.push_back(deforming->keyframes[k].time);
        frames.shapes.push_back(widened(keyframes[object][k].positions));
      }
      keyframes_.push_back(std::move(frames));
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

void Obstacles::deform(const Keyframes& keyframes, double time, std::vector<Vec3d>& positions) const {
  const auto next = static_cast<std::size_t>(
      std::upper_bound(keyframes.times.begin(), keyframes.times.end(), time) - keyframes.times.begin());
  const bool last = next == keyframes.times.size();
  const double from = next == 0 ? 0 : keyframes.times[next - 1];
  const double part = last ? 0 : std::max(0.0, (time - from) / (keyframes.times[next] - from));
  const std::size_t count = keyframes.shapes[0].size();
  for (std::size_t v = 0; v < count; ++v) {
    Vec3d& p = positions[keyframes.first + v];
    if (next > 0) p = keyframes.shapes[next - 1][v];
    if (!last) p += part * (keyframes.shapes[next][v] - p);
  }
}

Obstacles::Placed Obstacles::at(double time) const {
  Placed placed{{}, features_.positions, planes_};
  for (const Keyframes& keyframes : keyframes_) deform(keyframes, time, placed.positions);
  for (const auto& motion : motions_)
    placed.transforms.push_back(motion ? scene::motion_at(*motion, time) : scene::RigidTransform{});
  for (std::size_t v = 0; v < placed.positions.size(); ++v)
    if (motions_[collider_of_vertex_[v]])
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
