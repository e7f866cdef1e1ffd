#include <imgui.h>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace weft::window {

Result<void> draw_transport(Player& player, const Rates& rates) {
  ImGui::BeginDisabled(!player.has_world());
  const bool play = chosen_button(player.playing() ? "Pause" : "Play", 3);
  ImGui::SameLine();
  const bool step = button_across("Step", 3);
  ImGui::SameLine();
  const bool reset = button_across("Reset", 3);
  ImGui::EndDisabled();
  const double rate = player.playing() ? rates.frames_a_second() : 0;
  remark(rate > 0 ? text("%.2f × · %.1f fps", rate * player.facts().frame_seconds, rate) : " ");
  if (play) player.play(!player.playing());
  if (step) WEFT_CHECK(player.step());
  return reset ? player.reset() : Result<void>();
}

}  // namespace weft::window
