// Object File Format (Geomview), as text.
#pragma once

#include <cstddef>
#include <span>

#include "base/result.hpp"
#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// The vertices and faces of an OFF text; colours, normals and texture coordinates after the numbers (COFF,
/// NOFF, STOFF and their mixtures) are passed over. Polygons become fans. Errors  Input: what is wrong, with
/// the line; OFF BINARY, 4OFF and nOFF are not read. Source  geomview.org/docs/html/OFF.html.
Result<TriangleMesh> read_off(std::span<const std::byte> bytes);

}  // namespace weft::mesh
