#include "method/mass_spring/advance_fabric.hpp"

#include <cstring>

#include "element/incidence.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// Each node's triangles and hinges, as entries of the forces: rows, then their entries.
std::vector<std::uint32_t> gathers_of(const ElementTable& membranes, const ElementTable& hinges,
                                      const Body& body) {
  std::vector<std::uint32_t> nodes = membranes.nodes;  // of the forces, in their order
  nodes.insert(nodes.end(), hinges.nodes.begin(), hinges.nodes.end());
  const mesh::Adjacency forces = places_in(nodes, body.first_vertex, body.vertex_count);
  std::vector<std::uint32_t> gathers = forces.offsets;
  for (std::uint32_t& row : gathers) row += body.vertex_count + 1;
  gathers.insert(gathers.end(), forces.entries.begin(), forces.entries.end());
  return gathers;
}

/// The rows of moments by bends, then their entries: a hinge, and the bits of N·m.
std::vector<std::array<std::uint32_t, 2>> couplings_of(const hinge::Plate& plate) {
  const std::vector<hinge::Coupling> couplings = hinge::couplings(plate);
  const auto rows = static_cast<std::uint32_t>(plate.hinges.size());
  std::vector<std::array<std::uint32_t, 2>> words(rows);
  words.reserve(rows + couplings.size());
  for (const hinge::Coupling& coupling : couplings) {
    const auto at = static_cast<std::uint32_t>(words.size());
    std::array<std::uint32_t, 2>& row = words[coupling.row];
    if (row[0] == 0) row[0] = at;
    row[1] = at + 1;
    const auto entry = static_cast<float>(coupling.entry);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &entry, sizeof bits);
    words.push_back({coupling.column, bits});
  }
  return words;
}

}  // namespace

Result<void> AdvanceFabric::create_buffers(const SolverInputs& inputs, const Body& body) {
  gpu::Device& device = inputs.device;
  const Model& model = inputs.model.host;
  const ElementTable &membranes = model.elements(ElementKind::Membrane, body),
                     &hinges = model.elements(ElementKind::Hinge, body);
  const membrane::Law law = membrane_law(*body.fabric);
  const Stiffness& c = law.stiffness;
  layout_ = {body.first_vertex,
             body.vertex_count,
             static_cast<std::uint32_t>(membranes.size()),
             static_cast<std::uint32_t>(hinges.size()),
             {Vec4f::from(Vec3d{c.warp, c.coupled, c.weft}.to<float>(), static_cast<float>(c.shear)),
              static_cast<float>(law.delay), static_cast<std::uint32_t>(law.energy)}};
  WEFT_SET(params_, gpu::create_uniform(device, layout_, "fabric"));
  WEFT_SET(corners_, gpu::Buffer<std::uint32_t>::create_from(device, membranes.nodes, "membranes"));
  std::vector<Vec4f> slopes;
  for (std::size_t t = 0; t < membranes.size(); ++t)
    slopes.push_back({membranes.rest[4 * t], membranes.rest[4 * t + 1], membranes.rest[4 * t + 2],
                      membranes.rest[4 * t + 3]});
  WEFT_SET(slopes_, gpu::Buffer<Vec4f>::create_from(device, slopes, "membranes at rest"));
  WEFT_SET(gathers_, gpu::Buffer<std::uint32_t>::create_from(device, gathers_of(membranes, hinges, body),
                                                             "forces of nodes"));
  WEFT_SET(forces_,
           gpu::Buffer<Vec4f>::create(device, 3 * membranes.size() + 4 * hinges.size(), "forces of fabric"));
  if (hinges.size() == 0) return {};
  std::vector<Four> nodes;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const auto four = hinges.nodes_of(h);
    nodes.push_back({four[0], four[1], four[2], four[3]});
  }
  WEFT_SET(hinges_, gpu::Buffer<Four>::create_from(device, nodes, "hinges"));
  WEFT_SET(rest_angles_, gpu::Buffer<float>::create_from(device, hinges.rest, "angles at rest"));
  WEFT_SET(bends_, gpu::Buffer<float>::create(device, hinges.size(), "bends"));
  WEFT_SET(couplings_,
           gpu::Buffer<Two>::create_from(device, couplings_of(plate_of(model, body)), "moments by bends"));
  return {};
}

Result<void> AdvanceFabric::create_forces(const SolverInputs& inputs) {
  const State& state = inputs.state;
  const auto kernel_of = [&](const std::string& name) {
    return gpu::create_shared_kernel(inputs.device, "method/mass_spring/" + name + ".wgsl", {},
                                     inputs.workgroup_size);
  };
  WEFT_TRY(membranes, kernel_of("fabric_membranes"));
  WEFT_SET(membranes_, gpu::Dispatch::create_by_parity(membranes, membranes->workgroups_of(layout_.triangles),
                                                       [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                         return {params_,           corners_,
                                                                 slopes_,           state.position[p],
                                                                 state.velocity[p], forces_};
                                                       }));
  if (layout_.hinges == 0) return {};
  WEFT_TRY(bends, kernel_of("fabric_bends"));
  WEFT_SET(bend_,
           gpu::Dispatch::create_by_parity(
               bends, bends->workgroups_of(layout_.hinges), [&](std::size_t p) -> gpu::Dispatch::Bindings {
                 return {params_, hinges_, rest_angles_, state.position[p], state.velocity[p], bends_};
               }));
  WEFT_TRY(moments, kernel_of("fabric_hinges"));
  WEFT_SET(moments_, gpu::Dispatch::create_by_parity(moments, moments->workgroups_of(layout_.hinges),
                                                     [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                       return {params_,           hinges_, couplings_,
                                                               state.position[p], bends_,  forces_};
                                                     }));
  return {};
}

Result<AdvanceFabric> AdvanceFabric::create(const SolverInputs& inputs, const Body& body) {
  const State& state = inputs.state;
  AdvanceFabric made;
  WEFT_CHECK(made.create_buffers(inputs, body));
  WEFT_CHECK(made.create_forces(inputs));
  WEFT_TRY(kernel, gpu::create_shared_kernel(inputs.device, "method/mass_spring/advance_fabric.wgsl", {},
                                             inputs.workgroup_size));
  WEFT_SET(made.advance_, gpu::Dispatch::create_by_parity(kernel, kernel->workgroups_of(body.vertex_count),
                                                          [&](std::size_t p) -> gpu::Dispatch::Bindings {
                                                            return {state.steps,
                                                                    made.params_,
                                                                    made.gathers_,
                                                                    made.forces_,
                                                                    state.position[p],
                                                                    state.velocity[p],
                                                                    inputs.model.rest_position,
                                                                    state.motions,
                                                                    state.position[1 - p],
                                                                    *inputs.predicted()[p]};
                                                          }));
  return made;
}

void AdvanceFabric::record(gpu::ComputePass& pass) const {
  for (const gpu::Dispatch* dispatch : {&membranes_, &bend_, &moments_, &advance_}) dispatch->record(pass);
}

}  // namespace weft
