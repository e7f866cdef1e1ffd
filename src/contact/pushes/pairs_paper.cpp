#include "contact/pushes/pairs_paper.hpp"

#include <algorithm>
#include <numeric>

namespace weft::contact {
namespace {

/// Object triangles that one invocation takes: enough to pay for its cloth triangle, few enough for a 10K
/// sheet over 50K triangles to fill the largest GPU (20,000 * 200 invocations).
constexpr std::uint32_t kChunk = 256;

std::vector<PairRange> split(std::uint64_t cloth_count, std::uint64_t object_count, std::uint64_t max_pairs) {
  const std::uint64_t most = std::max<std::uint64_t>(max_pairs / std::max<std::uint64_t>(cloth_count, 1), 1);
  std::vector<PairRange> ranges;
  for (std::uint64_t first = 0; first < object_count; first += most)
    ranges.push_back({static_cast<std::uint32_t>(first),
                      static_cast<std::uint32_t>(std::min(most, object_count - first)), kChunk});
  return ranges;
}

}  // namespace

Result<PairsPaper> PairsPaper::create(gpu::Device& device, const GpuModel& model, const State& state,
                                      const Contacts& contacts, std::span<const ObjectTriangle> triangles,
                                      std::uint64_t max_pairs, std::uint32_t workgroup_size) {
  PairsPaper paper;
  paper.workgroups_ =
      (model.triangle_count() + 2 * workgroup_size - 1) / (2 * workgroup_size);  // two an invocation
  if (paper.workgroups_ > device.limits().max_workgroups_per_dimension)
    return make_error(
        ErrorKind::Limit,
        "Brute force over %u cloth triangles needs %u workgroups, more than this adapter's limit of %u.",
        model.triangle_count(), paper.workgroups_, device.limits().max_workgroups_per_dimension);
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/pushes/paper.wgsl", {}, workgroup_size));
  paper.kernel_ = std::move(kernel);
  WEFT_TRY(buffer, gpu::Buffer<ObjectTriangle>::create_from(device, triangles, "object triangles"));
  paper.triangles_ = std::move(buffer);
  std::vector<std::uint32_t> ids(triangles.size());
  std::iota(ids.begin(), ids.end(), 0U);
  WEFT_TRY(id_buffer, gpu::Buffer<std::uint32_t>::create_from(device, ids, "object ids"));
  paper.ids_ = std::move(id_buffer);

  const std::vector<PairRange> ranges = split(model.triangle_count(), triangles.size(), max_pairs);
  WEFT_TRY(range_buffer, gpu::Buffer<PairRange>::create_from(device, ranges, "pair ranges",
                                                             gpu::kUniform | gpu::kCopyTarget));
  paper.ranges_ = std::move(range_buffer);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    Dispatch dispatch;
    dispatch.chunks = (ranges[i].count + kChunk - 1) / kChunk;
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group, paper.kernel_.bind({state.steps, state.position[1 - parity], state.position[parity],
                                          model.triangles, paper.triangles_, paper.ids_, contacts.pushes,
                                          state.statistics, paper.ranges_.range(i * sizeof(PairRange), 16)}));
      dispatch.groups[parity] = std::move(group);
    }
    paper.dispatches_.push_back(std::move(dispatch));
  }
  return paper;
}

void PairsPaper::record(gpu::ComputePass& pass) const {
  for (const Dispatch& dispatch : dispatches_)
    kernel_.dispatch_groups(pass, dispatch.groups[pass.parity()], {workgroups_, dispatch.chunks});
}

}  // namespace weft::contact
