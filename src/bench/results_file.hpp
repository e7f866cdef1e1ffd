// Stored results, as `weft bench NAME --json` and bench/paper write them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace weft::bench {

/// A time of a stored row, and what its run says about its own noise.
struct StoredTime {
  double median = 0;  // ms
  struct Spread {
    double low = 0, high = 0;  // ms, at 5 and 95 of 100
  };
  std::optional<Spread> spread;  // none: not stored, or of too few times to mean something
};

struct StoredRow {
  std::string experiment;  // "pull"
  std::string name;        // all that is not measured: "sphere, bvh, nodes 4096"
  std::optional<StoredTime> time;
  std::string state_hash;  // empty: it has none
  std::string skipped;     // why it was not run; empty where it was
  std::string adapter;     // of its experiment; empty: not said
};

/// The rows of a file of one experiment, or of a machine's ("format": "weft-bench/1").
/// Errors  Input: missing, not JSON, neither of the two, or two rows of the same name.
Result<std::vector<StoredRow>> read_results(const std::string& path);

}  // namespace weft::bench
