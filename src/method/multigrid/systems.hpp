// Which bodies of a model one linear system has: one rule for the kernels and for the reference.
// Source: docs/bodies.md, One system.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/model.hpp"

namespace weft::multigrid {

/// Neighbours in a model, whose vertices follow each other. Never empty.
struct SystemBodies {
  std::span<const Body> bodies;

  const Body& first() const { return bodies.front(); }
  std::uint32_t first_vertex() const { return bodies.front().first_vertex; }
  std::uint32_t vertex_count() const {
    return bodies.back().first_vertex + bodies.back().vertex_count - first_vertex();
  }
};

/// Of all bodies, in their order: those with volume, which follow each other, together, since what presses one presses
/// the other in the same substep; each other body alone.
std::vector<SystemBodies> systems_of(const Model& model);

}  // namespace weft::multigrid
