#include "contact/proximity/collider_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/object_tree.hpp"
#include "contact/proximity/feature_owners.hpp"
#include "contact/proximity/triangle_order.hpp"
#include "mesh/curvature.hpp"
#include "mesh/sheet_rim.hpp"
#include "scene/motion.hpp"

namespace weft::contact {
namespace {

constexpr double kNormalUnits = 127;               // as in curved.wgsl
constexpr float kDirection = 0.25F, kSpin = 0.5F;  // of a shape's w, as in move_points.wgsl

std::uint32_t bits(float value) {
  std::uint32_t word = 0;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

class ColliderSetBuilder {
 public:
  ColliderSetBuilder(ColliderSet& set, const scene::Scene& scene, const ColliderMeshes& meshes,
                     std::uint32_t first_word, std::uint32_t first_triangle)
      : set_(set), scene_(scene), meshes_(meshes), first_word_(first_word), first_triangle_(first_triangle) {}

  Result<void> build() {
    if (scene_.colliders.size() > kMostColliders)
      return make_error(ErrorKind::Limit,
                        "The scene has %zu colliders, more than the %u that contact can hold.",
                        scene_.colliders.size(), kMostColliders);
    for (std::size_t c = 0; c < scene_.colliders.size(); ++c) WEFT_CHECK(add(c));
    set_.point_count = static_cast<std::uint32_t>(set_.shapes.size());
    for (DeformingCollider& one : set_.deforming) {
      const auto found =
          std::find(meshes_.object_colliders.begin(), meshes_.object_colliders.end(), one.collider);
      one.first_shape = static_cast<std::uint32_t>(set_.shapes.size());
      for (const std::vector<Vec3f>& shape :
           meshes_.deformations[static_cast<std::size_t>(found - meshes_.object_colliders.begin())].shapes)
        for (const Vec3f& p : shape) set_.shapes.push_back(Vec4f::from(p, 0));
      set_.moves = true;
    }
    if (set_.shapes.size() > mesh::kMostShapeVertices)
      return make_error(
          ErrorKind::Limit,
          "The shapes of the colliders have %zu vertices in all, more than the %zu that contact can "
          "number.",
          set_.shapes.size(), mesh::kMostShapeVertices);
    for (const Vec4f& end : ends_) set_.points.push_back(end);
    shapes_.resize(2 * ends_.size());
    for (std::size_t k = 0; k < ends_.size(); ++k) shapes_[2 * k + 1].w = std::floor(set_.shapes[k].w);
    for (const Vec4f& word : shapes_) set_.points.push_back(word);
    for (std::size_t c = 0; c < scene_.colliders.size(); ++c) {
      set_.points.push_back({1, 0, 0, 0});
      set_.points.push_back({0, 1, 0, 0});
      set_.points.push_back({0, 0, 1, 0});
      set_.points.push_back({});
    }
    return {};
  }

 private:
  Result<void> add(std::size_t c) {
    const scene::Collider& collider = scene_.colliders[c];
    if (scene::motion_of(collider) || scene::rigid_of(collider) != nullptr) set_.moves = true;
    const auto number = static_cast<std::uint32_t>(c);
    const auto first = static_cast<std::uint32_t>(set_.points.size());
    const auto& friction = scene::friction_of(collider);
    friction_ = friction ? static_cast<float>(*friction) : -1.0F;
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      add_point(c, sphere->center, sphere->radius);
      add_point(c, {}, 0, kSpin);
      set_.list.push_back({static_cast<std::uint32_t>(ColliderKind::Sphere), first, 0, number});
    } else if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider)) {
      add_point(c, capsule->a, capsule->radius);
      add_point(c, {}, 0, kSpin);
      add_point(c, capsule->b, capsule->radius);
      add_point(c, {}, 0, kSpin);
      set_.list.push_back({static_cast<std::uint32_t>(ColliderKind::Capsule), first, 0, number});
    } else if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) {
      add_point(c, plane->point, 0);
      add_point(c, plane->normal / length(plane->normal), 0, kDirection);
      add_point(c, {}, 0, kSpin);
      set_.list.push_back({static_cast<std::uint32_t>(ColliderKind::Plane), first, 0, number});
    } else {
      return add_mesh(c, first);
    }
    return {};
  }

  Result<void> add_mesh(std::size_t c, std::uint32_t first_point) {
    const auto found = std::find(meshes_.object_colliders.begin(), meshes_.object_colliders.end(), c);
    const auto o = static_cast<std::size_t>(found - meshes_.object_colliders.begin());
    const mesh::TriangleMesh& mesh = meshes_.objects[o];
    std::vector<Vec3d> places;
    for (const Vec3f& p : mesh.positions) places.push_back(p.to<double>());
    const bool closed = faces_outward(places, mesh.triangles);
    for (const Vec3d& p : places) add_point(c, p, closed ? -1 : 0);
    for (const mesh::Triangle& t : mesh.triangles)
      set_.faces.push_back({first_point + t[0], first_point + t[1], first_point + t[2]});
    set_.rims.resize(first_point, 0);
    for (const double rim : rim_distances(places, mesh.triangles))
      set_.rims.push_back(static_cast<float>(rim));
    if (!meshes_.deformations[o].empty()) {
      set_.deforming.push_back({c, first_point, static_cast<std::uint32_t>(mesh.positions.size()), 0,
                                meshes_.deformations[o].times});
      return add_deforming(mesh, first_point);
    }
    shapes_.resize(2 * std::size_t{first_point});
    for (const mesh::Curvature& at : mesh::vertex_curvatures(places, mesh.triangles)) add_curvature(c, at);
    return add_rigid(c, mesh, first_point);
  }

  void add_curvature(std::size_t c, const mesh::Curvature& at) {
    const Mat3& s = at.shape;
    const auto part = [](double n) {
      return static_cast<std::uint32_t>(std::lround(kNormalUnits * (n + 1)));
    };
    const std::uint32_t normal =
        part(at.normal.x) | part(at.normal.y) << 8U | part(at.normal.z) << 16U;  // f32 has it exactly
    shapes_.push_back(Vec4f::from(Vec3d{s.x.x, s.y.y, s.z.z}.to<float>(), static_cast<float>(normal)));
    shapes_.push_back(Vec4f::from(Vec3d{s.x.y, s.x.z, s.y.z}.to<float>(), static_cast<float>(c)));
  }

  /// A tree by the surface area heuristic, in the mesh's own space; a triangle is three words.
  Result<void> add_rigid(std::size_t c, const mesh::TriangleMesh& mesh, std::uint32_t first_point) {
    WEFT_TRY(triangles, object_triangles(std::span(&mesh, 1)));
    const ObjectTree tree = build_object_tree(triangles);
    if (tree.stack_size > kStackSize)
      return make_error(ErrorKind::Limit,
                        "The tree over %zu triangles needs a stack of %u, more than the kernel's %u.",
                        triangles.size(), tree.stack_size, kStackSize);
    const std::uint32_t nodes = next_word();
    const auto* words = reinterpret_cast<const TreeWord*>(tree.nodes.data());
    set_.trees.insert(set_.trees.end(), words, words + 8 * tree.nodes.size());
    const std::vector<std::uint32_t> owned = feature_owners(mesh.triangles);
    const std::uint32_t first = next_word();
    for (std::size_t t = 0; t < tree.triangles.size(); ++t) {
      const Vec4f* corner[] = {&tree.triangles[t].a, &tree.triangles[t].b, &tree.triangles[t].c};
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t owners = owned[tree.ids[t]] >> k;
        const std::uint32_t id = first_point + mesh.triangles[tree.ids[t]][k];
        set_.trees.push_back({bits(corner[k]->x), bits(corner[k]->y), bits(corner[k]->z),
                              id | (owners & 1U) << 30U | (owners >> 3U & 1U) << 31U});
      }
    }
    set_.list.push_back(
        {static_cast<std::uint32_t>(ColliderKind::Tree), nodes, first, static_cast<std::uint32_t>(c)});
    return {};
  }

  Result<void> add_deforming(const mesh::TriangleMesh& mesh, std::uint32_t first_point) {
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    const ImplicitTree tree(count, next_word());
    const std::vector<TreeWord> words = tree.words();
    set_.trees.insert(set_.trees.end(), words.begin(), words.end());
    const auto first = static_cast<std::uint32_t>(first_triangle_ + set_.triangles.size());
    const std::vector<std::uint32_t> owned = feature_owners(mesh.triangles);
    for (const std::uint32_t t : mesh_order(mesh)) {
      const mesh::Triangle& corner = mesh.triangles[t];
      set_.triangles.push_back(
          {first_point + corner[0], first_point + corner[1], first_point + corner[2], owned[t]});
    }
    set_.implicit.push_back(tree);
    set_.implicit_first.push_back(first);
    set_.implicit_count.push_back(count);
    set_.list.push_back({static_cast<std::uint32_t>(ColliderKind::Implicit), tree.first, first, count});
    return {};
  }

  void add_point(std::size_t c, const Vec3d& place, double radius, float kind = 0) {
    const Vec3f p = place.to<float>();
    set_.shapes.push_back(Vec4f::from(p, static_cast<float>(c) + kind));
    set_.points.push_back(Vec4f::from(p, static_cast<float>(radius)));
    ends_.push_back(Vec4f::from(p, friction_));
  }
  std::uint32_t next_word() const { return static_cast<std::uint32_t>(first_word_ + set_.trees.size()); }

  ColliderSet& set_;
  const scene::Scene& scene_;
  const ColliderMeshes& meshes_;
  std::uint32_t first_word_, first_triangle_;
  std::vector<Vec4f> ends_, shapes_;
  float friction_ = -1;
};

}  // namespace

