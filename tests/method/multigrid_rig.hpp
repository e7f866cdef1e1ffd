// One cloth's implicit substep on the GPU beside the reference's, from the same state.
#pragma once

#include <array>
#include <bit>

#include "fields.hpp"
#include "method/corners.hpp"
#include "method/multigrid/grid_cycle.hpp"
#include "method/multigrid/mesh_cycle.hpp"
#include "method/multigrid/reference/implicit_step.hpp"
#include "method/multigrid/solve_limits.hpp"
#include "solver_rig.hpp"

namespace weft {

template <class ClothCycle, class Kernels>
class ImplicitRig {
 public:
  /// `presses`: whether obstacles may hold nodes.
  ImplicitRig(gpu::Device& device, const std::string& members, double dt = 1.0 / 480,
              std::uint32_t workgroup_size = 64, bool presses = false,
              std::vector<mesh::TriangleMesh> meshes = {})
      : device_(device), scene_(scene_of(R"("solver": {"kind": "multigrid"}, )" + members)), dt_(dt) {
    meshes.resize(scene_.cloths.size());
    auto host = build_model(scene_, meshes);
    REQUIRE_OK(host);
    auto model = GpuModel::create(device, std::move(*host));
    REQUIRE_OK(model);
    model_ = std::move(*model);
    auto state = State::create(device, model_.host, 1);
    REQUIRE_OK(state);
    state_ = std::move(*state);
    auto sums = gpu::Buffer<std::int32_t>::create(device, (kHoldWords + kPressWords) * model_.vertex_count(),
                                                  "presses");
    REQUIRE_OK(sums);
    press_sums_ = std::move(*sums);
    auto aside = gpu::Buffer<Vec4f>::create(device, model_.vertex_count(), "predicted velocities");
    REQUIRE_OK(aside);
    predicted_ = std::move(*aside);
    // As in a world: aside where contact asks for it before the step is done.
    const Predicted predicted =
        presses ? Predicted{&predicted_, &predicted_} : Predicted{&state_.velocity[1], &state_.velocity[0]};
    const CycleInputs inputs{device,         model_,
                             state_,         dt,
                             predicted,      presses ? &press_sums_ : nullptr,
                             nullptr,        scene_.solver.residual,
                             workgroup_size, scene_.air ? &corners_ : nullptr};
    if (scene_.air) {
      auto corners = air_corners(device, model_.host);
      REQUIRE_OK(corners);
      corners_ = std::move(*corners);
    }
    const auto kernels = [&] {
      if constexpr (kIsMesh)
        return Kernels::create(inputs, multigrid::kind_of(model_.host.bodies[0]));
      else
        return Kernels::create(inputs);
    }();
    REQUIRE_OK(kernels);
    auto cycle = [&] {
      const Body& body = model_.host.bodies[0];
      if constexpr (kIsMesh)
        return ClothCycle::create(inputs, *kernels, multigrid::SystemBodies{{&body, 1}});
      else
        return ClothCycle::create(inputs, *kernels, {body});
    }();
    REQUIRE_OK(cycle);
    cycle_ = std::move(*cycle);
    params_.air.acceleration = Vec4f::from((scene_.gravity + scene_.external_force).to<float>(), 0);
    params_.time.dt = static_cast<float>(dt);
    params_.air.drag = static_cast<float>(scene_.drag);
    set_air(params_.air, scene_.air);
    const scene::WindField wind = scene::wind_field(scene_.wind);
    set_wind(params_.air, wind, {});
    params_.nodes.count = model_.vertex_count();
    state_.steps.write(device, std::span(&params_, 1));
  }

