#include <doctest/doctest.h>

#include <bit>
#include <filesystem>

#include "base/file.hpp"
#include "fake_run.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/texture.hpp"

using namespace weft;

namespace {

/// Four bytes of the other order.
template <class T>
T big_endian_at(const std::string& bytes, std::size_t offset) {
  const std::string turned = {bytes.at(offset + 3), bytes.at(offset + 2), bytes.at(offset + 1),
                              bytes.at(offset)};
  return value_at<T>(turned, 0);
}

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

std::vector<std::array<float, 2>> texture_in(const std::string& path, std::size_t vertices) {
  const std::string text = text_of_file(path);
  const auto texture = mesh::read_texture(std::as_bytes(std::span(text.data(), text.size())), path, vertices);
  REQUIRE_MESSAGE(texture, texture.error().message);
  return texture.value();
}

}  // namespace

TEST_CASE("a PC2 file has its header, and every place to the bit, beside an OBJ file of the first mesh") {
  const FakeRun run({2, 5, 8, 11}, "ply");
  const std::string bytes = run.bytes_of("pc2");
  CHECK(bytes.substr(0, 12) == std::string("POINTCACHE2\0", 12));
  CHECK(value_at<std::int32_t>(bytes, 12) == 1);
  REQUIRE(value_at<std::int32_t>(bytes, 16) == 26);
  CHECK(value_at<float>(bytes, 20) == 2.0F);  // the first frame
  CHECK(value_at<float>(bytes, 24) == 3.0F);  // frames from one to the next
  REQUIRE(value_at<std::int32_t>(bytes, 28) == 4);
  REQUIRE(bytes.size() == 32 + 12 * 26 * 4);
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t v = 0; v < 26; ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(same_bits(value_at<float>(bytes, 32 + 4 * (3 * (26 * k + v) + axis)),
                        run.shape(k).positions[v][static_cast<int>(axis)]));
  const auto first = mesh::read_mesh(run.path("a.obj"));
  REQUIRE(first);
  CHECK(first->positions == run.shape(0).positions);
  CHECK(first->triangles == run.shape(0).triangles);
  CHECK(texture_in(run.path("a.obj"), 26) == run.texture());
  CHECK(run.names() == std::vector<std::string>{"a.obj", "a.pc2", "run"});
}

TEST_CASE("an MDD file has its times and every place to the bit, all big-endian") {
  const FakeRun run({2, 5, 6, 11});
  const std::string bytes = run.bytes_of("mdd");
  REQUIRE(big_endian_at<std::int32_t>(bytes, 0) == 4);
  REQUIRE(big_endian_at<std::int32_t>(bytes, 4) == 26);
  REQUIRE(bytes.size() == 8 + 4 * 4 + 12 * 26 * 4);
  const double frames[] = {0, 3, 4, 9};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(big_endian_at<float>(bytes, 8 + 4 * k) == static_cast<float>(frames[k] * FakeRun::kFrame));
    for (std::size_t v = 0; v < 26; ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(same_bits(big_endian_at<float>(bytes, 24 + 4 * (3 * (26 * k + v) + axis)),
                        run.shape(k).positions[v][static_cast<int>(axis)]));
  }
  CHECK(run.names() == std::vector<std::string>{"a.mdd", "a.obj", "run"});
}

TEST_CASE("a range of frames and every n-th mesh of it are what is exported") {
  const FakeRun run({0, 2, 4, 6, 8, 10, 12});
  const auto frames_of = [&](const MeshRange& range) {
    const RunMeshes meshes = run.open(range);
    std::vector<std::uint32_t> frames;
    for (std::size_t k = 0; k < meshes.count(); ++k) frames.push_back(meshes.frame(k));
    return frames;
  };
  using Frames = std::vector<std::uint32_t>;
  CHECK(frames_of({3, 11, 1}) == Frames{4, 6, 8, 10});
  CHECK(frames_of({{}, {}, 3}) == Frames{0, 6, 12});
  CHECK(frames_of({4, {}, 2}) == Frames{4, 8, 12});
  CHECK(frames_of({{}, 0, 5}) == Frames{0});
  const std::string bytes = run.bytes_of("pc2", {3, 11, 2});
  CHECK(value_at<float>(bytes, 20) == 4.0F);
  CHECK(value_at<float>(bytes, 24) == 4.0F);
  CHECK(value_at<std::int32_t>(bytes, 28) == 2);
  CHECK(value_at<float>(bytes, 32 + 12 * 26) == run.shape(4).positions[0].x);
}

