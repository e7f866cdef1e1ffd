// Shared by the commands: options, the scene, where things are.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "scene/override.hpp"
#include "scene/scene.hpp"

namespace weft::cli {

/// Has a failed allocation end the program with a sentence and its exit code.
void say_where_memory_ends();

/// Options that name a scene and change it.
struct SceneOptions {
  std::string path;                     // as given: a name, a path, or "-"
  std::vector<std::string> shorthands;  // KEY=JSON too, for which an option stands; before sets
  std::string nodes;                    // of the first sheet, which has a grid: its JSON; before all of these
  std::vector<std::string> sets;        // KEY=JSON
  std::string solver;                   // replaces the scene's solver object
};

/// What they change, in order. Errors  Usage.
Result<std::vector<scene::Override>> changes_of(const SceneOptions& options);

/// The scene with its overrides. Errors  Input, Usage.
Result<scene::Scene> load(const SceneOptions& options);

/// The folder of the models that ./dev build makes: $WEFT_MODELS, or models/ beside the folder of this
/// program.
std::string models_folder();

/// "a, b, c"
std::string listed(std::span<const std::string_view> names);

/// Refuses a name that an option has and `known` has not. Errors  Usage.
Result<void> check_names(const char* option, const std::vector<std::string>& given,
                         std::span<const std::string_view> known);

/// Says a message on stderr, in one line: control characters become "?".
[[gnu::format(printf, 1, 2)]] void say(const char* format, ...);
/// Says why a command failed; the exit code that stands for it.
int report(const Error& error);

/// Whether the user has asked to stop (SIGINT, SIGTERM). The first call installs the handler.
bool interrupted();

}  // namespace weft::cli
