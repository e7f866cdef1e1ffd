#include "element/membrane/build.hpp"

#include <cassert>
#include <cmath>
#include <span>

namespace weft::membrane {

ElementTable build_membranes(const RestSheet& sheet, const Law& law, std::uint32_t first) {
  ElementTable table{ElementKind::Membrane, {}, {}, {}};
  table.nodes.reserve(3 * sheet.triangles.size());
  table.rest.reserve(4 * sheet.triangles.size());
  table.material.reserve(5 * sheet.triangles.size());
  const Stiffness& c = law.stiffness;
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    const auto& [i, j, k] = sheet.triangles[t];
    const Rest rest = Rest::of(sheet.places(t));
    table.nodes.insert(table.nodes.end(), {first + i, first + j, first + k});
    for (const MaterialPoint& slope : {rest.slope[1], rest.slope[2]})
      table.rest.insert(table.rest.end(), {static_cast<float>(slope.warp), static_cast<float>(slope.weft)});
    for (const double number : {c.warp, c.coupled, c.weft, c.shear, law.delay})
      table.material.push_back(static_cast<float>(number));
  }
  return table;
}

Rest rest_of(const ElementTable& table, std::size_t element) {
  assert(table.kind == ElementKind::Membrane);
  const std::span row = std::span(table.rest).subspan(4 * element, 4);
  Rest rest;
  rest.slope[1] = {row[0], row[1]};
  rest.slope[2] = {row[2], row[3]};
  rest.slope[0] = {-rest.slope[1].warp - rest.slope[2].warp, -rest.slope[1].weft - rest.slope[2].weft};
  rest.area =
      1 / (2 * std::abs(rest.slope[1].warp * rest.slope[2].weft - rest.slope[1].weft * rest.slope[2].warp));
  return rest;
}

}  // namespace weft::membrane