  /// A state, and the one a step before it; free nodes are moved by up to `amount` [m] and go at `speed`
  /// [m/s].
  void perturb(std::uint64_t seed, double amount, double speed) {
    Random random(seed);
    std::vector<Vec4f> x = download(state_.position[0]), v(x.size()), x_before = x, v_before(x.size());
    for (std::size_t n = 0; n < x.size(); ++n) {
      if (x[n].w == 0) continue;
      const auto draw = [&](double size) {
        const double a = random.uniform(-size, size), b = random.uniform(-size, size);
        return Vec3d{a, b, random.uniform(-size, size)};
      };
      const Vec3d place = x[n].xyz().to<double>() + draw(amount), velocity = draw(speed),
                  change = draw(0.1 * speed);
      x[n] = Vec4f::from(place.to<float>(), x[n].w);
      v[n] = Vec4f::from(velocity.to<float>(), n % 7 == 3 ? 0.0F : 1.0F);  // some nodes begin anew
      x_before[n] = Vec4f::from((place - dt_ * (velocity - 0.5 * change)).to<float>(), x[n].w);
      v_before[n] = Vec4f::from((velocity - change).to<float>(), 1);
    }
    set(x, v, x_before, v_before);
  }
  void set(const std::vector<Vec4f>& x, const std::vector<Vec4f>& v, const std::vector<Vec4f>& x_before,
           const std::vector<Vec4f>& v_before) {
    state_.position[0].write(device_, x);
    state_.velocity[0].write(device_, v);
    state_.position[1].write(device_, x_before);
    state_.velocity[1].write(device_, v_before);
    system_ = {};
    std::vector<Vec3d> before, velocity_before;
    for (std::size_t n = 0; n < x.size(); ++n) {
      system_.position.push_back(x[n].xyz().to<double>());
      system_.velocity.push_back(v[n].xyz().to<double>());
      system_.inverse_mass.push_back(static_cast<double>(x[n].w));
      before.push_back(x_before[n].xyz().to<double>());
      velocity_before.push_back(v_before[n].xyz().to<double>());
    }
    for (const Spring s : model_.host.springs())
      system_.springs.push_back({s.node_a, s.node_b, static_cast<double>(s.rest_length),
                                 static_cast<double>(s.stiffness), static_cast<double>(s.damping)});
    system_.fabrics = reference::fabric_cloths(model_.host);
    system_.acceleration = scene_.gravity + scene_.external_force;
    system_.drag = scene_.drag;
    system_.wind = scene::wind_field(scene_.wind);
    system_.air = scene_.air;
    system_.triangles = air_triangles(model_.host);
    stepper_.emplace(model_.host, dt_);
    stepper_->remember(before, velocity_before);
    for (std::size_t n = 0; n < v.size(); ++n)
      if (v[n].w == 0) stepper_->forget(n);
  }
  void hold(std::uint32_t node, const Vec3d& target) {
    params_.hands.rate = 20;
    params_.hands.speed = 10;
    const Vec4f goal = Vec4f::from(target.to<float>(), 1);
    slots_.set(device_, model_, std::span(&node, 1), 1);
    slots_.fill(params_.hands, state_, 0);
    GrabSlots::write_goals(device_, state_, std::span(&goal, 1), {});
    state_.steps.write(device_, std::span(&params_, 1));
    system_.grabs = {{node, target}};
    system_.grab_rate = 20;
    system_.grab_speed = 10;
  }
  /// Obstacles at every `every`-th node, in sums as the kernels keep them: some press, some do not, some
  /// agree on no direction; with friction from none to much. Every fourth has thousands of pairs: sums beyond 32 bits.
  /// Most nodes have been held before, with forces of the size of what presses now.
  void press(std::uint64_t seed, std::uint32_t every) {
    params_.contact.thickness = 0.01F;
    state_.steps.write(device_, std::span(&params_, 1));
    Random random(seed);
    const auto draw = [&] {
      const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
      return Vec3d{a, b, random.uniform(-1, 1)};
    };
    constexpr double kUnits = 1048576;  // of all sums: src/contact/proximity/press_sums.wgsl
    std::vector<std::int32_t> words(press_sums_.size());
    std::vector<reference::HoldForce> forces(model_.vertex_count());
    presses_.assign(model_.vertex_count(), {});
    for (std::size_t n = 0; n < presses_.size(); n += every) {
      const Vec3d normal = draw(), surface = 0.5 * draw();
      const double lack = random.uniform(-0.2, 1), friction = 2 * random.uniform(0, 1);
      std::int32_t* sums = &words[kHoldWords * forces.size() + kPressWords * n];
      const auto put = [&](std::size_t word, double value) {
        const std::int64_t sum = std::llround(value * kUnits);
        sums[word] = static_cast<std::int32_t>(sum);  // its lowest 32 bits
        sums[word + kPressWords / 2] =
            static_cast<std::int32_t>((sum - sums[word]) / (1LL << 32));  // how often past an end
        return static_cast<double>(sum) / kUnits;
      };
      const double weight = put(4, random.uniform(0.1, 3) * (n % (4 * every) == 0 ? 20000 : 1));
      reference::Press& press = presses_[n];
      press.weight = weight;
      press.normal = {put(0, weight * normal.x), put(1, weight * normal.y), put(2, weight * normal.z)};
      press.lack = put(3, weight * lack) * static_cast<double>(params_.contact.thickness);
      press.restored =
          put(9, weight * std::max(0.15 * lack, 0.0)) * static_cast<double>(params_.contact.thickness);
      press.surface = {put(5, weight * surface.x), put(6, weight * surface.y), put(7, weight * surface.z)};
      press.friction = put(8, weight * friction);
      if (n % (3 * every) == 0) continue;
      const double scale = 1e-3 / (dt_ * dt_ * system_.inverse_mass[n]);  // moves the node by a millimetre
      if (!(scale < 1e9)) continue;
      const Vec3d along = scale * draw();
      const double bears = scale * random.uniform(0, 1);
      const std::array<double, kHoldWords> force = {along.x, along.y, along.z, bears};
      for (std::size_t k = 0; k < kHoldWords; ++k)
        words[kHoldWords * n + k] = std::bit_cast<std::int32_t>(static_cast<float>(force[k]));
      forces[n] = {bears, along};
    }
    press_sums_.write(device_, words);
    pressed_sums_.assign(words.begin() + static_cast<std::ptrdiff_t>(kHoldWords * forces.size()),
                         words.end());
    stepper_->set_hold_forces(std::move(forces));
    set_history_of_pressed(0);
    for (std::size_t n = 0; n < presses_.size(); ++n)
      if (presses_[n].weight > 0) stepper_->forget(n);
  }
  /// Whether the kernels find a history at nodes that are pressed: 1 where they are first in the second system.
  void set_history_of_pressed(float history) {
    std::vector<Vec4f> velocity = download(state_.velocity[0]);
    for (std::size_t n = 0; n < presses_.size(); ++n)
      if (presses_[n].weight > 0) velocity[n].w = history;
    state_.velocity[0].write(device_, velocity);
  }
  const gpu::Buffer<std::int32_t>& press_sums() const { return press_sums_; }
  void set_ratio(double ratio) {
    ratio_ = ratio;
    params_.time.step_ratio = static_cast<float>(ratio);
    state_.steps.write(device_, std::span(&params_, 1));
  }

