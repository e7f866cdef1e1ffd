// read_back SCENE FRAMES: simulates a scene and prints its nodes as CSV, position [m] and speed [m/s].
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>
#include <weft/weft.hpp>

namespace {

weft::Result<void> run(const char* path, std::uint32_t frames) {
  auto scene = weft::Scene::from_file(path);
  if (!scene) return scene.error();
  auto world = weft::World::create(*scene);
  if (!world) return world.error();
  if (auto done = world->advance(frames); !done) return done;

  const std::size_t nodes = world->position().count();
  std::vector<weft::Vec3f> position(nodes), velocity(nodes);
  if (auto read = world->position().read(position); !read) return read;
  if (auto read = world->velocity().read(velocity); !read) return read;
  std::printf("x,y,z,speed\n");
  for (std::size_t node = 0; node < nodes; ++node) {
    const weft::Vec3d p = position[node].to<double>();
    std::printf("%.9g,%.9g,%.9g,%.9g\n", p.x, p.y, p.z, weft::length(velocity[node].to<double>()));
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "read_back SCENE FRAMES\n");
    return 2;
  }
  const weft::Result<void> result =
      run(argv[1], static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)));
  if (!result) std::fprintf(stderr, "read_back: %s\n", result.error().message.c_str());
  return result ? 0 : 1;
}
