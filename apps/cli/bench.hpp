#pragma once

#include <optional>
#include <string>

#include "bench/largest.hpp"
#include "bench/selection.hpp"
#include "common.hpp"

namespace weft::cli {

struct BenchOptions {
  std::string name;  // of the experiment
  std::string json;  // file; empty: none
  std::string adapter;
  bool unchecked = false;
  bench::Selection selection;
  std::optional<double> memory;         // GiB that `largest` may use; none: a quarter of what is available
  SceneOptions scene;                   // of `scene`
  std::optional<std::uint32_t> frames;  // instead of the scene's
  double seconds = bench::Budget().seconds;  // that `largest` may take to build a world
};

/// Measures and prints a table; writes JSON where asked. The exit code.
int bench(const BenchOptions& options);

}  // namespace weft::cli
