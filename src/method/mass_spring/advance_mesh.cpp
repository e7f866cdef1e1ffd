#include "method/mass_spring/advance_mesh.hpp"

namespace weft {

Result<AdvanceMesh> AdvanceMesh::create(const SolverInputs& inputs, const Body& body) {
  gpu::Device& device = inputs.device;
  const State& state = inputs.state;
  const Model& model = inputs.model.host;
  WEFT_TRY(built, build_neighbours(model.springs(body), model.incidence(ElementKind::Spring, body),
                                   body.first_vertex));
  MeshParams params;
  params.first = body.first_vertex;
  params.count = body.vertex_count;
  for (std::size_t kind = 0; kind < built.kinds.size(); ++kind)
    params.kinds[kind] = {built.kinds[kind].stiffness, built.kinds[kind].damping, 0, 0};
  AdvanceMesh made;
  WEFT_SET(made.slices_, gpu::Buffer<std::uint32_t>::create_from(device, built.slices, "neighbour slices"));
  WEFT_SET(made.neighbours_, gpu::Buffer<Neighbour>::create_from(device, built.entries, "neighbours"));
  WEFT_SET(made.params_, gpu::create_uniform(device, params, "mesh params"));
  const double damped = body.damping > 0 ? 1 : 0;
  WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/mass_spring/advance_mesh.wgsl",
                                             {{"kDamped", damped}}, inputs.workgroup_size));
  const gpu::Workgroups workgroups = kernel->workgroups_of(body.vertex_count);
  WEFT_SET(made.dispatch_,
           gpu::Dispatch::create_by_parity(kernel, workgroups, [&](std::size_t p) -> gpu::Dispatch::Bindings {
             return {state.steps,
                     made.params_,
                     made.slices_,
                     made.neighbours_,
                     state.position[p],
                     state.velocity[p],
                     inputs.model.rest_position,
                     state.motions,
                     state.position[1 - p],
                     *inputs.predicted()[p]};
           }));
  return made;
}

}  // namespace weft
