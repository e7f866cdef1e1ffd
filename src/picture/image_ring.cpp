#include "picture/image_ring.hpp"

#include <cassert>
#include <cstring>

namespace weft::picture {

constexpr std::uint32_t kRowAlignment = 256;  // bytes; WebGPU's for copies of textures

Result<ImageRing> ImageRing::create(gpu::Device& device, std::uint32_t width, std::uint32_t height) {
  ImageRing ring;
  ring.device_ = &device;
  ring.width_ = width;
  ring.height_ = height;
  ring.row_bytes_ = (4 * width + kRowAlignment - 1) / kRowAlignment * kRowAlignment;
  for (gpu::Readback& slot : ring.slots_) {
    WEFT_TRY(readback, gpu::Readback::create(device, std::uint64_t{ring.row_bytes_} * height, "picture"));
    slot = std::move(readback);
  }
  return ring;
}

void ImageRing::record(gpu::CommandList& list, const gpu::Texture& texture) const {
  assert(!full());
  const gpu::Readback& slot = slots_[(oldest_ + pending_) % kSlots];
  list.copy_texture(texture.id(), slot.target().id, width_, height_, row_bytes_);
}

void ImageRing::start() {
  assert(!full());
  slots_[(oldest_ + pending_) % kSlots].start();
  ++pending_;
}

Result<std::optional<Image>> ImageRing::try_take() {
  if (pending_ == 0) return std::optional<Image>{};
  gpu::Readback& slot = slots_[oldest_];
  if (!slot.ready() && !slot.failed()) device_->poll();
  if (!slot.ready() && !slot.failed()) return std::optional<Image>{};
  const bool failed = slot.failed();
  const std::vector<std::byte> bytes = slot.take();
  oldest_ = (oldest_ + 1) % kSlots;
  --pending_;
  if (failed) {
    WEFT_CHECK(device_->status());
    return make_error(ErrorKind::DeviceLost, "A picture of %u x %u pixels did not arrive.", width_, height_);
  }
  Image image{width_, height_, std::vector<std::uint8_t>(std::size_t{4} * width_ * height_)};
  for (std::uint32_t y = 0; y < height_; ++y)
    std::memcpy(image.pixel(0, y), bytes.data() + std::size_t{y} * row_bytes_, std::size_t{4} * width_);
  return std::optional<Image>(std::move(image));
}

Result<Image> ImageRing::take() {
  assert(pending_ > 0);
  WEFT_TRY(early, try_take());
  if (early) return std::move(*early);
  WEFT_CHECK(device_->wait());
  WEFT_TRY(image, try_take());
  if (!image)
    return make_error(ErrorKind::DeviceLost, "A picture of %u x %u pixels did not arrive.", width_, height_);
  return std::move(*image);
}

}  // namespace weft::picture
