#include <doctest/doctest.h>

#include <filesystem>

#include "base/file.hpp"
#include "fake_run.hpp"
#include "mesh/obj.hpp"

using namespace weft;

namespace {

std::string parts_with(const std::string& parts, const std::string& frame = "0.5") {
  return R"({"format": "weft-meshes/1", "frame_s": )" + frame + R"(, "parts": )" + parts + "}";
}

}  // namespace

TEST_CASE("meshes.json is read as it is written, whatever the names") {
  MeshParts parts{1.0 / 24,
                  {{"a \"b\" \\ \n\x01 ü", 3, 1, {}}, {"", 4, 2, Vec3d{0, 0.1, 1}}, {"cloth_1", 5, 3, {}}}};
  name_apart(parts.parts);
  CHECK(parts.parts[1].name == "cloth_1");
  CHECK(parts.parts[2].name == "cloth_1_2");
  const auto back = read_parts(parts_json(parts), "meshes.json");
  REQUIRE_MESSAGE(back, back.error().message);
  CHECK(back.value().frame == parts.frame);
  REQUIRE(back.value().parts.size() == 3);
  for (std::size_t p = 0; p < 3; ++p) {
    CHECK(back.value().parts[p].name == parts.parts[p].name);
    CHECK(back.value().parts[p].vertices == parts.parts[p].vertices);
    CHECK(back.value().parts[p].triangles == parts.parts[p].triangles);
    CHECK(back.value().parts[p].color == parts.parts[p].color);
  }
}

TEST_CASE("a meshes.json that is wrong is refused with the place and the value") {
  const FakeRun run({0});
  const std::string path = run.run() + "/meshes.json", in = "In file " + path + ", ";
  const auto said = [&](const std::string& text) {
    REQUIRE(write_file(path, text));
    return run.refusal();
  };
  CHECK(said("{").find(path) != std::string::npos);
  CHECK(said("{}") == "File " + path + " has no \"format\": \"weft-meshes/1\".");
  CHECK(said(parts_with("[]")) == in + "parts is no list of parts.");
  CHECK(said(parts_with("[1]")) == in + "parts[0] is 1, not an object.");
  CHECK(said(parts_with("[{}]")) == in + "parts[0] has no name.");
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 0, "triangles": 1}])")) ==
        in + "parts[0].vertices is 0, not a number from 1 to 4294967295.");
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 1.5, "triangles": 1}])")) ==
        in + "parts[0].vertices is 1.5, not a whole number.");
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 4}])")) == in + "parts[0].triangles is missing.");
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 4, "triangles": 2, "color": [1, 2, 0]}])")) ==
        in + "parts[0].color has 2, not a number from 0 to 1.");
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 4, "triangles": 2}])", "0")) ==
        in + "frame_s is 0, not a number from 1e-09 to 1000000000.");
  const std::string a = R"({"name": "a", "vertices": 20, "triangles": 24})";
  CHECK(said(parts_with("[" + a + ", " + a + "]")) == in + "two parts have the name \"a\".");
  CHECK(said(parts_with("[" + a + "]"))
            .find("has 26 vertices and 28 triangles, but the parts of " + path + " have 20 and 24.") !=
        std::string::npos);
  CHECK(said(parts_with(R"([{"name": "a", "vertices": 10, "triangles": 24}, {"name": "b", "vertices": 16,
        "triangles": 4}])"))
            .find("has a triangle with vertex 10, which is not in part \"a\" of " + path + ".") !=
        std::string::npos);
}

TEST_CASE(
    "a folder without meshes, a range without any and meshes that differ are refused, each in one sentence") {
  const FakeRun run({3, 6, 9});
  CHECK(RunMeshes::open(run.path("none"), {}).error().message ==
        "Folder " + run.path("none") + " cannot be read: No such file or directory.");
  REQUIRE(make_folder(run.path("empty")));
  CHECK(RunMeshes::open(run.path("empty"), {}).error().message ==
        "Folder " + run.path("empty") + " has no meshes of a run: weft run SCENE --out " + run.path("empty") +
            " --meshes-every 1 writes them.");
  CHECK(run.refusal({4, 5, 1}) ==
        "Folder " + run.run() + " has no mesh of the frames 4 to 5; it has those of 3 frames, 3 to 9.");
  CHECK(run.refusal({9, 3, 1}).find("the frames 9 to 3;") != std::string::npos);

  const RunMeshes meshes = run.open();
  mesh::TriangleMesh other = run.shape(1);
  std::swap(other.triangles[0], other.triangles[1]);
  REQUIRE(write_file(run.run() + "/mesh_00006.obj", mesh::write_obj(other)));
  CHECK(meshes.read(1).error().message == "File " + run.run() + "/mesh_00006.obj has other triangles than " +
                                              run.run() + "/mesh_00003.obj, the first mesh.");
  other.positions.push_back({});
  REQUIRE(write_file(run.run() + "/mesh_00006.obj", mesh::write_obj(other)));
  CHECK(meshes.read(1).error().message == "File " + run.run() +
                                              "/mesh_00006.obj has 27 vertices and 28 triangles, but " +
                                              run.run() + "/mesh_00003.obj, the first mesh, has 26 and 28.");
  std::filesystem::remove(run.run() + "/mesh_00006.obj");
  CHECK(meshes.read(1).error().message.find("mesh_00006.obj cannot be read") != std::string::npos);
  std::filesystem::remove(run.run() + "/meshes.json");
  CHECK(run.refusal() == "File " + run.run() + "/meshes.json cannot be read: No such file or directory.");
}

TEST_CASE("files of other names are no meshes of a run, and one as OBJ and PLY counts once") {
  const FakeRun run({0, 1, 2});
  for (const char* name : {"mesh_.obj", "mesh_1x.obj", "mesh_00007.stl", "mesh_0000000008.obj",
                           "mesh_00003.obj.tmp12", "final.obj", "mesh_00001.ply"})
    REQUIRE(write_file(run.run() + "/" + name, std::string("x")));
  const RunMeshes meshes = run.open();
  REQUIRE(meshes.count() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto shape = meshes.read(k);
    REQUIRE(shape);
    CHECK(shape.value().positions == run.shape(k).positions);
  }
}
