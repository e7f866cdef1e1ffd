// What a cloth with seams is cut from, and how far it is sewn. Source: docs/sewing.md.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft {

/// A seam as pairs of the pattern's nodes.
struct CutSeam {
  std::string where;  // file and JSON path
  std::vector<std::array<std::uint32_t, 2>> pairs;
  double force = 0;            // of the thread of a pair, at most [N]
  double damping = 0;          // of it, by which it pulls no faster than it may [N·s/m]
  double within = 0;           // how near the pairs are when they become one [m]
  double start = 0, last = 0;  // when threads begin to pull, and when the seam is waited for no longer [s]
};

/// A thread between two nodes: a spring without a length of its own.
struct Thread {
  std::uint32_t a = 0, b = 0;  // of the body, from 0; a < b
  double stiffness = 0;        // [N/m]
  double damping = 0;          // [N·s/m]
};

struct CutPattern {
  std::vector<Vec3d> position;            // of its nodes, which count from 0: where they begin [m]
  std::vector<mesh::Triangle> triangles;  // in the body's order, of these nodes
  std::vector<CutSeam> seams;
  std::vector<std::uint32_t> node;  // of each of these nodes, which one of the body it is now
  std::vector<Thread> threads;      // that pull now
};

}  // namespace weft
