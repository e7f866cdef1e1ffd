#include "element/spring/spread_order.hpp"

#include <algorithm>
#include <tuple>

namespace weft {

std::vector<std::uint32_t> spread_order(std::span<const std::uint32_t> first_nodes) {
  struct Place {
    std::uint32_t node, index, turn;  // turn: how many springs before this one begin at its node
  };
  std::vector<Place> places;
  for (std::uint32_t i = 0; i < first_nodes.size(); ++i) places.push_back({first_nodes[i], i, 0});
  const auto by_node = [](const Place& a, const Place& b) {
    return std::tie(a.node, a.index) < std::tie(b.node, b.index);
  };
  std::sort(places.begin(), places.end(), by_node);
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i].node == places[i - 1].node) places[i].turn = places[i - 1].turn + 1;
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.turn, a.node) < std::tie(b.turn, b.node);
  });
  std::vector<std::uint32_t> order;
  for (const Place& place : places) order.push_back(place.index);
  return order;
}

}  // namespace weft
