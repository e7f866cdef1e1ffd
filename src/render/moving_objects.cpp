#include "render/moving_objects.hpp"

#include <algorithm>

#include "scene/motion.hpp"

namespace weft::render {

MovingObjects::MovingObjects(std::vector<MovingObject> objects, const std::vector<scene::Collider>* colliders)
    : colliders_(colliders) {
  std::size_t most = 0;  // vertices of one that deforms
  for (MovingObject& object : objects) {
    given_ = given_ || object.draw.given.has_value();
    if (!object.draw.deformation.empty()) most = std::max(most, object.draw.mesh.positions.size());
    std::vector<Vec3f> first_shape = object.draw.mesh.positions;
    objects_.push_back({std::move(object), std::move(first_shape), {}});
  }
  rows_.resize(3 * objects_.size());
  positions_.reserve(most);
  normals_.reserve(most);
  sums_.reserve(most);
}

void MovingObjects::write(gpu::Device& device, const ObjectBuffers& buffers, double time) {
  if (objects_.empty() || (time == written_ && !given_)) return;
  Vec4f* row = rows_.data();
  for (std::size_t number = 0; number < objects_.size(); ++number) {
    const ObjectDraw& draw = objects_[number].object.draw;
    const std::optional<scene::ColliderMotion>& motion =
        draw.given ? scene::motion_of((*colliders_)[*draw.given]) : draw.motion;
    const scene::RigidTransform move = motion ? scene::motion_at(*motion, time) : scene::RigidTransform{};
    for (int axis = 0; axis < 3; ++axis) {
      const double* r = &move.rotation[3 * axis];
      *row++ = {static_cast<float>(r[0]), static_cast<float>(r[1]), static_cast<float>(r[2]),
                static_cast<float>(move.translation[axis])};
    }
    deform(device, buffers, number, time);
  }
  buffers.placement.write(device, rows_);
  written_ = time;
}

void MovingObjects::deform(gpu::Device& device, const ObjectBuffers& buffers, std::size_t number,
                           double time) {
  Moving& moving = objects_[number];
  const mesh::Deformation& deformation = moving.object.draw.deformation;
  if (deformation.empty()) return;
  const mesh::ShapeTimes::Moment moment = deformation.times.at(time);
  if (moment == moving.written) return;
  const auto shape_at = [&](std::size_t number_of_shape) -> const std::vector<Vec3f>& {
    return number_of_shape == 0 ? moving.first_shape : deformation.shapes[number_of_shape - 1];
  };
  const std::vector<Vec3f>&from = shape_at(moment.from), &to = shape_at(moment.to);
  mesh::TriangleMesh& shape = moving.object.draw.mesh;
  positions_.resize(shape.positions.size());
  normals_.resize(shape.positions.size());
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    shape.positions[i] =
        (from[i].to<double>() * (1 - moment.part) + to[i].to<double>() * moment.part).to<float>();
    positions_[i] = Vec4f::from(shape.positions[i], static_cast<float>(number));
  }
  write_vertex_normals(shape, sums_, normals_, moving.object.draw.material);
  buffers.position.write(device, positions_, moving.object.first_vertex);
  buffers.normal.write(device, normals_, moving.object.first_vertex);
  moving.written = moment;
}

}  // namespace weft::render
