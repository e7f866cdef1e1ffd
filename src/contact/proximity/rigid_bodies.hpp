#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/proximity/collider_set.hpp"
#include "contact/rules/rigid_body.hpp"
#include "gpu/kernel.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Words of a collider in the buffer of rigid bodies. Mirror of src/contact/proximity/rigid_words.wgsl.
inline constexpr std::uint32_t kRigidWords = 160;
/// Of these the state, which lasts, from the first on.
inline constexpr std::uint32_t kRigidStateWords = 32;
/// Where the three rows begin by which a body is drawn.
inline constexpr std::uint32_t kRigidRows = 128;

/// Those of the state as numbers.
class RigidWords {
 public:
  explicit RigidWords(std::span<const std::uint32_t> states) : states_(states) {}
  /// Of the k-th body.
  RigidState state(std::size_t k) const;

 private:
  std::span<const std::uint32_t> states_;
};

/// The rigid bodies of a scene: their motion, and what cloth gives them. Without any its buffer is there to be bound,
/// and nothing is recorded.
/// Reads   steps. Writes  places, of rigid colliders alone; statistics.
/// Errors  Shader, OutOfMemory. Source: docs/rigid.md.
class RigidBodies {
 public:
  RigidBodies() = default;
  static Result<RigidBodies> create(gpu::Device& device, const scene::Scene& scene,
                                    const ColliderMeshes& meshes, std::uint32_t workgroup_size);
  Result<void> bind(const State& state, const gpu::Buffer<ColliderPlace>& places);
  bool any() const { return any_; }
  /// kRigidWords for each collider, as bits.
  const gpu::Buffer<std::uint32_t>& words() const { return words_; }

  void record_move(gpu::ComputePass& pass) const;
  /// Between two iterations of impulses.
  void record_gather(gpu::ComputePass& pass) const;
  void record_arrive(gpu::ComputePass& pass) const;
  void record_rest(gpu::CommandList& list) const;

  /// Of each rigid body in the order of the colliders, kRigidStateWords.
  Result<std::vector<std::uint32_t>> states(gpu::Device& device) const;
  /// Puts them there, as many as there are.
  void set_states(gpu::Device& device, std::span<const std::uint32_t> states) const;
  std::size_t count() const { return bodies_.size(); }

 private:
  gpu::Kernel move_, gather_, arrive_;
  gpu::BindGroup move_group_, gather_group_, arrive_group_;
  gpu::Buffer<std::uint32_t> words_, rest_;
  gpu::Buffer<Vec4f> hulls_, touches_;
  std::vector<std::uint32_t> bodies_;  // the colliders that are rigid
  std::vector<ColliderSolid> solids_;  // of these
  std::size_t colliders_ = 0;
  bool any_ = false;
};

}  // namespace weft::contact
