// The command line. Data goes to stdout, all else to stderr; docs/cli.md lists commands and exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bench_command.hpp"
#include "completion.hpp"
#include "export.hpp"
#include "fabrics.hpp"
#include "inspect.hpp"
#include "run_command.hpp"
#include "scene/nearest.hpp"
#include "scenes.hpp"
#include "validate.hpp"
#include "version.hpp"
#include "view_command.hpp"

namespace {

using namespace weft::cli;

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

bool is_among(const std::string& word, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

/// Of `weft bench` with this word behind it, or without one.
std::string bench_error(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  return (word.empty() ? "Which bench is not said" : "There is no bench \"" + word + "\"") +
         "; there are: " + listed(known);
}

/// Why a command line does not parse, in one sentence. Of a word that is no command CLI11 says only that there must be
/// one.
std::string usage_error(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
  const std::string word = argc > 1 ? argv[1] : "-", second = argc > 2 ? argv[2] : "";
  if (word == "bench" && second.rfind('-', 0) != 0) {
    const auto benches = commands_of(*app.get_subcommand("bench"));
    return is_among(second, benches) ? error.what() : bench_error(second, benches);
  }
  const std::vector<std::string> names = commands_of(app);
  if (word[0] == '-' || is_among(word, names)) return error.what();
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string meant(weft::scene::nearest(word, known));
  return "There is no command \"" + word + "\"" + (meant.empty() ? "" : ", but there is \"" + meant + "\"");
}

/// The exit code of a command whose data may not all have reached a full disk or a closed pipe.
int finish_output(int code) {
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (whole || code != 0) return code;
  say("Standard output cannot be written: %s.", std::strerror(errno));
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  say_where_memory_ends();
  // Mesa's drivers ask for a Wayland display, and say so on stderr where there is no session.
  setenv("XDG_RUNTIME_DIR", "/nonexistent", 0);

  CLI::App app(
      "Example: weft run pull-armadillo --out out/pull\n\n"
      "Real-time cloth on any GPU: simulates a scene and draws it.\n",
      "weft");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text, "Print version, commit and wgpu-native's version");

  RunOptions run_options;
  CLI::App* run_command = add_run_command(app, run_options);

  ViewOptions view_options;
  CLI::App* view_command = add_view_command(app, view_options);

  SceneOptions check_options;
  CLI::App* check_command = app.add_subcommand(
      "check", "Example: weft check hanging\n\nRead a scene and its meshes without running it.");
  add_scene_options(*check_command, check_options);

  CLI::App* adapters_command =
      app.add_subcommand("adapters", "Example: weft adapters\n\nList the GPUs that weft can use.");
  bool scenes_json = false;
  CLI::App* scenes_command = app.add_subcommand(
      "scenes", "Example: weft scenes\n\nList the shipped scenes, which run and check know by name.");
  scenes_command->add_flag("--json", scenes_json, "Print them as JSON, with what they show");
  bool fabrics_json = false;
  CLI::App* fabrics_command = app.add_subcommand(
      "fabrics", "Example: weft fabrics --json\n\nList the measured fabrics that scenes know by name.");
  fabrics_command->add_flag("--json", fabrics_json, "Print them as JSON, with the source of every number");
  CLI::App* schema_command = app.add_subcommand(
      "schema", "Example: weft schema > weft-scene.schema.json\n\nPrint the JSON Schema of scenes.");

  BenchOptions bench_options;
  CompareOptions compare_options;
  const BenchCommand bench_command = add_bench_command(app, bench_options, compare_options);

  ValidateOptions validate_options;
  CLI::App* validate_command = app.add_subcommand("validate",
                                                  "Example: weft validate --only slope,landing\n\nHold this "
                                                  "GPU's cloth to laws of mechanics, each number beside "
                                                  "the law's.");
  validate_command->add_option("--solver", validate_options.solver, "Only by this kind; else by each")
      ->type_name("KIND");
  validate_command->add_option("--only", validate_options.only, "Only these laws: " + listed(law_names()))
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  validate_command->add_option("--adapter", validate_options.adapter, "Use the GPU whose name contains this")
      ->type_name("NAME");
  validate_command->add_flag("--json", validate_options.json, "Print JSON instead of a table");

  ExportOptions export_options;
  CLI::App* export_command = add_export_command(app, export_options);

  std::string shell;
  CLI::App* completion_command = app.add_subcommand(
      "completion", "Example: eval \"$(weft completion bash)\"\n\nPrint the completion script of a shell.");
  completion_command->add_option("SHELL", shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help, --version
    return finish_output(app.exit(wanted));
  } catch (const CLI::ParseError& error) {
    say("%s; weft --help and weft COMMAND --help say more.", usage_error(app, argc, argv, error).c_str());
    return 2;
  }
  int code = 2;
  if (*run_command) code = run(run_options);
  if (*view_command) code = view(argv);
  if (*check_command) code = check(check_options);
  if (*adapters_command) code = list_adapters();
  if (*scenes_command) code = list_scenes(scenes_json);
  if (*fabrics_command) code = list_fabrics(fabrics_json);
  if (*schema_command) code = print_schema();
  if (*bench_command.bench)
    code = *bench_command.compare ? compare_results(compare_options) : bench(bench_options);
  if (*validate_command) code = validate(validate_options);
  if (*export_command) code = export_run(export_options);
  if (*completion_command) code = print_completion(shell);
  return finish_output(code);
}
