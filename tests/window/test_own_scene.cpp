#include "player/own_scene.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "mesh/mesh_files.hpp"
#include "mesh/ply.hpp"
#include "model/assets.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using namespace weft::window;

namespace {

OwnMesh read_box(const TemporaryFolder& folder, bool with_sliver) {
  mesh::TriangleMesh box = mesh::cube();
  if (with_sliver) box.triangles.push_back({0, 0, 1});
  REQUIRE(write_file(folder.path("box.ply"), mesh::write_ply(box)));
  auto own = read_own_mesh(folder.path("box.ply"));
  REQUIRE(own);
  return std::move(*own);
}

}  // namespace

TEST_CASE("a dropped mesh comes without triangles that have no area, and says what it is") {
  const TemporaryFolder folder;
  const OwnMesh own = read_box(folder, true);
  CHECK(own.name == "box.ply");
  CHECK(own.dropped == 1);
  CHECK(own.mesh.triangles.size() == 12);
  const double side = own.longest_side();
  CHECK(own.area == doctest::Approx(6 * side * side));
}

TEST_CASE("what is dropped and is no mesh is refused with its name") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder.path("no.obj"), std::string("hello")));
  const auto own = read_own_mesh(folder.path("no.obj"));
  REQUIRE(!own);
  CHECK(own.error().kind == ErrorKind::Input);
  CHECK(own.error().message.find("no.obj") != std::string::npos);
  CHECK(!read_own_mesh(folder.path("missing.obj")));
}

TEST_CASE("both scenes of a mesh are scenes, with the mesh as long as it was asked for") {
  const TemporaryFolder folder;
  const OwnMesh own = read_box(folder, false);
  for (const Role role : {Role::Obstacle, Role::Cloth}) {
    const auto scene = scene::parse_scene(scene_of_mesh(own, role, 2.5), "box.ply");
    REQUIRE_MESSAGE(scene, scene.error().message);
    const auto assets = load_assets(*scene, [&](const std::string& name) -> Result<mesh::TriangleMesh> {
      CHECK(name == kOwnMesh);
      return own.mesh;
    });
    REQUIRE(assets);
    const mesh::TriangleMesh& placed = role == Role::Obstacle ? assets->objects.at(0) : assets->cloths.at(0);
    const mesh::Bounds box = mesh::bounds(placed);
    CHECK(box.high.x - box.low.x == doctest::Approx(2.5));
    CHECK(box.low.x == doctest::Approx(-1.25));
    CHECK(box.low.y == doctest::Approx(role == Role::Obstacle ? 0 : 2 * 0.25 * 2.5 + 0.08 * 2.5));
  }
}

TEST_CASE("a dropped mesh makes the scene that it makes on the page") {
  // tests/web/page/own_scene.test.ts holds the page to the same file.
  const auto bytes = read_file(source_path("tests/window/own_scenes.json"), 1U << 20U);
  REQUIRE(bytes);
  const auto stored =
      nlohmann::json::parse(std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
  OwnMesh own;
  const auto& mesh = stored.at("mesh");
  own.name = mesh.at("name");
  own.mesh.positions.resize(mesh.at("vertices"));
  own.mesh.triangles.resize(mesh.at("triangles"));
  const auto point = [](const nlohmann::json& p) -> Vec3f { return {p.at(0), p.at(1), p.at(2)}; };
  own.box = {point(mesh.at("low")), point(mesh.at("high"))};
  own.area = mesh.at("area");
  CHECK(nlohmann::json::parse(scene_of_mesh(own, Role::Obstacle, stored.at("length"))) ==
        stored.at("obstacle"));
  CHECK(nlohmann::json::parse(scene_of_mesh(own, Role::Cloth, stored.at("length"))) == stored.at("cloth"));
}
