#include "panel/mesh_dialog.hpp"

#include <imgui.h>

#include "panel/widgets.hpp"

namespace weft::window {
namespace {

constexpr char kTitle[] = "Open a mesh";

void draw_role(MeshQuestion& question, Role role, const char* label) {
  ImGui::BeginDisabled(!question.mesh->may_be(role));
  if (ImGui::RadioButton(label, question.role == role)) question.role = role;
  ImGui::EndDisabled();
}

void draw_counts(const OwnMesh& own) {
  const Vec3f side = own.box.high - own.box.low;
  ImGui::TextUnformatted(own.name.c_str());
  ImGui::Text("%s vertices, %s triangles, %.3g × %.3g × %.3g in the file's unit.",
              whole(static_cast<double>(own.mesh.positions.size())).c_str(),
              whole(static_cast<double>(own.mesh.triangles.size())).c_str(), static_cast<double>(side.x),
              static_cast<double>(side.y), static_cast<double>(side.z));
  if (own.dropped > 0)
    ImGui::Text("%s triangles without area left out.", whole(static_cast<double>(own.dropped)).c_str());
}

}  // namespace

Result<void> draw_mesh_dialog(Commands& commands) {
  const bool shown = ImGui::IsPopupOpen(kTitle);
  if (!commands.question && !shown) return {};
  if (!shown) ImGui::OpenPopup(kTitle);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  if (!ImGui::BeginPopupModal(kTitle, nullptr,
                              ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
    return {};
  bool open = false;
  if (commands.question) {
    MeshQuestion& question = *commands.question;
    draw_counts(*question.mesh);
    draw_role(question, Role::Obstacle, "An obstacle: a sheet falls on it");
    draw_role(question, Role::Cloth, "A cloth: it falls on a ball");
    ImGui::SetNextItemWidth(points(120));
    ImGui::InputDouble("m, its longest side", &question.length, 0, 0, "%.3g");
    if (!question.has_answer()) remark(text("It must be from %.3g to %.3g m.", kLeastLength, kMostLength));
    ImGui::BeginDisabled(!question.has_answer());
    open = ImGui::Button("Open");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) commands.question.reset();
  }
  if (open || !commands.question) ImGui::CloseCurrentPopup();  // a key may have answered too
  ImGui::EndPopup();
  return open ? commands.answer() : Result<void>();
}

}  // namespace weft::window
