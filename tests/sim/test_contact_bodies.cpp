// Meshes that are no sheets, as cloth: closed bodies and tubes with slivers drop, crumple, and pass through nothing.
#include <cmath>

#include "contact/reference/proximity/closest.hpp"
#include "contact/rules/contact_law.hpp"
#include "contact_rig.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/simplify.hpp"

using namespace weft;

namespace {

constexpr double kPi = 3.141592653589793;
constexpr std::uint32_t kFramesToUntangle = 3;
constexpr double kThickness = 0.005;  // [m]

/// A tube about x, open at both ends: rings of `around` vertices at `places` along it [m].
mesh::TriangleMesh tube_of(std::uint32_t around, double radius, const std::vector<double>& places) {
  mesh::TriangleMesh tube;
  for (const double x : places)
    for (std::uint32_t k = 0; k < around; ++k) {
      const double angle = 2 * kPi * k / around;
      tube.positions.push_back(Vec3d{x, radius * std::cos(angle), radius * std::sin(angle)}.to<float>());
    }
  for (std::uint32_t ring = 0; ring + 1 < places.size(); ++ring)
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = ring * around + k, b = ring * around + (k + 1) % around;
      tube.triangles.push_back({a, b, a + around});
      tube.triangles.push_back({b, b + around, a + around});
    }
  return tube;
}

/// Rings 30 mm apart, and behind every third one another at 0.3 mm: beside an edge of 31 mm that is aspect 100.
std::vector<double> places_with_slivers(int rings) {
  std::vector<double> places;
  for (int ring = 0; ring < rings; ++ring) {
    places.push_back(0.03 * (ring - 0.5 * (rings - 1)));
    if (ring % 3 == 1) places.push_back(places.back() + 0.0003);
  }
  return places;
}

struct Drop {
  std::string solver;
  std::string cloth;  // its mesh and transform
  std::string colliders = R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "friction": 0.4})";
  std::string time = R"({"substeps": "auto"})";
  std::size_t triangles = 0;  // of a shipped model
};

/// A shipped model, so much larger and higher [m].
Drop body(const std::string& name, std::size_t triangles, double scale, double height) {
  return {.solver = "multigrid",
          .cloth = R"("mesh": ")" + name + R"(", "transform": {"scale": )" + text_of(scale) +
                   R"(, "translate": [0, )" + text_of(height) + ", 0]}",
          .triangles = triangles};
}

std::unique_ptr<sim::World> world_of_drop(gpu::Device& device, const Drop& drop) {
  const scene::Scene scene =
      contact_scene(R"("solver": {"kind": ")" + drop.solver + R"("}, "time": )" + drop.time +
                    R"(, "contact": {"method": "proximity", "thickness": )" + text_of(kThickness) +
                    R"(}, "cloths": [{)" + drop.cloth +
                    R"(, "density": 0.2, "damping": 0.01, "friction": 0.3,
                       "stiffness": {"structural": 60, "shear": 12, "bend": 0.5}}], "colliders": [)" +
                    drop.colliders + "]");
  const auto assets = load_assets(scene, [&drop](const std::string& name) -> Result<mesh::TriangleMesh> {
    if (name == "tube.obj") return tube_of(12, 0.06, places_with_slivers(10));
    const auto model = mesh::read_mesh(kModels + "/" + name + ".ply");
    if (!model) return model.error();
    return mesh::simplify(*model, drop.triangles);
  });
  return world_from(device, scene, assets);
}

/// How near two triangles of the cloth are at rest [m].
double apart_at_rest(const Model& model, const reference::Crossing& pair) {
  const auto corners = [&](std::uint32_t triangle) {
    std::array<Vec3d, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = model.rest_position[model.triangles[triangle][k]];
    return at;
  };
  const std::array<Vec3d, 3> a = corners(pair.a), b = corners(pair.b);
  double least = reference::closest_on_triangle(a[0], b[0], b[1], b[2]).distance;
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, reference::closest_on_triangle(a[i], b[0], b[1], b[2]).distance,
                      reference::closest_on_triangle(b[i], a[0], a[1], a[2]).distance});
    for (std::size_t j = 0; j < 3; ++j)
      least =
          std::min(least, reference::closest_segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]).distance);
  }
  return least;
}

/// What has passed through anything, but for surfaces that touch at rest: these do not meet (docs/contact.md, Limits).
std::size_t passed_of_what_meets(sim::World& world) {
  const Moment now(world);
  REQUIRE(now.finite());
  const Model& model = world.model().host;
  std::size_t count = passed(world, now, world.assets().objects);
  for (const reference::Crossing& pair : reference::self_crossings({now.position, model.triangles}))
    if (apart_at_rest(model, pair) <= kTouchingAtRest * self_thickness(model, kThickness)) --count;
  return count;
}

/// Lets it fall, with 2 m/s to begin with, and audits every frame.
void check_drop(gpu::Device& device, const Drop& drop, std::uint32_t frames) {
  CAPTURE(drop.solver);
  auto world = world_of_drop(device, drop);
  push(*world, 0, world->model().host.vertex_count(), {0.3, -2, 0.1});
  const std::size_t before =
      passed_of_what_meets(*world);  // a simplified model may cross itself: that comes apart at once
  std::size_t bad = 0;
  for (std::uint32_t frame = 0; frame < frames; ++frame) {
    advance(*world, 1);
    if (before == 0 || frame >= kFramesToUntangle) bad = std::max(bad, passed_of_what_meets(*world));
  }
  const sim::Totals& totals = world->totals();
  MESSAGE(drop.solver, ": ", before, " crossings at first, then ", bad, ", ", totals.contacts,
          " contacts, truncated ", totals.truncated, ", stretch ", totals.max_stretch);
  CHECK(bad == 0);
  CHECK(totals.contacts > 0);
}

}  // namespace

TEST_CASE("a tube with slivers of aspect 100 drops, crumples, and passes through nothing") {
  GpuFixture fixture;
  check_drop(fixture.device(), {.solver = "multigrid", .cloth = R"("mesh": "tube.obj", "transform":
      {"rotate": [0, 0, 0.2588, 0.9659], "translate": [0, 0.17, 0]})"},
             40);
}

TEST_CASE("long: a tube with slivers of aspect 100 drops on a ball, in steps of either kind") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"})
    check_drop(
        fixture.device(),
        {.solver = solver,
         .cloth =
             R"("mesh": "tube.obj", "transform": {"rotate": [0, 0, 0.7071, 0.7071], "translate": [0, 0.36, 0]})",
         .colliders = R"({"kind": "sphere", "center": [0, 0.08, 0], "radius": 0.08, "friction": 0.3})"},
        30);
}

TEST_CASE("the armadillo, as cloth, drops on a floor, crumples, and passes through nothing") {
  GpuFixture fixture;
  check_drop(fixture.device(), body("armadillo", 2400, 0.004, 0.24), 24);
}

TEST_CASE("long: the dragon, as cloth, drops on a floor, crumples, and passes through nothing") {
  GpuFixture fixture;
  check_drop(fixture.device(), body("dragon", 6000, 3, -0.13), 30);
}
