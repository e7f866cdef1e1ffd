#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace weft::cli {

struct ValidateOptions {
  std::string solver;             // empty: every kind
  std::vector<std::string> only;  // empty: all laws
  std::string adapter;
  bool json = false;
};

std::vector<std::string_view> law_names();
/// Measures laws and prints each number beside the law's. Returns the exit code: 1 where a law does not hold.
int validate(const ValidateOptions& options);

}  // namespace weft::cli
