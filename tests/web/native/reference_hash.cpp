// reference_hash SCENE.json FRAMES [KEY=JSON...]: the hash of the reference's state after so many frames. The
// browser tests compare it with that of the WebAssembly module.
#include <cstdio>
#include <cstdlib>

#include "model/assets.hpp"
#include "reference/simulation.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"

namespace {

weft::Result<std::string> hash_after(const std::string& path, long frames,
                                     const std::vector<std::string>& changes) {
  std::vector<weft::scene::Override> overrides;
  for (const std::string& change : changes) {
    WEFT_TRY(parsed, weft::scene::parse_override(change));
    overrides.push_back(parsed);
  }
  WEFT_TRY(scene, weft::scene::load_scene(path, overrides));
  WEFT_TRY(assets, weft::load_assets(scene, weft::source_path("models")));
  WEFT_TRY(simulation, weft::reference::Simulation::create(scene, assets));
  for (long frame = 0; frame < frames; ++frame) WEFT_CHECK(simulation.advance_frame());
  return simulation.hash();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: reference_hash SCENE.json FRAMES [KEY=JSON...]\n");
    return 2;
  }
  const auto hash = hash_after(argv[1], std::strtol(argv[2], nullptr, 10), {argv + 3, argv + argc});
  if (!hash) {
    std::fprintf(stderr, "%s\n", hash.error().message.c_str());
    return weft::exit_code(hash.error().kind);
  }
  std::printf("%s\n", hash->c_str());
}
