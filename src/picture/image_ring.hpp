#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gpu/readback.hpp"
#include "gpu/texture.hpp"
#include "picture/image.hpp"

namespace weft::picture {

/// Pictures on their way to the host, oldest first: while one is drawn, those before it arrive.
class ImageRing {
 public:
  static constexpr std::size_t kSlots = 3;

  ImageRing() = default;
  static Result<ImageRing> create(gpu::Device& device, std::uint32_t width, std::uint32_t height);

  /// Records the copy of the texture into the next free slot.
  void record(gpu::CommandList& list, const gpu::Texture& texture) const;
  void start();
  bool full() const { return pending_ == kSlots; }
  std::size_t pending() const { return pending_; }

  /// The oldest picture, if it has arrived.
  /// Errors  DeviceLost.
  Result<std::optional<Image>> try_take();
  /// The oldest picture, waited for. There must be one.
  Result<Image> take();

 private:
  gpu::Device* device_ = nullptr;
  std::array<gpu::Readback, kSlots> slots_;
  std::uint32_t width_ = 0, height_ = 0, row_bytes_ = 0;
  std::size_t oldest_ = 0, pending_ = 0;
};

}  // namespace weft::picture