TEST_CASE("a PC2 file of meshes at unequal distances is refused with both, and nothing is written") {
  const FakeRun run({0, 2, 4, 5});
  const auto written = run.write("pc2", "a.pc2");
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == ErrorKind::Input);
  CHECK(written.error().message ==
        "Meshes in a PC2 file are at equal distances, but those of " + run.run() +
            " are 2 frames apart at frame 0 and 1 at frame 4; mdd and glb have times of "
            "their own.");
  CHECK(run.names() == std::vector<std::string>{"run"});
}

TEST_CASE("a sequence has the bits of the run's meshes, in either format, and can be exported in its turn") {
  for (const char* from : {"obj", "ply"})
    for (const char* to : {"obj", "ply"}) {
      const FakeRun run({0, 3, 6}, from);
      REQUIRE(run.write(to, "s/"));
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string path = run.path("s/" + mesh_name(static_cast<std::uint32_t>(3 * k), to));
        const auto mesh = mesh::read_mesh(path);
        REQUIRE(mesh);
        CHECK(mesh->positions == run.shape(k).positions);
        CHECK(mesh->triangles == run.shape(k).triangles);
        CHECK(texture_in(path, 26) == run.texture());
        if (std::string(from) == to)
          CHECK(text_of_file(path) == text_of_file(run.run() + path.substr(path.rfind('/'))));
      }
      CHECK(text_of_file(run.path("s/meshes.json")) == text_of_file(run.run() + "/meshes.json"));
      const auto again = RunMeshes::open(run.path("s"), {});
      REQUIRE(again);
      CHECK(again.value().count() == 3);
      const auto twice = run.write(to, "s");
      REQUIRE_FALSE(twice);
      CHECK(twice.error().message ==
            "Folder " + run.path("s") + " is there already; a sequence is written into a new one.");
      CHECK(run.names() == std::vector<std::string>{"run", "s"});
    }
}

TEST_CASE("an export that fails at a later mesh leaves nothing, and what was there before stays") {
  for (const char* format : {"glb", "pc2", "mdd", "obj", "ply"}) {
    CAPTURE(format);
    const FakeRun run({0, 1, 2, 3});
    const std::string last = run.run() + "/mesh_00003.obj", whole = text_of_file(last);
    REQUIRE(write_file(last, whole.substr(0, whole.size() / 2)));  // cut off
    const bool folder = std::string(format) == "obj" || std::string(format) == "ply";
    if (!folder) REQUIRE(write_file(run.path("a"), std::string("before")));
    const auto written = run.write(format, "a");
    REQUIRE_FALSE(written);
    CHECK(written.error().kind == ErrorKind::Input);
    CHECK(written.error().message.find("mesh_00003.obj") != std::string::npos);
    CHECK(run.names() == (folder ? std::vector<std::string>{"run"} : std::vector<std::string>{"a", "run"}));
    if (!folder) CHECK(text_of_file(run.path("a")) == "before");
  }
}

TEST_CASE("a file that nobody names stands beside the run") {
  CHECK(export_path("out/hanging", "glb") == "out/hanging.glb");
  CHECK(export_path("out/hanging/", "pc2") == "out/hanging.pc2");
  CHECK(export_path("out/v1.2", "ply") == "out/v1.2_ply");
  CHECK(export_path(".", "glb") == std::filesystem::current_path().string() + ".glb");
}
