#include "gpu/pipeline_cache.hpp"

#include <array>
#include <cstdio>

namespace weft::gpu {

std::string pipeline_key(const std::string& text, const std::string& path,
                         std::span<const Constant> constants) {
  std::string all = path;
  for (const Constant& constant : constants) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "=%a", constant.value);
    all += "\n" + constant.name + value.data();
  }
  return all + "\n" + text;
}

}  // namespace weft::gpu
