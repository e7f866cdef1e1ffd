// The laws that `weft validate` measures, by the methods that take them.
#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gpu/gpu_fixture.hpp"
#include "method/method.hpp"
#include "validate/law.hpp"

using namespace weft;
using validate::Bound, validate::Measure, validate::Rig, validate::Row;

namespace {

/// Measures laws and returns the names of those with a number that does not hold.
std::set<std::string> broken(gpu::Device& device, scene::SolverKind solver,
                             const std::vector<std::string>& names) {
  std::set<std::string> failed;
  std::size_t rows = 0;
  const auto measured = validate::measure_laws({device, solver}, names, [&](const Row& row) -> Result<void> {
    ++rows;
    MESSAGE(row.law->name << " by " << scene::name_of(solver) << ": " << row.measure.what << " "
                          << row.measure.value << ", by the law " << row.measure.expected);
    if (!row.measure.holds()) failed.insert(std::string(row.law->name));
    return {};
  });
  REQUIRE_MESSAGE(static_cast<bool>(measured), measured.error().message);
  CHECK(rows >= names.size());
  return failed;
}

}  // namespace

TEST_CASE("a number holds within its tolerance, on the side that it is bound to, and never if it is none") {
  const auto near = [](double value, double expected, Bound bound) {
    return Measure{"", "", value, expected, 0.02, bound}.holds();
  };
  CHECK(near(102, 100, Bound::Near));
  CHECK_FALSE(near(102.1, 100, Bound::Near));
  CHECK_FALSE(near(97.9, 100, Bound::Near));
  CHECK(near(-101, -100, Bound::Near));
  CHECK(near(0.02, 0, Bound::Near));
  CHECK_FALSE(near(-0.021, 0, Bound::Near));
  CHECK(near(5, 100, Bound::AtMost));
  CHECK_FALSE(near(103, 100, Bound::AtMost));
  CHECK(near(500, 100, Bound::AtLeast));
  CHECK_FALSE(near(97, 100, Bound::AtLeast));
  for (const Bound bound : {Bound::Near, Bound::AtMost, Bound::AtLeast}) {
    CHECK_FALSE(near(std::numeric_limits<double>::quiet_NaN(), 1, bound));
    CHECK_FALSE(near(std::numeric_limits<double>::infinity(), 1, bound));
  }
}

TEST_CASE("laws of motion and of friction hold, explicit and implicit") {
  GpuFixture fixture;
  for (const scene::SolverKind solver : {scene::SolverKind::MassSpring, scene::SolverKind::Multigrid})
    CHECK(
        broken(fixture.device(), solver, {"fall", "chain", "pendulum", "throw", "slope", "landing"}).empty());
}

TEST_CASE("long: all laws hold but those that docs/validation.md names") {
  GpuFixture fixture;
  const std::map<scene::SolverKind, std::set<std::string>> fail = {
      {scene::SolverKind::Xpbd, {"bias", "cantilever", "capstan", "order", "stretch", "throw"}},
      {scene::SolverKind::Vbd, {"capstan", "chain", "throw"}},
      {scene::SolverKind::ProjectiveDynamics, {"capstan", "throw"}}};
  for (const Method& method : methods()) {
    const auto named = fail.find(method.kind);
    const std::set<std::string> failed = broken(fixture.device(), method.kind, {});
    CHECK(failed == (named == fail.end() ? std::set<std::string>() : named->second));
  }
}
