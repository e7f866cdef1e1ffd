#pragma once

#include <array>
#include <cstdint>

#include "contact/proximity/cloth_patches.hpp"
#include "contact/proximity/collider_set.hpp"
#include "contact/proximity/kept_forces.hpp"
#include "contact/proximity/tree_refit.hpp"
#include "gpu/kernel.hpp"
#include "state/contact_pairs.hpp"
#include "state/state.hpp"

namespace weft::contact {

/// Mirror of SearchParams in src/contact/proximity/triangles.wgsl.
struct SearchParams {
  std::uint32_t triangle_count = 0, collider_count = 0, self_contact = 0, first_row = 0;
  std::uint32_t candidate_capacity = 0, pair_capacity = 0;
  float thickness = 0, self_thickness = 0;  // [m]
  std::uint32_t vertex_count = 0;
  std::uint32_t first_opposite = 0, first_rim = 0, first_rest = 0;  // words of `trees`
  std::uint32_t patch_columns = 0;
};
static_assert(sizeof(SearchParams) == 52);

/// The settings of a search.
struct SearchSetup {
  float thickness = 0, self_thickness = 0;  // [m]; the second 0: cloth does not meet cloth
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  std::uint32_t interval = 4;     // substeps from one that may search to the next
  std::size_t separations = 1;    // rounds in a substep that separate pairs of cloth
  bool presses = false;           // a solver asks for the lists before it predicts
  bool joins = false;             // its matrix has pairs, and all bodies with volume
  std::vector<float> most_slack;  // of each vertex [m]: weft::most_slacks
};

/// Finds and lists all pairs of features nearer than the thickness and how far both may go: broad phase,
/// narrow phase.
/// Eleven dispatches, which do nothing where no detection is due; twelve where blows are expected.
/// Reads   state.steps; state.position[parity] [m], at the start of the substep; where the solver has predicted that
///         vertices come, state.position[1 - parity], or their velocities, state.velocity[parity]; colliders' points.
/// Writes  pairs; state.statistics.
/// Errors  Input, Limit, Shader, OutOfMemory. Source: docs/contact.md.
class PairSearch {
 public:
  PairSearch() = default;
  static Result<PairSearch> create(gpu::Device& device, const GpuModel& model, const State& state,
                                   const ContactPairs& pairs, const scene::Scene& scene,
                                   const ColliderMeshes& meshes, const SearchSetup& setup);
  /// Takes over lists with other room. Errors  Limit, OutOfMemory.
  Result<void> bind_lists(gpu::Device& device, const State& state, const ContactPairs& pairs);
  /// Before the solver has predicted, by the velocities: in the first substep of a frame, which starts without lists.
  void record_early(gpu::ComputePass& pass) const;
  /// After it, by where vertices come.
  void record(gpu::ComputePass& pass) const;
  /// At the end of a frame: keeps the pairs' forces for the next one.
  void record_frame_end(gpu::ComputePass& pass) const { kept_.record_frame_end(pass); }

  const ColliderSet& colliders() const { return colliders_; }
  const gpu::Buffer<Vec4f>& points() const { return points_; }
  const gpu::Buffer<std::array<std::uint32_t, 2>>& candidates() const { return candidates_; }
  const ClothPatches& patches() const { return patches_; }
  /// The cloths' triangles in the order of their tree.
  const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  /// Whether steps are so long that a blow takes what it strikes out of its reach.
  bool expects_blows() const { return setup_.presses && setup_.self_thickness > 0; }
  Result<void> create_buffers(gpu::Device& device, const GpuModel& model, const scene::Scene& scene,
                              const ColliderMeshes& meshes);
  Result<void> create_begin(gpu::Device& device, const State& state, const ContactPairs& pairs);
  void record_lists(gpu::ComputePass& pass, bool starts, bool early) const;
  Result<void> create_trees(gpu::Device& device, const State& state, const ContactPairs& pairs,
                            std::uint32_t workgroup_size);
  Result<void> create_kernels(gpu::Device& device, const State& state, const ContactPairs& pairs);

  SearchSetup setup_;
  ColliderSet colliders_;
  std::vector<std::uint32_t> order_;
  std::uint32_t vertex_count_ = 0, triangle_count_ = 0;
  std::uint32_t first_opposite_ = 0, first_rim_ = 0, first_rest_ = 0;
  ContactRoom room_;
  ImplicitTree tree_;
  PatchTable patch_table_;
  ClothPatches patches_;
  gpu::Buffer<TreeWord> triangles_, trees_;
  gpu::Buffer<Vec4f> points_;
  gpu::Buffer<float> most_slack_;
  gpu::RawBuffer collider_list_, params_;
  gpu::Buffer<std::array<std::uint32_t, 2>> candidates_;
  TreeRefit refit_;
  KeptForces kept_;
  gpu::Kernel expect_blows_, leave_reach_, detect_begin_, early_begin_, find_candidates_, find_pairs_;
  std::array<gpu::BindGroup, 2> expect_groups_, leave_groups_, begin_groups_, early_groups_;  // by parity
  gpu::BindGroup candidate_group_, find_group_;
};

}  // namespace weft::contact
