// Texture coordinates of a mesh file.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace weft::mesh {

/// A pair for each vertex, as write_obj and write_ply put them: the lines "vt" of a name that ends in .obj, s and t of
/// the binary PLY file else. Empty where there are none, or not as many as vertices.
/// Errors  Input: what is wrong, with the line or byte.
Result<std::vector<std::array<float, 2>>> read_texture(std::span<const std::byte> bytes,
                                                       const std::string& name, std::size_t vertices);

}  // namespace weft::mesh
