#include "model/attachments.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/closest.hpp"
#include "model/panels.hpp"
#include "model/seams.hpp"
#include "scene/motion.hpp"
#include "scene/select.hpp"

namespace weft {
namespace {

/// The place of a point by a triangle: in its plane and across, by its own edges.
struct Hold {
  mesh::Triangle corners{};
  std::array<double, 3> weights{};
  std::array<double, 3> offset{};  // along the first edge, across it, along the normal [m]
};

std::array<Vec3d, 3> frame_of(const std::array<Vec3d, 3>& corners) {
  const Vec3d edge = corners[1] - corners[0], area = cross(edge, corners[2] - corners[0]);
  const double span = length(edge), size = length(area);
  if (!(span > 0 && size > 0)) return {};  // a shape may make a triangle flat: its point alone counts
  const Vec3d along = edge / span, normal = area / size;
  return {along, cross(normal, along), normal};
}

std::array<Vec3d, 3> corners_of(const mesh::Triangle& triangle, const std::vector<Vec3f>& positions) {
  return {positions[triangle[0]].to<double>(), positions[triangle[1]].to<double>(),
          positions[triangle[2]].to<double>()};
}

Vec3d place_of(const Hold& hold, const std::vector<Vec3f>& positions) {
  const std::array<Vec3d, 3> corners = corners_of(hold.corners, positions), frame = frame_of(corners);
  Vec3d place;
  for (std::size_t k = 0; k < 3; ++k) place += hold.weights[k] * corners[k] + hold.offset[k] * frame[k];
  return place;
}

/// The nearest triangle of a mesh.
struct Nearest {
  Hold hold;
  double distance = HUGE_VAL;  // [m]
};
Nearest nearest(const mesh::TriangleMesh& mesh, const Vec3d& point) {
  Nearest best;
  for (const mesh::Triangle& triangle : mesh.triangles) {
    const std::array<Vec3d, 3> corners = corners_of(triangle, mesh.positions);
    const Vec3d low = min(min(corners[0], corners[1]), corners[2]),
                high = max(max(corners[0], corners[1]), corners[2]);
    const Vec3d outside = max(max(low - point, point - high), Vec3d{});
    if (dot(outside, outside) > best.distance * best.distance) continue;
    const mesh::ClosestOnTriangle on = mesh::closest_on_triangle(point, corners[0], corners[1], corners[2]);
    if (!(on.distance < best.distance)) continue;
    const std::array<Vec3d, 3> frame = frame_of(corners);
    best.distance = on.distance;
    best.hold = {
        triangle, on.weights, {dot(on.offset, frame[0]), dot(on.offset, frame[1]), dot(on.offset, frame[2])}};
  }
  return best;
}

/// How far a point is outside of a collider that is no mesh [m].
double distance_to(const scene::Collider& collider, const Vec3d& point) {
  if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider))
    return std::abs(length(point - sphere->center) - sphere->radius);
  if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider))
    return std::abs(mesh::closest_on_segment(point, capsule->a, capsule->b).distance - capsule->radius);
  const auto& plane = std::get<scene::ColliderPlane>(collider);
  return std::abs(dot(point - plane.point, plane.normal));
}

/// Where the shapes of a deformation take a point that is held, from where it is at rest.
scene::MotionPath path_of(const Hold& hold, const mesh::Deformation& deformation, const Vec3d& rest) {
  scene::MotionPath path;
  path.loops = deformation.times.loops;
  for (std::size_t k = 0; k < deformation.shapes.size(); ++k)
    path.points.push_back({deformation.times.times[k], place_of(hold, deformation.shapes[k]) - rest});
  return path;
}

/// Ties the nodes of one attachment.
class Tie {
 public:
  Tie(Model& model, const scene::Scene& scene, const Assets& assets, const scene::Attachment& attachment)
      : model_(model), attachment_(attachment), collider_(scene.colliders[attachment.collider]) {
    const auto found =
        std::find(assets.object_colliders.begin(), assets.object_colliders.end(), attachment.collider);
    if (found == assets.object_colliders.end()) return;
    const auto object = static_cast<std::size_t>(found - assets.object_colliders.begin());
    mesh_ = &assets.objects[object];
    if (!assets.deformations[object].empty()) deformation_ = &assets.deformations[object];
  }

