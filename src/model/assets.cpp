#include "model/assets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/json.hpp"
#include "mesh/convex_hull.hpp"
#include "mesh/fill_surface.hpp"
#include "mesh/merge.hpp"
#include "mesh/primitives.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/read_tet_mesh.hpp"
#include "scene/load.hpp"

namespace weft {
namespace {

/// How far the end of an animation that loops may be from its beginning, by the size of its mesh.
constexpr double kLoopsWithin = 1e-3;

/// The meshes that a scene names. One that several cloths, colliders or keyframes name is read once, and kept
/// until the last of them.
class NamedMeshes {
 public:
  NamedMeshes(const scene::Scene& scene, const MeshReader& read) : read_(read) {
    for (const scene::Cloth& cloth : scene.cloths) {
      if (!cloth.mesh.empty()) ++meshes_[cloth.mesh].uses;
      for (const scene::Panel& panel : cloth.panels)
        if (!panel.grid) ++meshes_[panel.mesh].uses;
      if (cloth.solid && cloth.copy == 0 && !cloth.solid->surface.empty())
        ++meshes_[cloth.solid->surface].uses;
    }
    for (const scene::Collider& collider : scene.colliders)
      if (const auto* object = std::get_if<scene::ColliderMesh>(&collider); object && !object->animation) {
        ++meshes_[object->mesh].uses;
        for (const scene::ColliderKeyframe& keyframe : object->keyframes) ++meshes_[keyframe.mesh].uses;
      } else if (const auto* convex = std::get_if<scene::ColliderConvex>(&collider);
                 convex && convex->points.empty()) {
        ++meshes_[convex->mesh].uses;
      }
  }

  /// For one of its uses. Errors  those of the reader.
  Result<mesh::TriangleMesh> take(const std::string& name) {
    Named& named = meshes_[name];
    if (!named.mesh) {
      WEFT_TRY(mesh, read_(name));
      named.mesh = std::move(mesh);
    }
    if (--named.uses > 0) return *named.mesh;
    mesh::TriangleMesh last = std::move(*named.mesh);
    named.mesh.reset();
    return last;
  }

 private:
  struct Named {
    std::size_t uses = 0;  // that are still to come
    std::optional<mesh::TriangleMesh> mesh;
  };

  const MeshReader& read_;
  std::map<std::string, Named> meshes_;
};

Result<mesh::TriangleMesh> load_placed(NamedMeshes& meshes, const std::string& name,
                                       const scene::Transform& transform, const std::string& where) {
  auto loaded = meshes.take(name);
  if (!loaded) return loaded.error().while_doing("loading " + where);
  mesh::TriangleMesh placed =
      mesh::transformed(*loaded, transform.scale, transform.rotate, transform.translate);
  if (auto checked = mesh::check_mesh(placed); !checked)
    return checked.error().while_doing("placing " + where);
  return placed;
}

mesh::TriangleMesh placed_grid(const scene::GridShape& grid, const scene::Transform& transform) {
  mesh::TriangleMesh placed;
  for (const Vec3d& place : scene::grid_positions(grid, transform))
    placed.positions.push_back(place.to<float>());
  placed.triangles = mesh::grid_triangles({grid.nx, grid.ny, grid.width, grid.height});
  return placed;
}

/// The panels of a cloth as one mesh. `sizes` gets how many nodes each has.
Result<mesh::TriangleMesh> load_panels(NamedMeshes& meshes, const scene::Cloth& cloth,
                                       std::vector<std::uint32_t>& sizes) {
  mesh::TriangleMesh all;
  for (std::size_t p = 0; p < cloth.panels.size(); ++p) {
    const scene::Panel& panel = cloth.panels[p];
    const std::string where = path_of_index(cloth.where + ".panels", p);
    mesh::TriangleMesh one;
    if (panel.grid) {
      one = placed_grid(*panel.grid, panel.transform);
    } else {
      WEFT_SET(one, load_placed(meshes, panel.mesh, panel.transform, where));
    }
    sizes.push_back(static_cast<std::uint32_t>(one.positions.size()));
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), one.positions.begin(), one.positions.end());
    for (const mesh::Triangle& t : one.triangles)
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const auto& [scale, rotate, translate] = cloth.transform;
  mesh::TriangleMesh placed = mesh::transformed(all, scale, rotate, translate);
  if (auto checked = mesh::check_mesh(placed); !checked)
    return checked.error().while_doing("placing " + cloth.where);
  return placed;
}

/// The tetrahedra of a body that is no block, before its transform.
Result<mesh::TetMesh> load_solid(const scene::Cloth& body, NamedMeshes& meshes, const TetReader& read) {
  const scene::Solid& solid = *body.solid;
  if (solid.surface.empty()) {
    if (!mesh::names_tet_mesh(solid.tetrahedra))
      return input_error("%s.tetrahedra is \"%s\", whose name does not end in .msh, .vtk or .ele.",
                         body.where.c_str(), solid.tetrahedra.c_str());
    auto tets = read(solid.tetrahedra);
    if (!tets) return tets.error().while_doing("loading " + body.where);
    return tets;
  }
  auto surface = meshes.take(solid.surface);
  if (!surface) return surface.error().while_doing("loading " + body.where);
  auto tets = mesh::fill_surface(*surface, solid.cell / body.transform.scale);
  if (!tets)
    return tets.error().while_doing("filling mesh " + solid.surface).while_doing("loading " + body.where);
  return tets;
}

/// An object as it is at time 0, and the shapes of its animation.
struct AnimatedObject {
  mesh::TriangleMesh object;
  mesh::Deformation deformation;
};

/// Takes an animation of a collider's file as shapes.
class Animating {
 public:
  Animating(const scene::ColliderMesh& collider, const mesh::AnimatedMesh& file,
            const mesh::GltfAnimation& animation)
      : collider_(collider), wanted_(*collider.animation), file_(file), animation_(animation) {}

