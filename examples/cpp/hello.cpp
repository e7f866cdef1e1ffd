// hello [SCENE [FRAMES]]: simulates a scene, a hanging sheet if none is given, and prints the hash of its last state.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <weft/weft.hpp>

namespace {

const char* const kSheet = R"({
  "format": "weft-scene/1",
  "cloths": [{ "grid": [64, 64], "size": [2, 2], "plane": "xz", "density": 0.2, "pins": ["top_left", "top_right"] }]
})";

weft::Result<void> run(int argc, char** argv) {
  auto scene = argc > 1 ? weft::Scene::from_file(argv[1]) : weft::Scene::from_text(kSheet, "sheet");
  if (!scene) return scene.error();
  auto world = weft::World::create(*scene);
  if (!world) return world.error();

  const auto frames = argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : 60;
  if (auto done = world->advance(frames); !done) return done;
  auto hash = world->state_hash();  // waits for the frames
  if (!hash) return hash.error();

  const weft::Description about = world->describe();
  std::fprintf(stderr, "%s: %llu nodes after %.3f s, %u substeps a frame\n", world->adapter().name.c_str(),
               static_cast<unsigned long long>(about.nodes), world->time(), about.substeps);
  std::printf("%s\n", hash->c_str());
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const weft::Result<void> result = run(argc, argv);
  if (!result) std::fprintf(stderr, "hello: %s\n", result.error().message.c_str());
  return result ? 0 : 1;
}
