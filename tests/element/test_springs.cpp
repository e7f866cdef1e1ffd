// How springs are laid out for the kernels: nothing lost, nothing doubled, within the limits of each layout.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/random.hpp"
#include "element/incidence.hpp"
#include "element/spring/neighbours.hpp"
#include "element/spring/packed_springs.hpp"
#include "element/spring/spread_order.hpp"
#include "element/spring/spring_blocks.hpp"

using namespace weft;

namespace {

using Seen = std::tuple<std::uint32_t, std::uint32_t, float, float, float>;

/// `count` nodes at random, and springs between nodes of neighbouring numbers, of five kinds.
struct Network {
  std::vector<Vec3d> rest_position;
  ElementTable table{ElementKind::Spring, {}, {}, {}};

  Network(std::uint32_t count, std::uint32_t spring_count, std::uint64_t seed) {
    Random random(seed);
    for (std::uint32_t i = 0; i < count; ++i)
      rest_position.push_back({random.uniform(0, 1), random.uniform(0, 2), random.uniform(0, 0.1)});
    for (std::uint32_t s = 0; s < spring_count; ++s) {
      const std::uint32_t a = random.below(count - 1);
      const std::uint32_t b = a + 1 + random.below(std::min(40U, count - 1 - a));
      const auto kind = static_cast<float>(1 + random.below(5));
      append(table, {a, b, static_cast<float>(random.uniform(0.1, 1)), 10 * kind, kind});
    }
  }
  Springs springs() const { return Springs(table); }
  std::multiset<Seen> all() const {
    std::multiset<Seen> seen;
    for (const Spring s : springs()) seen.insert({s.node_a, s.node_b, s.rest_length, s.stiffness, s.damping});
    return seen;
  }
};

}  // namespace

TEST_CASE("blocks have every spring once, and no more nodes than a workgroup holds") {
  for (const auto& [count, springs] : {std::pair{2U, 1U}, {50U, 300U}, {5000U, 30000U}}) {
    CAPTURE(count);
    const Network network(count, springs, count);
    const auto built = build_spring_blocks(network.rest_position, network.springs());
    REQUIRE(built);
    std::multiset<Seen> seen;
    for (const SpringBlock& block : built->blocks) {
      CHECK(block.node_count <= kBlockNodes);
      const std::span<const std::uint32_t> nodes(&built->nodes[block.first_node], block.node_count);
      CHECK(std::set<std::uint32_t>(nodes.begin(), nodes.end()).size() == nodes.size());
      for (std::uint32_t s = 0; s < block.spring_count; ++s) {
        const BlockSpring& spring = built->springs[block.first_spring + s];
        const std::uint32_t a = spring.nodes_and_kind & 1023U, b = (spring.nodes_and_kind >> 10U) & 1023U;
        REQUIRE(std::max(a, b) < block.node_count);
        const SpringKind& kind = built->kinds[spring.nodes_and_kind >> 20U];
        seen.insert({nodes[a], nodes[b], spring.rest_length, kind.stiffness, kind.damping});
      }
    }
    CHECK(seen == network.all());
  }
}

TEST_CASE("packed springs are the springs, in another order") {
  const Network network(3000, 17000, 4);
  const auto packed = pack_springs(network.springs(), atomic_order(network.springs()), 3000);
  REQUIRE(packed);
  std::multiset<Seen> seen;
  for (const PackedSpring& spring : packed->springs) {
    const SpringKind& kind = packed->kinds[spring.node_b_and_kind >> 24U];
    seen.insert({spring.node_a, spring.node_b_and_kind & 0xffffffU, spring.rest_length, kind.stiffness,
                 kind.damping});
  }
  CHECK(seen == network.all());
}

TEST_CASE("what does not fit into a packed spring is a limit, with both numbers") {
  ElementTable table{ElementKind::Spring, {}, {}, {}};
  const Springs springs(table);
  CHECK(pack_springs(springs, {}, (1U << 24U) + 1).error().message ==
        "Packed springs number at most 16777216 nodes, not 16777217.");
  for (std::uint32_t s = 0; s < 256; ++s) append(table, {0, 1, 1, static_cast<float>(s), 0});
  CHECK(pack_springs(springs, atomic_order(springs), 2));
  append(table, {0, 1, 1, 256, 0});
  CHECK(pack_springs(springs, atomic_order(springs), 2).error().kind == ErrorKind::Limit);
}

TEST_CASE("a node's entries are its springs in their order, and what fills its slice pulls nowhere") {
  for (const std::uint32_t count : {5U, 32U, 33U, 200U}) {
    CAPTURE(count);
    constexpr std::uint32_t kFirst = 70;  // other cloths come before
    Network network(count, 6 * count, count);
    std::map<std::uint32_t, std::vector<Seen>> expected;
    for (std::uint32_t& node : network.table.nodes) node += kFirst;
    for (const Spring s : network.springs()) {
      expected[s.node_a].push_back({s.node_a, s.node_b, s.rest_length, s.stiffness, s.damping});
      expected[s.node_b].push_back({s.node_b, s.node_a, s.rest_length, s.stiffness, s.damping});
    }
    const auto built = build_neighbours(network.springs(), incidence(network.table, kFirst, count), kFirst);
    REQUIRE(built);
    REQUIRE(built->slices.size() == (count + kSlice - 1) / kSlice + 1);
    REQUIRE(built->entries.size() == built->slices.back());
    for (std::uint32_t i = 0; i < count; ++i) {
      std::vector<Seen> seen;
      for (std::uint32_t entry = built->slices[i / kSlice] + i % kSlice;
           entry < built->slices[i / kSlice + 1]; entry += kSlice) {
        const Neighbour& neighbour = built->entries[entry];
        const SpringKind& kind = built->kinds[neighbour.node_and_kind >> kNeighbourNodeBits];
        const std::uint32_t other = neighbour.node_and_kind & ((1U << kNeighbourNodeBits) - 1);
        if (other == kFirst + i) {
          CHECK(kind == SpringKind{});
          continue;
        }
        seen.push_back({kFirst + i, other, neighbour.rest_length, kind.stiffness, kind.damping});
      }
      CHECK(seen == expected[kFirst + i]);
    }
  }
}

TEST_CASE(
    "in a spread order no two springs beside each other begin at one node, while other nodes have springs "
    "left") {
  const std::vector<std::uint32_t> nodes = {7, 7, 7, 2, 2, 9, 7, 4};
  const std::vector<std::uint32_t> order = spread_order(nodes);
  const std::vector<std::uint32_t> expected = {3, 7, 0, 5, 4, 1, 2, 6};  // 2 4 7 9, 2 7, 7, 7
  CHECK(order == expected);
  CHECK(spread_order({}).empty());
}
