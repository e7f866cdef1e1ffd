// When and where cloth tears, against closed forms, and what a split keeps.
#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "base/quaternion.hpp"
#include "base/random.hpp"
#include "mesh/sides.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "model/cloth_size.hpp"
#include "model/tearing.hpp"
#include "model/tension.hpp"
#include "reference/simulation.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

constexpr double kWidth = 0.1, kLength = 0.2;  // of the strip [m]

const std::string kOfSprings = R"("density": 0.2, "stiffness": {"structural": 900, "shear": 200, "bend": 0})";
const std::string kOfFabric =
    R"("density": 0.2, "fabric": {"warp": 1000, "weft": 700, "shear": 200, "bending_warp": 1e-5})";

Model strip(const std::string& elements, double strength, const std::string& more = "") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [{"grid": [21, 11],
      "size": [0.2, 0.1], "strength": )" + std::to_string(strength) +
                                            ", " + elements + more + "}]}",
                                        "test.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(1));
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

std::vector<Vec3d> stretched(const Model& model, double strain) {
  std::vector<Vec3d> places = model.rest_position;
  for (Vec3d& p : places) p.x *= 1 + strain;
  return places;
}

/// What the strip that is stretched so bears along x by its width: the work by its strain, and so no word of tensions.
double force_by_width(const Model& model, double strain) {
  reference::MassSpringSystem system = reference::elements_of(model);
  system.velocity.assign(model.vertex_count(), {});
  const auto energy = [&](double at) {
    system.position = stretched(model, at);
    const reference::EnergySums sums = reference::energies(system);
    return sums.springs + sums.membranes;
  };
  constexpr double kStep = 1e-5;
  return (energy(strain + kStep) - energy(strain - kStep)) / (2 * kStep * kLength) / kWidth;
}

/// No edge has more than two triangles, and the triangles of each node are one fan.
bool is_manifold(const Model& model) {
  const std::vector<mesh::Side> sides = mesh::sorted_sides(model.triangles);
  std::map<std::uint32_t, std::size_t> rim, at;
  bool good = true;
  mesh::for_each_edge(sides, [&](std::span<const mesh::Side> of_edge) {
    good = good && of_edge.size() <= 2;
    if (of_edge.size() == 1)
      for (const std::uint32_t node : of_edge[0].nodes) ++rim[node];
  });
  for (const auto& [node, count] : rim) good = good && count == 2;
  return good;
}

Vec3d momentum(const Model& model, const std::vector<Vec3d>& velocity) {
  Vec3d sum;
  for (std::size_t node = 0; node < velocity.size(); ++node) sum += model.mass[node] * velocity[node];
  return sum;
}
Vec3d spin(const Model& model, const std::vector<Vec3d>& place, const std::vector<Vec3d>& velocity) {
  Vec3d sum;
  for (std::size_t node = 0; node < velocity.size(); ++node)
    sum += model.mass[node] * cross(place[node], velocity[node]);
  return sum;
}

std::vector<Vec3d> taken(const std::vector<Vec3d>& list, const std::vector<std::uint32_t>& from) {
  std::vector<Vec3d> made;
  for (const std::uint32_t node : from) made.push_back(list[node]);
  return made;
}

}  // namespace

TEST_CASE("a strip that is pulled tears where its force by width passes its strength, and not before") {
  for (const std::string& elements : {kOfSprings, kOfFabric}) {
    CAPTURE(elements);
    const double strain = 0.06, force = force_by_width(strip(elements, 1), strain);
    const Model stronger = strip(elements, 1.06 * force), weaker = strip(elements, 0.94 * force);
    CHECK_FALSE(tear(stronger, {}, stretched(stronger, strain)));
    CHECK(tear(weaker, {}, stretched(weaker, strain)));
  }
}

