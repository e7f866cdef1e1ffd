#include "method/mass_spring/advance_fabric.hpp"

#include "method/mass_spring/advance_gathered.hpp"

namespace weft {

Result<void> AdvanceFabric::create_forces(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  const auto kernel_of = [&](const std::string& name) {
    return gpu::create_shared_kernel(inputs.device, "method/mass_spring/" + name + ".wgsl", {},
                                     inputs.workgroup_size);
  };
  WEFT_TRY(membranes, kernel_of("fabric_membranes"));
  WEFT_SET(membranes_,
           gpu::Dispatch::create_by_parity(membranes, membranes->workgroups_of(fabric_.layout.triangles),
                                           [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                             return {fabric_.params,    fabric_.corners,   fabric_.slopes,
                                                     state.position[p], state.velocity[p], fabric_.forces};
                                           }));
  if (fabric_.layout.hinges == 0) return {};
  WEFT_SET(creases_, Creases::create(inputs.device, inputs.model.host, state, body, fabric_, fabric_.bends, 1,
                                     inputs.workgroup_size));
  WEFT_TRY(bends, kernel_of("fabric_bends"));
  WEFT_SET(bend_, gpu::Dispatch::create_by_parity(bends, bends->workgroups_of(fabric_.layout.hinges),
                                                  [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                    return {fabric_.params,      fabric_.hinges,
                                                            fabric_.rest_angles, state.position[p],
                                                            state.velocity[p],   fabric_.bends};
                                                  }));
  WEFT_TRY(moments, kernel_of("fabric_hinges"));
  WEFT_SET(moments_, gpu::Dispatch::create_by_parity(moments, moments->workgroups_of(fabric_.layout.hinges),
                                                     [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                       return {fabric_.params,    fabric_.hinges,
                                                               fabric_.couplings, state.position[p],
                                                               fabric_.bends,     fabric_.forces};
                                                     }));
  return {};
}

Result<AdvanceFabric> AdvanceFabric::create(const SolverInputs& inputs, const Body& body) {
  AdvanceFabric made;
  FabricBuffers& fabric = made.fabric_;
  WEFT_SET(fabric, FabricBuffers::create(inputs.device, inputs.model.host, body));
  WEFT_CHECK(fabric.create_forces(inputs.device, inputs.model.host, body));
  WEFT_CHECK(made.create_forces(inputs, body));
  WEFT_SET(made.advance_,
           create_advance_gathered(inputs, fabric.params, body.vertex_count, fabric.gathers, fabric.forces));
  return made;
}

void AdvanceFabric::record(gpu::ComputePass& pass) const {
  creases_.record(pass);
  for (const gpu::Dispatch* dispatch : {&membranes_, &bend_, &moments_, &advance_}) dispatch->record(pass);
}

}  // namespace weft
