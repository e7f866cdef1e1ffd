// How the angles of a plate fall to the facets beside them. In double. Source: docs/elements.md, Calibration.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "element/hinge/plate.hpp"

namespace weft::hinge {

/// What falls to a facet of an angle, as a sum over hinges.
struct Part {
  std::array<std::uint32_t, 5> hinges{};
  std::array<double, 5> weights{};  // 0 where there is no hinge
};

/// At a facet's three edges.
std::array<Part, 3> parts_of(const Plate& plate, const Facet& facet);
Vec3d angles_of(const std::array<Part, 3>& parts, std::span<const double> bends);
/// Of a hinge's own angle, in each of a facet's parts.
Vec3d weights_in(const std::array<Part, 3>& parts, std::uint32_t hinge);
/// The facets to which a part of a hinge's angle falls, ascending: its own, and those at the other sides of these.
std::vector<std::uint32_t> facets_of(const Plate& plate, std::uint32_t number);

}  // namespace weft::hinge
