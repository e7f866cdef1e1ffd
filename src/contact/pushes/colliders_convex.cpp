#include "contact/pushes/colliders_convex.hpp"

#include <limits>

namespace weft::contact {

Result<CollidersConvex> CollidersConvex::create(gpu::Device& device, const GpuModel& model,
                                                const State& state, const Contacts& contacts,
                                                std::span<const mesh::TriangleMesh> hulls,
                                                std::uint32_t workgroup_size) {
  const std::uint64_t pairs = std::uint64_t{model.triangle_count()} * hulls.size();
  if (pairs > std::numeric_limits<std::uint32_t>::max())
    return make_error(ErrorKind::Limit,
                      "%u cloth triangles and %zu convex bodies are more pairs than can be numbered.",
                      model.triangle_count(), hulls.size());
  WEFT_TRY(data, convex_bodies(hulls));
  CollidersConvex made;
  WEFT_SET(made.bodies_, gpu::Buffer<ConvexBody>::create_from(device, data.bodies, "convex bodies"));
  WEFT_SET(made.places_, gpu::Buffer<Vec4f>::create_from(device, data.places, "convex places"));
  WEFT_SET(made.words_, gpu::Buffer<std::uint32_t>::create_from(device, data.words, "convex words"));
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "contact/pushes/convex.wgsl", {}, workgroup_size));
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(
               kernel, kernel->workgroups_of(pairs), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {state.steps,     state.position[1 - p], state.position[p],
                         model.triangles, made.bodies_,          made.places_,
                         made.words_,     contacts.pushes,       state.statistics};
               }));
  return made;
}

}  // namespace weft::contact
