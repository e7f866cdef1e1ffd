#include "contact/pushes/colliders_convex.hpp"

#include <limits>

namespace weft::contact {

Result<CollidersConvex> CollidersConvex::create(gpu::Device& device, const GpuModel& model,
                                                const State& state, const Contacts& contacts,
                                                std::span<const mesh::TriangleMesh> hulls,
                                                std::uint32_t workgroup_size) {
  CollidersConvex convex;
  convex.pairs_ = std::uint64_t{model.triangle_count()} * hulls.size();
  if (convex.pairs_ > std::numeric_limits<std::uint32_t>::max())
    return make_error(ErrorKind::Limit,
                      "%u cloth triangles and %zu convex bodies are more pairs than can be numbered.",
                      model.triangle_count(), hulls.size());
  WEFT_TRY(data, convex_bodies(hulls));
  WEFT_TRY(kernel, gpu::Kernel::create(device, "contact/pushes/convex.wgsl", {}, workgroup_size));
  convex.kernel_ = std::move(kernel);
  WEFT_TRY(bodies, gpu::Buffer<ConvexBody>::create_from(device, data.bodies, "convex bodies"));
  convex.bodies_ = std::move(bodies);
  WEFT_TRY(places, gpu::Buffer<Vec4f>::create_from(device, data.places, "convex places"));
  convex.places_ = std::move(places);
  WEFT_TRY(words, gpu::Buffer<std::uint32_t>::create_from(device, data.words, "convex words"));
  convex.words_ = std::move(words);
  for (std::size_t parity = 0; parity < 2; ++parity) {
    WEFT_TRY(group, convex.kernel_.bind({state.steps, state.position[1 - parity], state.position[parity],
                                         model.triangles, convex.bodies_, convex.places_, convex.words_,
                                         contacts.pushes, state.statistics}));
    convex.groups_[parity] = std::move(group);
  }
  return convex;
}

void CollidersConvex::record(gpu::ComputePass& pass) const {
  kernel_.dispatch(pass, groups_[pass.parity()], pairs_);
}

}  // namespace weft::contact
