// The forces of a cloth of fabric as plain loops in double. Source: docs/elements.md.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "element/hinge/creases.hpp"
#include "element/hinge/plate.hpp"
#include "element/membrane/membranes.hpp"
#include "element/spring/law.hpp"
#include "model/cords.hpp"

namespace weft::reference {

/// Of no force up to its longest length.
inline spring::Law law_of(const Cord& cord) {
  if (cord.longest == 0) return {0, cord.stiffness};
  const double longest = cord.longest;
  return {longest, 0, longest, cord.stiffness};
}

/// Membranes, hinges and limited edges of one cloth. Nodes count from `first`.
struct FabricCloth {
  std::uint32_t first = 0, count = 0;
  membrane::Membranes membranes;
  hinge::Plate plate;                  // damped as they are
  std::vector<Cord> limits;            // of its edges, where it has a strain limit
  std::optional<hinge::Yield> yields;  // where its bends stay
  std::vector<hinge::Crease> creases;  // then what each facet keeps; else empty
  std::uint32_t first_crease = 0;      // among those of all cloths

  /// Adds the forces of all nodes of the model at these places [m] and velocities [m/s] to `forces` [N].
  void add_forces(std::span<const Vec3d> position, std::span<const Vec3d> velocity,
                  std::span<Vec3d> forces) const;
  /// `words`: those of all cloths (State::creases); takes its own.
  void set_creases(std::span<const Vec4f> words);
  /// Takes into the creases what bends at these places leave for good, as a substep begins.
  void yield(std::span<const Vec3d> position);
  double stretching(std::span<const Vec3d> position) const;  // of membranes and limited edges [J]
  double bending(std::span<const Vec3d> position) const;     // of hinges [J]
};

/// Those of a model's bodies that are of fabric.
std::vector<FabricCloth> fabric_cloths(const Model& model);

}  // namespace weft::reference
