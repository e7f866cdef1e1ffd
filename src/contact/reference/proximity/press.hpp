// The effect of obstacles on nodes in an implicit substep about to be solved, in double. Source:
// docs/solvers/multigrid.md, Contact.
#pragma once

#include <span>
#include <vector>

#include "contact/reference/proximity/respond.hpp"

namespace weft::reference {

/// Of a node: sums over its pairs with obstacles that it comes to, each weighted by |w|.
struct Press {
  Vec3d normal;         // the direction that they press in
  double lack = 0;      // how much further along it the node has to go than its velocity takes it [m]
  double restored = 0;  // the part of it by which the node is too near [m]
  double weight = 0;    // 0: there is none
  Vec3d surface;        // the obstacle's velocity [m/s]
  double friction = 0;  // μ
};

/// Of each node, by its place at the start of the substep [m] and the velocities that take it on [m/s]; `dt` [s];
/// `own_pairs`: SolvedContact's.
std::vector<Press> presses_of(std::span<const NearPair> pairs, std::span<const Vec3d> position,
                              std::span<const Vec3d> velocity, double dt, bool own_pairs);

}  // namespace weft::reference
