#include "overlay/overlay.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace weft::overlay {
namespace {

/// Room for `count` elements, with as much again where it grows, so that a panel that unfolds grows it once.
template <class T>
Result<bool> grow(gpu::Device& device, gpu::Buffer<T>& buffer, std::size_t count, const char* label) {
  if (count <= buffer.size() && buffer.size() > 0) return false;
  WEFT_TRY(made, gpu::Buffer<T>::create(device, std::max<std::size_t>(64, 2 * count), label));
  buffer = std::move(made);
  return true;
}

}  // namespace

Result<Overlay> Overlay::create(gpu::Device& device, gpu::TextureFormat format,
                                std::span<const std::uint8_t> atlas, std::uint32_t atlas_width,
                                std::uint32_t atlas_height) {
  if (atlas_width % 4 != 0 || atlas.size() != std::size_t{atlas_width} * atlas_height || atlas.empty())
    return make_error(ErrorKind::Shape,
                      "An atlas of %u x %u texels does not have %zu alphas in rows of whole words.",
                      atlas_width, atlas_height, atlas.size());
  Overlay made;
  made.device_ = &device;
  gpu::RenderPipelineInfo info;
  info.color = format;
  WEFT_TRY(picture, gpu::RenderPipeline::create(device, "overlay/picture.wgsl", info));
  made.picture_pipeline_ = std::move(picture);
  info.blend = true;
  WEFT_TRY(triangles, gpu::RenderPipeline::create(device, "overlay/overlay.wgsl", info));
  made.triangle_pipeline_ = std::move(triangles);
  std::vector<std::uint32_t> words(atlas.size() / 4);
  std::memcpy(words.data(), atlas.data(), atlas.size());
  WEFT_SET(made.atlas_, gpu::Buffer<std::uint32_t>::create_from(device, words, "atlas"));
  made.shown_params_ = {0, 0, atlas_width, atlas_height};
  WEFT_SET(made.params_, gpu::create_uniform(device, made.shown_params_, "overlay"));
  WEFT_SET(made.place_, gpu::create_uniform(device, made.shown_place_, "place of the picture"));
  WEFT_CHECK(made.set_triangles({}, {}));
  return made;
}

Result<void> Overlay::bind() {
  WEFT_SET(triangle_group_, triangle_pipeline_.bind({params_, vertices_, clips_, atlas_}));
  return {};
}

Result<void> Overlay::set_picture(const gpu::Texture& picture, std::uint32_t x, std::uint32_t y) {
  WEFT_SET(picture_group_, picture_pipeline_.bind({place_, picture.source()}));
  shown_place_.x = x;
  shown_place_.y = y;
  shown_place_.width = 0;  // written by the next record
  return {};
}

Result<void> Overlay::set_triangles(std::span<const Vertex> vertices, std::span<const Vec4f> clips) {
  WEFT_TRY(more_vertices, grow(*device_, vertices_, vertices.size(), "triangles of the overlay"));
  WEFT_TRY(more_clips, grow(*device_, clips_, clips.size(), "clips of the overlay"));
  if (more_vertices || more_clips) WEFT_CHECK(bind());
  vertices_.write(*device_, vertices);
  clips_.write(*device_, clips);
  count_ = static_cast<std::uint32_t>(vertices.size());
  return {};
}

void Overlay::record(gpu::CommandList& list, gpu::Id target, std::uint32_t width, std::uint32_t height) {
  if (shown_params_.width != width || shown_params_.height != height || shown_place_.width != width) {
    shown_params_.width = shown_place_.width = width;
    shown_params_.height = shown_place_.height = height;
    params_.write(*device_, std::span(&shown_params_, 1));
    place_.write(*device_, std::span(&shown_place_, 1));
  }
  gpu::RenderPass pass(list, {target, 0, 0, {0, 0, 0, 1}, false}, "overlay");
  if (picture_group_.id() != 0) pass.draw(picture_pipeline_.id(), picture_group_.id(), 6);
  if (count_ > 0) pass.draw(triangle_pipeline_.id(), triangle_group_.id(), count_);
}

}  // namespace weft::overlay
