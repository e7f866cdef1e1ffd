// How a world is made: buffers, contact, solver, reports.
#include "contact/proximity/rigid_bodies.hpp"
#include "contact/rules/contact_law.hpp"
#include "sim/changed_nodes.hpp"
#include "sim/world.hpp"

namespace weft::sim {

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
  tears_ = options.tears;
  sewing_ = options.sewing;
  WEFT_TRY(host, changed_model(scene_, assets, tears_, sewing_));
  for (std::size_t kind = 0; kind < kElementKinds; ++kind)
    element_counts_[kind] = host.count(static_cast<ElementKind>(kind));
  slivers_ = host.sliver_count();
  WEFT_TRY(plan, FramePlan::create(scene_, host, assets_));
  plan_ = std::move(plan);
  if (!given_colliders().empty())
    extents_ = collider_extents(scene_, host, assets_.objects, assets_.deformations);
  WEFT_TRY(model, GpuModel::create(device_, std::move(host)));
  model_ = std::move(model);
  WEFT_TRY(state, State::create(device_, model_.host, plan_.most_substeps(),
                                most_scripted(model_.host, scene_.time.frame)));
  state_ = std::move(state);
  const Method& method = plan_.method();
  WEFT_TRY(contact, contact::SceneContact::create(
                        device_, model_, state_, scene_, assets_,
                        {options.contact_room, plan_.most_substeps(), method.search_interval, plan_.step(),
                         solved_contact(scene_, method), options.workgroup_size}));
  contact_ = std::move(contact);
  scene::Solver settings = scene_.solver;
  settings.kind = method.kind;
  WEFT_TRY(solver,
           make_solver(settings, {device_, model_, state_, plan_.step(), contact_.contacts(),
                                  options.workgroup_size, options.two_steps, scene_.air.has_value()}));
  solver_ = std::move(solver);
  WEFT_TRY(surface, Surface::create(device_, model_, state_));
  surface_ = std::move(surface);
  WEFT_TRY(last_good, LastGood::create(device_, state_, method.history > 0, contact_.presses(),
                                       contact_.rigid() != nullptr ? &contact_.rigid()->words() : nullptr));
  last_good_ = std::move(last_good);
  WEFT_TRY(recorder, FrameRecorder::create(state_, *solver_, contact_, *last_good_, *surface_));
  recorder_ = std::move(recorder);
  WEFT_TRY(reports, ReportRing::create(device_, state_));
  reports_ = std::move(reports);
  motion_rows_.resize(3 * model_.host.motions.size() * plan_.most_substeps());
  grabs_.emplace(model_.host);
  std::vector<StepBlock> blocks(plan_.most_substeps());
  for (std::uint32_t s = 0; s < blocks.size(); ++s) {
    blocks[s].nodes = {model_.vertex_count(), s * 3 * static_cast<std::uint32_t>(model_.host.motions.size())};
    contact_.fill(blocks[s].contact, scene_, s);
    solver_->fill(blocks[s].method);
  }
  steps_ = FrameSteps(std::move(blocks), scene_.time.frame);
  steps_.set_air(scene_, 0);
  WEFT_CHECK(submit_rest());
  return device_.wait();  // in a browser, only now is it known whether all of this could be made
}

}  // namespace weft::sim
