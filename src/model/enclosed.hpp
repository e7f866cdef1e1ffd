// What a closed cloth encloses.
#pragma once

#include <span>
#include <vector>

#include "base/result.hpp"
#include "element/gas/law.hpp"
#include "model/model.hpp"

namespace weft {

/// The gas of a cloth with a pressure, whose triangles are at these places [m].
/// Errors  Input: an edge has not two triangles, two turn against each other, or they enclose nothing.
Result<gas::Law> enclosed_gas(const scene::Cloth& cloth, std::span<const mesh::Triangle> triangles,
                              std::span<const Vec3d> places);

/// The largest eigenvalue of M⁻¹ K of a body's gas at rest, from above [1/s²]; 0 without gas.
/// Source: docs/pressure.md, equation 5.
double gas_stiffness(const Model& model, const Body& body);

}  // namespace weft
