#include "method/mass_spring/advance_solid.hpp"

#include "method/mass_spring/advance_gathered.hpp"

namespace weft {

Result<AdvanceSolid> AdvanceSolid::create(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  gpu::Device& device = inputs.device;
  AdvanceSolid made;
  WEFT_SET(made.solid_, SolidBuffers::create(device, inputs.model.host, body));
  WEFT_SET(made.gathers_, gpu::Buffer<std::uint32_t>::create_from(
                              device, tet_corners_of_nodes(inputs.model.host, body), "forces of nodes"));
  WEFT_SET(made.forces_, gpu::Buffer<Vec4f>::create(device, std::size_t{4} * made.solid_.layout.tets,
                                                    "forces of tetrahedra"));
  WEFT_TRY(tets, gpu::create_shared_kernel(device, "method/mass_spring/solid_forces.wgsl", {},
                                           inputs.workgroup_size));
  WEFT_SET(made.tets_, gpu::Dispatch::create_by_parity(tets, tets->workgroups_of(made.solid_.layout.tets),
                                                       [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                         return {made.solid_.params, made.solid_.corners,
                                                                 made.solid_.rests,  state.position[p],
                                                                 state.velocity[p],  made.forces_};
                                                       }));
  WEFT_SET(made.advance_, create_advance_gathered(inputs, made.solid_.params, body.vertex_count,
                                                  made.gathers_, made.forces_));
  return made;
}

void AdvanceSolid::record(gpu::ComputePass& pass) const {
  tets_.record(pass);
  advance_.record(pass);
}

}  // namespace weft
