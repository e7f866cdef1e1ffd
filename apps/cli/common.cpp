#include "common.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "base/json.hpp"
#include "scene/load.hpp"
#include "scene/nearest.hpp"
#include "scene_source.hpp"

namespace weft::cli {
namespace {

std::atomic<bool> g_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

/// A second signal, of either kind and on whatever thread, ends the process as if none had been caught.
void on_interrupt(int number) {
  if (!g_interrupted.exchange(true)) return;
  ::signal(number, SIG_DFL);
  ::raise(number);
}

/// weft's rooms are built without exceptions, so a failed allocation would end the program without a word. No
/// memory may be taken here.
[[noreturn]] void on_no_memory() {
  constexpr char kSentence[] = "weft: The host has no memory left.\n";
  static_cast<void>(!::write(STDERR_FILENO, kSentence, sizeof kSentence - 1));
  ::_exit(exit_code(ErrorKind::OutOfMemory));
}

/// Whether a scene's first cloth is one that --nodes may have a say of. What else is wrong with the scene is said by
/// whoever reads it next. Errors  Input.
Result<void> check_has_grid(const SceneSource& source, const SceneOptions& options) {
  SceneOptions without = options;
  without.nodes.clear();
  WEFT_TRY(overrides, changes_of(without));
  const auto scene = scene::parse_scene(source.text, source.file, overrides);
  if (!scene || scene->cloths.empty() || scene->cloths[0].grid) return {};
  return input_error("%s has no grid, and --nodes %s is of a sheet with one.", scene->cloths[0].where.c_str(),
                     options.nodes.c_str());
}

}  // namespace

void say_where_memory_ends() { std::set_new_handler(on_no_memory); }

Result<std::vector<scene::Override>> changes_of(const SceneOptions& options) {
  std::vector<scene::Override> overrides;
  if (!options.solver.empty()) overrides.push_back(scene::override_solver(options.solver));
  if (!options.nodes.empty()) overrides.push_back({"cloths.0.grid", options.nodes});
  for (const auto* texts : {&options.shorthands, &options.sets})
    for (const std::string& text : *texts) {
      WEFT_TRY(change, scene::parse_override(text));
      overrides.push_back(change);
    }
  return overrides;
}

Result<scene::Scene> load(const SceneOptions& options) {
  WEFT_TRY(overrides, changes_of(options));
  WEFT_TRY(found, find_scene(options.path));
  if (!options.nodes.empty()) WEFT_CHECK(check_has_grid(found, options));
  return scene::parse_scene(found.text, found.file, overrides);
}

std::string models_folder() {
  if (const char* folder = std::getenv("WEFT_MODELS")) return folder;
  return folder_beside_program("models");
}

std::string listed(std::span<const std::string_view> names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

Result<void> check_names(const char* option, const std::vector<std::string>& given,
                         std::span<const std::string_view> known) {
  for (const std::string& name : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string near(scene::nearest(name, known));
    return make_error(
        ErrorKind::Usage, "%s does not know %s%s; there are: %s.", option, in_quotes(name).c_str(),
        near.empty() ? "" : (", did you mean " + in_quotes(near) + "?").c_str(), listed(known).c_str());
  }
  return {};
}

void say(const char* format, ...) {
  char text[4096];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  for (char* c = text; *c != 0; ++c)  // a file's name may hold a newline or an escape, a message is one line
    if (static_cast<unsigned char>(*c) < ' ' || *c == 0x7f) *c = '?';
  std::fprintf(stderr, "weft: %s\n", text);
}

int report(const Error& error) {
  say("%s", error.message.c_str());
  return exit_code(error.kind);
}

bool interrupted() {
  static const bool installed = [] {
    struct sigaction action = {};
    action.sa_handler = on_interrupt;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    return true;
  }();
  return installed && g_interrupted;
}

}  // namespace weft::cli
