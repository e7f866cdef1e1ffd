// The JSON Schema of scenes.
#pragma once

#include <string>

namespace weft::scene {

/// JSON Schema 2020-12 of weft-scene/1, from the same table as the checks. Left to the loader: that a
/// quaternion has unit length, path times rise, a box's max is not below its min, a grid's parts are not
/// named on a mesh, a camera does not look at itself, and how many nodes all grids have together.
std::string schema_json();

}  // namespace weft::scene
