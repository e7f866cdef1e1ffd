#pragma once

#include <CLI/CLI.hpp>

#include "bench.hpp"
#include "compare_results.hpp"

namespace weft::cli {

/// `bench`, and which of its commands does not measure.
struct BenchCommand {
  CLI::App* bench = nullptr;
  CLI::App* compare = nullptr;
};

/// Adds `bench` with a command for each experiment, whose parsing sets `options` and their name, and
/// `compare`.
BenchCommand add_bench_command(CLI::App& app, BenchOptions& options, CompareOptions& compare);

}  // namespace weft::cli
