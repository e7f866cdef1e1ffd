// A solver on its own: a scene's cloths without contact, stepped and read back.
#pragma once

#include <doctest/doctest.h>

#include <cstring>
#include <map>
#include <memory>
#include <string>

#include "base/random.hpp"
#include "gpu/device.hpp"
#include "gpu/readback.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "method/solver.hpp"
#include "method/stepper.hpp"
#include "scene/load.hpp"
#include "state/grab_slots.hpp"

namespace weft {

#define REQUIRE_OK(result) REQUIRE_MESSAGE(static_cast<bool>(result), (result).error().message)

/// Of mass_spring where the members name no solver.
inline scene::Scene scene_of(const std::string& members) {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "contact": {"method": "none"}, )" + members + "}", "test.json");
  REQUIRE_OK(scene);
  if (scene->solver.kind == scene::SolverKind::Auto) scene->solver.kind = scene::SolverKind::MassSpring;
  return std::move(*scene);
}

class SolverRig {
 public:
  static constexpr double kTime = 100.3;  // s; at which the wind stands still

  SolverRig(gpu::Device& device, const scene::Scene& scene, double dt,
            std::vector<mesh::TriangleMesh> meshes = {}, std::uint32_t workgroup_size = 256)
      : device_(device), scene_(scene), dt_(dt) {
    meshes.resize(scene.cloths.size());
    auto host = build_model(scene, meshes);
    REQUIRE_OK(host);
    auto model = GpuModel::create(device, std::move(*host));
    REQUIRE_OK(model);
    model_ = std::move(*model);
    auto state = State::create(device, model_.host, 1);
    REQUIRE_OK(state);
    state_ = std::move(*state);
    auto solver = make_solver(
        scene.solver, {device, model_, state_, dt, nullptr, workgroup_size, {}, scene.air.has_value()});
    REQUIRE_OK(solver);
    solver_ = std::move(*solver);
    StepBlock& params = params_;
    params.air.acceleration = Vec4f::from((scene.gravity + scene.external_force).to<float>(), 0);
    params.time.dt = static_cast<float>(dt);
    params.air.drag = static_cast<float>(scene.drag);
    set_air(params.air, scene.air);
    const scene::WindField wind = scene::wind_field(scene.wind);
    set_wind(params.air, wind, {wind.waves[0].rate * kTime, wind.waves[1].rate * kTime});
    params.nodes.count = model_.vertex_count();
    solver_->fill(params.method);
    state_.steps.write(device, std::span(&params, 1));
  }

  /// Moves every free node by up to `amount` [m] a side and gives it a velocity of up to `speed` [m/s].
  void perturb(std::uint64_t seed, double amount, double speed) {
    Random random(seed);
    std::vector<Vec4f> position = positions(), velocity(position.size());
    for (std::size_t i = 0; i < position.size(); ++i) {
      const auto draw = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
      const Vec3f move{draw(amount), draw(amount), draw(amount)};
      const Vec3f push{draw(speed), draw(speed), draw(speed)};
      if (position[i].w == 0) continue;
      position[i] = Vec4f::from(position[i].xyz() + move, position[i].w);
      velocity[i] = Vec4f::from(push, 0);
    }
    set(position, velocity);
  }
  void set(const std::vector<Vec4f>& position, const std::vector<Vec4f>& velocity) {
    state_.position[parity_].write(device_, position);
    state_.velocity[parity_].write(device_, velocity);
  }

  /// Holds a node from now on.
  void hold(std::uint32_t node, const Vec3d& target, double rate, double speed) {
    params_.hands.rate = static_cast<float>(rate);
    params_.hands.speed = static_cast<float>(speed);
    grabs_[node] = target;
    write_grabs();
  }

  /// Holds none from now on.
  void let_go() {
    grabs_.clear();
    write_grabs();
  }

  void advance(std::uint32_t steps) {
    while (steps > 0) {
      const std::uint32_t batch = steps < 500 ? steps : 500;
      gpu::CommandList list;
      {
        gpu::ComputePass pass(list, "steps");
        for (std::uint32_t s = 0; s < batch; ++s) {
          pass.set_step(0, (parity_ + s) & 1U);
          solver_->record(pass, contact::Stages(), 1);
        }
      }
      const auto submitted = device_.submit(list);
      REQUIRE_OK(submitted);
      parity_ = (parity_ + batch) & 1U;
      steps -= batch;
    }
  }

