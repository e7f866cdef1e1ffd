#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>

#include "base/state_hash.hpp"
#include "weft.hpp"

using namespace weft;

namespace {

/// A sheet on a ball, by the solver with a history, in 6 frames.
std::string draped_scene() {
  return R"({"format": "weft-scene/1", "time": {"substeps": 3, "frames": 6}, "render": {"size": [64, 48]},
      "solver": {"kind": "multigrid"}, "contact": {"method": "proximity", "thickness": 0.01},
      "cloths": [{"grid": [9, 8], "size": [0.4, 0.4], "plane": "xz", "density": 0.3,
                  "transform": {"translate": [0, 0.11, 0]}}],
      "colliders": [{"kind": "sphere", "center": [0.01, 0, 0], "radius": 0.1}]})";
}

struct Run {
  TemporaryFolder folder;
  std::string scene = put(folder, "a.json", draped_scene());

  std::string path(const std::string& name) const { return folder.path(name); }
  Ended run(const std::string& out, std::vector<std::string> more) const {
    more.insert(more.begin(), {"run", scene, "-o", path(out), "--json"});
    return run_weft(more);
  }
  /// The same, which must succeed: its summary.
  nlohmann::json summary(const std::string& out, std::vector<std::string> more = {}) const {
    const Ended ended = run(out, std::move(more));
    REQUIRE_MESSAGE(ended.code == 0, ended.err);
    return json_of(ended.out);
  }
  std::vector<std::string> checkpoints(const std::string& out) const {
    std::vector<std::string> names = names_in(path(out));
    names.erase(std::remove_if(names.begin(), names.end(),
                               [](const std::string& name) { return name.rfind("checkpoint_", 0) != 0; }),
                names.end());
    return names;
  }
};

const std::vector<std::string> kEverySecond = {"--checkpoint-every", "2"};
using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a resumed run ends in the bits, the totals and the pictures of one that never stopped") {
  const Run run;
  const auto whole = run.summary("whole", kEverySecond);
  CHECK(run.checkpoints("whole") ==
        Names{"checkpoint_00002.weft", "checkpoint_00004.weft", "checkpoint_00006.weft"});
  CHECK(whole.at("contacts") > 0);
  CHECK(!whole.contains("resumed_frames"));
  const auto resumed = run.summary("resumed", {"--resume", run.path("whole/checkpoint_00004.weft")});
  CHECK(resumed.at("resumed_frames") == 4);
  for (const char* member : {"state_hash", "frames", "simulated_s", "contacts", "max_stretch", "iterations"})
    CHECK(resumed.at(member) == whole.at(member));
  CHECK(read_text(run.path("resumed/final.obj")) == read_text(run.path("whole/final.obj")));
  const std::string rows = read_text(run.path("whole/frames.csv")),
                    heading = rows.substr(0, rows.find('\n') + 1);
  CHECK(read_text(run.path("resumed/frames.csv")) == heading + rows.substr(rows.find("\n4,") + 1));
  CHECK(count_frames(run.path("resumed")) == 2);
  for (const char* name : {"frame_00004.png", "frame_00005.png"})
    CHECK(read_text(run.path("resumed") + "/" + name) == read_text(run.path("whole") + "/" + name));
  // More frames than the scene has, and a checkpoint at the end of what there is.
  const auto longer = run.summary("longer", {"-n", "8", "--resume", run.path("whole/checkpoint_00006.weft")});
  CHECK(longer.at("state_hash") == run.summary("eight", {"-n", "8"}).at("state_hash"));
  CHECK(run.summary("none", {"--resume", run.path("whole/checkpoint_00006.weft")}).at("state_hash") ==
        whole.at("state_hash"));
}

TEST_CASE("a run that is resumed in its own folder keeps what was before it and replaces what comes after") {
  const Run run;
  const std::vector<std::string> meshes = {"--meshes-every", "1", "--checkpoint-every", "2"};
  const auto whole = run.summary("out", meshes);
  const std::string first = read_text(run.path("out/frame_00000.png"));
  put(run.folder, "out/frame_00000.png", "mine");
  put(run.folder, "out/frame_00003.png", "old");
  const std::string rows = read_text(run.path("out/frames.csv"));
  std::filesystem::rename(run.path("out/checkpoint_00002.weft"), run.path("out/checkpoint_00005.weft"));
  auto again = run.summary(
      "out", {"--resume", run.path("out/checkpoint_00005.weft"), "-n", "4", "--meshes-every", "1"});
  CHECK(read_text(run.path("out/frame_00000.png")) == "mine");
  CHECK(read_text(run.path("out/frame_00003.png")) != "old");
  CHECK(count_frames(run.path("out")) == 4);
  CHECK(read_text(run.path("out/frames.csv")) == rows.substr(0, rows.find("\n4,") + 1));
  CHECK(run.checkpoints("out") ==
        Names{"checkpoint_00005.weft"});  // what it went on from; it holds two frames
  CHECK(std::filesystem::exists(run.path("out/mesh_00001.obj")));
  CHECK(!std::filesystem::exists(run.path("out/mesh_00004.obj")));
  CHECK(run.summary("out", meshes).at("state_hash") == whole.at("state_hash"));
  CHECK(read_text(run.path("out/frame_00000.png")) == first);  // from the start nothing is kept
  CHECK(run.checkpoints("out").size() == 3);
}

