// How a world is made: buffers, contact, solver, reports.
#include <algorithm>

#include "sim/world.hpp"
#include "method/registry.hpp"

namespace weft::sim {
namespace {

constexpr double kEver = 1e9;  // s; later than any motion begins

std::size_t count_springs(const HostModel& model) {
  std::size_t count = 0;
  for (const ClothModel& cloth : model.cloths)
    count += cloth.grid ? mesh::grid_spring_count(*cloth.grid) : build_springs(model, cloth).size();
  return count;
}

contact::CollisionSetup collision_setup(const scene::Scene& scene, const Assets& assets,
                                          const WorldOptions& options) {
  contact::CollisionSetup setup;
  setup.method = scene.contact.method;
  setup.thickness = scene.contact.thickness;
  setup.objects = assets.objects;
  setup.workgroup_size = options.workgroup_size;
  for (const scene::Collider& collider : scene.colliders) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) setup.spheres.push_back(*sphere);
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) setup.planes.push_back(*plane);
  }
  return setup;
}

/// What the lists have room for at first; World makes them longer when they are short.
ContactRoom first_room(const Model& model) {
  return {std::max(32768U, 2 * model.triangle_count()), std::max(131072U, 12 * model.triangle_count())};
}

}  // namespace

Result<void> check_node_count(std::uint64_t nodes, const gpu::Device& device) {
  const std::uint64_t bytes = nodes * sizeof(Vec4f), limit = device.limits().max_storage_binding_size;
  if (bytes <= limit) return {};
  return make_error(ErrorKind::Limit,
                    "The positions of %llu nodes need %llu bytes, more than this adapter's "
                    "maxStorageBufferBindingSize of %llu.",
                    static_cast<unsigned long long>(nodes), static_cast<unsigned long long>(bytes),
                    static_cast<unsigned long long>(limit));
}

Result<void> World::build(const Assets& assets, const WorldOptions& options) {
  WEFT_CHECK(check_node_count(node_count(scene_, assets), device_));
  assets_ = assets;
  WEFT_TRY(host, build_model(scene_, assets.cloths));
  spring_count_ = count_springs(host);
  choice_ = choose_solver(scene_, host);
  limit_ = find_step_limit(choice_.kind, scene_, host);
  WEFT_TRY(substeps, weft::substeps_of(scene_, choice_.kind, limit_));
  substeps_ = substeps;
  WEFT_TRY(model, Model::create(device_, std::move(host)));
  model_ = std::move(model);
  if (scene_.contact.method == scene::ContactMethod::Proximity)
    movers_ = contact_movers(scene_, model_.host, assets_.objects, assets_.keyframes);
  most_substeps_ = substeps_ * contact_step_factor(movers_, scene_.contact.thickness, 0, kEver, step());
  WEFT_TRY(state, State::create(device_, model_.host, most_substeps_));
  state_ = std::move(state);
  options_ = options;
  WEFT_TRY(counts, gpu::Buffer<float>::create(device_, model_.vertex_count(), "contact counts"));
  contact_counts_ = std::move(counts);
  WEFT_CHECK(build_contact(options.contact_room ? *options.contact_room : first_room(model_)));
  WEFT_TRY(surface, Surface::create(device_, model_, state_));
  surface_ = std::move(surface);
  WEFT_TRY(last_good, LastGood::create(device_, state_, solver_->reads_step_before()));
  last_good_ = std::move(last_good);
  for (Report& report : reports_) {
    WEFT_TRY(readback, gpu::Readback::create(device_, sizeof(Statistics), "frame report"));
    report.readback = std::move(readback);
    report.commands.copy(state_.statistics.source(), report.readback.target());
  }
  motion_rows_.resize(3 * model_.host.motions.size() * most_substeps_);
  grabs_.emplace(model_.host);
  steps_ = FrameSteps(base_params(), most_substeps_, search_interval(choice_.kind),
                      model_.host.motions.size(), scene_.time.frame);
  steps_.set_air(scene_, 0);
  WEFT_CHECK(submit_rest());
  return device_.wait();  // in a browser, only now is it known whether all of this could be made
}

Result<void> World::build_contact(const ContactRoom& room) {
  const scene::ContactMethod method = scene_.contact.method;
  if (method == scene::ContactMethod::Proximity && (scene_.contact.self || !scene_.colliders.empty())) {
    const bool presses = solves_with_obstacles(scene_, choice_.kind);
    WEFT_TRY(contacts, Contacts::create_pairs(device_, model_.host, room, presses));
    contacts_ = std::move(contacts);
    WEFT_TRY(proximity, contact::Proximity::create(
                            device_, model_, state_, *contacts_->pairs, scene_,
                            {assets_.objects, assets_.object_colliders, assets_.keyframes}, most_substeps_,
                            search_interval(choice_.kind), options_.workgroup_size));
    proximity_ = std::move(proximity);
  } else if ((method == scene::ContactMethod::Paper || method == scene::ContactMethod::Bvh) &&
             !scene_.colliders.empty()) {
    WEFT_TRY(contacts, Contacts::create_pushes(device_, model_.host));
    contacts_ = std::move(contacts);
    WEFT_TRY(collision, contact::Collision::create(device_, model_, state_, *contacts_,
                                                     collision_setup(scene_, assets_, options_)));
    collision_ = std::move(collision);
  }
  scene::Solver settings = scene_.solver;
  settings.kind = choice_.kind;
  WEFT_TRY(solver, make_solver(settings, {device_, model_, state_, contacts_ ? &*contacts_ : nullptr,
                                          options_.workgroup_size, options_.two_steps}));
  solver_ = std::move(solver);
  constants_ = solver_->constants();
  return {};
}

}  // namespace weft::sim
