// Commands that look and do not run.
#pragma once

#include "common.hpp"

namespace weft::cli {

/// Reads all that `run` would read, and needs no adapter. The exit code.
int check(const SceneOptions& options);
int list_adapters();
int print_schema();

}  // namespace weft::cli
