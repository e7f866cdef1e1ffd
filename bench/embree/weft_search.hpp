#pragma once

#include "contact/proximity/pair_search.hpp"
#include "search_case.hpp"

namespace weft {

/// weft's broad phase by itself: boxes from positions, then candidates.
class WeftSearch {
 public:
  /// `room`: for so many candidates. Errors  Limit, Shader, OutOfMemory.
  static Result<WeftSearch> create(gpu::Device& device, const SearchCase& search, std::uint32_t room);
  /// One search, waited for. Errors  DeviceLost.
  Result<void> run() const;
  /// The pairs found, sorted. Errors  Limit: more than there is room for. DeviceLost.
  Result<std::vector<PairKey>> pairs() const;
  /// The sheet's triangles in weft's order.
  const std::vector<std::uint32_t>& order() const { return search_.order(); }

 private:
  gpu::Device* device_ = nullptr;
  GpuModel model_;
  State state_;
  ContactPairs pairs_;
  contact::PairSearch search_;
  gpu::CommandList list_;
  mesh::TriangleMesh object_;
};

}  // namespace weft
