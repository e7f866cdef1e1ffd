#include "element/spring/spring_kinds.hpp"

#include <algorithm>

namespace weft {

std::uint32_t SpringKinds::number_of(const SpringKind& kind) {
  const auto found = std::find(kinds_.begin(), kinds_.end(), kind);
  const auto number = static_cast<std::uint32_t>(found - kinds_.begin());
  if (found == kinds_.end()) kinds_.push_back(kind);
  return number;
}

}  // namespace weft
