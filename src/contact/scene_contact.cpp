#include "contact/scene_contact.hpp"

#include <algorithm>
#include <cstring>

#include "contact/proximity/proximity.hpp"
#include "contact/pushes/pushes.hpp"
#include "contact/rules/contact_law.hpp"
#include "gpu/readback.hpp"

namespace weft::contact {
namespace {

PushSetup push_setup(const scene::Scene& scene, const Assets& assets, std::uint32_t workgroup_size) {
  PushSetup setup;
  setup.method = scene.contact.method;
  setup.thickness = scene.contact.thickness;
  for (std::size_t o = 0; o < assets.objects.size(); ++o) {
    const bool convex =
        std::holds_alternative<scene::ColliderConvex>(scene.colliders[assets.object_colliders[o]]);
    (convex ? setup.hulls : setup.objects).push_back(assets.objects[o]);
  }
  setup.workgroup_size = workgroup_size;
  for (const scene::Collider& collider : scene.colliders) {
    if (const auto* sphere = std::get_if<scene::ColliderSphere>(&collider)) setup.spheres.push_back(*sphere);
    if (const auto* plane = std::get_if<scene::ColliderPlane>(&collider)) setup.planes.push_back(*plane);
  }
  return setup;
}

/// The initial capacity of the lists; make_room makes them longer when they are short.
ContactRoom first_room(const GpuModel& model) {
  const std::uint32_t triangles = model.triangle_count();
  return {std::max(32768U, 2 * triangles), std::max(16384U, triangles / 2),
          std::max(131072U, 12 * triangles)};
}

}  // namespace

SceneContact::SceneContact() = default;
SceneContact::SceneContact(SceneContact&&) noexcept = default;
SceneContact& SceneContact::operator=(SceneContact&&) noexcept = default;
SceneContact::~SceneContact() = default;

Result<SceneContact> SceneContact::create(gpu::Device& device, const GpuModel& model, const State& state,
                                          const scene::Scene& scene, const Assets& assets,
                                          const SceneContactSetup& setup) {
  SceneContact made;
  made.interval_ = setup.interval;
  switch (scene.contact.method) {
    case scene::ContactMethod::Proximity:
      if (scene.contact.self || !scene.colliders.empty())
        WEFT_CHECK(made.create_proximity(device, model, state, scene, assets, setup));
      break;
    case scene::ContactMethod::Paper:
    case scene::ContactMethod::Bvh:
      if (!scene.colliders.empty())
        WEFT_CHECK(made.create_pushes(device, model, state, scene, assets, setup));
      break;
    case scene::ContactMethod::None:
      break;
  }
  return made;
}

Result<void> SceneContact::create_proximity(gpu::Device& device, const GpuModel& model, const State& state,
                                            const scene::Scene& scene, const Assets& assets,
                                            const SceneContactSetup& setup) {
  const ContactRoom room = setup.room ? *setup.room : first_room(model);
  WEFT_TRY(contacts, Contacts::create_pairs(device, model.host, room, setup.solved));
  contacts_ = std::move(contacts);
  WEFT_TRY(proximity, Proximity::create(device, model, state, *contacts_->pairs, scene,
                                        {assets.objects, assets.object_colliders, assets.deformations},
                                        {setup.most_substeps, setup.interval, setup.step, setup.solved,
                                         setup.workgroup_size}));
  proximity_ = std::make_unique<Proximity>(std::move(proximity));
  WEFT_TRY(counts, gpu::Buffer<float>::create(device, model.vertex_count(), "contact counts"));
  counts_ = std::move(counts);
  return {};
}

Result<void> SceneContact::create_pushes(gpu::Device& device, const GpuModel& model, const State& state,
                                         const scene::Scene& scene, const Assets& assets,
                                         const SceneContactSetup& setup) {
  WEFT_TRY(contacts, Contacts::create_pushes(device, model.host));
  contacts_ = std::move(contacts);
  WEFT_TRY(pushes,
           Pushes::create(device, model, state, *contacts_, push_setup(scene, assets, setup.workgroup_size)));
  pushes_ = std::make_unique<Pushes>(std::move(pushes));
  return {};
}

const Stages& SceneContact::stages() const {
  static const Stages none;
  if (pushes_) return *pushes_;
  if (proximity_) return *proximity_;
  return none;
}

void SceneContact::fill(StepBlock::Contact& part, const scene::Scene& scene, std::uint32_t substep) const {
  part.thickness = static_cast<float>(scene.contact.thickness);
  if (pushes_) {
    part.push_scale = pushes_->push_scale();
    part.max_push = pushes_->max_push();
  }
  if (!proximity_) return;
  const ProximityLengths& lengths = proximity_->lengths();
  part.self_thickness = static_cast<float>(lengths.self_thickness);
  part.most_reach = static_cast<float>(lengths.most_reach);
  part.restitution = static_cast<float>(scene.contact.restitution);
  part.point_count = proximity_->pair_search().colliders().point_count;
  part.first_place = substep * static_cast<std::uint32_t>(scene.colliders.size());
  part.detect = substep == 0 ? Detect::Always : substep % interval_ == 0 ? Detect::IfDue : Detect::No;
}

void SceneContact::write_places(gpu::Device& device, const scene::Scene& scene, double time, double step,
                                std::uint32_t substeps) {
  if (proximity_) proximity_->write_places(device, scene, time, step, substeps);
}

Result<void> SceneContact::make_room(gpu::Device& device, const State& state, const ContactRoom& wanted) {
  if (!proximity_) return {};
  ContactPairs& pairs = *contacts_->pairs;
  const ContactRoom room = grown(pairs.room, wanted, device.limits().max_storage_binding_size);
  if (room == pairs.room) return {};  // the frame is repeated for another reason
  if (const Result<void> made = pairs.make_room(device, room); !made)
    return make_error(made.error().kind, "%s In shorter substeps (time.substeps) contact lists fewer pairs.",
                      made.error().message.c_str());
  WEFT_CHECK(proximity_->bind_lists(device, state, pairs));
  return counter_ ? create_counter(device) : Result<void>{};
}

bool SceneContact::adapt(const Statistics& report) { return proximity_ && proximity_->adapt(report); }

void SceneContact::end_frame(gpu::ComputePass& pass) const {
  if (proximity_) proximity_->end_frame(pass);
}

void SceneContact::record_rest(gpu::CommandList& list) const {
  if (!proximity_) return;
  list.clear(contacts_->pairs->kept.range(0, 4 * kKeptRoomWord));
  if (presses() != nullptr) list.clear(presses()->source());
  proximity_->rigid().record_rest(list);
}

const RigidBodies* SceneContact::rigid() const {
  return proximity_ && proximity_->rigid().any() ? &proximity_->rigid() : nullptr;
}

Result<std::vector<std::uint32_t>> SceneContact::forces(gpu::Device& device) const {
  if (!proximity_) return std::vector<std::uint32_t>{};
  const gpu::Buffer<std::uint32_t>& kept = contacts_->pairs->kept;
  WEFT_TRY(header, gpu::download_bytes(device, kept.range(0, 4)));
  std::uint32_t count = 0;
  std::memcpy(&count, header.data(), sizeof count);
  std::vector<std::uint32_t> forces(std::size_t{kKeptWords} * count);
  if (count == 0) return forces;
  WEFT_TRY(bytes, gpu::download_bytes(device, kept.range(4 * kHeader, 4 * forces.size())));
  std::memcpy(forces.data(), bytes.data(), bytes.size());
  return forces;
}

Result<bool> SceneContact::set_forces(gpu::Device& device, const State& state,
                                      std::span<const std::uint32_t> forces) {
  if (!proximity_) return false;
  const auto count = static_cast<std::uint32_t>(forces.size() / kKeptWords);
  const ContactRoom& room = contacts_->pairs->room;
  const bool is_short = count > room.near;
  if (is_short) WEFT_CHECK(make_room(device, state, {room.pairs, count, room.candidates}));
  const gpu::Buffer<std::uint32_t>& kept = contacts_->pairs->kept;
  kept.write(device, std::span(&count, 1));
  kept.write(device, forces, kHeader);
  return is_short;
}

void SceneContact::record_forget(gpu::CommandList& list) const {
  if (!proximity_) return;
  list.clear(contacts_->pairs->vertex_contacts.source());
  if (contacts_->pairs->pair_sums.size() > 0) list.clear(contacts_->pairs->pair_sums.source());
  if (presses() != nullptr) list.clear(presses()->source());
}

const gpu::Buffer<std::int32_t>* SceneContact::presses() const {
  return proximity_ && contacts_->pairs->presses.size() > 0 ? &contacts_->pairs->presses : nullptr;
}

Result<std::vector<std::int32_t>> SceneContact::hold_forces(gpu::Device& device) const {
  if (presses() == nullptr) return std::vector<std::int32_t>{};
  std::vector<std::int32_t> forces(presses()->size() / (kHoldWords + kPressWords) * kHoldWords);
  WEFT_TRY(bytes, gpu::download_bytes(device, presses()->range(0, sizeof(std::int32_t) * forces.size())));
  std::memcpy(forces.data(), bytes.data(), bytes.size());
  return forces;
}

void SceneContact::set_hold_forces(gpu::Device& device, std::span<const std::int32_t> forces) {
  if (presses() != nullptr) presses()->write(device, forces);
}

Result<void> SceneContact::create_counter(gpu::Device& device) {
  WEFT_TRY(counter, ContactCounts::create(device, *contacts_->pairs, counts_));
  counter_ = std::move(counter);
  return {};
}

Result<void> SceneContact::count(gpu::Device& device, bool on) {
  counter_.reset();
  return on && proximity_ ? create_counter(device) : Result<void>{};
}

void SceneContact::record_counts(gpu::ComputePass& pass) const {
  if (counter_) counter_->record(pass);
}

}  // namespace weft::contact
