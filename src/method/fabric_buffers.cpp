#include "method/fabric_buffers.hpp"

#include <cstring>

#include "element/incidence.hpp"
#include "model/fabric.hpp"

namespace weft {
namespace {

/// The rows of moments by bends, then their entries: a bend, and the bits of N·m. Of a cloth that keeps bends a row
/// ends with what creases take off: its facets' parts are behind the bends of hinges.
std::vector<std::array<std::uint32_t, 2>> couplings_of(const hinge::Plate& plate, bool keeps_bends) {
  const auto rows = static_cast<std::uint32_t>(plate.hinges.size());
  const std::vector<hinge::Coupling> of_hinges = hinge::couplings(plate),
                                     of_creases = keeps_bends ? hinge::crease_couplings(plate)
                                                              : std::vector<hinge::Coupling>();
  std::vector<std::array<std::uint32_t, 2>> words(rows);
  words.reserve(rows + of_hinges.size() + of_creases.size());
  auto hinge = of_hinges.begin();
  auto crease = of_creases.begin();
  for (std::uint32_t row = 0; row < rows; ++row) {
    const auto first = static_cast<std::uint32_t>(words.size());
    for (; hinge != of_hinges.end() && hinge->row == row; ++hinge)
      words.push_back({hinge->column, bits_of(hinge->entry)});
    for (; crease != of_creases.end() && crease->row == row; ++crease)
      words.push_back({rows + crease->column, bits_of(crease->entry)});
    words[row] = {first, static_cast<std::uint32_t>(words.size())};
  }
  return words;
}

}  // namespace

std::uint32_t bits_of(double value) {
  const auto number = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);  // libc++ 14 has no bit_cast
  return bits;
}

std::vector<std::uint32_t> rows_then_entries(std::span<const std::uint32_t> starts,
                                             std::span<const std::uint32_t> entries) {
  std::vector<std::uint32_t> words(starts.begin(), starts.end());
  for (std::uint32_t& row : words) row += static_cast<std::uint32_t>(starts.size());
  words.insert(words.end(), entries.begin(), entries.end());
  return words;
}

std::vector<std::uint32_t> gathers_of(const Model& model, const Body& body, std::span<const Cord> cords) {
  std::vector<std::uint32_t> nodes =
      model.elements(ElementKind::Membrane, body).nodes;  // of the forces, in their order
  const ElementTable& hinges = model.elements(ElementKind::Hinge, body);
  nodes.insert(nodes.end(), hinges.nodes.begin(), hinges.nodes.end());
  for (const Cord& cord : cords)
    nodes.insert(nodes.end(), {body.first_vertex + cord.a, body.first_vertex + cord.b});
  const mesh::Adjacency forces = places_in(nodes, body.first_vertex, body.vertex_count);
  return rows_then_entries(forces.offsets, forces.entries);
}

Result<FabricBuffers> FabricBuffers::create(gpu::Device& device, const Model& model, const Body& body) {
  FabricBuffers made;
  const ElementTable &membranes = model.elements(ElementKind::Membrane, body),
                     &hinges = model.elements(ElementKind::Hinge, body);
  const membrane::Law law = membrane_law(*body.fabric);
  const Stiffness& c = law.stiffness;
  made.layout = {body.first_vertex,
                 body.vertex_count,
                 static_cast<std::uint32_t>(membranes.size()),
                 static_cast<std::uint32_t>(hinges.size()),
                 {Vec4f::from(Vec3d{c.warp, c.coupled, c.weft}.to<float>(), static_cast<float>(c.shear)),
                  static_cast<float>(law.delay), static_cast<std::uint32_t>(law.energy)}};
  WEFT_SET(made.params, gpu::create_uniform(device, made.layout, "fabric"));
  WEFT_SET(made.corners, gpu::Buffer<std::uint32_t>::create_from(device, membranes.nodes, "membranes"));
  std::vector<Vec4f> slopes;
  for (std::size_t t = 0; t < membranes.size(); ++t)
    slopes.push_back({membranes.rest[4 * t], membranes.rest[4 * t + 1], membranes.rest[4 * t + 2],
                      membranes.rest[4 * t + 3]});
  WEFT_SET(made.slopes, gpu::Buffer<Vec4f>::create_from(device, slopes, "membranes at rest"));
  if (hinges.size() == 0) return made;
  WEFT_SET(made.hinges, gpu::Buffer<Four>::create_from(device, nodes_by_four(hinges), "hinges"));
  WEFT_SET(made.rest_angles, gpu::Buffer<float>::create_from(device, hinges.rest, "angles at rest"));
  const bool keeps_bends = body.fabric->plastic.has_value();
  made.bend_count = hinges.size() + (keeps_bends ? 3 * membranes.size() : 0);
  WEFT_SET(made.couplings, gpu::Buffer<Two>::create_from(device, couplings_of(model.plate(body), keeps_bends),
                                                         "moments by bends"));
  return made;
}

Result<void> FabricBuffers::create_forces(gpu::Device& device, const Model& model, const Body& body) {
  const ElementTable &membranes = model.elements(ElementKind::Membrane, body),
                     &hinges_at = model.elements(ElementKind::Hinge, body);
  const std::vector<Cord> cords_at = cords_of(model, body);
  WEFT_SET(gathers, gpu::Buffer<std::uint32_t>::create_from(device, gathers_of(model, body, cords_at),
                                                            "forces of nodes"));
  WEFT_SET(forces, gpu::Buffer<Vec4f>::create(
                       device, 3 * membranes.size() + 4 * hinges_at.size() + 2 * cords_at.size(),
                       "forces of fabric"));
  if (!cords_at.empty()) WEFT_SET(cords, gpu::Buffer<Cord>::create_from(device, cords_at, "cords of fabric"));
  if (bend_count > 0) WEFT_SET(bends, gpu::Buffer<float>::create(device, bend_count, "bends"));
  return {};
}

}  // namespace weft