TEST_CASE("after a lost device a run goes on from its last checkpoint, once from each") {
  const Run run;
  const auto whole = run.summary("whole");
  const Ended lost = run.run("lost", {"--checkpoint-every", "2", "--fault", "lost@3", "--fault", "lost@4"});
  CHECK(lost.code == 0);
  CHECK(lost.err.find(
            "weft: The GPU device was lost after 3 frames; the run goes on from its checkpoint after 2.\n") !=
        std::string::npos);
  CHECK(lost.err.find(
            "weft: The GPU device was lost after 4 frames; the run goes on from its checkpoint after 4.\n") !=
        std::string::npos);
  CHECK(json_of(lost.out).at("state_hash") == whole.at("state_hash"));
  CHECK(json_of(lost.out).at("frames") == 6);
  CHECK(read_text(run.path("lost/frames.csv")) == read_text(run.path("whole/frames.csv")));
  for (int frame = 0; frame < 6; ++frame) {
    const std::string name = "/frame_0000" + std::to_string(frame) + ".png";
    CHECK(read_text(run.path("lost") + name) == read_text(run.path("whole") + name));
  }
  const Ended twice = run.run("twice", {"--checkpoint-every", "2", "--fault", "lost@3", "--fault", "lost@3"});
  CHECK(twice.code == 5);
  CHECK(twice.err.find("weft: The GPU device is lost: ") != std::string::npos);
  CHECK(run.run("early", {"--checkpoint-every", "2", "--fault", "lost@1"}).code == 5);  // there is none yet
  const Ended resumed =
      run.run("resumed", {"--resume", run.path("twice/checkpoint_00002.weft"), "--fault", "lost@3"});
  CHECK(resumed.code == 0);  // it begins with one
  CHECK(json_of(resumed.out).at("state_hash") == whole.at("state_hash"));
}

TEST_CASE("an interrupted run leaves a checkpoint of its last whole frame") {
  const Run run;
  Child child(weft_command({"run", run.scene, "-n", "1000000", "-o", run.path("out"), "--checkpoint-every",
                            "1000000", "--json"}),
              on_lavapipe({}));
  REQUIRE(eventually([&] { return count_frames(run.path("out")) >= 3; }));
  child.signal(SIGINT);
  const Ended ended = child.wait();
  CHECK(ended.code == 130);
  const auto at = json_of(ended.out).at("frames").get<std::uint32_t>();
  char name[32];
  std::snprintf(name, sizeof name, "checkpoint_%05u.weft", at);
  CHECK(run.checkpoints("out") == Names{name});
  const auto resumed =
      run.summary("on", {"-n", std::to_string(at), "--resume", run.path("out") + "/" + name});
  CHECK(resumed.at("state_hash") == json_of(ended.out).at("state_hash"));
}

TEST_CASE(
    "what is no checkpoint of the scene is refused with exit code 3 in one sentence, and nothing is "
    "written") {
  const Run run;
  run.summary("whole", kEverySecond);
  const std::string whole = read_text(run.path("whole/checkpoint_00002.weft"));
  std::string spoiled = whole;
  spoiled[whole.size() / 2] = static_cast<char>(spoiled[whole.size() / 2] ^ 1);
  const auto check = [&](const std::string& file, const std::string& words,
                         std::vector<std::string> more = {}) {
    CAPTURE(file);
    more.insert(more.end(), {"--resume", file});
    const Ended ended = run.run("never", more);
    CHECK(ended.code == 3);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.find("weft: While resuming from " + file + ": " + words) == 0);
    CHECK(!std::filesystem::exists(run.path("never")));
  };
  check(put(run.folder, "cut.weft", whole.substr(0, 100)), "The saved state should have ");
  check(put(run.folder, "none.weft", ""), "A saved state begins with 32 bytes; here there are 0.");
  check(put(run.folder, "spoiled.weft", spoiled), "The saved state is damaged: its checksum is ");
  check(run.scene, "This is no saved state of weft: it does not begin with \"weftsave\".");
  check(run.path("nosuch"), "File " + run.path("nosuch") + " cannot be read: ");
  check(put(run.folder, "large.weft", std::string(1000000, 'w')),
        "File " + run.path("large.weft") + " has 1000000 bytes, more than the limit of ");
  const std::string good = run.path("whole/checkpoint_00002.weft");
  check(good, "The saved state is of another scene: its hash is ", {"--nodes", "9"});
  check(good, "The saved state is of another scene: its hash is ", {"--set", "gravity=[0,-9,0]"});
  // What no motion follows from may differ.
  CHECK(run.run("other", {"--resume", good, "--view", "normals", "--size", "32x32", "-n", "3"}).code == 0);
}

TEST_CASE("a checkpoint of another build or adapter goes on, and the message says which") {
  const Run run;
  run.summary("whole", kEverySecond);
  std::string text = read_text(run.path("whole/checkpoint_00002.weft"));
  const std::size_t at = text.find("weft 0.");
  REQUIRE(at != std::string::npos);
  text[at + 5] = '9';
  const std::size_t adapter = text.find("llvmpipe");
  REQUIRE(adapter != std::string::npos);
  text[adapter] = 'L';
  const std::uint64_t checksum = bytes_hash(std::as_bytes(std::span(text.data(), text.size())).subspan(32));
  text.replace(24, sizeof checksum, reinterpret_cast<const char*>(&checksum), sizeof checksum);
  const Ended ended = run.run("on", {"--resume", put(run.folder, "other.weft", text)});
  CHECK(ended.code == 0);
  CHECK(ended.err.find("weft: The checkpoint was written by weft 9.") != std::string::npos);
  CHECK(ended.err.find(" on Llvmpipe ") != std::string::npos);
  CHECK(ended.err.find(": bits may differ from those of a run that goes on there.\n") != std::string::npos);
}
