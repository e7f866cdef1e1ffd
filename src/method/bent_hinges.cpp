#include "method/bent_hinges.hpp"

#include <algorithm>

namespace weft {

Result<BentHinges> BentHinges::create(const SolverInputs& inputs, const Body& body,
                                      const FabricBuffers& fabric) {
  const State& state = inputs.state;
  BentHinges made;
  made.resistance = hinge::stiffness_bounds(inputs.model.host.plate(body));
  made.resist = std::any_of(made.resistance.begin(), made.resistance.end(), [](double k) { return k > 0; });
  if (!made.resist) return made;
  WEFT_SET(made.bends,
           (gpu::Buffer<std::array<float, 2>>::create(inputs.device, fabric.bend_count, "bends")));
  WEFT_SET(made.creases, Creases::create(inputs.device, inputs.model.host, state, body, fabric, made.bends, 2,
                                         inputs.workgroup_size));
  WEFT_TRY(kernel,
           gpu::create_shared_kernel(inputs.device, "method/bend_hinges.wgsl", {}, inputs.workgroup_size));
  WEFT_SET(made.bend, gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(fabric.layout.hinges),
                                                      [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                        return {state.steps,       fabric.params,
                                                                fabric.hinges,     fabric.rest_angles,
                                                                state.position[p], state.position[1 - p],
                                                                made.bends};
                                                      }));
  return made;
}

}  // namespace weft
