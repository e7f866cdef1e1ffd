// How much cloth there is of a body, at rest.
#pragma once

#include "model/model.hpp"

namespace weft {

double mass_of(const Model& model, const Body& body);    // [kg]
double area_of(const Model& model, const Body& body);    // of its triangles [m²]
double volume_of(const Model& model, const Body& body);  // of its tetrahedra [m³]
/// Of a triangle whose nodes count among all [m²].
double area_of(const Model& model, const mesh::Triangle& triangle);

}  // namespace weft
