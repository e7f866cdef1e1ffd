// Springs as rows of a table: two nodes; rest: length [m]; material: stiffness [N/m], damping [N·s/m].
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "element/table.hpp"

namespace weft {

/// One spring, as the kernels read it (src/element/spring/packed_spring.wgsl).
struct Spring {
  std::uint32_t node_a = 0, node_b = 0;
  float rest_length = 0;  // [m]
  float stiffness = 0;    // [N/m]
  float damping = 0;      // [N·s/m]
};
static_assert(sizeof(Spring) == 20);

inline void append(ElementTable& table, const Spring& spring) {
  assert(table.kind == ElementKind::Spring);
  table.nodes.insert(table.nodes.end(), {spring.node_a, spring.node_b});
  table.rest.push_back(spring.rest_length);
  table.material.insert(table.material.end(), {spring.stiffness, spring.damping});
}

/// The springs of a table, which must outlive it.
class Springs {
 public:
  explicit Springs(const ElementTable& table) : table_(&table) { assert(table.kind == ElementKind::Spring); }

  const ElementTable& table() const { return *table_; }
  std::size_t size() const { return table_->size(); }
  Spring operator[](std::size_t s) const {
    return {table_->nodes[2 * s], table_->nodes[2 * s + 1], table_->rest[s], table_->material[2 * s],
            table_->material[2 * s + 1]};
  }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Spring;
    using difference_type = std::ptrdiff_t;
    using pointer = const Spring*;
    using reference = Spring;
    Iterator(const Springs& springs, std::size_t at) : springs_(&springs), at_(at) {}
    Spring operator*() const { return (*springs_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    const Springs* springs_;
    std::size_t at_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

 private:
  const ElementTable* table_;
};

}  // namespace weft
