// own_mesh [PICTURE.png]: a round cloth, made here, whose middle is lifted along a path that is made here too. Prints
// the height of the middle and of the rim's lowest node, and draws the end where there is a name for the picture.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>
#include <weft/weft.hpp>

namespace {

constexpr std::uint32_t kRings = 12, kAround = 48;
constexpr double kRadius = 0.5;  // m
constexpr std::uint32_t kFrames = 60;

struct Disc {
  std::vector<weft::Vec3f> positions;
  std::vector<weft::Triangle> triangles;
};

/// Node 0 is the middle; ring r has the nodes from 1 + (r - 1) * kAround on.
Disc make_disc() {
  Disc disc;
  disc.positions.push_back({0, 0, 0});
  for (std::uint32_t ring = 1; ring <= kRings; ++ring)
    for (std::uint32_t k = 0; k < kAround; ++k) {
      const double angle = 2 * 3.14159265358979 * k / kAround, radius = kRadius * ring / kRings;
      disc.positions.push_back(
          {static_cast<float>(radius * std::cos(angle)), 0, static_cast<float>(-radius * std::sin(angle))});
    }
  for (std::uint32_t k = 0; k < kAround; ++k) {
    const std::uint32_t next = (k + 1) % kAround;
    disc.triangles.push_back({0, 1 + k, 1 + next});
    for (std::uint32_t inner = 1; inner + kAround < disc.positions.size(); inner += kAround) {
      const std::uint32_t outer = inner + kAround;
      disc.triangles.push_back({inner + k, outer + k, outer + next});
      disc.triangles.push_back({inner + k, outer + next, inner + next});
    }
  }
  return disc;
}

/// A motion of node 0: 0.8 m up within a second, slow at both ends.
std::string lift() {
  std::string points;
  for (int i = 0; i <= 20; ++i) {
    const double time = i / 20.0, height = 0.4 * (1 - std::cos(3.14159265358979 * time));
    points += (i > 0 ? ", [" : "[") + std::to_string(time) + ", [0, " + std::to_string(height) + ", 0]]";
  }
  return R"([{ "nodes": { "nodes": [0] }, "kind": "path", "points": [)" + points + "] }]";
}

weft::Result<void> run(const char* picture) {
  auto scene = weft::Scene::from_text(R"({ "format": "weft-scene/1", "drag": 1,
    "solver": { "kind": "multigrid" }, "cloths": [{ "mesh": "disc", "density": 0.2 }] })");
  if (!scene) return scene.error();
  const Disc disc = make_disc();
  if (auto added = scene->add_mesh("disc", disc.positions, disc.triangles); !added) return added;
  if (auto set = scene->set("cloths.0.motions", lift()); !set) return set;

  auto world = weft::World::create(*scene);
  if (!world) return world.error();
  if (auto done = world->advance(kFrames); !done) return done;

  std::vector<weft::Vec3f> positions(world->position().count());
  if (auto read = world->position().read(positions); !read) return read;
  float lowest = positions[0].y;
  for (const weft::Vec3f& p : positions) lowest = std::min(lowest, p.y);
  std::printf("middle %.4f m, lowest %.4f m\n", static_cast<double>(positions[0].y),
              static_cast<double>(lowest));

  if (picture == nullptr) return {};
  weft::PictureOptions options;
  options.width = 640;
  options.height = 480;
  auto image = world->draw(options);
  if (!image) return image.error();
  return weft::write_png(picture, *image);
}

}  // namespace

int main(int argc, char** argv) {
  const weft::Result<void> result = run(argc > 1 ? argv[1] : nullptr);
  if (!result) std::fprintf(stderr, "own_mesh: %s\n", result.error().message.c_str());
  return result ? 0 : 1;
}
