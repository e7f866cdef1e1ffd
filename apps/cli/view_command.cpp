#include "view_command.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "numbers.hpp"
#include "run_command.hpp"
#include "scene/names.hpp"
#include "scene_source.hpp"

namespace weft::cli {
namespace {

constexpr unsigned kLeastSide = 200, kMostSide = 8192;  // of the window

}  // namespace

CLI::App* add_view_command(CLI::App& app, ViewOptions& options) {
  CLI::App* command = app.add_subcommand(
      "view",
      "Example: weft view hanging\n\nShow a scene in a window, to play with; files can be dropped on it.");
  add_scene_options(*command, options.scene);
  command->add_option("--view", options.view, "What is shown first, instead of the scene's render.view")
      ->type_name("VIEW")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(scene::kViewNames), std::end(scene::kViewNames))));
  command
      ->add_option_function<std::string>(
          "--size",
          [&options](const std::string& text) {
            unsigned width = 0, height = 0;
            int used = 0;
            const bool read = std::sscanf(text.c_str(), "%5ux%5u%n", &width, &height, &used) == 2 &&
                              static_cast<std::size_t>(used) == text.size();
            if (!read || width < kLeastSide || height < kLeastSide || width > kMostSide || height > kMostSide)
              throw CLI::ValidationError("--size",
                                         "\"" + text + "\" is not of the form 1280x800, each from " +
                                             std::to_string(kLeastSide) + " to " + std::to_string(kMostSide));
            options.width = width;
            options.height = height;
          },
          "Of the window")
      ->type_name("WxH");
  command->add_flag("--paused", options.paused, "The cloth waits for Play");
  command->add_option("-o,--out", options.out, "Folder for what is saved and recorded; out by default")
      ->type_name("DIR");
  CLI::Option* paused = command->get_option("--paused");
  command->add_flag("--record", options.record, "Record pictures and a video from the first frame on");
  command
      ->add_option("-n,--frames", options.frames, "Close after N frames, one a picture, and say how it went")
      ->check(kWholeNumber)
      ->check(CLI::Range(0U, kMostFrames))
      ->excludes(paused);
  command->add_option("--picture", options.picture, "Write what the window shows last as this PNG file")
      ->type_name("FILE");
  command->add_option("--adapter", options.adapter, "Use the GPU whose name contains this")
      ->type_name("NAME");
  return command;
}

int view(char** arguments) {
  const std::string program = beside_program("weft_window");
  if (::access(program.c_str(), X_OK) == 0) ::execv(program.c_str(), arguments);
  const int why = errno;
  return report(
      make_error(ErrorKind::Failure,
                 "There is no window: %s cannot be run (%s); ./dev view SCENE installs GLFW and Dear ImGui "
                 "and builds it.",
                 program.c_str(), std::strerror(why)));
}

}  // namespace weft::cli
