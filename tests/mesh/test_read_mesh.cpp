#include <doctest/doctest.h>

#include "base/file.hpp"
#include "mesh/glb.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh_files.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using namespace weft::mesh;

TEST_CASE("a mesh is read by the end of its name, in capitals or not") {
  const TemporaryFolder folder;
  const std::string ply = text_of(write_ply(cube()));
  const std::pair<const char*, std::string> files[] = {
      {"a.obj", text_of(write_obj(cube()))},
      {"A.OBJ", text_of(write_obj(cube()))},
      {"a.ply", ply},
      {"a.ply.gz", gzip(ply)},
      {"a.glb", text_of(write_glb(cube(), {smooth_normals(cube()), {}}))},
      {"b.GLB", elaborate_glb()},
      {"b.Ply.Gz", gzip(ply)},
      {"b.ply", elaborate_ply(PlyFormat::Text, cube(), 1)},
      {"a.off", text_off(cube())},
      {"a.b.stl", text_stl(cube())},
      {"b.stl", binary_stl(cube())}};
  for (const auto& [name, content] : files) {
    INFO(name);
    REQUIRE(write_file(folder.path(name), content));
    const auto mesh = read_mesh(folder.path(name));
    REQUIRE(mesh);
    CHECK(signed_volume(*mesh) == doctest::Approx(1.0));
    CHECK(mesh->positions.size() == 8);
  }
}

TEST_CASE(
    "a mesh file that is missing, a folder, of another kind or broken is an input error with its name") {
  const TemporaryFolder folder;
  REQUIRE(make_folder(folder.path("folder.ply")));
  REQUIRE(write_file(folder.path("mesh.fbx"), std::string("x")));
  REQUIRE(write_file(folder.path("broken.obj"), std::string("v 0 0\n")));
  REQUIRE(write_file(folder.path(".obj"), write_obj(cube())));
  for (const char* name : {"missing.obj", "folder.ply", "mesh.fbx", "broken.obj", "none/a.off"}) {
    INFO(name);
    const auto mesh = read_mesh(folder.path(name));
    REQUIRE_FALSE(mesh);
    CHECK(mesh.error().kind == ErrorKind::Input);
    CHECK(mesh.error().message.find("While reading mesh " + folder.path(name) + ": ") == 0);
  }
  CHECK(read_mesh(folder.path("broken.obj")).error().message ==
        "While reading mesh " + folder.path("broken.obj") + ": Line 1 has 2 coordinates, fewer than 3.");
  CHECK_FALSE(read_mesh(""));
}
