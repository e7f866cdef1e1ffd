#include "bench_command.hpp"

namespace weft::cli {
namespace {

CLI::App* add_experiment(CLI::App& bench, BenchOptions& options, const std::string& name,
                         const std::string& example, const std::string& what) {
  CLI::App* command = bench.add_subcommand(name, "Example: weft bench " + example + "\n\n" + what);
  command->add_option("--json", options.json, "Write the results to this file too")->type_name("FILE");
  command->add_option("--adapter", options.adapter, "Use the GPU whose name contains this")
      ->type_name("NAME");
  command->add_flag("--unchecked", options.unchecked,
                    "Compile kernels without run-time checks (native only)");
  command->add_flag("--quick", options.selection.quick, "Small sizes only, for machines without a GPU");
  command->final_callback([&options, name] { options.name = name; });
  return command;
}

void add_sizes(CLI::App& command, BenchOptions& options, const std::string& variants) {
  command
      .add_option("--sides", options.selection.sides,
                  "Nodes along an edge of the sheet, instead of the experiment's own sizes")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(2U, 65535U));
  command.add_option("--only", options.selection.only, "Only these: " + variants)
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace

CLI::App* add_bench_command(CLI::App& app, BenchOptions& options) {
  CLI::App* bench = app.add_subcommand(
      "bench", "Example: weft bench hanging --quick --json results.json\n\nMeasure, or compare results.");
  bench->require_subcommand(1);
  add_sizes(*add_experiment(*bench, options, "hanging", "hanging --sides 64,256 --only grid",
                            "Measure the formulations of the solver over sizes."),
            options, "grid, mesh, springs");
  CLI::App* pull = add_experiment(*bench, options, "pull", "pull --objects sphere --sides 64 --only bvh",
                                  "Measure the contact methods over objects and sizes.");
  add_sizes(*pull, options, "none, bvh, proximity, proximity_self, paper");
  pull->add_option("--objects", options.selection.objects, "Only these: sphere, armadillo, dragon")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_experiment(*bench, options, "contact", "contact --quick --json results.json",
                 "Measure searches, steps and kernels of contact over poses, sizes and objects.");
  return bench;
}

}  // namespace weft::cli
