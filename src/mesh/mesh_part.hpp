// A part of a mesh that has a name of its own: a cloth or a body of a scene.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/vec.hpp"

namespace weft::mesh {

/// The vertices and triangles that follow those of the parts before; no triangle has vertices of two parts.
struct MeshPart {
  std::string name;
  std::uint32_t vertices = 0, triangles = 0;
  std::optional<Vec3d> color;  // linear red, green, blue in [0, 1]
};

}  // namespace weft::mesh
