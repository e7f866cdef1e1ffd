// What the meshes of a run are: the file meshes.json beside them.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "mesh/mesh_part.hpp"

namespace weft {

struct MeshParts {
  double frame = 0;                   // how long a frame is [s]
  std::vector<mesh::MeshPart> parts;  // each with a name that no other has
};

inline constexpr const char* kPartsFile = "meshes.json";

/// Gives each part a name that is not empty and that no part before it has.
void name_apart(std::vector<mesh::MeshPart>& parts);

std::string parts_json(const MeshParts& parts);

/// Errors  Input: it is no such JSON; what is wrong, with its place.
Result<MeshParts> read_parts(const std::string& text, const std::string& file);

}  // namespace weft