TEST_CASE("the tension of fabric that is stretched evenly is its law's at every node, however it is turned") {
  const Model model = strip(kOfFabric, 1);
  const Mat3 turn = matrix_of({0.1, 0.7, -0.3, std::sqrt(1 - 0.59)});
  std::vector<Vec3d> places = stretched(model, 0.05);
  for (Vec3d& p : places) p = turn * p;
  const Vec3d along = turn * Vec3d{1, 0, 0};
  for (const Mat3& tension : tensions(model, model.bodies[0], places)) {
    const Principal most = largest_principal(tension);
    CHECK(most.value == doctest::Approx(1000 * 0.05).epsilon(1e-9));  // warp times strain
    CHECK(std::abs(dot(most.direction, along)) == doctest::Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("cloth without load, turned or pressed together does not tear, however weak it is") {
  for (const std::string& elements : {kOfSprings, kOfFabric}) {
    const Model model = strip(elements, 0.01);
    CHECK_FALSE(tear(model, {}, model.rest_position));
    std::vector<Vec3d> pressed = model.rest_position;
    for (Vec3d& p : pressed) p = 0.95 * Vec3d{p.y, p.z, p.x};
    CHECK_FALSE(tear(model, {}, pressed));
  }
}

TEST_CASE("splits keep mass, area, momentum and the mesh's fans, add no energy, and repeat") {
  for (const std::string& elements : {kOfSprings, kOfFabric}) {
    CAPTURE(elements);
    const Model whole = strip(elements, 20);
    Random random(7);
    Model model = whole;
    Tears tears;
    std::vector<Vec3d> places = stretched(whole, 0.1), velocities;
    for (Vec3d& p : places)
      p += 0.001 * Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    for (std::size_t node = 0; node < places.size(); ++node)
      velocities.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    const auto energy_of = [&](const Model& of) {
      reference::MassSpringSystem system = reference::elements_of(of);
      system.position = places;
      system.velocity = velocities;
      const reference::EnergySums sums = reference::energies(system);
      return sums.kinetic + sums.springs + sums.membranes;
    };
    std::size_t splits = 0;
    for (int frame = 0; frame < 12; ++frame) {
      const auto tearing = tear(model, tears, places), again = tear(model, tears, places);
      if (!tearing) break;
      REQUIRE(again);
      CHECK(tearing->tears == again->tears);
      const auto made = torn_model(whole, tearing->tears);
      REQUIRE_MESSAGE(made, made.error().message);
      const Vec3d before = momentum(model, velocities), spun = spin(model, places, velocities);
      const double energy = energy_of(model);
      places = taken(places, tearing->from);
      velocities = taken(velocities, tearing->from);
      CHECK(tearing->tears.splits() > splits);
      splits = tearing->tears.splits();
      tears = tearing->tears;
      model = *made;
      CHECK(length(momentum(model, velocities) - before) < 1e-14);
      CHECK(length(spin(model, places, velocities) - spun) < 1e-14);
      CHECK(energy_of(model) <= energy * (1 + 1e-6));  // tables are f32
      CHECK(mass_of(model, model.bodies[0]) ==
            doctest::Approx(mass_of(whole, whole.bodies[0])).epsilon(1e-12));
      CHECK(area_of(model, model.bodies[0]) == area_of(whole, whole.bodies[0]));
      CHECK(model.triangles.size() == whole.triangles.size());
      CHECK(is_manifold(model));
    }
    CHECK(splits > 20);
  }
}

TEST_CASE(
    "springs of a mesh that is whole are those of torn_springs, and tears of another cloth are refused") {
  const Model whole = strip(kOfSprings, 20);
  const mesh::TriangleMesh mesh = cloth_mesh(whole, whole.bodies[0]);
  const Tears none{{{{}, mesh.triangles}}};
  const auto torn = torn_model(whole, none);
  REQUIRE(torn);
  const ElementTable &a = whole.elements(ElementKind::Spring), &b = torn->elements(ElementKind::Spring);
  CHECK(a.nodes == b.nodes);
  CHECK(a.rest == b.rest);
  CHECK(a.material == b.material);
  Tears other = none;
  std::swap(other.cloths[0].triangles[0], other.cloths[0].triangles[5]);
  CHECK_FALSE(torn_model(whole, other));
  other = none;
  other.cloths[0].origin = {3};  // a node that no triangle has
  CHECK_FALSE(torn_model(whole, other));
}
