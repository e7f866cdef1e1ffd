#include "render/moving_objects.hpp"

#include <algorithm>

#include "scene/motion.hpp"

namespace weft::render {

MovingObjects::MovingObjects(std::vector<MovingObject> objects) {
  std::size_t most = 0;  // vertices of one that deforms
  for (MovingObject& object : objects) {
    std::vector<ObjectKeyframe>& keyframes = object.draw.keyframes;
    if (!keyframes.empty()) {
      most = std::max(most, object.draw.mesh.positions.size());
      keyframes.insert(keyframes.begin(), {0, object.draw.mesh.positions});
    }
    objects_.push_back({std::move(object), 0});
  }
  rows_.resize(3 * objects_.size());
  positions_.reserve(most);
  normals_.reserve(most);
  sums_.reserve(most);
}

void MovingObjects::write(gpu::Device& device, const ObjectBuffers& buffers, double time) {
  if (objects_.empty() || time == written_) return;
  Vec4f* row = rows_.data();
  for (std::size_t number = 0; number < objects_.size(); ++number) {
    const std::optional<scene::ColliderMotion>& motion = objects_[number].object.draw.motion;
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
  const std::vector<ObjectKeyframe>& keyframes = moving.object.draw.keyframes;
  if (keyframes.empty()) return;
  time = std::clamp(time, 0.0, keyframes.back().time);
  if (time == moving.written_shape) return;
  const auto next = std::find_if(keyframes.begin() + 1, keyframes.end() - 1,
                                 [&](const ObjectKeyframe& one) { return one.time > time; });
  const ObjectKeyframe &from = *(next - 1), &to = *next;
  const double part = (time - from.time) / (to.time - from.time);
  mesh::TriangleMesh& shape = moving.object.draw.mesh;
  positions_.resize(shape.positions.size());
  normals_.resize(shape.positions.size());
  for (std::size_t i = 0; i < shape.positions.size(); ++i) {
    shape.positions[i] =
        (from.positions[i].to<double>() * (1 - part) + to.positions[i].to<double>() * part).to<float>();
    positions_[i] = Vec4f::from(shape.positions[i], static_cast<float>(number));
  }
  write_vertex_normals(shape, sums_, normals_);
  buffers.position.write(device, positions_, moving.object.first_vertex);
  buffers.normal.write(device, normals_, moving.object.first_vertex);
  moving.written_shape = time;
}

}  // namespace weft::render
