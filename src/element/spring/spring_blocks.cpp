#include "element/spring/spring_blocks.hpp"

#include "element/spring/spread_order.hpp"
#include "mesh/morton_order.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

std::vector<std::uint32_t> order_of(std::span<const Vec3d> rest_position, const Springs& springs) {
  std::vector<Vec3d> middles;
  middles.reserve(springs.size());
  for (const Spring spring : springs)
    middles.push_back(0.5 * (rest_position[spring.node_a] + rest_position[spring.node_b]));
  return mesh::morton_order(middles);
}

/// The block that is being filled.
class Filling {
 public:
  Filling(SpringBlocks& built, std::size_t vertex_count) : built_(built), place_(vertex_count, kNone) {}

  void add(const Spring& spring, std::uint32_t kind) {
    const std::uint32_t fresh =
        (place_[spring.node_a] == kNone ? 1U : 0U) + (place_[spring.node_b] == kNone ? 1U : 0U);
    if (block_.node_count + fresh > kBlockNodes) close();
    const std::uint32_t a = place_of(spring.node_a), b = place_of(spring.node_b);
    built_.springs.push_back({a | (b << kPlaceBits) | (kind << (2 * kPlaceBits)), spring.rest_length});
    ++block_.spring_count;
  }
  void close() {
    if (block_.spring_count > 0) built_.blocks.push_back(block_);
    spread();
    for (std::uint32_t k = 0; k < block_.node_count; ++k) place_[built_.nodes[block_.first_node + k]] = kNone;
    block_ = {static_cast<std::uint32_t>(built_.nodes.size()), 0,
              static_cast<std::uint32_t>(built_.springs.size()), 0};
  }

 private:
  std::uint32_t place_of(std::uint32_t node) {
    if (place_[node] == kNone) {
      place_[node] = block_.node_count++;
      built_.nodes.push_back(node);
    }
    return place_[node];
  }

  void spread() {
    const std::span<BlockSpring> springs = std::span(built_.springs).subspan(block_.first_spring);
    const std::vector<BlockSpring> before(springs.begin(), springs.end());
    std::vector<std::uint32_t> nodes;
    for (const BlockSpring& spring : before)
      nodes.push_back(spring.nodes_and_kind & ((1U << kPlaceBits) - 1));
    std::size_t next = 0;
    for (const std::uint32_t index : spread_order(nodes)) springs[next++] = before[index];
  }

  SpringBlocks& built_;
  std::vector<std::uint32_t> place_;  // in the block, by node
  SpringBlock block_;
};

}  // namespace

Result<SpringBlocks> build_spring_blocks(std::span<const Vec3d> rest_position, const Springs& springs) {
  constexpr std::size_t kMostKinds = 1U << (32 - 2 * kPlaceBits);
  SpringBlocks built;
  built.springs.reserve(springs.size());
  SpringKinds kinds;
  Filling filling(built, rest_position.size());
  for (const std::uint32_t index : order_of(rest_position, springs)) {
    const std::uint32_t kind = kinds.number_of(springs[index]);
    if (kinds.all().size() > kMostKinds)
      return make_error(ErrorKind::Limit,
                        "Blocks of springs take at most %zu pairs of stiffness and damping in a scene.",
                        kMostKinds);
    filling.add(springs[index], kind);
  }
  filling.close();
  built.kinds = kinds.all();
  return built;
}

}  // namespace weft
