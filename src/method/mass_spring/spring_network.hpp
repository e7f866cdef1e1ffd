#pragma once

#include <vector>

#include "model/model.hpp"

namespace weft {

/// The network of springs whose highest frequency limits the step.
struct SpringNetwork {
  std::vector<Vec4f> position;  // [m]; w: inverse mass [1/kg]
  // Their nodes count from 0.
  ElementTable springs{ElementKind::Spring, {}, {}, {}};
  ElementTable triples{ElementKind::Triple, {}, {}, {}};
};

/// At most 64 x 64 nodes of a grid, with its spacing, and their masses [kg].
mesh::Grid stiffest_grid(mesh::Grid grid);
std::vector<double> grid_masses(const Model& model, const Body& body, const mesh::Grid& part);

/// The part of a cloth that decides its highest frequency: a mesh whole; of a grid at most 64 x 64 nodes with
/// the same spacing, mass and springs, since the highest frequency of a lattice of N x N nodes is within (π /
/// 2N)² of that of any larger one (0.06 % at N = 64). Kinematic nodes are taken as free, which can only raise it
/// (eigenvalues interlace).
SpringNetwork stiffest_part(const Model& model, const Body& body);

}  // namespace weft
