#include "method/multigrid/fabric_system.hpp"

namespace weft {
namespace {

constexpr std::size_t kTermWords = 6;  // src/method/multigrid/membrane_term.wgsl
constexpr std::size_t kCordWords = 2;  // src/method/multigrid/cord_term.wgsl

}  // namespace

Result<void> FabricSystem::create_buffers(const CycleInputs& inputs, const Body& body,
                                          const ElementPairs& pairs, std::span<const BlockEntries> blocks) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  WEFT_SET(elements_, FabricBuffers::create(device, model, body));
  WEFT_CHECK(elements_.create_forces(device, model, body));
  WEFT_SET(creases_, Creases::create(device, model, inputs.state, body, elements_, elements_.bends, 1,
                                     inputs.workgroup_size));
  // Where there is no hinge, one of no stiffness is bound, of which no block has a part.
  std::vector<float> bounds;
  for (const double bound : hinge::stiffness_bounds(model.plate(body)))
    bounds.push_back(static_cast<float>(bound));
  if (bounds.empty()) bounds.push_back(0);
  WEFT_SET(bounds_, gpu::Buffer<float>::create_from(device, bounds, "bounds of hinges"));
  WEFT_SET(wings_, gpu::Buffer<Vec4f>::create(device, 4 * bounds.size(), "slopes of hinges"));
  WEFT_SET(terms_, gpu::Buffer<Vec4f>::create(
                       device, kTermWords * elements_.layout.triangles + kCordWords * elements_.cords.size(),
                       "membranes' matrix"));
  WEFT_SET(parts_, BlockParts::create(device, pairs, blocks));
  return {};
}

Result<FabricSystem> FabricSystem::create(const CycleInputs& inputs, const FabricKernels& kernels,
                                          const Body& body, const ElementPairs& pairs,
                                          std::span<const BlockEntries> blocks, const MeshSystem& mesh) {
  FabricSystem made;
  WEFT_CHECK(made.create_buffers(inputs, body, pairs, blocks));
  const FabricBuffers& own = made.elements_;
  const gpu::RawBuffer& steps = inputs.state.steps;
  const auto add = [&](const gpu::SharedKernel& kernel, std::uint64_t count,
                       const gpu::Dispatch::Bindings& bindings) -> Result<void> {
    if (count == 0) return {};
    WEFT_TRY(stage, gpu::Dispatch::create(kernel, kernel->workgroups_of(count), bindings));
    made.stages_.push_back(std::move(stage));
    return {};
  };
  WEFT_CHECK(add(kernels.membranes, own.layout.triangles,
                 {steps, own.params, mesh.levels, own.corners, own.slopes, mesh.place, mesh.vectors,
                  made.terms_, own.forces}));
  WEFT_CHECK(add(kernels.hinges, own.layout.hinges,
                 {steps, own.params, mesh.levels, own.hinges, own.rest_angles, made.bounds_, mesh.place,
                  mesh.vectors, made.wings_, own.bends}));
  WEFT_CHECK(add(kernels.forces, own.layout.hinges,
                 {own.params, own.couplings, made.wings_, own.bends, own.forces}));
  WEFT_CHECK(
      add(kernels.cords, own.cords.size(),
          {steps, own.params, mesh.levels, own.cords, mesh.place, mesh.vectors, made.terms_, own.forces}));
  WEFT_CHECK(add(kernels.blocks, blocks.size(),
                 {mesh.levels, mesh.place, made.terms_, own.slopes, made.wings_, made.parts_.parts,
                  made.parts_.targets, mesh.entries, mesh.blocks}));
  return made;
}

}  // namespace weft
