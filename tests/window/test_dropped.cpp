#include "player/dropped.hpp"

#include <doctest/doctest.h>

using namespace weft;
using window::dropped_file;
using window::DroppedKind;

TEST_CASE("a dropped file is what the end of its name says, in capitals or not") {
  const auto kind = [](const std::string& path) {
    const auto dropped = dropped_file({path});
    REQUIRE(dropped);
    CHECK(dropped->path == path);
    return dropped->kind;
  };
  CHECK(kind("/a/b.json") == DroppedKind::Scene);
  CHECK(kind("/a/b.JSON") == DroppedKind::Scene);
  CHECK(kind("/a/breeze-00120.weft") == DroppedKind::State);
  CHECK(kind("/a/bunny.obj") == DroppedKind::Mesh);
  CHECK(kind("/a/bunny.ply.gz") == DroppedKind::Mesh);
  CHECK(kind("/a.json/bunny") == DroppedKind::Mesh);
}

TEST_CASE("a scene is opened with the meshes that come with it") {
  const auto dropped = dropped_file({"/a/cube.ply", "/a/scene.json", "/a/ball.obj"});
  REQUIRE(dropped);
  CHECK(dropped->kind == DroppedKind::Scene);
  CHECK(dropped->path == "/a/scene.json");
}

TEST_CASE("what cannot be opened together is refused with one sentence") {
  const auto sentence = [](const std::vector<std::string>& paths) {
    const auto dropped = dropped_file(paths);
    REQUIRE(!dropped);
    CHECK(dropped.error().kind == ErrorKind::Input);
    return dropped.error().message;
  };
  CHECK(sentence({}) == "Nothing that was dropped is a file.");
  CHECK(sentence({"/x/a.json", "/x/b.json"}) == "Open one scene at a time: a.json and b.json are two.");
  CHECK(sentence({"a.obj", "b.obj", "c.weft"}) == "Open one mesh at a time, or a scene: these are 3 files.");
}
