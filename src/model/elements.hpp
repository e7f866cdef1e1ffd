// The elements of a model, built lazily and once.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "element/colors.hpp"
#include "element/hinge/plate.hpp"
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
    content_.reset();
    return *this;
  }
  ElementStore(ElementStore&&) = default;
  ElementStore& operator=(ElementStore&&) = default;
  ~ElementStore() = default;

  OfKind& of(ElementKind kind) const { return content().kinds[static_cast<std::size_t>(kind)]; }
  std::vector<std::unique_ptr<const hinge::Plate>>& plates() const { return content().plates; }  // of bodies

 private:
  struct Content {
    std::array<OfKind, kElementKinds> kinds;
    std::vector<std::unique_ptr<const hinge::Plate>> plates;
  };

  Content& content() const {
    if (!content_) content_ = std::make_unique<Content>();
    return *content_;
  }

  mutable std::unique_ptr<Content> content_;
};

}  // namespace weft