  /// Runs parts of the substep of parity 0.
  template <class Record>
  void run(const Record& record) {
    gpu::CommandList list;
    {
      gpu::ComputePass pass(list, "multigrid");
      record(pass);
    }
    const auto submitted = device_.submit(list);
    REQUIRE_OK(submitted);
  }
  /// One of the vectors of a level, as src/method/multigrid/cloth.wgsl numbers them.
  std::vector<Vec4f> vector(std::size_t level, std::uint32_t number) {
    const auto& l = cycle_.shapes()[level];
    const std::uint32_t count = node_count(l);
    const std::vector<Vec4f> all = download(cycle_.vectors());
    const auto values = std::span(all).subspan(l.first_vector + std::size_t{number} * count, count);
    std::vector<Vec4f> found;
    for (const Vec4f& value : values) found.push_back(value);
    return found;
  }
  template <class T>
  std::vector<T> download(const gpu::Buffer<T>& buffer) {
    auto values = gpu::download(device_, buffer);
    REQUIRE_OK(values);
    return std::move(*values);
  }

  /// The first system; the second where the first has led to `ways` [m].
  auto linearise(const std::vector<Vec3d>& ways = {}) const {
    if constexpr (kIsMesh) {
      return stepper_->linearise_mesh(system_, system_.position, dt_, ratio_, 0, presses_, ways);
    } else {
      return stepper_->linearise(system_, system_.position, dt_, ratio_, 0, presses_, ways);
    }
  }
  /// The reference's state after one step.
  reference::MassSpringSystem advanced() {
    reference::MassSpringSystem system = system_;
    stepper_->advance({system, system.position, dt_, ratio_, pressed()});
    return system;
  }

