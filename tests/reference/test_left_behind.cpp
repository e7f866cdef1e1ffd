// Contact only presses: what an obstacle leaves behind falls, or flies on, by itself. In double.
#include <cmath>

#include "rig.hpp"

using namespace weft;

namespace {

constexpr double kG = 9.81, kLies = 0.005;  // [m/s²]; where the sheet lies over the obstacle at the start [m]

/// The mean height after so many frames of a sheet that lies on a floor, whose own way up at these times is `path`.
double height_after(const std::string& collider, const std::string& path, int frames) {
  auto simulation = simulation_of_text(
      R"("gravity": [0, -9.81, 0], "solver": {"kind": "multigrid"}, "contact": {"thickness": 0.005},
      "cloths": [{"grid": [4, 4], "size": [0.2, 0.2], "plane": "xz", "density": 0.3, "friction": 0.3, "damping": 0.01,
      "stiffness": {"structural": 60, "shear": 12, "bend": 0.5}, "transform": {"translate": [0, 0.005, 0]}}],
      "colliders": [{)" +
      collider + R"(, "motion": {"kind": "path", "points": [)" + path + "]}}]");
  advance(simulation, frames);
  double sum = 0;
  for (const Vec3d& x : simulation.positions()) sum += x.y;
  return sum / static_cast<double>(simulation.positions().size());
}

/// Two sheets of 5 x 5 nodes, 20 mm apart in a sheet and 5 mm between them, as one mesh; the lower one is first.
mesh::TriangleMesh two_sheets() {
  mesh::TriangleMesh mesh;
  for (const float height : {0.0F, 0.005F}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t node = 0; node < 25; ++node)
      mesh.positions.push_back(
          {0.02F * static_cast<float>(node % 5), height, 0.02F * static_cast<float>(node / 5)});
    for (std::uint32_t j = 0; j < 4; ++j)
      for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t a = first + 5 * j + i;
        mesh.triangles.push_back({a, a + 5, a + 1});
        mesh.triangles.push_back({a + 1, a + 5, a + 6});
      }
  }
  return mesh;
}

/// The mean height of the upper one.
double upper_height(const reference::Simulation& simulation) {
  double sum = 0;
  for (std::size_t node = 25; node < 50; ++node) sum += simulation.positions()[node].y;
  return sum / 25;
}

}  // namespace

TEST_CASE("cloth that a layer of its own leaves behind falls as a stone, in double") {
  std::string lower;
  for (int node = 0; node < 25; ++node) lower += (node > 0 ? ", " : "") + std::to_string(node);
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"}, "contact": {"thickness": 0.005},
      "cloths": [{"mesh": "two.obj", "density": 0.3, "damping": 0.01,
      "stiffness": {"structural": 60, "shear": 12, "bend": 0.5}, "motions": [{"nodes": {"nodes": [)" +
          lower + R"(]}, "kind": "path", "points": [[0.1, [0, 0, 0]], [1.1, [0, -5, 0]]]}]}]})",
      "test.json");
  REQUIRE_OK(scene);
  const auto assets =
      load_assets(*scene, [](const std::string&) -> Result<mesh::TriangleMesh> { return two_sheets(); });
  REQUIRE_OK(assets);
  auto simulation = reference::Simulation::create(*scene, *assets);
  REQUIRE_OK(simulation);
  advance(*simulation, 6);  // it lies
  const double lay = upper_height(*simulation);
  advance(*simulation, 6);
  const double fell = lay - upper_height(*simulation), law = kG * 0.1 * 0.1 / 2;
  MESSAGE("it lay at " << lay << " m and fell by " << fell << " of " << law << " m");
  CHECK(lay > 0);
  CHECK(fell == doctest::Approx(law).epsilon(0.03).scale(0));
}

TEST_CASE("cloth that an obstacle leaves behind falls as a stone, and flies on where it stops, in double") {
  for (const std::string collider : {R"("kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0])",
                                     R"("kind": "box", "center": [0, -0.1, 0], "size": [1, 0.2, 1])"}) {
    CAPTURE(collider);
    for (const double speed : {0.5, 1.0, 5.0, 30.0}) {  // down, from 0.1 s on
      CAPTURE(speed);
      const double end =
          height_after(collider, "[0.1, [0, 0, 0]], [1.1, [0, " + std::to_string(-speed) + ", 0]]", 12);
      const double falls = kG * 0.1 * 0.1 / 2, law = kLies - std::min(falls, 0.1 * speed);
      MESSAGE("a floor sinks at " << speed << " m/s: " << end << " of " << law << " m");
      CHECK(end == doctest::Approx(law).epsilon(0.02).scale(0));
    }
    // Up at 1 m/s for a quarter of a second, then still, or down.
    for (const std::string after : {R"(, [1, [0, 0.25, 0]])", R"(, [0.5, [0, 0, 0]])"}) {
      const double end = height_after(collider, "[0, [0, 0, 0]], [0.25, [0, 0.25, 0]]" + after, 21);
      const double law = kLies + 0.25 + 0.1 - kG * 0.1 * 0.1 / 2;
      MESSAGE("a floor that rose: " << end << " of " << law << " m");
      CHECK(end == doctest::Approx(law).epsilon(0.01).scale(0));
    }
  }
}
