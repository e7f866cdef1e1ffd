#pragma once

#include <span>

#include "gpu/buffer.hpp"

namespace weft {

/// A uniform block that stays as it is.
template <class T>
Result<gpu::Buffer<T>> uniform(gpu::Device& device, const T& value, const char* label) {
  return gpu::Buffer<T>::create_from(device, std::span(&value, 1), label, gpu::kUniform | gpu::kCopyTarget);
}

}  // namespace weft
