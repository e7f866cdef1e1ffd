// "Did you mean ...?"
#pragma once

#include <span>
#include <string_view>

namespace weft::scene {

/// How many letters must be added, dropped, changed or swapped with their neighbour to make `b` of `a`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word closest to `word`, the first of equals; empty if more than a third of the letters would
/// change and neither begins with the other.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace weft::scene
