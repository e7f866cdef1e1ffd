#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace weft {

/// An order of springs with these first nodes in which springs beside each other have different ones: the
/// first of each node, then the second of each, and so on. Invocations beside each other then do not wait for
/// one another's atomics.
std::vector<std::uint32_t> spread_order(std::span<const std::uint32_t> first_nodes);

}  // namespace weft
