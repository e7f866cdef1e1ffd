// Elements as tables: couplings of nodes, whatever their energy.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace weft {

/// Spring: along the line between two nodes. Triple: three nodes in a row of a grid that resist bending. Membrane:
/// a triangle of fabric, Hinge: two that share an edge. Tet: a tetrahedron of a body with volume.
enum class ElementKind : std::uint8_t { Spring, Triple, Membrane, Hinge, Tet };
inline constexpr std::size_t kElementKinds = 5;
inline constexpr std::array<std::uint32_t, kElementKinds> kArity = {2, 3, 3, 4, 4};
inline constexpr std::array<const char*, kElementKinds> kElementNames = {
    "springs", "bending of grids (stiffness.bending)", "membranes", "hinges", "tetrahedra"};

/// All elements of a kind, in a fixed order. How many numbers an element has in `rest` and `material` is the kind's
/// own matter: element/<kind>/.
struct ElementTable {
  ElementKind kind = ElementKind::Spring;
  std::vector<std::uint32_t> nodes;  // kArity of them an element
  std::vector<float> rest, material;

  std::uint32_t arity() const { return kArity[static_cast<std::size_t>(kind)]; }
  std::size_t size() const { return nodes.size() / arity(); }
  std::span<const std::uint32_t> nodes_of(std::size_t element) const {
    return std::span(nodes).subspan(element * arity(), arity());
  }
};

/// The nodes of all elements of a table of four each, as kernels bind them.
inline std::vector<std::array<std::uint32_t, 4>> nodes_by_four(const ElementTable& table) {
  std::vector<std::array<std::uint32_t, 4>> all;
  all.reserve(table.size());
  for (std::size_t e = 0; e < table.size(); ++e) {
    const auto nodes = table.nodes_of(e);
    all.push_back({nodes[0], nodes[1], nodes[2], nodes[3]});
  }
  return all;
}

}  // namespace weft
