#include "memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace weft::cli {
namespace {

/// Address space that this process may still map: the limit of `ulimit -v`.
std::uint64_t mappable_bytes() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::numeric_limits<std::uint64_t>::max();
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const std::uint64_t mapped = pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(mapped, limit.rlim_cur);
}

}  // namespace

Result<std::uint64_t> available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t kibibytes = 0; file >> name >> kibibytes; std::getline(file, unit))
    if (name == "MemAvailable:") return std::min(kibibytes << 10U, mappable_bytes());
  return make_error(ErrorKind::Failure,
                    "/proc/meminfo does not say how much memory is available; --memory GIB does.");
}

Result<void> check_host_memory(const scene::Scene& scene, const Assets& assets) {
  const auto available = available_memory();
  if (!available) return {};
  return check_memory(scene, assets, kWorldBytesPerNode, *available, "the host's");
}

}  // namespace weft::cli
