#pragma once

#include <span>

#include "contact/reference/pushes/pushes.hpp"

namespace weft::reference {

/// Answers pushes: a node that has any goes to its previous position plus their mean, and turns back at half
/// its velocity. Source: Sung et al., Algorithm 2; docs/solvers/mass_spring.md, equation 6.
void respond(std::span<const NodePush> pushes, std::span<const Vec3d> previous, std::span<Vec3d> position,
             std::span<Vec3d> velocity);

}  // namespace weft::reference
