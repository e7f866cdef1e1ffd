#include "player/commands.hpp"

#include <filesystem>
#include <set>

#include "../mesh/mesh_files.hpp"
#include "base/file.hpp"
#include "mesh/ply.hpp"
#include "opened_player.hpp"
#include "player/saved_file.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using namespace weft::window;

TEST_CASE("a saved state goes on to the bits of the cloth that never stopped, with its pins") {
  const TemporaryFolder folder;
  Opened opened;
  REQUIRE(opened.player.step());
  REQUIRE(opened.player.pins().toggle(0, -0.2));
  REQUIRE(opened.player.step());
  const auto path = save_file(opened.player, folder.path("out"), "weft");
  REQUIRE(path);
  CHECK(*path == folder.path("out") + "/sheet-00002.weft");
  const std::string expected = opened.hash_after(6);
  Opened other;
  REQUIRE(other.player.open_state(*path));
  CHECK(other.player.pins().all().size() == 1);
  CHECK(other.player.world().frame() == 2);
  CHECK(other.hash_after(6) == expected);
  REQUIRE(write_file(folder.path("no.weft"), std::string("hello")));
  CHECK(!other.player.open_state(folder.path("no.weft")));
}

TEST_CASE("frames are recorded as a run writes them, one picture each") {
  const TemporaryFolder folder;
  Opened opened;
  REQUIRE(opened.player.step());
  CHECK(!opened.player.recording());
  REQUIRE(opened.player.record(folder.path("film")));
  opened.hash_after(4);
  CHECK(opened.player.recording()->count() <= 3);  // some are on their way
  const auto sentence = opened.player.stop_recording();
  REQUIRE(sentence);
  CHECK(!opened.player.recording());
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("film")))
    if (entry.path().extension() == ".png") names.insert(entry.path().filename().string());
  CHECK(names == std::set<std::string>{"frame_00001.png", "frame_00002.png", "frame_00003.png"});
  CHECK(sentence->find("3 pictures") == 0);
  CHECK(sentence->find(" are in " + folder.path("film") + ".") != std::string::npos);
}

TEST_CASE("shape and picture are saved under the scene's name and frame") {
  const TemporaryFolder folder;
  Opened opened;
  for (const char* end : {"obj", "ply", "glb", "png"}) {
    const auto path = save_file(opened.player, folder.path(""), end);
    REQUIRE(path);
    CHECK(*path == folder.path(std::string("sheet-00000.") + end));
    CHECK(std::filesystem::file_size(*path) > 100);
  }
}

TEST_CASE("a recording that cannot be written is said, and the window goes on") {
  const TemporaryFolder folder;
  REQUIRE(write_file(folder.path("file"), std::string("no folder")));
  Opened opened;
  Commands commands(opened.player, {{}, {}, folder.path("file")});
  REQUIRE(commands.toggle_recording());
  CHECK(!opened.player.recording());
  CHECK(opened.player.notice.tone() == Tone::Error);
  CHECK(opened.player.notice.sentence().find(folder.path("file")) != std::string::npos);
}

TEST_CASE("another scene ends the recording, and the next one has a folder of its own") {
  const TemporaryFolder folder;
  Opened opened;
  Commands commands(opened.player, {{}, {}, folder.path("out")});
  REQUIRE(commands.toggle_recording());
  REQUIRE(opened.player.step());
  REQUIRE(opened.player.change({{"cloths.0.density", "0.3"}}));
  CHECK(!opened.player.recording());
  CHECK(opened.player.notice.sentence().find(folder.path("out") + "/sheet.") != std::string::npos);
  CHECK(commands.recording_folder() == folder.path("out") + "/sheet-2");
}

TEST_CASE("a scene, a state and a mesh are opened by drop") {
  const TemporaryFolder folder;
  Opened opened;
  Player& player = opened.player;
  Commands commands(player, {{}, {}, folder.path("")});
  REQUIRE(write_file(folder.path("small.json"), sheet(5)));
  REQUIRE(commands.open_files({folder.path("small.json")}));
  CHECK(player.shown().name == "small");
  CHECK(player.facts().nodes == 25);
  REQUIRE(player.step());
  REQUIRE(commands.save("weft"));
  REQUIRE(player.step());
  REQUIRE(commands.open_files({folder.path("small-00001.weft")}));
  CHECK(player.world().frame() == 1);
  REQUIRE(write_file(folder.path("cube.ply"), mesh::write_ply(mesh::cube())));
  REQUIRE(commands.open_files({folder.path("cube.ply")}));
  REQUIRE(commands.question);  // first it is asked what the mesh shall be
  CHECK(player.shown().name == "small");
  commands.question->role = Role::Cloth;
  REQUIRE(commands.answer());
  CHECK(!commands.question);
  CHECK(player.shown().name == "cube");
  CHECK(player.facts().nodes == 8);
}

TEST_CASE("a dropped file that cannot be opened is said in a sentence, and the scene stays") {
  const TemporaryFolder folder;
  Opened opened;
  Player& player = opened.player;
  Commands commands(player, {{}, {}, folder.path("")});
  for (const char* name : {"bad.json", "bad.weft", "bad.obj"}) {
    CAPTURE(name);
    REQUIRE(write_file(folder.path(name), std::string("hello")));
    player.notice.clear();
    REQUIRE(commands.open_files({folder.path(name)}));
    CHECK(player.notice.tone() == Tone::Error);
    CHECK(!player.notice.sentence().empty());
    CHECK(!commands.question);
    CHECK(player.shown().name == "sheet");
  }
  opened.hash_after(1);
}
