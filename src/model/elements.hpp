// The elements of a model, built lazily and once.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "element/colors.hpp"
#include "element/incidence.hpp"
#include "element/table.hpp"

namespace weft {

/// The tables built so far. A copy starts empty, since the copied model may be changed.
class ElementStore {
 public:
  struct OfKind {
    std::vector<std::unique_ptr<const ElementTable>> bodies;
    std::vector<std::unique_ptr<const mesh::Adjacency>> incidence;  // of bodies
    std::unique_ptr<const ElementTable> joined;
    std::unique_ptr<const Colors> colors;
  };

  ElementStore() = default;
  ElementStore(const ElementStore&) {}
  ElementStore& operator=(const ElementStore&) {
    kinds_.reset();
    return *this;
  }
  ElementStore(ElementStore&&) = default;
  ElementStore& operator=(ElementStore&&) = default;
  ~ElementStore() = default;

  OfKind& of(ElementKind kind) const {
    if (!kinds_) kinds_ = std::make_unique<std::array<OfKind, kElementKinds>>();
    return (*kinds_)[static_cast<std::size_t>(kind)];
  }

 private:
  mutable std::unique_ptr<std::array<OfKind, kElementKinds>> kinds_;
};

}  // namespace weft
