#pragma once

#include <utility>

#include "gpu/types.hpp"

namespace weft::gpu {

namespace backend {
void release(ObjectKind kind, Id id);
}

/// Owns one WebGPU object.
class Object {
 public:
  Object() = default;
  Object(ObjectKind kind, Id id) : id_(id), kind_(kind) {}
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)), kind_(other.kind_) {}
  Object& operator=(Object&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, 0);
      kind_ = other.kind_;
    }
    return *this;
  }
  ~Object() { reset(); }

  Id id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  void reset() {
    if (id_ != 0) backend::release(kind_, id_);
    id_ = 0;
  }

  Id id_ = 0;
  ObjectKind kind_ = ObjectKind::None;
};

}  // namespace weft::gpu
