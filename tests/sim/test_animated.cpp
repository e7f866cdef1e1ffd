// Obstacles that an animation of their file deforms.
#include <algorithm>

#include "animated_box.hpp"
#include "contact/reference/proximity/audit.hpp"
#include "mesh/adjacency.hpp"
#include "model/attachments.hpp"
#include "scene/motion.hpp"
#include "world_rig.hpp"

using namespace weft;

namespace {

std::vector<Vec3d> places_of(const sim::Snapshot& state) {
  std::vector<Vec3d> places;
  for (const Vec4f& position : state.position) places.push_back(position.xyz().to<double>());
  return places;
}

/// The shape of a world's first object as it is now.
std::vector<Vec3d> shape_now(const sim::World& world) {
  const mesh::Deformation& deformation = world.assets().deformations.at(0);
  const mesh::ShapeTimes::Moment moment = deformation.times.at(world.time());
  const auto shape = [&](std::size_t number) {
    return reference::widened(number == 0 ? world.assets().objects.at(0).positions
                                          : deformation.shapes[number - 1]);
  };
  std::vector<Vec3d> from = shape(moment.from);
  const std::vector<Vec3d> to = shape(moment.to);
  for (std::size_t v = 0; v < from.size(); ++v) from[v] += moment.part * (to[v] - from[v]);
  return from;
}

}  // namespace

TEST_CASE("what begins anew moves cloth as the same shapes, written one round after the other") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"}) {
    CAPTURE(solver);
    const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": ")" + solver +
                                              R"("}, "contact": {"method": "proximity", "thickness": 0.01},
            "cloths": [{"grid": [9, 9], "size": [0.4, 0.4], "plane": "xz", "density": 0.2,
                        "transform": {"translate": [0, 0.06, 0]}}],
            "colliders": [{"kind": "mesh", "mesh": "box.glb", "animation": {"rate": 40}}]})",
                                          "a.json");
    if (!scene) FAIL(scene.error().message);
    const auto assets = load_assets(
        *scene,
        [](const std::string& name) -> Result<mesh::TriangleMesh> {
          return input_error("%s.", name.c_str());
        },
        [](const std::string&) {
          return mesh::AnimatedMesh::read(animated_box({0.5, 0.1, 0.5}, {0, 0.05, 0.1}, {0, 0.03F, 0}));
        });
    REQUIRE_OK(assets);
    Assets twice = *assets;
    mesh::Deformation& written = twice.deformations[0];
    const std::vector<double> round = written.times.times;
    REQUIRE(written.times.loops);
    REQUIRE(round.size() == 4);
    written.times.loops = false;
    for (int more = 1; more < 4; ++more)
      for (std::size_t k = 0; k < round.size(); ++k) {
        written.times.times.push_back(more * round.back() + round[k]);
        written.shapes.push_back(written.shapes[k]);
      }
    auto anew = world_from(fixture.device(), *scene, assets);
    auto apart = world_from(fixture.device(), *scene, Result<Assets>(twice));
    // Places differ by the rounding of their times, by 1e-16 of a round; contact must not tell.
    advance(*anew, 18);
    advance(*apart, 18);
    const auto a = anew->snapshot(), b = apart->snapshot();
    REQUIRE_OK(a);
    REQUIRE_OK(b);
    double most = 0;
    for (std::size_t v = 0; v < a->position.size(); ++v)
      most = std::max(most, static_cast<double>(length(a->position[v].xyz() - b->position[v].xyz())));
    MESSAGE(solver << ": apart by " << most << " m");
    CHECK(most < 1e-4);
    CHECK(anew->totals().contacts > 0);
    CHECK(static_cast<double>(a->position[40].y) > 0.06);  // it lies on the box, which is 0.1 m thick
  }
}

TEST_CASE("long: a skirt passes through neither itself nor the person who walks in it, for a whole cycle") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), shipped_scene("walk"));
  const std::vector<mesh::Triangle>& body = world->assets().objects.at(0).triangles;
  for (int check = 0; check < 9; ++check) {
    advance(*world, 8);
    const auto now = world->snapshot();
    REQUIRE_OK(now);
    const std::vector<Vec3d> cloth = places_of(*now), person = shape_now(*world);
    const reference::Surfaces skirt{cloth, world->model().host.triangles};
    CAPTURE(check);
    CHECK(reference::self_crossings(skirt).empty());
    CHECK(reference::crossings(skirt, {person, body}).empty());
    mesh::TriangleMesh solid{{}, body};
    for (const Vec3d& p : person) solid.positions.push_back(p.to<float>());
    CHECK(reference::inside_mesh(cloth, solid).count == 0);
  }
  CHECK(world->totals().crossings == 0);
  CHECK(world->totals().max_stretch < 1.1);
}

TEST_CASE("the mannequin is a closed body in every shape of its walk, and ends as it begins") {
  const scene::Scene scene = shipped_scene("walk");
  const auto assets = load_assets(scene, kModels);
  REQUIRE_OK(assets);
  const mesh::TriangleMesh& body = assets->objects.at(0);
  // Each edge is of two triangles, once each way.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ways;
  for (const mesh::Triangle& t : body.triangles)
    for (std::size_t k = 0; k < 3; ++k) ways.push_back({t[k], t[(k + 1) % 3]});
  std::sort(ways.begin(), ways.end());
  CHECK(std::adjacent_find(ways.begin(), ways.end()) == ways.end());
  for (const auto& [a, b] : ways) CHECK(std::binary_search(ways.begin(), ways.end(), std::pair{b, a}));
  const double volume = mesh::signed_volume(body);
  CHECK(volume > 0.05);
  CHECK(volume < 0.07);
  for (const std::vector<Vec3f>& shape : assets->deformations.at(0).shapes) {
    CHECK(std::abs(mesh::signed_volume({shape, body.triangles}) / volume - 1) < 0.05);
    double fastest = 0;
    for (std::size_t v = 0; v < body.positions.size(); ++v)
      fastest = std::max(fastest, static_cast<double>(length(shape[v] - body.positions[v])));
    CHECK(fastest < 1);
  }
  CHECK(assets->deformations[0].times.loops);
  CHECK(assets->deformations[0].times.times.back() == doctest::Approx(1.2));
}

TEST_CASE("the skirt's waist keeps its length as the mannequin walks") {
  const scene::Scene scene = shipped_scene("walk");
  const auto assets = load_assets(scene, kModels);
  REQUIRE_OK(assets);
  const auto model = build_model(scene, *assets);
  REQUIRE_OK(model);
  double least = 1, most = 1;
  for (int frame = 0; frame <= 72; ++frame) {
    const auto place = [&](std::uint32_t node) {
      return scene::motion_at(model->motions[model->motion[node] - 2],
                              frame / 60.0)(model->rest_position[node]);
    };
    for (const mesh::Edge& edge : mesh::mesh_edges(model->triangles)) {
      if (!model->kinematic(edge[0]) || !model->kinematic(edge[1])) continue;
      const double stretch = length(place(edge[0]) - place(edge[1])) /
                             length(model->rest_position[edge[0]] - model->rest_position[edge[1]]);
      least = std::min(least, stretch);
      most = std::max(most, stretch);
    }
  }
  MESSAGE("between " << least << " and " << most << " of it");
  CHECK(least > 0.9);
  CHECK(most < 1.1);
}
