#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "model/drawn_mesh.hpp"

namespace weft {

/// The bytes of a file of the format "obj", "ply" or "glb", with normals and texture coordinates.
/// Errors  Input: another format.
Result<std::vector<std::byte>> mesh_file(const DrawnMesh& drawn, std::string_view format);

}  // namespace weft
