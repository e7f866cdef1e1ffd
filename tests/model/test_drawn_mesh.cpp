#include <doctest/doctest.h>

#include "mesh/obj.hpp"
#include "model/mesh_file.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloths, std::size_t count) {
  const auto scene =
      scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [)" + cloths + "]}", "sheet.json");
  REQUIRE_MESSAGE(scene, scene.error().message);
  auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(count));
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}

/// A sheet of 2 m by 1 m and 5 x 3 nodes as it hangs at rest, each cell halved `level` times.
DrawnMesh drawn_sheet(std::uint32_t level) {
  const Model model = model_of(R"({"grid": [5, 3], "size": [2, 1], "density": 0.2})", 1);
  std::vector<Vec4f> positions;
  for (const Vec3d& p : model.rest_position) positions.push_back(Vec4f::from(p.to<float>(), 1));
  return drawn_mesh(model, positions, level);
}

}  // namespace

TEST_CASE("a picture covers the longer side of a sheet, and its upper edge lies along the sheet's top") {
  for (const std::uint32_t level : {0U, 1U}) {
    const DrawnMesh drawn = drawn_sheet(level);
    CAPTURE(level);
    REQUIRE(drawn.attributes.texture.size() == drawn.shape.positions.size());
    REQUIRE(drawn.attributes.normals.size() == drawn.shape.positions.size());
    const Vec3f corner = drawn.shape.positions[0];  // top left
    for (std::size_t v = 0; v < drawn.shape.positions.size(); ++v) {
      const Vec3f off = drawn.shape.positions[v] - corner;
      CHECK(drawn.attributes.texture[v][0] == doctest::Approx(off.x / 2));
      CHECK(drawn.attributes.texture[v][1] == doctest::Approx(0.5 + off.y / 2));
      CHECK(std::abs(drawn.attributes.normals[v].z) == doctest::Approx(1));
    }
  }
}

TEST_CASE("mesh files of all three formats have normals and texture coordinates, and there is no fourth") {
  const DrawnMesh drawn = drawn_sheet(0);
  for (const auto& [format, words] :
       {std::pair{"obj", "f 1/1/1 "}, {"ply", "property float s"}, {"glb", "TEXCOORD_0"}}) {
    const auto bytes = mesh_file(drawn, format);
    REQUIRE(bytes);
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    CAPTURE(format);
    CHECK(text.find(words) != std::string::npos);
  }
  CHECK(mesh_file(drawn, "stl").error().message ==
        "The format stl is not known; there are obj, ply and glb.");
}

TEST_CASE("the parts of a drawn mesh are its cloths, one after the other, with linear colours") {
  const std::string sheets =
      R"({"grid": [5, 3], "size": [2, 1], "density": 0.2, "color": [0, 0.5, 1]}, {"grid": [2, 7], "size": [1, 1],
        "density": 0.2})";
  const Model model = model_of(sheets, 2);
  std::vector<Vec4f> positions;
  for (const Vec3d& p : model.rest_position) positions.push_back(Vec4f::from(p.to<float>(), 1));
  for (const std::uint32_t level : {0U, 1U, 2U}) {
    CAPTURE(level);
    const std::vector<mesh::MeshPart> parts = drawn_parts(model, level);
    const mesh::TriangleMesh shape = drawn_mesh(model, positions, level).shape;
    REQUIRE(parts.size() == 2);
    CHECK(parts[0].vertices + parts[1].vertices == shape.positions.size());
    CHECK(parts[0].triangles + parts[1].triangles == shape.triangles.size());
    for (std::size_t t = 0; t < shape.triangles.size(); ++t)
      for (const std::uint32_t vertex : shape.triangles[t])
        CHECK((vertex < parts[0].vertices) == (t < parts[0].triangles));
    REQUIRE(parts[0].color);
    CHECK(parts[0].color->x == 0);
    CHECK(parts[0].color->y == doctest::Approx(0.2140411));  // IEC 61966-2-1
    CHECK(parts[0].color->z == 1);
    CHECK(!parts[1].color);
  }
}
