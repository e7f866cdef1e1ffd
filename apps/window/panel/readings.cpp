#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace weft::window {
namespace {

std::string megabytes(std::uint64_t bytes) { return text("%.1f MB", static_cast<double>(bytes) / 1e6); }
std::string count_of(std::uint64_t count) { return whole(static_cast<double>(count)); }

void draw_facts(Player& player) {
  const Description& facts = player.facts();
  reading("Nodes", count_of(facts.nodes));
  reading("Triangles", count_of(facts.triangles));
  reading("Springs", count_of(facts.springs));
  reading("Membranes, hinges", count_of(facts.membranes) + ", " + count_of(facts.hinges));
  if (facts.tetrahedra > 0) reading("Tetrahedra", count_of(facts.tetrahedra));
  reading("Substeps per frame", count_of(facts.substeps));
  reading("Step", text("%.2f ms", 1e3 * facts.step_seconds));
  reading("Largest stable step",
          facts.stable_step_seconds > 0 ? text("%.2f ms", 1e3 * facts.stable_step_seconds) : "any");
  reading("Buffers on the GPU", megabytes(player.device().allocated_bytes()));
  remark(player.device().adapter().name);
}

}  // namespace

void draw_readings(Player& player, const Rates& rates) {
  heading("Readings");
  if (!player.has_world()) return;
  const sim::Totals& totals = player.world().totals();
  const double frame = player.facts().frame_seconds;
  const std::vector<float>& graph = rates.graph();
  ImGui::PlotLines("##graph", graph.data(), static_cast<int>(graph.size()), 0, nullptr, 0, FLT_MAX,
                   {ImGui::GetContentRegionAvail().x, points(40)});
  tip("How long the last pictures took [ms].");
  const auto while_playing = [&](const std::string& value) { return player.playing() ? value : "–"; };
  reading("Simulated time", text("%.2f s", static_cast<double>(totals.frames) * frame));
  reading("Speed against real time", while_playing(text("%.2f ×", rates.frames_a_second() * frame)));
  reading("Frames a second", while_playing(text("%.1f", rates.frames_a_second())));
  reading("A picture", text("%.1f ms", rates.picture_ms()));
  reading("CPU per picture", text("%.2f ms", rates.cpu_ms()));
  reading("Dropped time", text("%.2f s", player.dropped_seconds()));
  reading("Largest stretch", text("%.1f %%", 100 * std::max(0.0F, totals.max_stretch - 1)));
  reading("Contacts", count_of(totals.contacts));
  reading("Pairs, at most", count_of(totals.pairs));
  if (totals.iterations > 0) reading("Residual, at most", text("%.2g", static_cast<double>(totals.residual)));
  for (const std::string& sentence : player.remarks()) remark(sentence);
  if (ImGui::CollapsingHeader("Facts")) draw_facts(player);
}

}  // namespace weft::window