  Result<void> add(std::uint32_t node, std::uint32_t own_number) {
    if (model_.kinematic(node))
      return input_error(
          "%s holds node %u, which is %s.", attachment_.where.c_str(), own_number,
          model_.motion[node] == 1 ? "pinned or attached already" : "moved or attached already");
    for (const NodeGrab& grab : model_.grabs)
      if (grab.node == node)
        return input_error("%s holds node %u, which %s grabs; a grab holds a free node.",
                           attachment_.where.c_str(), own_number, grab.grab.where.c_str());
    const Vec3d rest = model_.rest_position[node];
    const Nearest at = mesh_ != nullptr ? nearest(*mesh_, rest) : Nearest{{}, distance_to(collider_, rest)};
    if (at.distance > attachment_.reach)
      return input_error("%s: node %u is %.3g m from the collider, more than the reach of %g m.",
                         attachment_.where.c_str(), own_number, at.distance, attachment_.reach);
    if (deformation_ != nullptr) {
      follow(node, path_of(at.hold, *deformation_, rest));
    } else if (const auto& motion = scene::motion_of(collider_)) {
      if (group_ == 0) {
        model_.motions.push_back({attachment_.where, attachment_.nodes, *motion});
        if (auto* carried = std::get_if<scene::MotionCarried>(&model_.motions.back().shape))
          carried->collider = attachment_.collider;
        group_ = 1 + static_cast<std::uint32_t>(model_.motions.size());
      }
      model_.motion[node] = group_;
    } else {
      model_.motion[node] = 1;  // with what stays
    }
    model_.start_position[node] = rest;
    return {};
  }
  bool to_mesh() const { return mesh_ != nullptr; }
  bool deforms() const { return deformation_ != nullptr; }
  std::size_t shapes() const { return deforms() ? deformation_->shapes.size() : 0; }

 private:
  void follow(std::uint32_t node, scene::MotionPath path) {
    model_.motions.push_back({attachment_.where, attachment_.nodes, std::move(path)});
    model_.motion[node] = 1 + static_cast<std::uint32_t>(model_.motions.size());
  }

  Model& model_;
  const scene::Attachment& attachment_;
  const scene::Collider& collider_;
  const mesh::TriangleMesh* mesh_ = nullptr;
  const mesh::Deformation* deformation_ = nullptr;
  std::uint32_t group_ = 0;  // of the collider's motion
};

/// How much all attachments take.
struct Attached {
  std::size_t nodes = 0, shapes = 0;
};

Result<void> attach(Model& model, const scene::Scene& scene, const Assets& assets, std::size_t cloth,
                    Attached& attached) {
  const Body& body = model.bodies[cloth];
  const std::optional<scene::GridShape>& grid = scene.cloths[cloth].grid;
  const auto positions = std::span(model.rest_position).subspan(body.first_vertex, body.vertex_count);
  const scene::Selection selection{positions, grid ? grid->nx : 0, grid ? grid->ny : 0};
  for (const scene::Attachment& attachment : scene.cloths[cloth].attachments) {
    if (attachment.collider >= scene.colliders.size())
      return input_error("%s.collider is %zu, but the scene has %zu colliders, from 0.",
                         attachment.where.c_str(), attachment.collider, scene.colliders.size());
    WEFT_TRY(nodes, scene::select_nodes(attachment.nodes, selection));
    Tie tie(model, scene, assets, attachment);
    if (tie.deforms() && scene::motion_of(scene.colliders[attachment.collider]))
      return input_error("%s.collider is %zu, which deforms and has a motion; a node follows one of them.",
                         attachment.where.c_str(), attachment.collider);
    if (tie.to_mesh()) attached.nodes += nodes.size();
    attached.shapes += nodes.size() * tie.shapes();
    if (attached.shapes > kMostAttachedShapes)
      return make_error(ErrorKind::Limit,
                        "%s brings the shapes that attached nodes go through to %zu, more than %zu.",
                        attachment.where.c_str(), attached.shapes, kMostAttachedShapes);
    if (attached.nodes > kMostAttachedNodes)
      return make_error(ErrorKind::Limit,
                        "%s brings the nodes that are attached to meshes to %zu, more than %zu.",
                        attachment.where.c_str(), attached.nodes, kMostAttachedNodes);
    for (const std::uint32_t node : nodes) WEFT_CHECK(tie.add(body.first_vertex + node, node));
  }
  return {};
}

}  // namespace

Result<Model> build_model(const scene::Scene& scene, const Assets& assets) {
  WEFT_TRY(model, build_model(scene, assets.cloths, assets.solids));
  add_warps(model, scene, assets);
  Attached attached;
  for (std::size_t cloth = 0; cloth < scene.cloths.size(); ++cloth)
    WEFT_CHECK(attach(model, scene, assets, cloth, attached));
  WEFT_CHECK(add_seams(model, scene, assets));
  return model;
}

}  // namespace weft
