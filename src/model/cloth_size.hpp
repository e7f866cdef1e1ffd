// How much cloth there is of a body, at rest.
#pragma once

#include "model/model.hpp"

namespace weft {

double mass_of(const Model& model, const Body& body);  // [kg]
double area_of(const Model& model, const Body& body);  // of its triangles [m²]

}  // namespace weft
