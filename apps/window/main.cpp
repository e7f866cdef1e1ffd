// weft_window: the window of `weft view`, which goes on as this program.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "assets.hpp"
#include "base/words.hpp"
#include "checkpoint.hpp"
#include "common.hpp"
#include "scene/load.hpp"
#include "scene/names.hpp"
#include "scene_source.hpp"
#include "view_command.hpp"
#include "window.hpp"

namespace weft::window {
namespace {

Result<Inputs> read_inputs(const SceneText& source, const OwnMesh* mesh) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  if (mesh == nullptr) {
    WEFT_TRY(assets, cli::load_checked_assets(scene));
    return Inputs{std::move(scene), std::move(assets)};
  }
  WEFT_TRY(assets, cli::load_checked_assets(scene, kOwnMesh, mesh->mesh));
  return Inputs{std::move(scene), std::move(assets)};
}

Result<SceneText> scene_text(const std::string& source) {
  WEFT_TRY(found, cli::find_scene(source));
  return SceneText{std::move(found.text), std::move(found.file), {}};
}

std::string name_of(const std::string& source) {
  return source == "-" ? "scene" : std::filesystem::path(source).stem().string();
}

/// What the scene shows first. Before a window opens: a scene that is refused is refused as by `weft check`.
Result<scene::View> checked_view(const SceneText& source) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  if (const auto assets = load_assets(scene, cli::models_folder()); !assets) return assets.error();
  return scene.render.view;
}

Result<void> show_scene(const cli::ViewOptions& options) {
  cli::interrupted();
  Options wanted;
  wanted.first.name = name_of(options.scene.path);
  WEFT_SET(wanted.first.scene, scene_text(options.scene.path));
  WEFT_SET(wanted.first.scene.changes, cli::changes_of(options.scene));
  WEFT_TRY(first_view, checked_view(wanted.first.scene));
  wanted.view = first_view;
  for (std::size_t i = 0; i < std::size(scene::kViewNames); ++i)
    if (options.view == scene::kViewNames[i]) wanted.view = static_cast<scene::View>(i);
  wanted.read = read_inputs;
  wanted.build = cli::build_name();
  wanted.places = {cli::shipped_scenes(), scene_text, options.out};
  wanted.interrupted = cli::interrupted;
  wanted.adapter = options.adapter;
  wanted.width = options.width;
  wanted.height = options.height;
  wanted.paused = options.paused;
  wanted.record = options.record;
  wanted.frames = options.frames;
  wanted.picture = options.picture;
  WEFT_TRY(end, Window(wanted).show());
  if (!end.recorded.empty()) std::printf("%s\n", end.recorded.c_str());
  if (!options.frames) return {};
  std::printf("%s: %s in a window of %u x %u pixels on %s\n", options.scene.path.c_str(),
              counted(end.frames, "frame", "frames").c_str(), end.width, end.height, end.adapter.c_str());
  if (end.median_ms > 0)
    std::printf("  a frame     %.2f ms, the median from one picture to the next\n", end.median_ms);
  std::printf("  state hash  %s\n", end.state_hash.c_str());
  return {};
}

}  // namespace
}  // namespace weft::window

int main(int argc, char** argv) {
  weft::cli::say_where_memory_ends();
  setenv("XDG_RUNTIME_DIR", "/nonexistent", 0);  // as weft does, for Mesa's drivers
  CLI::App app("The window of weft view.", "weft");
  app.require_subcommand(1);
  weft::cli::ViewOptions options;
  weft::cli::add_view_command(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : weft::exit_code(weft::ErrorKind::Usage);
  }
  const weft::Result<void> shown = weft::window::show_scene(options);
  return shown ? 0 : weft::cli::report(shown.error());
}
