// A sheet of membranes and hinges, and what acts on it. Source: docs/elements.md, The reference.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "element/membrane/law.hpp"
#include "element/orthotropic.hpp"

namespace weft::reference {

/// Where a held node is.
struct Placed {
  Vec3d position, velocity;  // [m], [m/s]
};

struct Sheet {
  std::vector<Vec3d> rest;                // [m]
  std::vector<mesh::Triangle> triangles;  // that have areas; every node is in one
  Vec3d warp{1, 0, 0};
  std::vector<std::uint8_t> held;  // 1 for each held node; none: all are free
  membrane::Law membrane;
  Stiffness bending;        // [N·m]
  double density = 0;       // [kg/m²]
  Vec3d gravity;            // [m/s²]
  double drag = 0;          // deceleration by velocity [1/s]
  std::vector<Vec3d> load;  // on each node, besides its weight [N]; none: no load

  std::function<Placed(std::uint32_t node, double time)> place;  // of held nodes; none: they stay at rest

  bool is_held(std::size_t node) const { return !held.empty() && held[node] != 0; }
  Placed placed(std::size_t node, double time) const {
    return place ? place(static_cast<std::uint32_t>(node), time) : Placed{rest[node], {}};
  }
};

}  // namespace weft::reference
