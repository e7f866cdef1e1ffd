#include "run_command.hpp"

#include <cstdio>

#include "numbers.hpp"

namespace weft::cli {
namespace {

/// "1280x720" as "[1280,720]"; "64", where one number may stand for both, as "[64,64]".
std::string pair_of(const std::string& text, bool one_for_both) {
  unsigned first = 0, second = 0;
  int used = 0;
  const auto whole = [&](int count) { return count > 0 && static_cast<std::size_t>(used) == text.size(); };
  const bool digits = text.find_first_not_of("0123456789x") == std::string::npos && text.size() <= 21;
  if (digits && whole(std::sscanf(text.c_str(), "%9ux%9u%n", &first, &second, &used) == 2 ? 1 : 0))
    return "[" + std::to_string(first) + "," + std::to_string(second) + "]";
  if (digits && one_for_both && whole(std::sscanf(text.c_str(), "%9u%n", &first, &used)))
    return "[" + std::to_string(first) + "," + std::to_string(first) + "]";
  return {};
}

/// An option that stands for a --set of this key.
template <class Take>
void add_pair(CLI::App& command, const char* option, bool one_for_both, const char* what, const Take& take) {
  command
      .add_option_function<std::string>(
          option,
          [option, one_for_both, take](const std::string& text) {
            const std::string value = pair_of(text, one_for_both);
            if (value.empty())
              throw CLI::ValidationError(option, "\"" + text + "\" is not of the form " +
                                                     (one_for_both ? "64 or 64x32" : "1280x720"));
            take(value);
          },
          what)
      ->type_name(one_for_both ? "N|NxM" : "WxH");
}

void add_outputs(CLI::App& command, RunOptions& options) {
  CLI::Option* out = command
                         .add_option("-o,--out", options.out,
                                     "Folder for pictures, video, frames.csv, final.obj, summary.json")
                         ->type_name("DIR");
  command.add_flag("!--no-pictures", options.pictures, "Neither pictures nor a video")->needs(out);
  command.add_flag("!--no-measures", options.measures, "frames.csv without energies, which are read back")
      ->needs(out);
  add_every(command, "--meshes-every", options.meshes_every,
            "The first frame and every N-th after it as a mesh file too")
      ->needs(out);
  command.add_option("--mesh-format", options.mesh_format, "Of those: obj or ply")
      ->check(CLI::IsMember({"obj", "ply"}))
      ->needs("--meshes-every");
  add_every(command, "--checkpoint-every", options.checkpoint_every,
            "A file to resume from after every N-th frame, and after the last")
      ->needs(out);
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command
      .add_option(
          "SCENE", options.path,
          "A shipped scene by its name, a file as docs/scene.md describes it, or - for standard input")
      ->required();
  command.add_option("--set", options.sets, "Change a value of the scene: cloths.0.grid=[128,128]")
      ->type_name("KEY=JSON")
      ->allow_extra_args(false);  // else it takes SCENE for a second value
  command.add_option("--solver", options.solver, "Replace the scene's solver by this kind's defaults")
      ->type_name("KIND");
  add_pair(command, "--nodes", true, "Nodes of the first sheet: --set cloths.0.grid",
           [&options](const std::string& nodes) { options.nodes = nodes; });
}

CLI::App* add_run_command(CLI::App& app, RunOptions& options) {
  CLI::App* command =
      app.add_subcommand("run",
                         "Example: weft run hanging --frames 120 --out out/hanging\n\nSimulate a "
                         "scene, draw it, say how it went.");
  add_scene_options(*command, options.scene);
  add_pair(
      *command, "--size", false, "Pixels of pictures: --set render.size",
      [&options](const std::string& size) { options.scene.shorthands.push_back("render.size=" + size); });
  command
      ->add_option_function<std::string>(
          "--view",
          [&options](const std::string& view) { options.scene.shorthands.push_back("render.view=" + view); },
          "What pictures show: --set render.view")
      ->type_name("VIEW");
  command->add_option("-n,--frames", options.frames, "Frames to simulate instead of the scene's")
      ->check(kWholeNumber)
      ->check(CLI::Range(0U, kMostFrames));
  add_outputs(*command, options);
  command->add_option("--resume", options.resume, "Go on from this checkpoint, of the same scene")
      ->type_name("FILE");
  command->add_option("--adapter", options.adapter, "Use the GPU whose name contains this")
      ->type_name("NAME");
  command->add_flag("-q,--quiet", options.quiet, "No progress bar, and no summary for people");
  command->add_flag("--json", options.json, "Print the summary as JSON");
  command->add_option("--fault", options.faults)->group("")->allow_extra_args(false);  // for tests
  return command;
}

}  // namespace weft::cli
