// The nodes of a Gmsh file by the numbers that the file gives them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/result.hpp"

namespace weft::mesh {

/// From a node's number, its tag, to its place in the mesh. Tags may have gaps and any order.
class MshNodes {
 public:
  void reserve(std::size_t count) { rows_.reserve(count); }
  void add(std::int64_t tag) { rows_.push_back({tag, static_cast<std::uint32_t>(rows_.size())}); }
  std::size_t size() const { return rows_.size(); }

  /// To be called after the last add. Errors  Input: a tag is there twice.
  Result<void> finish() {
    std::sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
      return a.tag != b.tag ? a.tag < b.tag : a.vertex < b.vertex;
    });
    for (std::size_t i = 1; i < rows_.size(); ++i)
      if (rows_[i].tag == rows_[i - 1].tag)
        return input_error("The file has node %lld twice.", static_cast<long long>(rows_[i].tag));
    return {};
  }

  std::optional<std::uint32_t> find(std::int64_t tag) const {
    const auto before = [](const Row& row, std::int64_t wanted) { return row.tag < wanted; };
    const auto found = std::lower_bound(rows_.begin(), rows_.end(), tag, before);
    if (found == rows_.end() || found->tag != tag) return std::nullopt;
    return found->vertex;
  }

 private:
  struct Row {
    std::int64_t tag = 0;
    std::uint32_t vertex = 0;
  };
  std::vector<Row> rows_;
};

}  // namespace weft::mesh
