#pragma once

#include <string>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/object.hpp"

namespace weft::gpu {

/// A two-dimensional texture and the view of it whole.
class Texture {
 public:
  Texture() = default;
  /// Errors  Limit: a side is longer than the adapter's maxTextureDimension2D. OutOfMemory.
  static Result<Texture> create(Device& device, const TextureInfo& info, const std::string& label);

  Id id() const { return texture_.id(); }
  Id view() const { return view_.id(); }
  BindingSource source() const { return {view_.id(), ObjectKind::TextureView, 0, 0}; }
  const TextureInfo& info() const { return info_; }

 private:
  Object texture_, view_;
  TextureInfo info_;
};

class Sampler {
 public:
  Sampler() = default;
  static Result<Sampler> create(Device& device, const SamplerInfo& info, const std::string& label);
  BindingSource source() const { return {object_.id(), ObjectKind::Sampler, 0, 0}; }

 private:
  Object object_;
};

}  // namespace weft::gpu
