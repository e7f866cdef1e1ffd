// Which changes of a scene a running world can take over.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace weft::scene {

/// The JSON path of the first key in which two scenes differ and that shapes the model or the step:
/// "cloths[0].stiffness". None where they differ at most in gravity, external_force, drag, wind and the
/// numbers of `air`, and in what no state follows from: file, title, description, names, colours, looks, materials,
/// time.frames, camera and render but for subdivide.
std::optional<std::string> fixed_difference(const Scene& running, const Scene& wanted);

}  // namespace weft::scene
