#include "method/multigrid/solid_system.hpp"

namespace weft {
namespace {

constexpr std::size_t kTetTermWords = 9;  // src/method/multigrid/solid_term.wgsl

}  // namespace

Result<SolidSystem> SolidSystem::create(const CycleInputs& inputs, const SolidKernels& kernels,
                                        const multigrid::SystemBodies& bodies, const ElementPairs& pairs,
                                        std::span<const BlockEntries> blocks, const MeshSystem& mesh) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  SolidSystem made;
  std::uint32_t tets = 0;
  for (const Body& body : bodies.bodies) {
    WEFT_TRY(own, SolidBuffers::create(device, model, body, bodies.first_vertex(), tets));
    tets += own.layout.tets;
    made.elements_.push_back(std::move(own));
  }
  WEFT_SET(made.terms_, gpu::Buffer<Vec4f>::create(device, kTetTermWords * tets, "tetrahedra's matrix"));
  WEFT_SET(made.forces_, gpu::Buffer<Vec4f>::create(device, std::size_t{4} * tets, "forces of tetrahedra"));
  WEFT_SET(made.gathers_, gpu::Buffer<std::uint32_t>::create_from(
                              device, tet_corners_of_nodes(model, bodies.bodies), "tetrahedra of nodes"));
  WEFT_SET(made.parts_, BlockParts::create(device, pairs, blocks));
  for (const SolidBuffers& own : made.elements_) {
    WEFT_TRY(terms, gpu::Dispatch::create(kernels.terms, kernels.terms->workgroups_of(own.layout.tets),
                                          {inputs.state.steps, own.params, mesh.levels, own.corners,
                                           own.rests, mesh.place, mesh.vectors, made.terms_, made.forces_}));
    made.stages_.push_back(std::move(terms));
  }
  WEFT_TRY(sums, gpu::Dispatch::create(kernels.blocks, kernels.blocks->workgroups_of(blocks.size()),
                                       {mesh.levels, mesh.place, made.terms_, made.parts_.parts,
                                        made.parts_.targets, mesh.entries, mesh.blocks}));
  made.stages_.push_back(std::move(sums));
  return made;
}

}  // namespace weft
