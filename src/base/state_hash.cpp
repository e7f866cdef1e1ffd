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
  return hash_text(XXH3_64bits_digest(&state));
}

std::uint64_t bytes_hash(std::span<const std::byte> bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

std::string hash_text(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace weft
