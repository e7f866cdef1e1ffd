// The copies of a cloth: the same again, some way further on.
#pragma once

#include <cstdint>

#include "base/json.hpp"
#include "base/result.hpp"
#include "scene/scene.hpp"

namespace weft::scene {

/// How often a cloth stands, and how far each copy is from the one before it [m].
struct Copies {
  std::uint32_t count = 1;
  Vec3d offset;
};

/// What the checked `json` of a cloth at `path` says of its copies; without a word of them it stands once.
/// Errors  Input: a cloth with grabs; a last copy whose translation is out of range; copies that written out
///         would have over kMaxJsonValues values.
Result<Copies> copies_of(const Json& json, const std::string& file, const std::string& path);

/// The cloth `shift` further on [m]: its sheet, the places that select its nodes, the centres of its
/// rotations.
Cloth shifted(Cloth cloth, const Vec3d& shift);

}  // namespace weft::scene
