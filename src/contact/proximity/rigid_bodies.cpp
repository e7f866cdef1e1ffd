#include "contact/proximity/rigid_bodies.hpp"

#include <cstring>

#include "contact/rules/rigid_body.hpp"
#include "gpu/readback.hpp"

namespace weft::contact {
namespace {

// As in src/contact/proximity/rigid_words.wgsl and move_rigid.wgsl.
constexpr std::uint32_t kPlace = 0, kTurn = 4, kVelocity = 8, kMomentum = 12, kKind = 32, kInverseMass = 33,
                        kExtent = 34, kFriction = 35, kHalf = 36, kRadius = 39, kInertia = 40, kMass = 43,
                        kCenter = 44, kFirst = 47, kAxes = 48, kCorners = 52, kFaces = 53, kEdges = 54,
                        kTouchVectors = 4;

class Words {
 public:
  explicit Words(std::span<std::uint32_t> words) : words_(words) {}
  void number(std::uint32_t at, double value) {
    const auto single = static_cast<float>(value);
    std::memcpy(&words_[at], &single, sizeof single);
  }
  void vector(std::uint32_t at, const Vec3d& v) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) number(at + axis, v[static_cast<int>(axis)]);
  }
  void quaternion(std::uint32_t at, const Quaternion& q) {
    for (std::uint32_t k = 0; k < 4; ++k) number(at + k, q[k]);
  }
  void whole(std::uint32_t at, std::size_t value) { words_[at] = static_cast<std::uint32_t>(value); }

 private:
  std::span<std::uint32_t> words_;
};

void write_rows(Words& words, const scene::RigidTransform& transform) {
  for (std::uint32_t row = 0; row < 3; ++row) {
    for (std::uint32_t column = 0; column < 3; ++column)
      words.number(kRigidRows + 4 * row + column, transform.rotation[3 * row + column]);
    words.number(kRigidRows + 4 * row + 3, transform.translation[static_cast<int>(row)]);
  }
}

void write_solid(Words words, const ColliderSolid& solid, std::vector<Vec4f>& hulls) {
  words.whole(kKind, static_cast<std::size_t>(solid.kind));
  words.number(kExtent, solid.extent);
  words.number(kFriction, solid.friction);
  words.vector(kHalf, solid.half);
  words.number(kRadius, solid.radius);
  words.vector(kCenter, solid.center);
  words.quaternion(kAxes, solid.axes);
  words.whole(kFirst, hulls.size());
  words.whole(kCorners, solid.points.size());
  words.whole(kFaces, solid.planes.size());
  for (const Vec3d& p : solid.points) hulls.push_back(Vec4f::from(p.to<float>(), 0));
  for (const auto& plane : solid.planes)
    hulls.push_back({static_cast<float>(plane[0]), static_cast<float>(plane[1]), static_cast<float>(plane[2]),
                     static_cast<float>(plane[3])});
  words.whole(kEdges, solid.edges.size());
  for (const auto& [start, end] : solid.edges) {
    hulls.push_back(Vec4f::from(start.to<float>(), 0));
    hulls.push_back(Vec4f::from((end - start).to<float>(), 0));
  }
  if (!solid.rigid()) return;
  const RigidState start = start_of(solid);
  words.vector(kPlace, start.place);
  words.quaternion(kTurn, start.turn);
  words.vector(kVelocity, start.velocity);
  words.vector(kMomentum, start.momentum);
  words.number(kInverseMass, 1 / solid.mass);
  words.number(kMass, solid.mass);
  words.vector(kInertia, solid.inertia);
  write_rows(words, {});
}

}  // namespace

