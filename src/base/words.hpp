#pragma once

#include <cstdint>
#include <string>

namespace weft {

/// "1 picture", "2 pictures"
std::string counted(std::uint64_t count, const char* one, const char* many);

}  // namespace weft
