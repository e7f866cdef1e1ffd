// Contact by proximity has the same bits however it is run: twice, in groups of any size, from a snapshot,
// with lists that must grow.
#include "contact_rig.hpp"

using namespace weft;

namespace {

/// Two sheets that fall on a sphere and a floor, in an odd number of substeps.
scene::Scene falling(const std::string& friction = "0.3") {
  return contact_scene(R"("time": {"substeps": 9}, "contact": {"method": "proximity", "thickness": 0.01},
    "cloths": [)" + lying_cloth(9, "[0, 0.22, 0]", ", \"friction\": " + friction) +
                       "," + lying_cloth(8, "[0.03, 0.24, 0.02]") + R"(],
    "colliders": [{"kind": "sphere", "center": [0.01, 0.1, 0.02], "radius": 0.1},
                  {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
}

constexpr std::uint32_t kFrames = 14;  // the second sheet meets the first in the fourth

struct Ran {
  std::string hash;
  std::uint64_t contacts = 0;
  std::uint32_t contact_hash = 0;
  bool operator==(const Ran&) const = default;
};
Ran ran(sim::World& world) { return {hash_of(world), world.totals().contacts, world.totals().contact_hash}; }
Ran run(gpu::Device& device, const sim::WorldOptions& options = {}) {
  auto world = world_of(device, falling(), options);
  advance(*world, kFrames);
  return ran(*world);
}

/// Of a run as usual, which the program does once.
const Ran& usual(gpu::Device& device) {
  static const Ran first = run(device);
  return first;
}

}  // namespace

TEST_CASE("contact has the same bits twice, for each workgroup size, and after a reset") {
  GpuFixture fixture;
  const Ran& first = usual(fixture.device());
  CHECK(first.contacts > 1000);
  for (const std::uint32_t size : {64U, 128U}) {
    CAPTURE(size);
    CHECK(run(fixture.device(), {.workgroup_size = size}) == first);
  }
  auto world = world_of(fixture.device(), falling());
  advance(*world, 5);
  REQUIRE(world->reset());
  advance(*world, kFrames);
  CHECK(ran(*world) == first);
  auto other = world_of(fixture.device(), falling("0.2"));  // all of this can differ
  advance(*other, kFrames);
  CHECK(ran(*other).hash != first.hash);
}

TEST_CASE("a snapshot of a contact goes on with the same bits in a new world and in its own") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), falling());
  advance(*world, 6);
  const auto middle = world->snapshot();
  REQUIRE_OK(middle);
  const std::uint64_t contacts = world->totals().contacts;
  CHECK(contacts > 100);
  advance(*world, kFrames - 6);
  const Ran straight = ran(*world);
  auto other = world_of(fixture.device(), falling());
  REQUIRE(other->restore(*middle));
  advance(*other, kFrames - 6);
  CHECK(hash_of(*other) == straight.hash);
  CHECK(other->totals().contacts == straight.contacts - contacts);
  REQUIRE(world->restore(*middle));
  advance(*world, kFrames - 6);
  CHECK(hash_of(*world) == straight.hash);
  CHECK(world->totals().contacts == straight.contacts + straight.contacts - contacts);
}

TEST_CASE("lists grow by half more than was wanted, unless only what was wanted fits a binding") {
  const std::uint64_t limit = 1000000 * sizeof(ListedPair);
  const auto pairs = [&](std::uint32_t has, std::uint32_t wanted) {
    return grown({has, 10, 10}, {wanted, 10, 10}, limit).pairs;
  };
  CHECK(pairs(1000, 900) == 1000);
  CHECK(pairs(1000, 2000) == 3000);
  CHECK(pairs(1000, 900000) == 1000000);   // 1.35 million do not fit
  CHECK(pairs(1000, 1200000) == 1200000);  // nor do these: the buffer says so, with both numbers
  CHECK(grown({10, 10, 1000}, {10, 10, 3500000}, limit).candidates == limit / 8);
  CHECK(grown({10, 1000, 10}, {10, 240000, 10}, limit).near == limit / sizeof(Contact));
}

TEST_CASE("lists that are too short grow, their frames are run again, and the bits are the same") {
  GpuFixture fixture;
  const Ran& roomy = usual(fixture.device());
  for (const ContactRoom& room : {ContactRoom{8, 100000, 100000}, {100000, 8, 100000}, {100000, 100000, 8}}) {
    CAPTURE(room.pairs);
    CAPTURE(room.near);
    CAPTURE(room.candidates);
    auto world = world_of(fixture.device(), falling(), {.contact_room = room});
    advance(*world, kFrames);
    CHECK(world->totals().repeated_frames > 0);
    CHECK(world->totals().frames == kFrames);
    CHECK(ran(*world) == roomy);
  }
}

TEST_CASE(
    "a first frame after a restore that finds its lists too short is run again from what was restored") {
  GpuFixture fixture;
  auto roomy = world_of(fixture.device(), falling());
  advance(*roomy, 6);
  const auto middle = roomy->snapshot();
  REQUIRE_OK(middle);
  advance(*roomy, 2);
  auto world = world_of(fixture.device(), falling(), {.contact_room = ContactRoom{8, 8, 8}});
  REQUIRE(world->restore(*middle));
  advance(*world, 2);
  CHECK(world->totals().repeated_frames > 0);
  CHECK(hash_of(*world) == hash_of(*roomy));
}

TEST_CASE("lists that are too short grow also where a reset came before the frame was reported") {
  GpuFixture fixture;
  const Ran& roomy = usual(fixture.device());
  auto world = world_of(fixture.device(), falling(), {.contact_room = ContactRoom{8, 8, 8}});
  for (int frame = 0; frame < 3; ++frame) REQUIRE(world->advance_frame());
  REQUIRE(world->reset());
  advance(*world, kFrames);
  CHECK(ran(*world) == roomy);
}

TEST_CASE("lists that are too short grow the same when frames are asked for one by one") {
  GpuFixture fixture;
  const Ran& roomy = usual(fixture.device());
  auto world = world_of(fixture.device(), falling(), {.contact_room = ContactRoom{8, 8, 8}});
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    REQUIRE(world->advance_frame());
    REQUIRE(world->finish());  // a frame at a time, where advance() asks for all at once
  }
  CHECK(world->totals().repeated_frames > 0);
  CHECK(ran(*world) == roomy);
}
