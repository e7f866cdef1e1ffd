#pragma once

#include <CLI/CLI.hpp>

#include "bench.hpp"

namespace weft::cli {

/// Adds `bench` with a command for each experiment; parsing sets `options` and their name.
CLI::App* add_bench_command(CLI::App& app, BenchOptions& options);

}  // namespace weft::cli
