#pragma once

#include <optional>

#include "gpu/texture.hpp"
#include "picture/image.hpp"
#include "picture/image_ring.hpp"
#include "render/renderer.hpp"

namespace weft::picture {

/// Draws into pictures on the host.
/// A frame: reset a list, record, submit it, start, and take what has arrived; read waits. Not more than
/// ImageRing::kSlots pictures may be on their way.
class Offscreen {
 public:
  /// `legend`: whether a picture of a view that shows a field says what its colours mean.
  /// Errors  those of render::Renderer::create.
  static Result<Offscreen> create(gpu::Device& device, const render::Settings& settings,
                                  const render::Inputs& inputs, bool legend = true);

  /// Records all passes and the copy to the host. `parity` chooses the position buffer.
  void record(gpu::CommandList& list, std::uint32_t parity) const;
  /// As render::Renderer::set_time; before the submit.
  void set_time(double time) { renderer_.set_time(time); }
  void set_camera(const render::Camera& camera) { renderer_.set_camera(camera); }
  /// Call after the submit of what record recorded.
  void start() { ring_.start(); }
  bool full() const { return ring_.full(); }
  std::size_t pending() const { return ring_.pending(); }
  /// The oldest picture, if it has arrived; never blocks.
  Result<std::optional<Image>> try_take();
  /// The oldest picture, waited for. There must be one.
  Result<Image> read();
  /// Record, submit, start and read in one, waiting: for single pictures.
  Result<Image> draw(std::uint32_t parity);

 private:
  void finish(Image& image) const;

  gpu::Device* device_ = nullptr;
  render::Renderer renderer_;
  gpu::Texture resolved_;
  ImageRing ring_;
  std::optional<render::Field> legend_;
};

}  // namespace weft::picture