  /// `vertices` has how many all animations of the scene have so far, with their nodes and joints.
  Result<AnimatedObject> run(std::size_t& vertices) const {
    const double end = animation_.duration;
    // Times of a file are rounded to f32.
    if (wanted_.start > end * (1 + kRoundedTime))
      return input_error("%s.animation.start is %g s, after the animation's end at %g s.",
                         collider_.where.c_str(), wanted_.start, end);
    const double start = std::min(wanted_.start, end);
    const bool loops = wanted_.loop && end > 0;
    if (loops) WEFT_CHECK(check_loop());
    const double lasts = (loops ? end : end - start) / wanted_.speed;
    const double count = lasts > 0 ? std::max(1.0, std::ceil(lasts * wanted_.rate * (1 - kRoundedTime))) : 0;
    WEFT_CHECK(check_size(count, vertices));
    AnimatedObject made;
    WEFT_TRY(first, file_.posed(animation_, start));
    first.positions = placed(std::move(first.positions));
    WEFT_CHECK(check_placed(first));
    made.object = std::move(first);
    made.deformation.times.loops = loops;
    for (double k = 1; k <= count; ++k) {
      const double time = lasts * k / count, at = start + wanted_.speed * time;
      made.deformation.times.times.push_back(time);
      if (loops && k == count) {  // to the bit where it began
        made.deformation.shapes.push_back(made.object.positions);
        continue;
      }
      WEFT_TRY(shape, file_.places(animation_, k == count ? end : loops ? std::fmod(at, end) : at));
      made.deformation.shapes.push_back(placed(std::move(shape)));
      WEFT_CHECK(check_placed({made.deformation.shapes.back(), made.object.triangles}));
    }
    return made;
  }

 private:
  static constexpr double kRoundedTime = 1e-6;

  std::vector<Vec3f> placed(std::vector<Vec3f> positions) const {
    const scene::Transform& transform = collider_.transform;
    return mesh::transformed({std::move(positions), {}}, transform.scale, transform.rotate,
                             transform.translate)
        .positions;
  }
  Result<void> check_placed(const mesh::TriangleMesh& mesh) const {
    if (auto checked = mesh::check_mesh(mesh); !checked)
      return checked.error().while_doing("placing " + collider_.where);
    return {};
  }

  /// Refuses an animation that does not end as it begins.
  Result<void> check_loop() const {
    WEFT_TRY(from, file_.places(animation_, 0));
    WEFT_TRY(to, file_.places(animation_, animation_.duration));
    const std::vector<Vec3f> begin = placed(std::move(from)), end = placed(std::move(to));
    const mesh::Bounds box = mesh::bounds({begin, {}});
    double most = 0;
    for (std::size_t v = 0; v < begin.size(); ++v)
      most = std::max(most, static_cast<double>(length(end[v] - begin[v])));
    if (most <= kLoopsWithin * static_cast<double>(length(box.high - box.low))) return {};
    return input_error(
        "%s.animation ends with a vertex %.3g m from where it begins; it can be run with \"loop\": false.",
        collider_.where.c_str(), most);
  }

