// From a running world to what the renderer takes: for a page, for files and for measurements alike.
#pragma once

#include "render/inputs.hpp"
#include "render/renderer.hpp"
#include "sim/world.hpp"

namespace weft::view {

/// How the world's scene wants to be drawn: size, view, camera, subdivision, and the bounds of what moves [m].
render::Settings settings_of(const sim::World& world);

/// The buffers of the world, which must outlive the renderer, and its obstacles.
render::Inputs inputs_of(const sim::World& world);

}  // namespace weft::view