  const ClothCycle& cycle() const { return cycle_; }
  /// The first system, and what presses in the second: the same.
  void run_first() {
    run([&](gpu::ComputePass& pass) { cycle_.record_first(pass); });
    if (!pressed_sums_.empty())
      press_sums_.write(device_, pressed_sums_, kHoldWords * std::size_t{model_.vertex_count()});
  }
  /// In the reference, whose whole step does this itself: what its first system does not hold bears nothing in the
  /// second.
  void let_go_after_first() {
    std::vector<reference::HoldForce> forces = stepper_->hold_forces();
    const auto first = linearise();
    for (std::size_t n = 0; n < forces.size(); ++n)
      if (!first.holds[n]) forces[n] = {};
    stepper_->set_hold_forces(std::move(forces));
  }
  void run_substep() {
    run_first();
    run([&](gpu::ComputePass& pass) { cycle_.record_last(pass, multigrid::kMostIterations); });
  }
  /// The forces of holds that are kept on the GPU.
  std::vector<reference::HoldForce> hold_forces() {
    const std::vector<std::int32_t> words = download(press_sums_);
    std::vector<reference::HoldForce> forces(model_.vertex_count());
    for (std::size_t n = 0; n < forces.size(); ++n) {
      std::array<double, kHoldWords> force{};
      for (std::size_t k = 0; k < kHoldWords; ++k)
        force[k] = static_cast<double>(std::bit_cast<float>(words[kHoldWords * n + k]));
      forces[n] = {force[3], {force[0], force[1], force[2]}};
    }
    return forces;
  }
  const std::vector<reference::HoldForce>& expected_hold_forces() const { return stepper_->hold_forces(); }
  bool held(std::size_t node) const { return stepper_->held()[node]; }
  bool has_history(std::size_t node) const { return stepper_->has_history(node); }
  const State& state() const { return state_; }
  /// After a substep, in it.
  std::vector<Vec4f> velocity() { return download(presses_.empty() ? state_.velocity[1] : predicted_); }
  const GpuModel& model() const { return model_; }
  const reference::MassSpringSystem& system() const { return system_; }

 private:
  /// The same for any velocities.
  std::function<reference::Pressed(std::span<const Vec3d>)> pressed() const {
    if (presses_.empty()) return {};
    return [this](std::span<const Vec3d>) -> reference::Pressed { return {{}, presses_}; };
  }

  static constexpr bool kIsMesh = std::is_same_v<ClothCycle, MeshCycle>;

  gpu::Device& device_;
  gpu::Buffer<std::int32_t> press_sums_;
  std::vector<reference::Press> presses_;
  std::vector<std::int32_t> pressed_sums_;
  gpu::Buffer<Vec4f> predicted_;
  gpu::Buffer<std::uint32_t> corners_;
  scene::Scene scene_;
  double dt_, ratio_ = 1;
  StepBlock params_;
  GrabSlots slots_;
  GpuModel model_;
  State state_;
  ClothCycle cycle_;
  reference::MassSpringSystem system_;
  std::optional<reference::ImplicitStepper> stepper_;
};

using MultigridRig = ImplicitRig<GridCycle, GridKernels>;
using MeshRig = ImplicitRig<MeshCycle, MeshKernels>;

/// After its whole substep the rig's nodes have come where the reference's have, and as fast; those that obstacles
/// hold, if any may, begin anew, and keep the force that held them.
template <class Rig>
void check_substep(Rig& rig, bool pressed = false) {
  rig.run_substep();
  const reference::MassSpringSystem expected = rig.advanced();
  const reference::Field after = field(rig.download(rig.state().position[1]));
  const std::vector<Vec4f> velocity = rig.velocity();
  reference::Field way, wanted;
  for (std::size_t n = 0; n < after.size(); ++n) {
    way.push_back(after[n] - rig.system().position[n]);
    wanted.push_back(expected.position[n] - rig.system().position[n]);
    const float mark = velocity[n].w;
    CHECK((rig.has_history(n) ? mark == 1 : rig.held(n) ? mark == -1 : mark == -2 || mark == 0));
  }
  CHECK(difference(way, wanted) < 1e-3);
  CHECK(difference(field(velocity), expected.velocity) < 1e-3);
  if (!pressed) return;
  reference::Field found_force, wanted_force;
  const std::vector<reference::HoldForce> found = rig.hold_forces(), kept = rig.expected_hold_forces();
  for (std::size_t n = 0; n < kept.size(); ++n) {
    found_force.insert(found_force.end(), {found[n].along, {found[n].normal, 0, 0}});
    wanted_force.insert(wanted_force.end(), {kept[n].along, {kept[n].normal, 0, 0}});
  }
  CHECK(difference(found_force, wanted_force) < 1e-3);
}

}  // namespace weft
