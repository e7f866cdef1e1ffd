#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.hpp"
#include "bench/largest_side.hpp"

using namespace weft;
using bench::Trial;

namespace {

constexpr std::uint32_t kFirst = 32, kBeyond = 65536;

/// Fits up to `largest`, and says that its buffer grows as if up to `promised` did.
struct Fake {
  std::uint32_t largest = 0, promised = 0;
  std::uint64_t limit = 0;
  std::vector<std::uint32_t> tried;

  Result<Trial> attempt(std::uint32_t side) {
    tried.push_back(side);
    if (side > largest) return Trial{Trial::Outcome::Refused, 0, "side " + std::to_string(side)};
    const double part = static_cast<double>(side - 1) / (promised - 1);
    return Trial{Trial::Outcome::Fits, static_cast<std::uint64_t>(part * part * static_cast<double>(limit)),
                 ""};
  }
  Result<bench::LargestSide> find() {
    return bench::find_largest_side(kFirst, kBeyond, limit,
                                    [&](std::uint32_t side) { return attempt(side); });
  }
};

}  // namespace

TEST_CASE("the largest side that fits is found in few tries, and the next was refused") {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const auto largest = static_cast<std::uint32_t>(random.uniform(kFirst, kBeyond - 1));
    Fake fake{largest, largest, static_cast<std::uint64_t>(random.uniform(1e6, 4e9)), {}};
    const auto found = fake.find();
    REQUIRE(found);
    CAPTURE(largest);
    CHECK(found->side == largest);
    CHECK(found->untried.empty());
    CHECK(fake.tried.size() <= 9);
    if (largest + 1 < kBeyond) CHECK(found->refusal == "side " + std::to_string(largest + 1));
  }
}

TEST_CASE("the largest side is found too where something else than the buffer's limit refuses") {
  for (const std::uint32_t largest : {32U, 33U, 100U, 2364U, 65534U}) {
    Fake fake{largest, 4 * largest, 1ULL << 30U, {}};
    const auto found = fake.find();
    REQUIRE(found);
    CHECK(found->side == largest);
    CHECK(fake.tried.size() <= 40);
    CHECK(std::count(fake.tried.begin(), fake.tried.end(), largest) == 1);
  }
}

TEST_CASE("a size that is too much to try ends the search with the reason and about the right side") {
  Fake fake{2365, 2365, 1ULL << 27U, {}};
  const auto found = bench::find_largest_side(kFirst, kBeyond, fake.limit, [&](std::uint32_t side) {
    if (side > 1000) return Result<Trial>(Trial{Trial::Outcome::Untried, 0, "too much"});
    return fake.attempt(side);
  });
  REQUIRE(found);
  CHECK(found->untried == "too much");
  CHECK(found->side <= 2365);
  CHECK(found->side > 2365 * 0.98);
}

TEST_CASE("where not even the first side fits, that is an error with its reason") {
  Fake fake{16, 16, 1000, {}};
  const auto found = fake.find();
  REQUIRE_FALSE(found);
  CHECK(found.error().kind == ErrorKind::Limit);
  CHECK(found.error().message == "Not even 32 nodes a side fit: side 32");
}
