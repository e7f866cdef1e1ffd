#include "render/field.hpp"

namespace weft::render {

std::optional<Field> field_of(scene::View view) {
  switch (view) {
    case scene::View::Stretch:
      return Field{"stretch", {0.95, 1.15}, 2};
    case scene::View::Velocity:
      return Field{"speed m/s", {0, 4}, 1};
    case scene::View::Contacts:
      return Field{"contacts", {0, 8}, 0};
    case scene::View::Textured:
    case scene::View::Wireframe:
    case scene::View::Normals:
      break;
  }
  return {};
}

}  // namespace weft::render
