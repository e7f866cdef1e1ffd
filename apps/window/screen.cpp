#include "screen.hpp"

#include <imgui.h>

#include "picture/png.hpp"
#include "player/saved_file.hpp"

namespace weft::window {

Result<void> Screen::begin(gpu::Device& device, const gpu::WindowHandles& window, std::uint32_t width,
                           std::uint32_t height) {
  device_ = &device;
  WEFT_TRY(surface, gpu::WindowSurface::create(device, window));
  surface_.emplace(std::move(surface));
  return resize(width, height);
}

Result<void> Screen::take_font(const gpu::Texture& picture) {
  unsigned char* alphas = nullptr;
  int wide = 0, high = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alphas, &wide, &high);
  const auto columns = static_cast<std::uint32_t>(wide), rows = static_cast<std::uint32_t>(high);
  WEFT_SET(overlay_, overlay::Overlay::create(*device_, surface_->format(),
                                              std::span(alphas, std::size_t{columns} * rows), columns, rows));
  return set_picture(picture);
}

Result<void> Screen::resize(std::uint32_t width, std::uint32_t height) {
  width_ = width;
  height_ = height;
  return surface_->resize(width, height);
}

Result<void> Screen::take_panel() {
  const ImDrawData& data = *ImGui::GetDrawData();
  const ImVec2 scale = data.FramebufferScale;
  vertices_.clear();
  clips_.clear();
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      const auto number = static_cast<std::uint32_t>(clips_.size());
      clips_.push_back({clip.x * scale.x, clip.y * scale.y, clip.z * scale.x, clip.w * scale.y});
      for (unsigned int at = 0; at < command.ElemCount; ++at) {
        const auto index = command.VtxOffset + list.IdxBuffer[static_cast<int>(command.IdxOffset + at)];
        const ImDrawVert& corner = list.VtxBuffer[static_cast<int>(index)];
        vertices_.push_back(
            {corner.pos.x * scale.x, corner.pos.y * scale.y, corner.uv.x, corner.uv.y, corner.col, number});
      }
    }
  }
  return overlay_.set_triangles(vertices_, clips_);
}

Result<void> Screen::show() {
  WEFT_TRY(view, surface_->begin());
  if (view == 0) return {};
  list_.reset();
  overlay_.record(list_, view, width_, height_);
  WEFT_CHECK(device_->submit(list_));
  return surface_->present();
}

Result<void> Screen::write(const std::string& path) {
  WEFT_TRY(texture, gpu::Texture::create(*device_,
                                         {width_, height_, 1, surface_->format(),
                                          gpu::kRenderTarget | gpu::kTextureCopySource},
                                         "the window's picture"));
  list_.reset();
  overlay_.record(list_, texture.view(), width_, height_);
  WEFT_CHECK(device_->submit(list_));
  WEFT_TRY(image, image_of(*device_, texture));
  return picture::write_png(path, image);
}

}  // namespace weft::window
