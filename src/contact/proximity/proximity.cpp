#include "contact/proximity/proximity.hpp"

#include <algorithm>
#include <cmath>

#include "contact/proximity/feature_rings.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact/rules/yielding_edges.hpp"

namespace weft::contact {
namespace {

double farthest(const Model& model) {
  double most = 0;
  for (const Vec3d& p : model.rest_position)
    most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most;
}

}  // namespace

Result<ProximityLengths> proximity_lengths(const Model& model, const scene::Contact& contact) {
  const double thickness = contact.thickness;
  if (!(thickness > 0))
    return input_error("contact.thickness is %g m; proximity needs more than 0.", thickness);
  // Positions are rounded to 2^-24 of their size; a gap of a hundredth of the thickness has to be told from
  // none.
  const double rounding = farthest(model) / 16777216;
  if (thickness < 100 * rounding)
    return input_error(
        "contact.thickness is %g m; %g m from the origin proximity needs at least %.3g m, a hundred steps of "
        "f32.",
        thickness, farthest(model), 100 * rounding);
  ProximityLengths lengths;
  lengths.thickness = thickness;
  if (contact.self) lengths.self_thickness = self_thickness(model, thickness);
  lengths.most_reach = flat_reach(model, contact);
  return lengths;
}

Result<Proximity> Proximity::create(gpu::Device& device, const GpuModel& model, const State& state,
                                    const ContactPairs& pairs, const scene::Scene& scene,
                                    const ColliderMeshes& meshes, const ProximitySetup& wanted) {
  Proximity made;
  made.interval_ = wanted.interval;
  made.presses_ = pairs.presses.size() > 0;
  made.holds_pairs_ = pairs.pair_sums.size() > 0;
  made.substeps_ = wanted.substeps;
  WEFT_TRY(lengths, proximity_lengths(model.host, scene.contact));
  made.lengths_ = lengths;
  SearchSetup setup;
  setup.thickness = static_cast<float>(lengths.thickness);
  setup.self_thickness = static_cast<float>(lengths.self_thickness);
  setup.interval = wanted.interval;
  setup.separations = contact_iterations(wanted.step);
  setup.presses = made.presses_;
  setup.joins = wanted.solved.pairs;
  setup.workgroup_size = wanted.workgroup_size;
  for (const double slack : most_slacks(model.host, lengths.most_reach, lengths.self_thickness))
    setup.most_slack.push_back(static_cast<float>(slack));
  WEFT_TRY(search, PairSearch::create(device, model, state, pairs, scene, meshes, setup));
  made.search_ = std::move(search);
  const ColliderSet& colliders = made.search_.colliders();
  WEFT_TRY(rings,
           gpu::Buffer<std::uint32_t>::create_from(device,
                                                   feature_rings(model.vertex_count(), model.host.triangles,
                                                                 colliders.point_count, colliders.faces),
                                                   "feature rings"));
  made.rings_ = std::move(rings);
  WEFT_SET(made.rigid_, RigidBodies::create(device, scene, meshes, wanted.workgroup_size));
  WEFT_CHECK(made.create_kernels(device, state, wanted));
  WEFT_SET(made.near_, NearPairs::create(device, made.presses_, wanted.workgroup_size));
  const std::vector<LimitedEdge> edges = limited_edges(model.host);
  // What a rigid body gives to cloth it gets from cloth: a way that is shortened beside another would lose it.
  const YieldingEdges yielding =
      made.rigid_.any() ? YieldingEdges{} : yielding_edges(model.host, wanted.step);
  WEFT_TRY(respond,
           Respond::create(
               device, {wanted.interval, impulse_rule(model.host, scene.contact, wanted.step),
                        contact_iterations(wanted.step), lengths.self_thickness > 0, made.presses_,
                        wanted.solved.balances, made.rigid_.any(), edges, yielding.edges, yielding.time,
                        wanted.solved.pairs ? push_times(model.host) : PushTimes{}, wanted.workgroup_size}));
  made.respond_ = std::move(respond);
  WEFT_CHECK(made.bind_own(device, state, pairs));
  return made;
}

Result<void> Proximity::bind_lists(gpu::Device& device, const State& state, const ContactPairs& pairs) {
  WEFT_CHECK(search_.bind_lists(device, state, pairs));
  return bind_own(device, state, pairs);
}

Result<void> Proximity::bind_own(gpu::Device& device, const State& state, const ContactPairs& pairs) {
  pair_room_ = pairs.room.pairs;
  near_room_ = pairs.room.near;
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, evaluate_.bind({state.steps, state.position[parity], pairs.predicted, search_.points(),
                                    pairs.contacts, pairs.vertex_contacts, state.statistics, rings_,
                                    rigid_.words()}));
    evaluate_groups_[parity] = std::move(group);
    if (!presses_) continue;
    const auto bind_press = [&](const gpu::Buffer<Vec4f>& velocity) {
      return press_.bind({state.steps, state.position[parity], velocity, search_.points(), pairs.listed,
                          state.statistics, pairs.presses, rings_});
    };
    WEFT_SET(press_groups_[parity], bind_press(state.velocity[parity]));
    WEFT_SET(press_again_groups_[parity], bind_press(pairs.predicted));
    if (!holds_pairs_) continue;
    const auto bind_pairs = [&](const gpu::Buffer<Vec4f>& velocity) {
      return press_pairs_.bind({state.steps, state.position[parity], velocity, search_.points(),
                                pairs.contacts, state.statistics, rings_, pairs.pair_holds, pairs.pair_sums});
    };
    WEFT_SET(press_pair_groups_[parity], bind_pairs(state.velocity[parity]));
    WEFT_SET(press_pair_again_groups_[parity], bind_pairs(pairs.predicted));
  }
  WEFT_CHECK(near_.bind(state, pairs, search_.points()));
  return respond_.bind(device, state, pairs, search_.points(), rigid_.words());
}

