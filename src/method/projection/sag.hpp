#pragma once

#include "method/step_limit.hpp"
#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// By what part of itself "auto" lets a sheet that hangs by an edge be longer than its springs say.
inline constexpr double kSag = 0.005;

/// The steps of methods whose sweeps over elements begin each substep without forces: stable at any length; "auto" has
/// those in which cloth sags by kSag, the cloth that needs the shortest. Source: docs/solvers/xpbd.md, equations 7 and
/// 13.
StepLimit sag_limit(const scene::Scene& scene, const Model& model);

}  // namespace weft
