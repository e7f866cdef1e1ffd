// What a cloth of fabric is made of: its sheet at rest, its membranes' law and its plate. Source: docs/elements.md.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "element/hinge/creases.hpp"
#include "element/hinge/plate.hpp"
#include "element/membrane/law.hpp"
#include "model/model.hpp"

namespace weft {

/// What the fabric resists stretching with [N/m].
Moduli membrane_moduli(const scene::Fabric& fabric);
membrane::Law membrane_law(const scene::Fabric& fabric);
/// What the fabric resists bending with [N·m].
Stiffness bending_law(const scene::Fabric& fabric);

/// When its bends stay; none: they do not.
std::optional<hinge::Yield> yield_law(const scene::Fabric& fabric);
/// Triangles of bodies that keep bends: all of them, and those of the bodies before this one.
std::uint32_t crease_count(const Model& model);
std::uint32_t first_crease(const Model& model, const Body& body);

/// A body's sheet at rest. Nodes count from 0.
struct FabricSheet {
  std::vector<Vec3d> position;  // [m]
  std::vector<mesh::Triangle> triangles;
  std::vector<std::uint8_t> held;  // 1: a node that the scene moves or pins
  Vec3d warp;
  std::vector<mesh::Triangle> cut;  // of what is sewn: RestSheet::cut
  std::vector<Vec3d> warps;         // RestSheet::warps

  RestSheet rest() const { return {position, triangles, warp, held, cut, warps}; }
};
FabricSheet fabric_sheet(const Model& model, const Body& body);

/// The hinges of a plate as rows of a table; rest: the angle [rad]. Nodes are numbered from `first`.
ElementTable hinge_table(const hinge::Plate& plate, std::uint32_t first);

}  // namespace weft