Result<RigidBodies> RigidBodies::create(gpu::Device& device, const scene::Scene& scene,
                                        const ColliderMeshes& meshes, std::uint32_t workgroup_size) {
  RigidBodies made;
  made.any_ = scene::has_rigid(scene);
  made.colliders_ = made.any_ ? scene.colliders.size() : 0;
  std::vector<std::uint32_t> words(kRigidWords * made.colliders_);
  std::vector<Vec4f> hulls;
  if (made.any_) {
    const std::vector<ColliderSolid> solids = solids_of(scene, meshes.objects, meshes.object_colliders);
    for (std::size_t c = 0; c < solids.size(); ++c) {
      write_solid(Words(std::span(words).subspan(kRigidWords * c, kRigidWords)), solids[c], hulls);
      if (!solids[c].rigid()) continue;
      made.bodies_.push_back(static_cast<std::uint32_t>(c));
      made.solids_.push_back(solids[c]);
    }
  }
  WEFT_SET(made.words_, gpu::Buffer<std::uint32_t>::create_from(device, words, "rigid bodies"));
  if (!made.any_) return made;
  WEFT_SET(made.rest_, gpu::Buffer<std::uint32_t>::create_from(device, words, "rigid bodies at the start"));
  WEFT_SET(made.hulls_, gpu::Buffer<Vec4f>::create_from(device, hulls, "convex hulls"));
  const std::size_t touches = std::size_t{kTouchVectors} * kMostTouches * made.colliders_;
  WEFT_SET(made.touches_, gpu::Buffer<Vec4f>::create(device, touches, "touches of rigid bodies"));
  WEFT_SET(made.move_, gpu::Kernel::create(device, "contact/proximity/move_rigid.wgsl", {}, 64));
  WEFT_SET(made.gather_,
           gpu::Kernel::create(device, "contact/proximity/gather_rigid.wgsl", {}, workgroup_size));
  WEFT_SET(made.arrive_,
           gpu::Kernel::create(device, "contact/proximity/arrive_rigid.wgsl", {}, workgroup_size));
  return made;
}

Result<void> RigidBodies::bind(const State& state, const gpu::Buffer<ColliderPlace>& places) {
  if (!any_) return {};
  WEFT_SET(move_group_, move_.bind({state.steps, words_, hulls_, places, touches_, state.statistics}));
  WEFT_SET(gather_group_, gather_.bind({words_}));
  WEFT_SET(arrive_group_, arrive_.bind({state.steps, words_, state.statistics}));
  return {};
}

void RigidBodies::record_move(gpu::ComputePass& pass) const {
  if (any_) move_.dispatch_groups(pass, move_group_, {});
}
void RigidBodies::record_gather(gpu::ComputePass& pass) const {
  if (any_) gather_.dispatch(pass, gather_group_, colliders_);
}
void RigidBodies::record_arrive(gpu::ComputePass& pass) const {
  if (any_) arrive_.dispatch(pass, arrive_group_, colliders_);
}
void RigidBodies::record_rest(gpu::CommandList& list) const {
  if (any_) list.copy(rest_.source(), words_.source());
}

Result<std::vector<std::uint32_t>> RigidBodies::states(gpu::Device& device) const {
  std::vector<std::uint32_t> states;
  if (!any_) return states;
  WEFT_TRY(words, gpu::download(device, words_));
  for (const std::uint32_t c : bodies_) {
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(kRigidWords * c);
    states.insert(states.end(), first, first + kRigidStateWords);
  }
  return states;
}

void RigidBodies::set_states(gpu::Device& device, std::span<const std::uint32_t> states) const {
  const RigidWords numbers(states);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const std::uint32_t first = kRigidWords * bodies_[k];
    words_.write(device, states.subspan(kRigidStateWords * k, kRigidStateWords), first);
    const RigidState state = numbers.state(k);
    std::array<std::uint32_t, kRigidWords> drawn{};
    Words words(drawn);
    write_rows(words, transform_of(solids_[k], state.place, state.turn));
    words_.write(device, std::span(drawn).subspan(kRigidRows, 12), first + kRigidRows);
  }
}

RigidState RigidWords::state(std::size_t k) const {
  const auto number = [&](std::uint32_t at) {
    float value = 0;
    std::memcpy(&value, &states_[kRigidStateWords * k + at], sizeof value);
    return static_cast<double>(value);
  };
  const auto vector = [&](std::uint32_t at) { return Vec3d{number(at), number(at + 1), number(at + 2)}; };
  return {vector(kPlace),
          {number(kTurn), number(kTurn + 1), number(kTurn + 2), number(kTurn + 3)},
          vector(kVelocity),
          vector(kMomentum),
          {},
          {}};
}

}  // namespace weft::contact
