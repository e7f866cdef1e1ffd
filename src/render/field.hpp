// The numbers at vertices that some views show through the colour map.
#pragma once

#include <optional>

#include "scene/scene.hpp"

namespace weft::render {

struct Range {
  double lowest = 0, highest = 1;
};

struct Field {
  const char* title;  // with its unit, if it has one
  Range range;        // what the colour map spans, unless the settings say another
  int decimals;       // of a legend's numbers
};

/// The field that a view shows; none: it shows no field.
std::optional<Field> field_of(scene::View view);

}  // namespace weft::render
