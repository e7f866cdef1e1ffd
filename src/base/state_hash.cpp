#include "base/state_hash.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstdio>

namespace weft {

std::string state_hash(std::span<const std::byte> position, std::span<const std::byte> velocity) {
  XXH3_state_t state;
  XXH3_64bits_reset(&state);
  XXH3_64bits_update(&state, position.data(), position.size());
  XXH3_64bits_update(&state, velocity.data(), velocity.size());
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(XXH3_64bits_digest(&state)));
  return text;
}

}  // namespace weft