Result<ColliderSet> ColliderSet::create(const scene::Scene& scene, const ColliderMeshes& meshes,
                                        std::uint32_t first_word, std::uint32_t first_triangle) {
  ColliderSet set;
  WEFT_CHECK(ColliderSetBuilder(set, scene, meshes, first_word, first_triangle).build());
  return set;
}

void place_colliders(const scene::Scene& scene, const ColliderSet& set, double time, double step,
                     std::span<ColliderPlace> places) {
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    ColliderPlace& place = places[c];
    scene::RigidTransform now, then;
    if (const auto& motion = scene::motion_of(scene.colliders[c])) {
      now = scene::motion_at(*motion, time);
      then = scene::motion_at(*motion, time + step);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double* r = &now.rotation[3 * axis];
      place.rows[static_cast<std::size_t>(axis)] = {static_cast<float>(r[0]), static_cast<float>(r[1]),
                                                    static_cast<float>(r[2]),
                                                    static_cast<float>(now.translation[axis])};
    }
    place.spin = Vec4f::from(scene::spin_between(now, then, step).to<float>(), 0);
    place.shape = {};
  }
  for (const DeformingCollider& one : set.deforming) {
    // The kernel adds the point's own number, so shapes are addressed by the place of point 0.
    const auto first_of = [&](std::size_t shape) {
      return shape == 0 ? 0.0F
                        : static_cast<float>(one.first_shape) +
                              static_cast<float>(shape - 1) * static_cast<float>(one.point_count) -
                              static_cast<float>(one.first_point);
    };
    const mesh::ShapeTimes::Moment moment = one.times.at(time);
    places[one.collider].shape = {first_of(moment.from), first_of(moment.to), static_cast<float>(moment.part),
                                  0};
  }
}

}  // namespace weft::contact
