#pragma once

#include "common.hpp"

namespace weft::cli {

struct BenchOptions {
  std::string name;  // hanging, pull
  std::string json;  // file; empty: none
  std::string adapter;
  bool quick = false;
  bool unchecked = false;
};

/// Measures and prints a table; writes JSON where asked. The exit code.
int bench(const BenchOptions& options);

}  // namespace weft::cli
