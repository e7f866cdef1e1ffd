#include "memory.hpp"

#include <fstream>
#include <string>

namespace weft::cli {

Result<std::uint64_t> available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t kibibytes = 0; file >> name >> kibibytes; std::getline(file, unit))
    if (name == "MemAvailable:") return kibibytes << 10U;
  return make_error(ErrorKind::Failure,
                    "/proc/meminfo does not say how much memory is available; --memory GIB does.");
}

}  // namespace weft::cli
