#include "player/saved_file.hpp"

#include <cstdio>
#include <filesystem>

#include "base/file.hpp"
#include "picture/image_ring.hpp"
#include "picture/png.hpp"

namespace weft::window {
namespace {

/// "hanging-00120.glb"
std::string file_name(const std::string& scene, std::uint32_t frame, const std::string& end) {
  char number[16];
  std::snprintf(number, sizeof number, "-%05u.", frame);
  return scene + number + end;
}

}  // namespace

Result<picture::Image> image_of(gpu::Device& device, const gpu::Texture& texture) {
  const gpu::TextureInfo& info = texture.info();
  WEFT_TRY(ring, picture::ImageRing::create(device, info.width, info.height));
  gpu::CommandList list;
  ring.record(list, texture);
  WEFT_CHECK(device.submit(list));
  ring.start();
  WEFT_TRY(image, ring.take());
  if (info.format == gpu::TextureFormat::Bgra8Unorm)
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) std::swap(image.rgba[at], image.rgba[at + 2]);
  return image;
}

Result<std::string> save_file(Player& player, const std::string& folder, const std::string& end) {
  WEFT_CHECK(player.world().finish());
  WEFT_CHECK(make_folder(folder));
  const std::string path =
      (std::filesystem::path(folder) / file_name(player.shown().name, player.world().frame(), end)).string();
  if (end == "png") {
    WEFT_TRY(image, image_of(player.device(), player.canvas()));
    WEFT_CHECK(picture::write_png(path, image));
  } else if (end == "weft") {
    WEFT_TRY(state, player.session().save_state(player.build()));
    WEFT_CHECK(write_file(path, state));
  } else {
    WEFT_CHECK(player.session().export_mesh(end));
    WEFT_CHECK(write_file(path, player.session().exported()));
  }
  return path;
}

}  // namespace weft::window