  std::vector<Vec4f> positions() { return read(state_.position[parity_]); }
  std::vector<Vec4f> velocities() { return read(state_.velocity[parity_]); }
  const GpuModel& model() const { return model_; }
  double dt() const { return dt_; }

  /// The same system, as it stands, for the reference.
  reference::MassSpringSystem reference() {
    reference::MassSpringSystem system;
    for (const Vec4f& x : positions()) {
      system.position.push_back(x.xyz().to<double>());
      system.inverse_mass.push_back(static_cast<double>(x.w));
    }
    for (const Vec4f& v : velocities()) system.velocity.push_back(v.xyz().to<double>());
    const ElementTable& triples = model_.host.elements(ElementKind::Triple);
    for (std::size_t t = 0; t < triples.size(); ++t) {
      const auto nodes = triples.nodes_of(t);
      system.bending.push_back({nodes[0], nodes[1], nodes[2], static_cast<double>(triples.material[t])});
    }
    for (const Spring s : model_.host.springs())
      system.springs.push_back({s.node_a, s.node_b, static_cast<double>(s.rest_length),
                                static_cast<double>(s.stiffness), static_cast<double>(s.damping)});
    system.fabrics = reference::fabric_cloths(model_.host);
    for (reference::FabricCloth& cloth : system.fabrics) cloth.set_creases(read(state_.creases));
    system.solids = reference::solid_bodies(model_.host);
    system.gases = reference::enclosed_gases(model_.host);
    system.acceleration = scene_.gravity + scene_.external_force;
    system.drag = scene_.drag;
    system.wind = scene::wind_field(scene_.wind);
    system.air = scene_.air;
    system.triangles = air_triangles(model_.host);
    system.time = kTime;
    system.grabs = grabs_;
    system.grab_rate = static_cast<double>(params_.hands.rate);
    system.grab_speed = static_cast<double>(params_.hands.speed);
    return system;
  }

 private:
  void write_grabs() {
    std::vector<std::uint32_t> nodes;
    std::vector<Vec4f> goals;
    for (const auto& [node, target] : grabs_) {
      nodes.push_back(node);
      goals.push_back(Vec4f::from(target.to<float>(), 1));
    }
    slots_.set(device_, model_, nodes, nodes.size());
    slots_.fill(params_.hands, state_, 0);
    GrabSlots::write_goals(device_, state_, goals, {});
    state_.steps.write(device_, std::span(&params_, 1));
  }
  std::vector<Vec4f> read(const gpu::Buffer<Vec4f>& buffer) {
    auto values = gpu::download(device_, buffer);
    REQUIRE_OK(values);
    return std::move(*values);
  }

  gpu::Device& device_;
  scene::Scene scene_;
  double dt_;
  StepBlock params_;
  std::map<std::uint32_t, Vec3d> grabs_;
  GrabSlots slots_;
  GpuModel model_;
  State state_;
  std::unique_ptr<Solver> solver_;
  std::uint32_t parity_ = 0;
};

inline bool same_bits(const std::vector<Vec4f>& a, const std::vector<Vec4f>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec4f)) == 0;
}

/// A mesh cloth for tests: a sheet of nx x ny nodes as a plain mesh, or a sphere's skin.
inline mesh::TriangleMesh sheet_mesh(std::uint32_t nx, std::uint32_t ny, double width, double height) {
  const mesh::Grid grid{nx, ny, width, height};
  mesh::TriangleMesh mesh;
  for (std::uint32_t j = 0; j < ny; ++j)
    for (std::uint32_t i = 0; i < nx; ++i) {
      const mesh::RestPoint p = mesh::rest_point(grid, i, j);
      mesh.positions.push_back(Vec3d{p.x, 0, p.y}.to<float>());
    }
  mesh.triangles = mesh::grid_triangles(grid);
  return mesh;
}

/// So many substeps in double from where the rig stands.
inline reference::MassSpringSystem exact_after(SolverRig& rig, const scene::Scene& scene, int steps) {
  reference::MassSpringSystem system = rig.reference();
  const auto stepper = reference::make_stepper(scene.solver, rig.model().host, rig.dt());
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3d> places = system.position;  // pinned nodes stay
    stepper->advance({system, places, rig.dt()});
  }
  return system;
}

}  // namespace weft
