#include "contact/reference/proximity/near_list.hpp"

#include <algorithm>
#include <cmath>

namespace weft::reference {
namespace {

double farthest_move(const std::vector<Vec3d>& from, const std::vector<Vec3d>& to) {
  double most = 0;  // squared
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3d way = to[i] - from[i];
    most = std::max(most, dot(way, way));
  }
  return std::sqrt(most);
}

}  // namespace

bool NearList::covers(const Features& cloth, const Features& object, const Reach& reach) const {
  if (reached_.self < 0) return false;
  const double cloth_way = farthest_move(cloth_at_, cloth.positions);
  const double object_way = farthest_move(object_at_, object.positions);
  return reach.self + 2 * cloth_way <= reached_.self &&
         reach.object + cloth_way + object_way <= reached_.object;
}

std::vector<FeaturePair> NearList::near(const Features& cloth, const Features& object, const Reach& reach,
                                        double slack) {
  if (!covers(cloth, object, reach)) {
    ++searches_;
    reached_ = {reach.self + 2 * slack, reach.object + 2 * slack};
    cloth_at_ = cloth.positions;
    object_at_ = object.positions;
    listed_ = reach.self > 0 ? self_pairs(cloth, reached_.self) : std::vector<FeaturePair>{};
    const std::vector<FeaturePair> more = object_pairs(cloth, object, trees_of(object), reached_.object);
    listed_.insert(listed_.end(), more.begin(), more.end());
  }
  std::vector<FeaturePair> pairs;
  for (const FeaturePair& pair : listed_) {
    const FeaturePair now = measured(pair, cloth, object);
    if (now.distance < (pair.kind <= PairKind::EdgeEdge ? reach.self : reach.object)) pairs.push_back(now);
  }
  return pairs;
}

}  // namespace weft::reference
