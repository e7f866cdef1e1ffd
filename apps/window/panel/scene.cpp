#include <imgui.h>

#include <algorithm>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"
#include "player/key_limits.hpp"
#include "player/lists.hpp"
#include "scene/names.hpp"

namespace weft::window {
namespace {

/// One of a few words; none: as it was.
std::optional<std::string> draw_words(const char* label, const std::string& now,
                                      const std::vector<std::string>& words, const std::string& meaning) {
  std::optional<std::string> chosen;
  row(label);
  if (ImGui::BeginCombo((std::string("##") + label).c_str(), now.c_str())) {
    for (const std::string& word : words)
      if (ImGui::Selectable(word.c_str(), word == now) && word != now) chosen = word;
    ImGui::EndCombo();
  }
  tip(meaning);
  return chosen;
}

Result<void> draw_key(Player& player, const char* label, const std::string& key) {
  const std::optional<KeyLimits>& limits = limits_of(key);
  const Json* now = player.values().now(key);
  if (!limits || now == nullptr) return {};
  const auto chosen = draw_words(label, now->text, limits->choices, limits->meaning);
  return chosen ? player.change({{key, json_text(*chosen)}}) : Result<void>();
}

/// Another method has other settings and other steps.
Result<void> draw_solver(Player& player) {
  const std::string solver = player.facts().solver;
  const std::vector<std::string> words(std::begin(scene::kSolverKindNames),
                                       std::end(scene::kSolverKindNames));
  const auto chosen =
      draw_words("Solver", solver, words, "The method that moves the cloth, with its own settings.");
  if (const std::string& why = player.facts().solver_reason; !why.empty()) remark(why);
  if (!chosen) return {};
  return player.change({{"solver", scene::override_solver(*chosen).value},
                        {"solver.forces", std::nullopt},
                        {"time.substeps", std::nullopt}});
}

Result<void> draw_list(Player& player, Commands& commands) {
  std::string title = player.has_world() ? player.shown().name : "none";
  for (const SceneGroup& group : scene_groups())
    for (const SceneEntry& each : group.scenes)
      if (each.name == title) title = each.title;
  std::optional<std::string> chosen;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##scene", title.c_str(), ImGuiComboFlags_HeightLarge)) {
    const std::vector<std::string>& there = commands.scenes();
    for (const SceneGroup& group : scene_groups()) {
      ImGui::TextDisabled("%s", group.title.c_str());
      for (const SceneEntry& each : group.scenes)
        if (std::find(there.begin(), there.end(), each.name) != there.end() &&
            ImGui::Selectable(("  " + each.title).c_str(), each.title == title))
          chosen = each.name;
    }
    ImGui::EndCombo();
  }
  return chosen ? commands.open_shipped(*chosen) : Result<void>();
}

}  // namespace

Result<void> draw_scene(Player& player, Commands& commands) {
  heading("Scene");
  WEFT_CHECK(draw_list(player, commands));
  if (!player.has_world()) return {};
  if (const std::string& what = player.world().scene().description; !what.empty()) remark(what);
  WEFT_CHECK(draw_solver(player));
  if (!player.facts().solver_settings.empty()) WEFT_CHECK(draw_key(player, "Forces", "solver.forces"));
  return draw_key(player, "Contact", "contact.method");
}

}  // namespace weft::window
