#pragma once

#include <cstdint>
#include <vector>

#include "element/spring/spring.hpp"

namespace weft {

/// The stiffness and damping that springs share. Mirror: src/element/spring/packed_spring.wgsl.
struct SpringKind {
  float stiffness = 0;  // [N/m]
  float damping = 0;    // [N·s/m]
  bool operator==(const SpringKind&) const = default;
};

/// The different kinds of a set of springs, in the order in which they are met. They are few: three
/// stiffnesses a material, whole or half.
class SpringKinds {
 public:
  /// The number of a spring's kind.
  std::uint32_t number_of(const SpringKind& kind);
  std::uint32_t number_of(const Spring& spring) {
    return number_of(SpringKind{spring.stiffness, spring.damping});
  }
  const std::vector<SpringKind>& all() const { return kinds_; }

 private:
  std::vector<SpringKind> kinds_;
};

}  // namespace weft
