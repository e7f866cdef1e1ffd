#include "method/projection/project_solid.hpp"

#include "element/colors.hpp"
#include "element/tet/law.hpp"

namespace weft {

Result<ProjectSolid> ProjectSolid::create(const SolverInputs& inputs, const Body& body,
                                          Multipliers multipliers) {
  gpu::Device& device = inputs.device;
  const State& state = inputs.state;
  ProjectSolid made;
  WEFT_SET(made.solid_, SolidBuffers::create(device, inputs.model.host, body));
  const SolidLawBlock& law = made.solid_.layout.law;
  const Colors colors =
      color_elements(inputs.model.host.elements(ElementKind::Tet, body), inputs.model.vertex_count());
  for (std::uint32_t color = 0; color < colors.count(); ++color)
    WEFT_CHECK(made.colors_.add(device, static_cast<std::uint32_t>(colors.of(color).size())));
  WEFT_SET(made.order_,
           gpu::Buffer<std::uint32_t>::create_from(device, colors.elements, "tetrahedra by color"));
  WEFT_SET(made.multiplier_,
           gpu::Buffer<float>::create(device, kept_multipliers(multipliers, 9 * colors.elements.size()),
                                      "multipliers of tetrahedra"));
  for (const bool first : {true, false}) {
    std::vector<gpu::Constant> constants = sweep_constants(multipliers, !first);
    constants.push_back(
        {"kNeoHookean", law.energy == static_cast<std::uint32_t>(tet::Energy::NeoHookean) ? 1.0 : 0.0});
    constants.push_back({"kDamped", law.delay > 0 ? 1.0 : 0.0});
    WEFT_TRY(kernel, gpu::create_shared_kernel(device, "method/projection/project_tets.wgsl",
                                               std::move(constants), inputs.workgroup_size));
    WEFT_SET((first ? made.first_ : made.later_),
             made.colors_.dispatches(
                 kernel, [&](std::size_t p, const gpu::RawBuffer& color) -> gpu::Dispatch::Bindings {
                   return {state.steps,       made.solid_.params,  color,
                           made.order_,       made.solid_.corners, made.solid_.rests,
                           state.position[p], made.multiplier_,    state.position[1 - p]};
                 }));
  }
  return made;
}

void ProjectSolid::record(gpu::ComputePass& pass, bool first) const {
  for (const gpu::Dispatch& color : first ? first_ : later_) color.record(pass);
  for (auto color = later_.rbegin(); color != later_.rend(); ++color) color->record(pass);
}

}  // namespace weft