Result<void> Proximity::create_kernels(gpu::Device& device, const State& state, const ProximitySetup& setup) {
  const std::uint32_t workgroup_size = setup.workgroup_size;
  const gpu::Constant own_pairs{"kOwnPairs", setup.solved.own_pairs ? 1.0 : 0.0};
  WEFT_TRY(evaluate, gpu::Kernel::create(device, "contact/proximity/evaluate.wgsl",
                                         {own_pairs, {"kRigid", rigid_.any() ? 1.0 : 0.0}}, workgroup_size));
  evaluate_ = std::move(evaluate);
  if (presses_) {
    const gpu::Constant forgets{"kForgets", setup.solved.without_history ? 1.0 : 0.0};
    WEFT_SET(press_, gpu::Kernel::create(device, "contact/proximity/press.wgsl", {forgets, own_pairs},
                                         workgroup_size));
    WEFT_SET(press_pairs_,
             gpu::Kernel::create(device, "contact/proximity/press_pairs.wgsl", {forgets}, workgroup_size));
  }
  const ColliderSet& colliders = search_.colliders();
  if (!colliders.moves) return {};
  rows_.resize(colliders.list.size() * (substeps_ + 1));
  WEFT_TRY(places, gpu::Buffer<ColliderPlace>::create(device, rows_.size(), "collider places"));
  places_ = std::move(places);
  WEFT_TRY(shapes, gpu::Buffer<Vec4f>::create_from(device, colliders.shapes, "collider shapes"));
  shapes_ = std::move(shapes);
  WEFT_TRY(move, gpu::Kernel::create(device, "contact/proximity/move_points.wgsl", {}, workgroup_size));
  move_points_ = std::move(move);
  WEFT_TRY(move_group, move_points_.bind({state.steps, places_, shapes_, search_.points()}));
  move_group_ = std::move(move_group);
  return rigid_.bind(state, places_);
}

void Proximity::write_places(gpu::Device& device, const scene::Scene& scene, double time, double step,
                             std::uint32_t substeps) {
  const ColliderSet& colliders = search_.colliders();
  if (!colliders.moves) return;
  const std::size_t count = colliders.list.size();
  for (std::uint32_t s = 0; s <= substeps; ++s)
    place_colliders(scene, colliders, time + s * step, step, std::span(rows_).subspan(s * count, count));
  places_.write(device, std::span(rows_).first((substeps + 1) * count));
}

void Proximity::move_colliders(gpu::ComputePass& pass) const {
  const ColliderSet& colliders = search_.colliders();
  rigid_.record_move(pass);
  if (colliders.moves)
    move_points_.dispatch(pass, move_group_,
                          std::max<std::size_t>(colliders.point_count, 4 * colliders.list.size()));
}

void Proximity::press(gpu::ComputePass& pass) const {
  if (!presses_) return;
  move_colliders(pass);
  if (pass.step() == 0) {
    pass.begin_phase("search");
    search_.record_early(pass);
    pass.begin_phase("step");
  }
  press_.dispatch_strided(pass, press_groups_[pass.parity()], pair_room_);
  if (pass.step() == 0 || holds_pairs_) near_.record_early(pass);
  if (!holds_pairs_) return;
  press_pairs_.dispatch_strided(pass, press_pair_groups_[pass.parity()], near_room_);
}

void Proximity::press_again(gpu::ComputePass& pass) const {
  if (!presses_) return;
  press_.dispatch_strided(pass, press_again_groups_[pass.parity()], pair_room_);
  if (!holds_pairs_) return;
  near_.record_again(pass);
  press_pairs_.dispatch_strided(pass, press_pair_again_groups_[pass.parity()], near_room_);
}

void Proximity::search(gpu::ComputePass& pass) const {
  if (!presses_) move_colliders(pass);
  if (pass.step() % interval_ != 0) return;
  pass.begin_phase("search");
  search_.record(pass);
  pass.begin_phase("step");
}

void Proximity::measure(gpu::ComputePass& pass) const {
  near_.record(pass);
  evaluate_.dispatch_strided(pass, evaluate_groups_[pass.parity()], near_room_);
  rigid_.record_gather(pass);
}

}  // namespace weft::contact
