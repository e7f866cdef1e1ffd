#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "contact/pushes/pushes.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/readback.hpp"
#include "mesh/grid.hpp"
#include "mesh/triangle_mesh.hpp"
#include "state/state.hpp"

namespace weft {

/// A cloth between two instants.
struct Pose {
  std::vector<mesh::Triangle> triangles;
  std::vector<Vec4f> previous, predicted;  // [m]; w: inverse mass [1/kg]

  mesh::TriangleMesh predicted_mesh() const {
    mesh::TriangleMesh mesh{{}, triangles};
    for (const Vec4f& p : predicted) mesh.positions.push_back(p.xyz());
    return mesh;
  }
};

/// A sheet of n x n nodes that lies in a box's upper part, waves, and has moved down and sideways by 2 % of
/// its size.
inline Pose sheet_over(const mesh::Bounds& box, std::uint32_t n, double height, double wave,
                       std::uint64_t seed) {
  const mesh::Grid grid{n, n, 1, 1};
  Pose pose;
  pose.triangles = mesh::grid_triangles(grid);
  const Vec3d low = box.low.to<double>(), size = box.high.to<double>() - low;
  Random random(seed);
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const mesh::RestPoint at = mesh::rest_point(grid, i, j);
      const double ripple = wave * random.uniform(-1, 1);
      const Vec3d now{low.x + (1.1 * at.x - 0.05) * size.x, low.y + (height + ripple) * size.y,
                      low.z + (1.1 * at.y - 0.05) * size.z};
      pose.predicted.push_back(Vec4f::from(now.to<float>(), 1));
      pose.previous.push_back(Vec4f::from((now + Vec3d{0.01 * size.x, 0.02 * size.y, 0}).to<float>(), 1));
    }
  return pose;
}

struct Found {
  std::vector<std::int32_t> pushes;
  Statistics statistics;
  float push_scale = 1, max_push = 0;
  std::size_t dispatches = 0;

  bool same_as(const Found& other) const {
    return pushes == other.pushes && std::memcmp(&statistics, &other.statistics, sizeof(statistics)) == 0;
  }
};

inline Model model_of(const Pose& pose) {
  Model host;
  for (const Vec4f& p : pose.previous) host.rest_position.push_back(p.xyz().to<double>());
  host.start_position = host.rest_position;
  host.uv.resize(pose.previous.size());
  host.mass.assign(pose.previous.size(), 1);
  host.motion.assign(pose.previous.size(), 0);
  host.triangles = pose.triangles;
  return host;
}

/// Model, state and contacts of a pose, with the pushes recorded for one substep.
class PushRun {
 public:
  PushRun(gpu::Device& device, const Pose& pose, const contact::PushSetup& setup, std::uint32_t parity = 0)
      : device_(device), parity_(parity) {
    auto model = GpuModel::create(device, model_of(pose));
    REQUIRE(model);
    model_ = std::move(*model);
    auto state = State::create(device, model_.host, 2);
    REQUIRE(state);
    state_ = std::move(*state);
    auto contacts = Contacts::create_pushes(device, model_.host);
    REQUIRE(contacts);
    contacts_ = std::move(*contacts);
    place(pose);
    auto made = contact::Pushes::create(device, model_, state_, contacts_, setup);
    REQUIRE_MESSAGE(made, made.error().message);
    pushes_ = std::move(*made);
    StepBlock step;
    step.nodes.count = model_.vertex_count();
    step.contact.push_scale = pushes_.push_scale();
    step.contact.thickness = static_cast<float>(setup.thickness);
    step.contact.max_push = pushes_.max_push();
    state_.steps.write(device, std::vector<StepBlock>{step, step});
    gpu::ComputePass pass(list_, "pushes");
    pass.set_step(parity, parity);
    pushes_.measure(pass);
  }

  /// Another pose of the same cloth: a pipeline takes far longer to make than to run.
  void place(const Pose& pose) {
    state_.position[parity_].write(device_, pose.previous);
    state_.position[1 - parity_].write(device_, pose.predicted);
  }

  /// Clears, runs once and reads back.
  Found run() {
    gpu::CommandList clear;
    clear.clear(contacts_.pushes.source());
    clear.clear(state_.statistics.source());
    REQUIRE(device_.submit(clear));
    REQUIRE(device_.submit(list_));
    auto pushes = gpu::download(device_, contacts_.pushes);
    auto statistics = gpu::download(device_, state_.statistics);
    REQUIRE(pushes);
    REQUIRE(statistics);
    Found found{*pushes, {}, pushes_.push_scale(), pushes_.max_push(), list_.dispatch_count()};
    REQUIRE(statistics->size() * 4 == sizeof(Statistics));
    std::memcpy(static_cast<void*>(&found.statistics), statistics->data(), sizeof(Statistics));
    return found;
  }

  const gpu::CommandList& list() const { return list_; }

 private:
  gpu::Device& device_;
  std::uint32_t parity_ = 0;
  GpuModel model_;
  State state_;
  Contacts contacts_;
  contact::Pushes pushes_;
  gpu::CommandList list_;
};

inline Found find_contacts(gpu::Device& device, const Pose& pose, const contact::PushSetup& setup,
                           std::uint32_t parity = 0) {
  return PushRun(device, pose, setup, parity).run();
}

}  // namespace weft