  Result<void> check_size(double count, std::size_t& vertices) const {
    const double all = static_cast<double>(vertices) + count * static_cast<double>(file_.size());
    const auto most = static_cast<double>(mesh::kMostShapeVertices);
    if (all > most)
      return make_error(
          ErrorKind::Limit,
          "%s.animation takes %.0f shapes, which brings those of the scene to %.0f vertices, nodes and "
          "joints, more than %.0f; a lower rate takes fewer.",
          collider_.where.c_str(), count, all, most);
    vertices = static_cast<std::size_t>(all);
    return {};
  }

  const scene::ColliderMesh& collider_;
  const scene::ColliderAnimation& wanted_;
  const mesh::AnimatedMesh& file_;
  const mesh::GltfAnimation& animation_;
};

Result<AnimatedObject> load_animated(const AnimationReader& read, const scene::ColliderMesh& collider,
                                     std::size_t& vertices) {
  const auto doing = "loading " + collider.where;
  const auto file = read(collider.mesh);
  if (!file) return file.error().while_doing(doing);
  const auto animation = file->animation(collider.animation->name);
  if (!animation) return animation.error().while_doing(doing);
  return Animating(collider, *file, **animation).run(vertices);
}

/// A keyframe of an object that has all its triangles still.
Result<mesh::TriangleMesh> load_keyframe(NamedMeshes& meshes, const scene::ColliderMesh& collider,
                                         std::size_t number, const mesh::TriangleMesh& object) {
  const std::string where = path_of_index(collider.where + ".keyframes", number);
  const std::string& name = collider.keyframes[number].mesh;
  WEFT_TRY(placed, load_placed(meshes, name, collider.transform, where));
  if (placed.positions.size() != object.positions.size())
    return input_error("%s: mesh %s has %zu vertices, but %s has %zu; a keyframe moves the same ones.",
                       where.c_str(), name.c_str(), placed.positions.size(), collider.mesh.c_str(),
                       object.positions.size());
  if (placed.triangles != object.triangles)
    return input_error("%s: mesh %s has other triangles than %s; a keyframe moves the same ones.",
                       where.c_str(), name.c_str(), collider.mesh.c_str());
  return placed;
}

/// Adds an object that has all its triangles still, and how it deforms.
/// Errors  Input: no triangle has an area.
Result<void> add_object(Assets& assets, std::size_t collider, mesh::TriangleMesh object,
                        mesh::Deformation deformation, const std::string& name) {
  assets.dropped_triangles += mesh::drop_degenerate_triangles(object, deformation.shapes);
  if (object.triangles.empty()) return input_error("%s has no triangle with an area.", name.c_str());
  // Between triangles that only lie side by side are rims, on which cloth catches.
  assets.merged_vertices += mesh::merge_vertices(object, deformation.shapes);
  assets.objects.push_back(std::move(object));
  assets.object_colliders.push_back(collider);
  assets.deformations.push_back(std::move(deformation));
  return {};
}

/// The hull of what is placed in the world, so that it is convex there to the bit.
Result<mesh::TriangleMesh> load_convex(NamedMeshes& meshes, const scene::ColliderConvex& collider) {
  std::vector<Vec3f> points;
  for (const Vec3d& point : collider.points)
    points.push_back(scene::transformed(collider.transform, point).to<float>());
  if (points.empty()) {
    WEFT_TRY(placed, load_placed(meshes, collider.mesh, collider.transform, collider.where));
    points = std::move(placed.positions);
  }
  auto hull = mesh::convex_hull(points);
  if (!hull) return hull.error().while_doing("taking the hull of " + collider.where);
  return hull;
}

}  // namespace

Result<mesh::AnimatedMesh> no_animation(const std::string& name) {
  return input_error("Mesh %s has no animation.", name.c_str());
}

Result<mesh::TetMesh> no_tetrahedra(const std::string& name) {
  return input_error("Mesh %s has no tetrahedra.", name.c_str());
}

Result<Assets> load_assets(const scene::Scene& scene, const std::string& models_folder) {
  const auto read = [&](const std::string& name) -> Result<mesh::TriangleMesh> {
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_mesh(path);
  };
  const auto read_animated = [&](const std::string& name) -> Result<mesh::AnimatedMesh> {
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_animated_mesh(path);
  };
  const auto read_tets = [&](const std::string& name) -> Result<mesh::TetMesh> {
    WEFT_TRY(path, scene::mesh_path(scene, name, models_folder));
    return mesh::read_tet_mesh(path);
  };
  return load_assets(scene, read, read_animated, read_tets);
}

