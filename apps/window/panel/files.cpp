#include <imgui.h>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace weft::window {

Result<void> draw_files(Player& player, Commands& commands) {
  heading("Files");
  remark("Drop a mesh, a scene or a state on the window to open it.");
  if (!player.has_world()) return {};
  constexpr std::pair<const char*, const char*> kFormats[] = {
      {"PNG", "png"}, {"OBJ", "obj"}, {"PLY", "ply"}, {"GLB", "glb"}, {"State", "weft"}};
  const char* chosen = nullptr;
  for (const auto& [label, end] : kFormats) {
    if (label != kFormats[0].first) ImGui::SameLine();
    if (button_across(label, std::size(kFormats))) chosen = end;
  }
  if (chosen != nullptr) WEFT_CHECK(commands.save(chosen));
  const std::string label = player.recording() ? text("Stop: %u pictures", player.recording()->count())
                                               : "Record pictures and a video";
  return button_across(label + "###record", 1) ? commands.toggle_recording() : Result<void>();
}

}  // namespace weft::window
