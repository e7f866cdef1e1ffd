// Bodies of scenes: from blocks, filled surfaces and tetrahedral meshes, placed with their mass.
#include <doctest/doctest.h>

#include <fstream>
#include <numeric>

#include "mesh/primitives.hpp"
#include "model/assets.hpp"
#include "model/attachments.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"
#include "temporary_folder.hpp"

using namespace weft;

namespace {

scene::Scene bodies(const std::string& list, const std::string& file = "a.json") {
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "bodies": [)" + list + "]}", file);
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

/// A ball of radius 1 and the unit tetrahedron, and how often each was asked for.
struct Readers {
  int balls = 0, tets = 0;
  Result<Assets> load(const scene::Scene& scene) {
    return load_assets(
        scene,
        [&](const std::string& name) -> Result<mesh::TriangleMesh> {
          ++balls;
          mesh::TriangleMesh ball = mesh::make_sphere(24, 16);
          if (name == "open.ply") ball.triangles.pop_back();
          return ball;
        },
        no_animation,
        [&](const std::string&) -> Result<mesh::TetMesh> {
          ++tets;
          return mesh::TetMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
        });
  }
};

double total_mass(const Model& model) { return std::accumulate(model.mass.begin(), model.mass.end(), 0.0); }

const std::string kMaterial = R"("density": 500, "material": {"young": 1000})";

}  // namespace

TEST_CASE("a body weighs its density by its volume, however it was made, turned and scaled") {
  const std::string transform =
      R"(, "transform": {"scale": 0.5, "rotate": [0, 0.6, 0, 0.8], "translate": [7, 8, 9]}, )";
  const std::string block = R"({"block": [2, 3, 4], "size": [1, 2, 3])", tets = R"({"tetrahedra": "a.msh")",
                    ball = R"({"surface": "ball.ply", "cell": 0.05)";
  for (const auto& [body, volume, error] :
       {std::tuple{block, 6.0, 1e-5}, {tets, 1.0 / 6, 1e-5}, {ball, 4.0, 0.06}}) {
    CAPTURE(body);
    Readers readers;
    const scene::Scene scene = bodies(body + transform + kMaterial + "}");
    const auto assets = readers.load(scene);
    REQUIRE_MESSAGE(static_cast<bool>(assets), assets.error().message);
    const auto model = build_model(scene, *assets);
    REQUIRE_MESSAGE(static_cast<bool>(model), model.error().message);
    CHECK(total_mass(*model) == doctest::Approx(500 * volume / 8).epsilon(error));
    Vec3d middle;
    for (std::size_t n = 0; n < model->vertex_count(); ++n)
      middle += model->mass[n] * model->rest_position[n];
    middle = middle / total_mass(*model);
    CHECK(length(middle - Vec3d{7, 8, 9}) < 0.4);
  }
}

TEST_CASE("the cells of a filled surface are as large as said in the world, whatever its scale") {
  std::size_t counts[2] = {};
  for (const int k : {0, 1}) {
    Readers readers;
    const std::string scale = k == 0 ? "1" : "0.01", cell = k == 0 ? "0.25" : "0.0025";
    const auto assets =
        readers.load(bodies(R"({"surface": "ball.ply", "cell": )" + cell + R"(, "transform": {"scale": )" +
                            scale + "}, " + kMaterial + "}"));
    REQUIRE_MESSAGE(static_cast<bool>(assets), assets.error().message);
    counts[k] = assets->solids[0].tets.size();
  }
  CHECK(counts[0] > 100);
  CHECK(counts[0] == counts[1]);
}

TEST_CASE("copies of a body are read and filled once, and stand apart") {
  Readers readers;
  const scene::Scene scene = bodies(
      R"({"surface": "ball.ply", "cell": 0.5, "copies": {"count": 3, "offset": [0, 4, 0]}, )" + kMaterial +
      R"(}, {"tetrahedra": "a.msh", "copies": {"count": 2, "offset": [3, 0, 0]}, )" + kMaterial + "}");
  const auto assets = readers.load(scene);
  REQUIRE_MESSAGE(static_cast<bool>(assets), assets.error().message);
  CHECK(readers.balls == 1);
  CHECK(readers.tets == 1);
  const auto model = build_model(scene, *assets);
  REQUIRE_MESSAGE(static_cast<bool>(model), model.error().message);
  REQUIRE(model->bodies.size() == 5);
  const Body &first = model->bodies[0], &third = model->bodies[2];
  REQUIRE(first.vertex_count == third.vertex_count);
  for (std::uint32_t n = 0; n < first.vertex_count; ++n)
    CHECK(length(model->rest_position[third.first_vertex + n] - model->rest_position[first.first_vertex + n] -
                 Vec3d{0, 8, 0}) < 1e-6);
}

TEST_CASE(
    "a surface that is open, and a mesh that is none, are refused with the body's place and the reason") {
  Readers readers;
  const auto open = readers.load(bodies(R"({"surface": "open.ply", "cell": 0.5, )" + kMaterial + "}"));
  REQUIRE_FALSE(open);
  CHECK(open.error().kind == ErrorKind::Input);
  CHECK(open.error().message.find("loading a.json: bodies[0]") != std::string::npos);
  CHECK(open.error().message.find("edge") != std::string::npos);
  const auto none = load_assets(bodies(R"({"tetrahedra": "a.msh", )" + kMaterial + "}"),
                                [](const std::string& name) -> Result<mesh::TriangleMesh> {
                                  return input_error("%s was not expected.", name.c_str());
                                });
  REQUIRE_FALSE(none);
  CHECK(none.error().message.find("Mesh a.msh has no tetrahedra") != std::string::npos);
}

TEST_CASE("tetrahedra come from a file beside the scene, and TetGen's nodes from the one beside that") {
  const TemporaryFolder folder;
  const auto put = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.path(name)) << text;
  };
  put("a.node", "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  put("a.ele", "1 4 0\n1 1 3 2 4\n");  // inside out by its order
  const scene::Scene scene = bodies(R"({"tetrahedra": "a.ele", )" + kMaterial + "}", folder.path("s.json"));
  const auto assets = load_assets(scene, source_path("models"));
  REQUIRE_MESSAGE(static_cast<bool>(assets), assets.error().message);
  const auto model = build_model(scene, *assets);
  REQUIRE_MESSAGE(static_cast<bool>(model), model.error().message);
  CHECK(total_mass(*model) == doctest::Approx(500.0 / 6));
  const auto missing = load_assets(
      bodies(R"({"tetrahedra": "b.ele", )" + kMaterial + "}", folder.path("s.json")), source_path("models"));
  REQUIRE_FALSE(missing);
  CHECK(missing.error().message.find("b.ele") != std::string::npos);
}