Result<Assets> load_assets(const scene::Scene& scene, const MeshReader& read,
                           const AnimationReader& read_animated, const TetReader& read_tets) {
  Assets assets;
  std::size_t animated_vertices = 0;
  NamedMeshes meshes(scene, read);
  for (const scene::Cloth& cloth : scene.cloths) {
    if (cloth.solid && cloth.copy > 0) {
      assets.solids.push_back(mesh::TetMesh(assets.solids.back()));  // a copy is as the one before it
    } else if (cloth.solid && !cloth.solid->block) {
      WEFT_TRY(solid, load_solid(cloth, meshes, read_tets));
      assets.solids.push_back(std::move(solid));
    } else {
      assets.solids.emplace_back();
    }
    mesh::TriangleMesh placed;
    std::vector<std::uint32_t> panels;
    if (!cloth.panels.empty()) {
      WEFT_SET(placed, load_panels(meshes, cloth, panels));
    } else if (!cloth.mesh.empty()) {
      WEFT_TRY(loaded, load_placed(meshes, cloth.mesh, cloth.transform, cloth.where));
      placed = std::move(loaded);
    }
    assets.cloths.push_back(std::move(placed));
    assets.panels.push_back(std::move(panels));
  }
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    const auto* object = std::get_if<scene::ColliderMesh>(&scene.colliders[c]);
    if (object != nullptr && object->animation) {
      WEFT_TRY(animated, load_animated(read_animated, *object, animated_vertices));
      WEFT_CHECK(add_object(assets, c, std::move(animated.object), std::move(animated.deformation),
                            object->where + ": mesh " + object->mesh));
    } else if (object != nullptr) {
      WEFT_TRY(placed, load_placed(meshes, object->mesh, object->transform, object->where));
      mesh::Deformation deformation;
      for (std::size_t k = 0; k < object->keyframes.size(); ++k) {
        WEFT_TRY(keyframe, load_keyframe(meshes, *object, k, placed));
        deformation.times.times.push_back(object->keyframes[k].time);
        deformation.shapes.push_back(std::move(keyframe.positions));
      }
      WEFT_CHECK(add_object(assets, c, std::move(placed), std::move(deformation),
                            object->where + ": mesh " + object->mesh));
    } else if (const auto* box = std::get_if<scene::ColliderBox>(&scene.colliders[c])) {
      WEFT_CHECK(add_object(assets, c,
                            mesh::transformed(mesh::make_box(box->size), 1, box->rotate, box->center), {},
                            scene.file + ": " + path_of_index("colliders", c) + ", a box,"));
    } else if (const auto* convex = std::get_if<scene::ColliderConvex>(&scene.colliders[c])) {
      WEFT_TRY(hull, load_convex(meshes, *convex));
      WEFT_CHECK(add_object(assets, c, std::move(hull), {}, convex->where + ": the hull"));
    }
  }
  return assets;
}

namespace {

/// Of one cloth or body. A scene of grids and blocks may come without a mesh for each.
std::uint64_t nodes_of(const scene::Scene& scene, const Assets& assets, std::size_t cloth) {
  if (const auto& solid = scene.cloths[cloth].solid) {
    if (!solid->block) return cloth < assets.solids.size() ? assets.solids[cloth].positions.size() : 0;
    std::uint64_t nodes = 1;
    for (const std::uint32_t cells : solid->block->cells) nodes *= std::uint64_t{cells} + 1;
    return nodes;
  }
  const auto& grid = scene.cloths[cloth].grid;
  if (grid) return std::uint64_t{grid->nx} * grid->ny;
  return cloth < assets.cloths.size() ? assets.cloths[cloth].positions.size() : 0;
}

}  // namespace

std::uint64_t node_count(const scene::Scene& scene, const Assets& assets) {
  std::uint64_t nodes = 0;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) nodes += nodes_of(scene, assets, c);
  return nodes;
}

Result<void> check_memory(const scene::Scene& scene, const Assets& assets, std::uint64_t bytes_per_node,
                          std::uint64_t limit, const char* whose) {
  const std::uint64_t nodes = node_count(scene, assets);
  std::uint64_t bytes = nodes * bytes_per_node;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c)
    if (scene.cloths[c].solid) bytes += nodes_of(scene, assets, c) * kSolidBytesPerNode;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c)
    if (scene.cloths[c].fabric) bytes += nodes_of(scene, assets, c) * kFabricBytesPerNode;
  if (bytes <= limit) return {};
  return make_error(ErrorKind::Limit,
                    "A cloth of %llu nodes needs about %llu bytes of %s memory, more than its limit of %llu.",
                    static_cast<unsigned long long>(nodes), static_cast<unsigned long long>(bytes), whose,
                    static_cast<unsigned long long>(limit));
}

}  // namespace weft
