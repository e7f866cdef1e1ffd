// Which rows of an experiment are asked for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace weft::bench {

struct Selection {
  bool quick = false;                // fewer and smaller sizes, less time for each row
  std::vector<std::uint32_t> sides;  // nodes along an edge of the sheet; empty: the experiment's own
  std::vector<std::string> only;     // variants by their short names; empty: all
  std::vector<std::string> objects;  // or scenes; empty: the experiment's own
  std::optional<double> most_ms;     // of a frame: what takes longer is a skipped row

  bool has_variant(std::string_view name) const {
    return only.empty() || std::find(only.begin(), only.end(), name) != only.end();
  }
};

}  // namespace weft::bench
