#include "render/scene_inputs.hpp"

#include <algorithm>
#include <cassert>

#include "scene/motion.hpp"

namespace weft::render {
namespace {

void include(mesh::Bounds& bounds, const Vec3f& point) {
  bounds.low = min(bounds.low, point);
  bounds.high = max(bounds.high, point);
}

}  // namespace

Inputs inputs_of(const GpuModel& model, const State& state, const VertexBuffers& buffers,
                 const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& objects,
                 const std::vector<mesh::Deformation>& deformations) {
  Inputs inputs;
  inputs.cloth.position = {&state.position[0], &state.position[1]};
  inputs.cloth.velocity = {&state.velocity[0], &state.velocity[1]};
  inputs.cloth.normal = &buffers.normal;
  inputs.cloth.stretch = &buffers.stretch;
  inputs.cloth.contacts = buffers.contacts;
  inputs.cloth.uv = &model.uv;
  inputs.cloth.triangles = &model.triangles;
  for (const Body& body : model.host.bodies) {
    double size = 0;
    for (std::uint32_t v = 0; v < body.vertex_count; ++v) {
      const auto& uv = model.host.uv[body.first_vertex + v];
      size = std::max({size, static_cast<double>(uv[0]), static_cast<double>(uv[1])});
    }
    ClothRange range{body.first_triangle, body.triangle_count, body.color, size};
    range.woven = !body.solid && !body.gas;
    range.look = body.look;
    if (body.grid) {
      range.grid = ClothGrid{*body.grid, body.first_vertex};
      range.rim = {body.grid->width, body.grid->height};
    }
    inputs.cloth.ranges.push_back(range);
  }
  inputs.rigid = buffers.rigid;
  inputs.colliders = &scene.colliders;
  std::size_t object = 0;
  for (std::size_t c = 0; c < scene.colliders.size(); ++c) {
    const scene::Collider& collider = scene.colliders[c];
    if (const auto* mesh = std::get_if<scene::ColliderMesh>(&collider)) {
      assert(object < objects.size());
      inputs.objects.push_back(
          {objects[object], deformations.empty() ? mesh::Deformation{} : deformations[object], mesh->motion});
      if (scene::carried_of(collider) != nullptr) inputs.objects.back().given = c;
      inputs.objects.back().material = mesh->material;
      ++object;
    }
    if (const auto* box = std::get_if<scene::ColliderBox>(&collider)) {  // drawn with sharp edges
      inputs.boxes.push_back(*box);
      inputs.box_colliders.push_back(c);
      ++object;
    }
    if (const auto* convex = std::get_if<scene::ColliderConvex>(&collider)) {
      assert(object < objects.size());
      inputs.hulls.push_back({objects[object], {}, convex->motion});
      if (convex->rigid && buffers.rigid.words != nullptr) inputs.hulls.back().rigid = c;
      if (scene::carried_of(collider) != nullptr) inputs.hulls.back().given = c;
      inputs.hulls.back().material = convex->material;
      ++object;
    }
    if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider)) {
      inputs.capsules.push_back(*capsule);
      inputs.capsule_colliders.push_back(c);
    }
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) {
      inputs.spheres.push_back(*sphere);
      inputs.sphere_colliders.push_back(c);
    }
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) {
      inputs.planes.push_back(*plane);
      inputs.plane_colliders.push_back(c);
    }
  }
  return inputs;
}

mesh::Bounds scene_bounds(const Model& model, const scene::Scene& scene,
                          const std::vector<mesh::TriangleMesh>& objects) {
  mesh::Bounds bounds{model.rest_position[0].to<float>(), model.rest_position[0].to<float>()};
  const double end = scene.time.frames * scene.time.frame;
  double sag = 0;  // how far a sheet can hang down from where it is pinned or lies [m]
  for (const auto& uv : model.uv)
    sag = std::max({sag, static_cast<double>(uv[0]), static_cast<double>(uv[1])});
  const Vec3d pull = scene.gravity + scene.external_force;
  const Vec3d down = length(pull) > 0 ? pull / length(pull) : Vec3d{};
  for (std::size_t v = 0; v < model.vertex_count(); ++v) {
    include(bounds, model.rest_position[v].to<float>());
    include(bounds, (model.rest_position[v] + sag * down).to<float>());
    if (model.motion[v] > 1)
      include(bounds,
              scene::motion_at(model.motions[model.motion[v] - 2], end)(model.rest_position[v]).to<float>());
  }
  for (const mesh::TriangleMesh& object : objects) {
    const mesh::Bounds box = mesh::bounds(object);
    include(bounds, box.low);
    include(bounds, box.high);
  }
  const auto include_ball = [&](const Vec3d& center, double radius) {
    const Vec3d r{radius, radius, radius};
    include(bounds, (center - r).to<float>());
    include(bounds, (center + r).to<float>());
  };
  for (const scene::Collider& collider : scene.colliders) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider))
      include_ball(sphere->center, sphere->radius);
    if (const auto* capsule = std::get_if<scene::ColliderCapsule>(&collider))
      for (const Vec3d& point : {capsule->a, capsule->b}) include_ball(point, capsule->radius);
  }
  return bounds;
}

}  // namespace weft::render
