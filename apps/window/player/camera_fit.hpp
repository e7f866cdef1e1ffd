#pragma once

#include <vector>

#include "view/canvas_view.hpp"

namespace weft::window {

/// In a picture narrower than the scenes' cameras are made for, moves the camera back until the cloth, whose nodes are
/// here [m], is in it from left to right. As the page does it (apps/web/src/fit_camera.ts).
void fit_camera(view::CanvasView& look, const std::vector<Vec3d>& cloth);

}  // namespace weft::window
