#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>

#include "mesh/glb.hpp"
#include "mesh/mesh_files.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "weft.hpp"

using namespace weft;
using namespace weft::mesh;

namespace {

struct BadMesh {
  std::string name;   // of the file
  std::string bytes;  // what is in it
  std::string words;  // of the message
};

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string half(const std::string& text) { return text.substr(0, text.size() / 2); }

std::vector<BadMesh> bad_meshes() {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string ply = text_of(write_ply(cube())), off = text_off(cube());
  const std::string stl = text_stl(cube()), binary = binary_stl(cube());
  const std::string text_ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string cut_face =
      text_of(write_obj(cube()))
          .substr(0, text_of(write_obj(cube())).find("f ") + 3);  // an OBJ has no counts
  return {
      // Of no kind.
      {"a.txt", "hello", "does not end in .glb"},
      {"a.obj.gz", gzip(points), "does not end in .glb"},
      {"none.obj", "", "The mesh has no triangles"},
      {"noise.ply", repeated("\xff\x00\x7f\n", 5000), "not with ply"},
      // OBJ.
      {"half.obj", cut_face, "Line 9 has a face of 1 corners"},
      {"points.obj", points, "The mesh has no triangles"},
      {"two.obj", "v 0 0\n", "Line 1 has 2 coordinates, fewer than 3"},
      {"nan.obj", points + "v nan 0 0\nf 1 2 3\n",
       "Line 4 has the coordinate \"nan\", which is not a finite number"},
      {"inf.obj", points + "v 0 -inf 0\nf 1 2 3\n", "Line 4 has the coordinate \"-inf\""},
      {"huge.obj", points + "v 0 1e39 0\nf 1 2 3\n", "beyond the largest of single precision"},
      {"word.obj", "v 0 zero 0\nf 1 1 1\n", "Line 1 has the coordinate \"zero\""},
      {"zero.obj", points + "f 0 1 2\n", "Line 4 names vertex 0, which is not in 1 to 3"},
      {"past.obj", points + "f 1 2 4\n", "Line 4 names vertex 4, which is not in 1 to 3"},
      {"back.obj", points + "f -1 -2 -4\n", "Line 4 names vertex -4, but only 3 vertices come before it"},
      {"far.obj", points + "f 1 2 " + std::string(30, '9') + "\n", "Line 4 has the corner \"99"},
      {"corners.obj", points + "f 1 2\n", "Line 4 has a face of 2 corners, fewer than 3"},
      {"digits.obj", "v " + std::string(3'000'000, '1') + " 0 0\nf 1 1 1\n",
       "Line 1 has the coordinate 111111"},
      {"fan.obj", points + "f" + repeated(" 1", 1'000'000) + " 9\n", "Line 4 names vertex 9"},
      {"slashes.obj", repeated("\\\n", 500'000), "The mesh has no triangles"},
      {"zeros.obj", std::string(100'000, '\0'), "The mesh has no triangles"},
      {"lines.obj", points + "f 1 2 \x1b[31m\x07\n", "Line 4 has the corner \"?[31m?\""},
      // PLY.
      {"half.ply", half(ply), "has 8 rows, but the file can hold at most 3"},
      {"cut.ply", ply.substr(0, ply.size() - 1), "all that the file can hold"},
      {"keyword.ply", "ply", "The file ends on line 1, before end_header"},
      {"format.ply", replaced(text_ply, "ascii", "binary"), "format"},
      {"vertices.ply", replaced(ply, "vertex 8", "vertex 4000000000"),
       "has 4000000000 rows, but the file can hold at most 21"},
      {"faces.ply", replaced(ply, "face 12", "face 9223372036854775807"), "has 9223372036854775807 rows"},
      {"beyond.ply", replaced(ply, "face 12", "face 99999999999999999999"),
       "the count \"99999999999999999999\""},
      {"negative.ply", replaced(ply, "vertex 8", "vertex -8"), "the count \"-8\""},
      {"void.ply", "ply\nformat ascii 1.0\nelement void 4611686018427387904\nend_header\n",
       "The header has no element vertex"},
      {"list.ply", replaced(ply, "list uchar", "list uint"), "has the size 196608"},
      {"twice.ply", replaced(text_ply, "float z", "float x"), "x"},
      {"float.ply", replaced(text_ply, "uchar int", "uchar float"), "is not a list of integers"},
      {"index.ply", replaced(text_ply, "3 0 1 2", "3 0 1 3"), "names vertex 3, but the mesh has 3 vertices"},
      {"minus.ply", replaced(text_ply, "3 0 1 2", "3 0 1 -1"),
       "names vertex -1, but the mesh has 3 vertices"},
      {"nan.ply", replaced(text_ply, "1 0 0", "1 nan 0"),
       "The value \"nan\" on line 11 is not a finite number"},
      {"properties.ply",
       "ply\nformat ascii 1.0\nelement vertex 0\n" + repeated("property int a\n", 1'000'000),
       "over the limit of 64"},
      {"comment.ply", "ply\ncomment " + std::string(3'000'000, 'c'),
       "The file ends on line 2, before end_header"},
      // Packed PLY.
      {"half.ply.gz", half(gzip(ply)), "before they are complete"},
      {"bomb.ply.gz", gzip(text_ply + std::string(5'000'000, ' ')),
       "bytes of gzip data unpack to more than the limit of"},
      {"deep.ply.gz", gzip(gzip(ply)), "The gzip data hold gzip data again"},
      {"sum.ply.gz", replaced(gzip(ply), gzip(ply).substr(gzip(ply).size() - 8, 4), "\1\2\3\4"),
       "incorrect data check"},
      {"header.ply.gz", "\x1f\x8b", "The gzip data end at byte 2"},
      {"many.ply.gz", repeated(gzip(""), 10'000), "not with ply"},
      // GLB.
      {"half.glb", half(text_of(write_glb(cube(), {smooth_normals(cube()), {}}))), "bytes, but the file has"},
      {"noise.glb", repeated("\xff\x00\x7f\n", 5000), "not with the 0x46546c67 of a GLB file"},
      {"past.glb",
       replaced(text_of(write_glb(cube(), {smooth_normals(cube()), {}})), "\"count\":8,", "\"count\":9,"),
       "accessors[0].count is 9; it must be a whole number from 0 to 8"},
      {"elsewhere.glb",
       replaced(text_of(write_glb(cube(), {smooth_normals(cube()), {}})), "\"byteLength\":336",
                "\"uri\":\"a.bi\"    "),
       "buffers[0].uri names data outside of the file"},
      // STL.
      {"short.stl", std::string(83, 'x'), "where \"solid\" is due"},
      {"none.stl", std::string(84, '\0'), "The mesh has no triangles"},
      {"half.stl", half(stl), "ends the file"},
      {"cut.stl", binary.substr(0, binary.size() - 7), "take 684 bytes, but it has 677"},
      {"count.stl", replaced(binary, std::string("\x0c\0\0\0", 4), "\xff\xff\xff\xff"),
       "The file states 4294967295 triangles"},
      {"nan.stl", replaced(stl, "vertex 0", "vertex nan"), "Line 4 has the coordinate \"nan\""},
      {"word.stl", replaced(stl, "vertex", "vortex"), "Line 4 has \"vortex\" where \"vertex\" is due"},
      {"solids.stl", "solid a\n" + repeated("solid b\n", 100'000), "Line 2 has \"solid\""},
      // OFF.
      {"keyword.off", "OOF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "Line 1 begins with \"OOF\""},
      {"half.off", half(off), "announces 12 faces, more than the 73 bytes after it can hold"},
      {"vertices.off", replaced(off, "8 12", "4000000000 12"), "announces 4000000000 vertices"},
      {"faces.off", replaced(off, "8 12", "8 9223372036854775807"), "announces 9223372036854775807 faces"},
      {"corners.off", replaced(off, "3 0 2 1", "4000000000 0 2 1"), "announces a face of 4000000000 corners"},
      {"index.off", replaced(off, "3 0 2 1", "3 0 2 8"), "names vertex \"8\", but the mesh has 8 vertices"},
      {"nan.off", replaced(off, "1 1 0", "1 nan 0"), "Line 5 has the coordinate \"nan\""},
      {"polygons.off", "OFF\n1 90000 0\n0 0 0\n" + repeated("399999 0\n", 90'000),
       "but all faces together have at most 405001"},
  };
}

std::string scene_with_collider(const std::string& mesh) {
  return tiny_scene(R"("colliders": [{"kind": "mesh", "mesh": ")" + mesh + R"("}], )");
}
std::string scene_with_cloth(const std::string& mesh) {
  return scene_of_cloth(R"("mesh": ")" + mesh + R"(", "density": 0.2)");
}

/// The output of weft check for a scene of this folder.
Ended check(const TemporaryFolder& folder, const std::string& scene) {
  put(folder, "a.json", scene);
  return run_without_driver({"check", "a.json"}, {{}, folder.path(""), false});
}

}  // namespace

TEST_CASE("every bad mesh is refused in one sentence that names it, as a collider and as a cloth") {
  const auto table = bad_meshes();
  CHECK(table.size() >= 40);
  for (const BadMesh& bad : table) {
    CAPTURE(bad.name);
    const TemporaryFolder folder;
    put(folder, bad.name, bad.bytes);
    const Ended collider = check(folder, scene_with_collider(bad.name));
    CHECK(check_refusal(collider, 3, bad.words, bad.bytes.size()) == "");
    CHECK(collider.err.rfind(
              "weft: While loading a.json: colliders[0]: While reading mesh " + bad.name + ": ", 0) == 0);
    const Ended cloth = check(folder, scene_with_cloth(bad.name));
    CHECK(check_refusal(cloth, 3, bad.words, bad.bytes.size()) == "");
    CHECK(cloth.err.rfind("weft: While loading a.json: cloths[0]: While reading mesh " + bad.name + ": ",
                          0) == 0);
  }
}

TEST_CASE(
    "good meshes of every format are read, as a collider and as a cloth, in memory that follows their size") {
  const std::pair<std::string, std::string> files[] = {{"a.obj", text_of(write_obj(cube()))},
                                                       {"a.ply", text_of(write_ply(cube()))},
                                                       {"a.ply.gz", gzip(text_of(write_ply(cube())))},
                                                       {"a.off", text_off(cube())},
                                                       {"a.stl", binary_stl(cube())},
                                                       {"A.STL", text_stl(cube())}};
  const TemporaryFolder folder;
  for (const auto& [name, bytes] : files) {
    put(folder, name, bytes);
    const Ended collider = check(folder, scene_with_collider(name));
    CHECK_MESSAGE(collider.code == 0, collider.err);
    CHECK(collider.out.find("1 collider with 12 triangles") != std::string::npos);
    const Ended cloth = check(folder, scene_with_cloth(name));
    CHECK_MESSAGE(cloth.code == 0, cloth.err);
    CHECK(cloth.out.find("8 nodes and 12 triangles") != std::string::npos);
  }
}

TEST_CASE("meshes that are no files, or hold nothing of use, are refused") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("folder.obj"));
  put(folder, "secret.obj", text_of(write_obj(cube())));
  REQUIRE(::chmod(folder.path("secret.obj").c_str(), 0) == 0);
  REQUIRE(::mkfifo(folder.path("pipe.obj").c_str(), 0600) == 0);
  std::filesystem::create_symlink("loop.obj", folder.path("loop.obj"));
  put(folder, "flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\nf 1 1 2\n");
  put(folder, "loose.obj", text_of(write_obj(cube())) + "v 5 5 5\n");
  put(folder, "large.obj", "v 3e38 0 0\nv 0 3e38 0\nv 0 0 3e38\nf 1 2 3\n");
  const std::pair<std::string, std::string> rows[] = {
      {scene_with_collider("missing.obj"), "missing.obj cannot be read: No such file or directory"},
      {scene_with_collider("folder.obj"), "folder.obj is not a regular file"},
      {scene_with_collider("secret.obj"), "secret.obj cannot be read: Permission denied"},
      {scene_with_collider("pipe.obj"), "pipe.obj is not a regular file"},
      {scene_with_collider("/dev/zero.obj"), "cannot be read"},
      {scene_with_collider("loop.obj"), "loop.obj cannot be read: Too many levels of symbolic links"},
      {scene_with_collider("nosuchmodel"), "nosuchmodel"},
      {scene_with_collider("a\\nb.obj"), "is not a path"},
      {scene_with_collider("flat.obj"), "flat.obj has no triangle with an area"},
      {scene_with_cloth("missing.obj"), "missing.obj cannot be read: No such file or directory"},
      {scene_with_cloth("secret.obj"), "secret.obj cannot be read: Permission denied"},
      {scene_with_cloth("flat.obj"), "area"},
      {scene_with_cloth("loose.obj"), "While building a.json: cloths[0]: "},
      {scene_of_cloth(R"("mesh": "large.obj", "density": 1, "transform": {"scale": 1e6})"),
       "While placing a.json: cloths[0]: "},
  };
  for (const auto& [scene, words] : rows) {
    CAPTURE(scene);
    CHECK(check_refusal(check(folder, scene), 3, words, scene.size()) == "");
  }
}
