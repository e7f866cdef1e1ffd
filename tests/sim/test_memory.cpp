// What the process holds while a world runs on: a driver that compiles a kernel again at each bind keeps every copy.
#include <unistd.h>

#include <fstream>

#include "world_rig.hpp"

using namespace weft;

namespace {

double resident_mib() {
  std::uint64_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  REQUIRE(resident > 0);
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

/// What 480 substeps of a shipped scene add, once 80 have made what lasts [MiB].
double growth(const std::string& name, const std::string& solver) {
  CAPTURE(name);
  CAPTURE(solver);
  GpuFixture fixture;
  const auto scene =
      shipped_scene(name, {{"cloths.0.grid", "[12, 12]"}, {"solver.kind", solver}, {"time.substeps", "8"}});
  auto world = world_of(fixture.device(), scene);
  advance(*world, 10);
  const double before = resident_mib();
  advance(*world, 60);
  return resident_mib() - before;
}

}  // namespace

// A copy of a small kernel takes 0.2 MiB and more on lavapipe: one a substep would come to 96 MiB.
TEST_CASE("memory does not grow from substep to substep") {
  CHECK(growth("hanging", "multigrid") < 10);
  CHECK(growth("drape-sphere", "multigrid") < 10);
  CHECK(growth("drape-sphere", "mass_spring") < 10);
  CHECK(growth("incline", "mass_spring") < 10);
}
