#include "bench_command.hpp"

#include "numbers.hpp"
#include "run_command.hpp"

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
  command->final_callback([&options, name] { options.name = name; });
  return command;
}

void add_quick(CLI::App& command, BenchOptions& options) {
  command.add_flag("--quick", options.selection.quick, "Small sizes only, for machines without a GPU");
}

void add_names(CLI::App& command, const char* option, std::vector<std::string>& names,
               const std::string& known) {
  command.add_option(option, names, "Only these: " + known)
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void add_sides(CLI::App& command, BenchOptions& options) {
  command
      .add_option("--sides", options.selection.sides,
                  "Nodes along an edge of the sheet, instead of the experiment's own sizes")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(2U, 65535U));
}

CLI::App* add_compare(CLI::App& bench, CompareOptions& options) {
  CLI::App* command = bench.add_subcommand("compare",
                                           "Example: weft bench compare before.json after.json\n\nSet the "
                                           "times of stored results beside each other.");
  command->add_option("A", options.before, "Results before a change")->required();
  command->add_option("B", options.after, "Results after it")->required();
  command->add_flag("--json", options.json, "Print JSON instead of a table");
  command->add_flag("--fail", options.fail, "End with exit code 1 where something is slower");
  return command;
}

}  // namespace

BenchCommand add_bench_command(CLI::App& app, BenchOptions& options, CompareOptions& compare) {
  CLI::App* bench = app.add_subcommand(
      "bench", "Example: weft bench hanging --quick --json results.json\n\nMeasure, or compare results.");
  bench->require_subcommand(1);
  CLI::App* hanging = add_experiment(*bench, options, "hanging", "hanging --sides 64,256 --only grid",
                                     "Measure the formulations of the solver over sizes.");
  CLI::App* pull = add_experiment(*bench, options, "pull", "pull --objects sphere --sides 64 --only bvh",
                                  "Measure the contact methods over objects and sizes.");
  CLI::App* contact =
      add_experiment(*bench, options, "contact", "contact --quick --json results.json",
                     "Measure searches, steps and kernels of contact over poses, sizes and objects.");
  CLI::App* multigrid =
      add_experiment(*bench, options, "multigrid", "multigrid --sides 64,256 --only multigrid,explicit",
                     "Measure time and error of the implicit solver beside explicit steps and null lines.");
  CLI::App* methods =
      add_experiment(*bench, options, "methods", "methods --sides 64 --json methods.json",
                     "Measure time and error of every method over its substeps and sweeps, scene by scene.");
  CLI::App* scene = add_experiment(*bench, options, "scene", "scene sewn-dress --frames 60",
                                   "Measure what frames of a scene take, and each kernel of them.");
  add_scene_options(*scene, options.scene);
  scene->add_option("-n,--frames", options.frames, "Frames to measure instead of the scene's; at least 1")
      ->check(kWholeNumber)
      ->check(CLI::Range(1U, kMostFrames));
  CLI::App* copy = add_experiment(*bench, options, "copy", "copy --json results.json",
                                  "Measure what a copy and a dispatch take at best.");
  CLI::App* largest = add_experiment(*bench, options, "largest", "largest --only grid",
                                     "Find the largest sheet that fits, and run it.");
  for (CLI::App* sized : {hanging, pull, contact, multigrid, methods, copy}) add_quick(*sized, options);
  for (CLI::App* sheet : {hanging, largest})
    add_names(*sheet, "--only", options.selection.only, "grid, mesh, springs, blocks");
  add_names(*pull, "--only", options.selection.only, "none, bvh, proximity, proximity_self, paper");
  add_names(*multigrid, "--only", options.selection.only,
            "multigrid, multigrid4, multigrid16, explicit, null, fabric, drape");
  add_names(*methods, "--only", options.selection.only,
            "words of methods, as solver.kind has them, and null");
  add_names(*methods, "--scenes", options.selection.objects,
            "sheet, strip, cantilever, ball, armadillo, twist, "
            "pull-sphere, pull-armadillo, pull-dragon");
  methods
      ->add_option("--most-ms", options.selection.most_ms,
                   "Leave out what takes longer for a frame, in the median of eight and more")
      ->type_name("MS")
      ->check(CLI::PositiveNumber);
  add_names(*pull, "--objects", options.selection.objects, "sphere, armadillo, dragon");
  for (CLI::App* sized : {hanging, pull, multigrid, methods}) add_sides(*sized, options);
  largest
      ->add_option("--memory", options.memory, "Memory to use at most; else a quarter of what is available")
      ->type_name("GIB")
      ->check(CLI::PositiveNumber);
  largest->add_option("--seconds", options.seconds, "Time to build a sheet at most, else 60")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  return {bench, add_compare(*bench, compare)};
}

}  // namespace weft::cli
