// A person who walks on the spot, and a skirt for her: made from cones, so that nobody else's mesh is needed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace weft::mesh {

/// A GLB file: a closed surface of some 7,000 vertices, 1.7 m high, feet on y = 0, facing +z; a skin of 17 joints; the
/// animations "walk" (a cycle of 1.2 s) and "stand" (still). `generator` is its asset.generator.
std::vector<std::byte> make_mannequin(const std::string& generator);

/// A skirt around her waist that stands off as a cone: 72 vertices around, its uppermost ring 12 mm off her waist.
TriangleMesh make_skirt();

}  // namespace weft::mesh
