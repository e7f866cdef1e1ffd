#include "contact/proximity/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/proximity/feature_owners.hpp"
#include "contact/proximity/triangle_order.hpp"
#include "contact/rules/contact_law.hpp"
#include "mesh/sheet_rim.hpp"

namespace weft::contact {
namespace {

/// Of find_candidates: the triangles that walk a tree together, and by how many invocations. The more triangles there
/// are, the more of what they meet each of them asks in vain; with 128 invocations instead of 64 a search takes 0.3 and
/// 0.2 ms less where a sheet of 65,536 nodes lies on the dragon and on the armadillo (H100).
constexpr std::uint32_t kOwn = 64, kWalkers = 128;
/// Of find_candidates: the workgroups for the same triangles that share the trees out, at most.
constexpr std::uint32_t kMostShares = 4;
/// Of find_pairs: the candidates whose tests a workgroup shares out.
constexpr std::uint32_t kTesters = 128;

/// Friction is stored beside the bits of the owned features, in 24 bits as a multiple of 2^-17: up to 128, to
/// 4e-6.
std::uint32_t friction_bits(double friction) {
  return static_cast<std::uint32_t>(std::lround(friction * 131072)) << 8U;
}

/// Four distances a word.
void append_rims(std::vector<TreeWord>& trees, std::vector<float> rims) {
  rims.resize((rims.size() + 3) / 4 * 4, 0);
  for (std::size_t i = 0; i < rims.size(); i += 4) {
    std::array<std::uint32_t, 4> word{};
    std::memcpy(word.data(), &rims[i], sizeof word);
    trees.push_back({word[0], word[1], word[2], word[3]});
  }
}

/// A vertex's place at rest [m], and its cloth's number.
void append_rest(std::vector<TreeWord>& trees, const Model& model, bool joins) {
  for (std::size_t c = 0; c < model.bodies.size(); ++c)
    for (std::uint32_t v = 0; v < model.bodies[c].vertex_count; ++v) {
      const Vec3f place = model.rest_position[model.bodies[c].first_vertex + v].to<float>();
      std::array<std::uint32_t, 3> word{};
      std::memcpy(word.data(), &place, sizeof word);
      trees.push_back({word[0], word[1], word[2], contact_number(model, c, joins)});
    }
}

}  // namespace

Result<PairSearch> PairSearch::create(gpu::Device& device, const GpuModel& model, const State& state,
                                      const ContactPairs& pairs, const scene::Scene& scene,
                                      const ColliderMeshes& meshes, const SearchSetup& setup) {
  PairSearch made;
  made.vertex_count_ = model.vertex_count();
  made.triangle_count_ = model.triangle_count();
  made.setup_ = setup;
  WEFT_CHECK(made.create_buffers(device, model, scene, meshes));
  WEFT_CHECK(made.create_trees(device, state, pairs, setup.workgroup_size));
  WEFT_CHECK(made.create_kernels(device, state, pairs));
  WEFT_CHECK(made.bind_lists(device, state, pairs));
  return made;
}

Result<void> PairSearch::create_buffers(gpu::Device& device, const GpuModel& model, const scene::Scene& scene,
                                        const ColliderMeshes& meshes) {
  tree_ = ImplicitTree(triangle_count_);
  std::vector<TreeWord> trees = tree_.words(), triangles;
  order_ = cloth_order(model.host);
  if (setup_.self_thickness > 0) patch_table_ = PatchTable(model.host);
  patch_table_.write_cells(tree_, order_, trees);
  WEFT_TRY(colliders,
           ColliderSet::create(scene, meshes, static_cast<std::uint32_t>(trees.size()), triangle_count_));
  colliders_ = std::move(colliders);
  trees.insert(trees.end(), colliders_.trees.begin(), colliders_.trees.end());

  std::vector<mesh::Triangle> ordered;
  for (const std::uint32_t t : order_) ordered.push_back(model.host.triangles[t]);
  const std::vector<std::uint32_t> owned = feature_owners(ordered);
  std::size_t body = 0;
  for (std::size_t t = 0; t < ordered.size(); ++t) {
    const auto& bodies = model.host.bodies;
    while (body + 1 < bodies.size() && order_[t] >= bodies[body + 1].first_triangle) ++body;
    triangles.push_back(
        {ordered[t][0], ordered[t][1], ordered[t][2], owned[t] | friction_bits(scene.cloths[body].friction)});
  }
  triangles.insert(triangles.end(), colliders_.triangles.begin(), colliders_.triangles.end());

  first_opposite_ = static_cast<std::uint32_t>(trees.size());
  const std::vector<mesh::Triangle> opposite = opposite_corners(ordered);
  for (std::size_t t = 0; t < opposite.size(); ++t)
    trees.push_back({opposite[t][0], opposite[t][1], opposite[t][2], patch_table_.cell_of(order_[t])});
  first_rim_ = static_cast<std::uint32_t>(trees.size());
  std::vector<float> rims;
  for (const double rim : rim_distances(model.host.rest_position, model.host.triangles))
    rims.push_back(static_cast<float>(rim));
  rims.insert(rims.end(), colliders_.rims.begin(), colliders_.rims.end());
  append_rims(trees, std::move(rims));
  first_rest_ = static_cast<std::uint32_t>(trees.size());
  append_rest(trees, model.host, setup_.joins);

  WEFT_TRY(tree_buffer, gpu::Buffer<TreeWord>::create_from(device, trees, "trees"));
  trees_ = std::move(tree_buffer);
  WEFT_TRY(triangle_buffer, gpu::Buffer<TreeWord>::create_from(device, triangles, "ordered triangles"));
  triangles_ = std::move(triangle_buffer);
  WEFT_TRY(points, gpu::Buffer<Vec4f>::create_from(device, colliders_.points, "collider points"));
  points_ = std::move(points);
  WEFT_SET(most_slack_, gpu::Buffer<float>::create_from(device, setup_.most_slack, "most slack"));
  std::vector<TreeWord> list = colliders_.list;
  list.resize(kMostColliders);
  WEFT_TRY(list_buffer,
           gpu::Buffer<TreeWord>::create_from(device, list, "colliders", gpu::kUniform | gpu::kCopyTarget));
  collider_list_ = std::move(list_buffer);
  return {};
}

Result<void> PairSearch::create_trees(gpu::Device& device, const State& state, const ContactPairs& pairs,
                                      std::uint32_t workgroup_size) {
  WEFT_TRY(refit, TreeRefit::create(device, workgroup_size));
  refit_ = std::move(refit);
  WEFT_CHECK(refit_.add(device, state.steps, tree_, 0, triangle_count_, pairs.predicted, triangles_,
                        state.statistics, trees_));
  for (std::size_t i = 0; i < colliders_.implicit.size(); ++i)
    WEFT_CHECK(refit_.add(device, state.steps, colliders_.implicit[i], colliders_.implicit_first[i],
                          colliders_.implicit_count[i], points_, triangles_, state.statistics, trees_));
  return {};
}

Result<void> PairSearch::create_begin(gpu::Device& device, const State& state, const ContactPairs& pairs) {
  const std::uint32_t size = setup_.workgroup_size;
  const gpu::Constant interval{"kDetectInterval", static_cast<double>(setup_.interval)};
  const auto begin = [&](bool early) {
    return gpu::Kernel::create(
        device, "contact/proximity/detect_begin.wgsl",
        {interval, {"kPredicted", early ? 0.0 : 1.0}, {"kIsFirst", early || !setup_.presses ? 1.0 : 0.0}},
        size);
  };
  if (expects_blows())
    WEFT_SET(expect_blows_, gpu::Kernel::create(device, "contact/proximity/expect_blows.wgsl", {}, size));
  WEFT_SET(leave_reach_, gpu::Kernel::create(device, "contact/proximity/leave_reach.wgsl", {interval}, size));
  WEFT_SET(detect_begin_, begin(false));
  if (setup_.presses) WEFT_SET(early_begin_, begin(true));
  for (std::size_t parity = 0; parity < 2; ++parity) {
    const auto &start = state.position[parity], &end = state.position[1 - parity];
    const auto bind = [&](const gpu::Kernel& kernel, const gpu::Buffer<Vec4f>& motion) {
      return kernel.bind({state.steps, start, motion, pairs.predicted, pairs.vertex_contacts,
                          state.statistics, most_slack_});
    };
    WEFT_SET(leave_groups_[parity],
             leave_reach_.bind({state.steps, start, end, pairs.predicted, state.statistics}));
    WEFT_SET(begin_groups_[parity], bind(detect_begin_, end));
    if (setup_.presses) WEFT_SET(early_groups_[parity], bind(early_begin_, state.velocity[parity]));
  }
  return {};
}

Result<void> PairSearch::create_kernels(gpu::Device& device, const State& state, const ContactPairs& pairs) {
  WEFT_CHECK(create_begin(device, state, pairs));
  WEFT_SET(patches_, ClothPatches::create(device, patch_table_, state, pairs, setup_.separations,
                                          setup_.workgroup_size));
  WEFT_SET(find_candidates_,
           gpu::Kernel::create(device, "contact/proximity/find_candidates.wgsl", {}, kWalkers));
  WEFT_SET(find_pairs_, gpu::Kernel::create(device, "contact/proximity/find_pairs.wgsl", {}, kTesters));
  WEFT_SET(kept_, KeptForces::create(device, setup_.presses, setup_.workgroup_size));
  return {};
}

Result<void> PairSearch::bind_lists(gpu::Device& device, const State& state, const ContactPairs& pairs) {
  room_ = pairs.room;
  SearchParams params{triangle_count_, static_cast<std::uint32_t>(colliders_.list.size())};
  params.self_contact = setup_.self_thickness > 0 ? 1 : 0;
  params.first_row = 4 * colliders_.point_count;
  params.candidate_capacity = room_.candidates;
  params.pair_capacity = room_.pairs;
  params.thickness = setup_.thickness;
  params.self_thickness = setup_.self_thickness;
  params.vertex_count = vertex_count_;
  params.first_opposite = first_opposite_;
  params.first_rim = first_rim_;
  params.first_rest = first_rest_;
  params.patch_columns = patch_table_.columns;
  WEFT_SET(params_, gpu::create_uniform(device, params, "search params"));
  using Candidate = std::array<std::uint32_t, 2>;
  candidates_ = {};  // freed before the larger one is allocated
  WEFT_TRY(candidates, gpu::Buffer<Candidate>::create(device, room_.candidates, "contact candidates"));
  candidates_ = std::move(candidates);
  WEFT_TRY(broad_group, find_candidates_.bind({params_, collider_list_, pairs.predicted, triangles_, trees_,
                                               points_, candidates_, state.statistics, patches_.openness()}));
  candidate_group_ = std::move(broad_group);
  WEFT_TRY(narrow_group, find_pairs_.bind({params_, pairs.predicted, triangles_, trees_, points_, candidates_,
                                           pairs.listed, pairs.vertex_contacts, state.statistics}));
  find_group_ = std::move(narrow_group);
  for (std::size_t parity = 0; expects_blows() && parity < 2; ++parity)
    WEFT_SET(
        expect_groups_[parity],
        expect_blows_.bind({state.steps, state.position[parity], state.position[1 - parity], pairs.predicted,
                            points_, pairs.listed, pairs.contacts, pairs.vertex_contacts, state.statistics}));
  return kept_.bind(state, pairs);
}

void PairSearch::record_early(gpu::ComputePass& pass) const {
  early_begin_.dispatch(pass, early_groups_[pass.parity()], vertex_count_);
  record_lists(pass, true, true);
}

void PairSearch::record(gpu::ComputePass& pass) const {
  if (expects_blows()) expect_blows_.dispatch_strided(pass, expect_groups_[pass.parity()], room_.pairs);
  leave_reach_.dispatch(pass, leave_groups_[pass.parity()], vertex_count_);
  detect_begin_.dispatch(pass, begin_groups_[pass.parity()], vertex_count_);
  record_lists(pass, !setup_.presses, false);
}

void PairSearch::record_lists(gpu::ComputePass& pass, bool starts, bool early) const {
  kept_.record_search(pass, starts);
  refit_.record(pass);
  patches_.record_search(pass, early);
  gpu::Workgroups walks = find_candidates_.workgroups_of(kWalkers * ((triangle_count_ + kOwn - 1) / kOwn));
  walks.z = std::min(kMostShares, 1 + static_cast<std::uint32_t>(colliders_.list.size()));
  find_candidates_.dispatch_groups(pass, candidate_group_, walks);
  find_pairs_.dispatch_strided(pass, find_group_, room_.candidates);
}

}  // namespace weft::contact
