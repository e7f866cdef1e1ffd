// The hinges of methods that move ways, in double: what src/method/bend_hinges.wgsl and bent_hinge.wgsl do.
#pragma once

#include <cstdint>

#include "element/hinge/plate.hpp"
#include "method/reference_ways.hpp"

namespace weft::reference {

struct Bend {
  double angle = 0, delayed = 0;  // from its rest, and τ times its rate [rad]
};

/// The corners of a hinge at the ways so far; its nodes count from `first` [m].
hinge::Corners corners_of(const hinge::Hinge& hinge, const Ways& ways, std::uint32_t first);
/// How far it is bent there.
Bend bend_of(const hinge::Hinge& hinge, const Ways& ways, std::uint32_t first, double delay, double dt);
/// The short way from one angle to another: what is folded flat goes on beyond pi.
double short_way(double difference);

}  // namespace weft::reference
