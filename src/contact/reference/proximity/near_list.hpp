// Near pairs, substep after substep, without a search in each.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/reference/proximity/pairs.hpp"

namespace weft::reference {

/// Keeps a list of pairs with a larger radius than requested, and measures only these while nothing has
/// moved so far that another could have come near. The result equals that of a search, in its order.
class NearList {
 public:
  struct Reach {
    double self = 0, object = 0;  // [m]; self 0: cloth does not meet cloth
  };
  /// The pairs of cloth with itself and with obstacles that are nearer than `reach`. Where it must search, it
  /// does so for what may move `slack` [m] more.
  std::vector<FeaturePair> near(const Features& cloth, const Features& object, const Reach& reach,
                                double slack);
  std::uint64_t searches() const { return searches_; }

 private:
  bool covers(const Features& cloth, const Features& object, const Reach& reach) const;

  std::uint64_t searches_ = 0;
  std::vector<FeaturePair> listed_;
  Reach reached_{-1, -1};                    // of the list
  std::vector<Vec3d> cloth_at_, object_at_;  // when it was made [m]
};

}  // namespace weft::reference
