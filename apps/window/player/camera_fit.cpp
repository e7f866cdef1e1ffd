#include "player/camera_fit.hpp"

#include <algorithm>
#include <cmath>

#include "render/orbit.hpp"

namespace weft::window {
namespace {

constexpr double kSceneAspect = 16.0 / 9;
constexpr double kFull = 0.86;  // of half the picture's width, for the cloth: there has to be room to move
constexpr std::size_t kLooks = 1024;  // nodes that are looked at, more or less

}  // namespace

void fit_camera(view::CanvasView& look, const std::vector<Vec3d>& cloth) {
  if (static_cast<double>(look.canvas().width) / look.canvas().height >= kSceneAspect) return;
  const std::size_t stride = 1 + cloth.size() / kLooks;
  double widest = 0;
  for (std::size_t node = 0; node < cloth.size(); node += stride) {
    const render::Projected seen = look.project(cloth[node]);
    if (seen.depth > 0) widest = std::max(widest, std::abs(seen.x));
  }
  if (widest > kFull) look.set_camera(render::zoom(look.camera(), kFull / widest));
}

}  // namespace weft::window
