// What a body with volume is made of: its tetrahedra with their law. Source: docs/bodies.md.
#pragma once

#include "element/tet/tets.hpp"
#include "model/model.hpp"

namespace weft {

tet::Law tet_law(const scene::Solid& solid);

/// Of a body with volume, at rest. Nodes count from 0.
tet::Tets body_tets(const Model& model, const Body& body);

}  // namespace weft
