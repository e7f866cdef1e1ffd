#pragma once

#include <imgui.h>

namespace weft::window {

inline const ImVec4 kChosen = {0.06F, 0.39F, 0.51F, 1};  // the page's teal
inline constexpr float kMargin = 14;                     // [point]

/// Colours and sizes of the panel. `scale`: what a point is of Dear ImGui's units.
void apply_theme(bool dark, float scale);

}  // namespace weft::window
