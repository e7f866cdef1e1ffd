#include <doctest/doctest.h>
#include <signal.h>

#include <cstring>
#include <filesystem>

#include "mesh/grid.hpp"
#include "mesh/ply.hpp"
#include "weft.hpp"

using namespace weft;

namespace {

/// A folder as of a run of `count` frames whose meshes are all one sheet of so many nodes a side.
std::string still_run(const TemporaryFolder& folder, std::uint32_t count, std::uint32_t side) {
  const mesh::Grid grid{side, side};
  mesh::TriangleMesh sheet{{}, mesh::grid_triangles(grid)};
  for (std::uint32_t v = 0; v < side * side; ++v)
    sheet.positions.push_back({static_cast<float>(v % side), static_cast<float>(v / side), 0});
  std::filesystem::create_directories(folder.path("run"));
  const auto bytes = mesh::write_ply(sheet);
  put(folder, "run/mesh_00000.ply", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  put(folder, "run/meshes.json",
      R"({"format": "weft-meshes/1", "frame_s": 0.1, "parts": [{"name": "a", "vertices": )" +
          std::to_string(side * side) + R"(, "triangles": )" + std::to_string(sheet.triangles.size()) +
          "}]}");
  for (std::uint32_t frame = 1; frame < count; ++frame) {
    char name[32];
    std::snprintf(name, sizeof name, "run/mesh_%05u.ply", frame);
    std::filesystem::create_symlink("mesh_00000.ply", folder.path(name));
  }
  return folder.path("run");
}

float float_at(const std::string& bytes, std::size_t offset) {
  float value = 0;
  REQUIRE(offset + sizeof value <= bytes.size());
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

std::vector<std::string> beside(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("")))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("a run of two cloths with a copy is exported by its names, its times and the bits of its meshes") {
  const TemporaryFolder folder;
  const std::string sheet = R"("size": [1, 1], "density": 0.2, "damping": 0, "stiffness":
      {"structural": 1, "shear": 0, "bend": 0})";
  const std::string scene =
      put(folder, "a.json",
          R"({"format": "weft-scene/1", "time": {"frame": 0.125, "substeps": 4, "frames": 5}, "cloths": [
             {"name": "flag", "grid": [4, 3], "color": [1, 0.5, 0], )" +
              sheet + R"(, "copies": {"count": 2, "offset": [3, 0, 0]}}, {"grid": [3, 3], )" + sheet + "}]}");
  const std::string out = folder.path("out");
  const Ended ran = run_weft(
      {"run", scene, "-o", out, "-q", "--no-pictures", "--meshes-every", "2", "--checkpoint-every", "3"});
  REQUIRE_MESSAGE(ran.code == 0, ran.err);
  const auto parts = json_of(read_text(out + "/meshes.json"));
  CHECK(parts["frame_s"] == 0.125);
  REQUIRE(parts["parts"].size() == 3);
  const char* const names[] = {"flag", "flag_2", "cloth_2"};
  for (std::size_t p = 0; p < 3; ++p) {
    CHECK(parts["parts"][p]["name"] == names[p]);
    CHECK(parts["parts"][p]["vertices"] == (p < 2 ? 12 : 9));
    CHECK(parts["parts"][p]["triangles"] == (p < 2 ? 12 : 8));
    CHECK(parts["parts"][p].contains("color") == (p < 2));
  }
  CHECK(parts["parts"][0]["color"][1].get<double>() == doctest::Approx(0.21404114));  // sRGB's 0.5, linear

  const Ended ended = run_without_driver({"export", out, "--format", "pc2"});
  CHECK(ended.code == 0);
  CHECK(ended.err == "");
  CHECK(ended.out == out + ".pc2, " + out + ".obj: 3 meshes of 33 vertices, frames 0 to 4, 0.500 s\n");
  const std::string cache = read_text(out + ".pc2");
  REQUIRE(cache.size() == 32 + 3 * 33 * 12);
  CHECK(float_at(cache, 24) == 2.0F);
  for (std::size_t k = 0; k < 3; ++k) {
    const mesh::TriangleMesh mesh = read_obj_file(out + "/mesh_0000" + std::to_string(2 * k) + ".obj");
    for (std::size_t v = 0; v < 33; ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(float_at(cache, 32 + 4 * (3 * (33 * k + v) + axis)) ==
              mesh.positions[v][static_cast<int>(axis)]);
  }
  const Ended quiet =
      run_without_driver({"export", out, "--format", "glb", "-q", "-o", folder.path("x.glb")});
  CHECK(quiet.code == 0);
  CHECK(quiet.out == "");
  const std::string glb = read_text(folder.path("x.glb"));
  for (const char* name : names)
    CHECK(glb.find("\"name\":\"" + std::string(name) + "\"") != std::string::npos);

  // A run that goes on without meshes keeps those of before its checkpoint, and what they are.
  REQUIRE(
      run_weft({"run", scene, "-o", out, "-q", "--no-pictures", "--resume", out + "/checkpoint_00003.weft"})
          .code == 0);
  CHECK(run_without_driver({"export", out, "--format", "mdd"})
            .out.find("2 meshes of 33 vertices, frames 0 to 2") != std::string::npos);
  // And one from the start without any leaves none.
  REQUIRE(run_weft({"run", scene, "-o", out, "-q", "--no-pictures"}).code == 0);
  CHECK(names_in(out) == std::vector<std::string>{"final.obj", "frames.csv", "summary.json"});
}

TEST_CASE("what cannot be exported ends with one sentence and its exit code, and nothing is written") {
  const TemporaryFolder folder;
  const std::string run = still_run(folder, 3, 4);
  const auto check_refused = [&](std::vector<std::string> words, int code, const std::string& said) {
    words.insert(words.begin(), {"export", run});
    const Ended ended = run_without_driver(words);
    CHECK(ended.code == code);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    CHECK_MESSAGE(ended.err.find(said) != std::string::npos, ended.err);
    CHECK(beside(folder) == std::vector<std::string>{"run"});
  };
  check_refused({}, 2, "--format is required");
  check_refused({"--format", "fbx"}, 2,
                "--format does not know \"fbx\"; there are: glb, pc2, mdd, obj, ply, usda, usdc, abc.");
  check_refused(
      {"--format", "usdc"}, 1,
      "The Python package writes the format usdc: after pip install 'weft[usd]', python -m weft export " +
          run + " --format usdc.");
  check_refused({"--format", "glb", "--every", "0"}, 2, "not in range");
  check_refused({"--format", "glb", "--first", "ten"}, 2, "\"ten\" is not a whole number");
  check_refused({"--format", "glb", "--first", "7"}, 3,
                "has no mesh of the frames 7 to 2; it has those of 3 frames, 0 to 2.");
  check_refused({"--format", "glb", "-o", folder.path("none/a.glb")}, 1, "none/a.glb");
  check_refused({"--format", "pc2", "-o", folder.path("a.obj")}, 2,
                "a.obj would be the cache and the OBJ file of its first mesh both.");
  check_refused({"--format", "mdd", "-o", run}, 1, "cannot be replaced: Is a directory");
  CHECK(run_without_driver({"export", folder.path("none"), "--format", "glb"}).code == 3);
}

TEST_CASE("an export that is interrupted ends with exit code 130 and leaves nothing") {
  for (const char* format : {"mdd", "ply"}) {
    const TemporaryFolder folder;
    const std::string run = still_run(folder, 5000, 200);  // minutes
    Child child(weft_command({"export", run, "--format", format}), on_lavapipe({}));
    REQUIRE(eventually([&] { return beside(folder).size() > 1; }));
    child.signal(SIGINT);
    const Ended ended = child.wait();
    CHECK(ended.code == 130);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.find("of 5000 meshes; nothing is written.") != std::string::npos);
    CHECK(beside(folder) == std::vector<std::string>{"run"});
  }
}

TEST_CASE("a disk that is full ends the export with exit code 1 and leaves nothing") {
  const TemporaryFolder folder;
  const std::string run = still_run(folder, 20, 50);  // 600 kB of places
  const Ended ended = call({"/bin/sh", "-c",
                            "trap '' XFSZ; ulimit -f 400; exec " + weft_binary() + " export " + run +
                                " --format mdd"});  // blocks of 512 bytes
  CHECK(ended.code == 1);
  CHECK(check_message(ended.err) == "");
  CHECK(ended.err.find("takes only ") != std::string::npos);
  CHECK(beside(folder) == std::vector<std::string>{"run"});
}

TEST_CASE("an export holds one mesh at a time") {
  const TemporaryFolder folder;
  const std::string run = still_run(folder, 600, 100);
  for (const char* format : {"pc2", "glb"}) {
    const Ended ended = run_without_driver({"export", run, "--format", format, "-q"});
    CHECK(ended.code == 0);
    CHECK(std::filesystem::file_size(folder.path("run.") + format) > (std::size_t{68} << 20U));
    CHECK(ended.peak < (std::size_t{kSanitized ? 256 : 48} << 20U));
  }
}
