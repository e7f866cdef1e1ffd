#pragma once

#include <embree3/rtcore.h>

#include <atomic>

#include "search_case.hpp"

namespace weft {

/// The same query by Embree: scenes of boxes, one a triangle, and rtcCollide.
class EmbreeSearch {
 public:
  /// How its tree follows the sheet: refitted, or rebuilt.
  enum class Update { Refit, BuildFast, Build };

  /// The sheet's triangles stand in weft's `order`. The case must outlive this; `room`: for so many pairs.
  EmbreeSearch(RTCDevice device, const SearchCase& search, const std::vector<std::uint32_t>& order,
               Update update, std::size_t room);
  ~EmbreeSearch();
  EmbreeSearch(const EmbreeSearch&) = delete;
  EmbreeSearch& operator=(const EmbreeSearch&) = delete;

  /// Brings the sheet's tree to where the nodes are.
  void update();
  /// Finds the pairs.
  void collide();
  /// The pairs found, sorted.
  std::vector<PairKey> pairs() const;

 private:
  struct Box {
    Vec3f low, high;
  };
  static void bounds_of_sheet(const RTCBoundsFunctionArguments* arguments);
  static void bounds_of_object(const RTCBoundsFunctionArguments* arguments);
  static void take(void* user, RTCCollision* collisions, unsigned int count);
  RTCScene make_scene(RTCDevice device, std::size_t count, RTCBoundsFunction bounds, Update update);
  Box box_of(const std::vector<Vec3f>& positions, const mesh::Triangle& triangle) const;
  bool is_pair(std::uint32_t own, std::uint32_t other) const;

  const SearchCase& search_;
  std::vector<mesh::Triangle> sheet_;  // in weft's order
  RTCScene sheet_scene_ = nullptr, object_scene_ = nullptr;
  std::vector<PairKey> found_;
  std::atomic<std::size_t> found_count_ = 0;
};

}  // namespace weft
