#pragma once

#include <string>

namespace weft::cli {

struct CompareOptions {
  std::string before, after;  // files of results
  bool json = false;          // instead of a table
  bool fail = false;          // exit code 1 where something is slower
};

/// Prints stored results beside each other; needs no adapter. The exit code.
int compare_results(const CompareOptions& options);

}  // namespace weft::cli
