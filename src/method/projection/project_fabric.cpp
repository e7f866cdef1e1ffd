#include "method/projection/project_fabric.hpp"

#include <string>

#include "element/membrane/law.hpp"

namespace weft {
namespace {

Result<gpu::SharedKernel> kernel_of(const SolverInputs& inputs, const std::string& name,
                                    std::vector<gpu::Constant> constants) {
  return gpu::create_shared_kernel(inputs.device, "method/projection/" + name + ".wgsl", std::move(constants),
                                   inputs.workgroup_size);
}

}  // namespace

Result<ProjectFabric::Ordered> ProjectFabric::ordered(const SolverInputs& inputs, const ElementTable& table,
                                                      std::span<const double> resistance,
                                                      std::size_t multipliers) const {
  const Colors colors = color_elements(table, inputs.model.vertex_count());
  Ordered made;
  std::vector<std::uint32_t> order;
  for (std::uint32_t color = 0; color < colors.count(); ++color) {
    const std::size_t before = order.size();
    for (const std::uint32_t element : colors.of(color))
      if (resistance.empty() || resistance[element] > 0) order.push_back(element);  // others hold nothing
    WEFT_CHECK(made.colors.add(inputs.device, static_cast<std::uint32_t>(order.size() - before)));
  }
  WEFT_SET(made.order, gpu::Buffer<std::uint32_t>::create_from(inputs.device, order, "elements by color"));
  WEFT_SET(made.multiplier, gpu::Buffer<float>::create(
                                inputs.device, kept_multipliers(multipliers_, multipliers), "multipliers"));
  return made;
}

Result<void> ProjectFabric::create_membranes(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  const MembraneLawBlock& law = fabric_.layout.law;
  const bool apart = law.energy == static_cast<std::uint32_t>(membrane::Energy::NeoHookean) && law.delay > 0;
  WEFT_SET(membranes_, ordered(inputs, inputs.model.host.elements(ElementKind::Membrane, body), {},
                               std::size_t{apart ? 6U : 3U} * fabric_.layout.triangles));
  for (const bool first : {true, false}) {
    std::vector<gpu::Constant> constants = sweep_constants(multipliers_, !first);
    constants.push_back({"kDampedApart", apart ? 1.0 : 0.0});
    WEFT_TRY(kernel, kernel_of(inputs, "project_membranes", std::move(constants)));
    WEFT_SET((first ? membranes_.first : membranes_.later),
             membranes_.colors.dispatches(
                 kernel, [&](std::size_t p, const gpu::RawBuffer& color) -> gpu::Dispatch::Bindings {
                   return {state.steps,       fabric_.params,        color,
                           membranes_.order,  fabric_.corners,       fabric_.slopes,
                           state.position[p], membranes_.multiplier, state.position[1 - p]};
                 }));
  }
  return {};
}

Result<void> ProjectFabric::create_hinges(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  WEFT_SET(bent_, BentHinges::create(inputs, body, fabric_));
  if (!bent_.resist) return {};
  WEFT_SET(hinges_, ordered(inputs, inputs.model.host.elements(ElementKind::Hinge, body), bent_.resistance,
                            bent_.resistance.size()));
  for (const bool first : {true, false}) {
    WEFT_TRY(kernel, kernel_of(inputs, "project_hinges", sweep_constants(multipliers_, !first)));
    WEFT_SET((first ? hinges_.first : hinges_.later),
             hinges_.colors.dispatches(
                 kernel, [&](std::size_t p, const gpu::RawBuffer& color) -> gpu::Dispatch::Bindings {
                   return {state.steps,        fabric_.params,       color,
                           hinges_.order,      fabric_.hinges,       fabric_.rest_angles,
                           fabric_.couplings,  bent_.bends,          state.position[p],
                           hinges_.multiplier, state.position[1 - p]};
                 }));
  }
  return {};
}

Result<ProjectFabric> ProjectFabric::create(const SolverInputs& inputs, const Body& body,
                                            Multipliers multipliers) {
  ProjectFabric made;
  made.multipliers_ = multipliers;
  WEFT_SET(made.fabric_, FabricBuffers::create(inputs.device, inputs.model.host, body));
  WEFT_CHECK(made.create_membranes(inputs, body));
  WEFT_CHECK(made.create_hinges(inputs, body));
  return made;
}

void ProjectFabric::record(gpu::ComputePass& pass, bool first) const {
  if (first) bent_.creases.record(pass);
  bent_.bend.record(pass);
  for (const Ordered* elements : {&hinges_, &membranes_})
    for (const gpu::Dispatch& color : first ? elements->first : elements->later) color.record(pass);
  for (auto color = membranes_.later.rbegin(); color != membranes_.later.rend(); ++color) color->record(pass);
  bent_.bend.record(pass);
  for (auto color = hinges_.later.rbegin(); color != hinges_.later.rend(); ++color) color->record(pass);
}

}  // namespace weft
