#pragma once

#include <string>

#include "bench/selection.hpp"

namespace weft::cli {

struct BenchOptions {
  std::string name;  // of the experiment
  std::string json;  // file; empty: none
  std::string adapter;
  bool unchecked = false;
  bench::Selection selection;
};

/// Measures and prints a table; writes JSON where asked. The exit code.
int bench(const BenchOptions& options);

}  // namespace weft::cli
