#include <doctest/doctest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>

#include "weft.hpp"

using namespace weft;

namespace {

bool is_temporary(const std::string& name) { return name.find(".tmp") != std::string::npos; }

/// The video's frames as ffprobe counts them by decoding all; -1 if it is broken.
int count_video_frames(const std::string& path) {
  const Ended ended = call({"/usr/bin/env", "ffprobe", "-v", "error", "-count_frames", "-select_streams", "v",
                            "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0", path});
  return ended.code == 0 && ended.err.empty() ? std::atoi(ended.out.c_str()) : -1;
}

void check_video(const std::string& out) {
  if (!std::filesystem::exists(out + "/run.mp4")) return;
  if (has_program("ffprobe"))
    CHECK(count_video_frames(out + "/run.mp4") == static_cast<int>(count_frames(out)));
}

/// A run whose state is made bad before a frame must end as a run of the frames before it.
void check_divergence(int frame) {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), number = std::to_string(frame);
  const std::string out = folder.path("bad"), clean_out = folder.path("clean");
  const Ended bad = run_weft({"run", scene, "--out", out, "--json", "--fault", "nan@" + number});
  const Ended clean = run_weft({"run", scene, "--out", clean_out, "--json", "--frames", number});
  REQUIRE(clean.code == 0);
  CHECK(bad.code == 6);
  CHECK(check_message(bad.err) == "");
  CHECK(bad.err.find("In frame " + number + " the state of ") != std::string::npos);
  const auto summary = json_of(read_text(out + "/summary.json"));
  CHECK(summary == json_of(bad.out));
  CHECK(summary.at("end") == "diverged");
  CHECK(summary.at("real_time_factor") == 0);
  CHECK(summary.at("frames") == frame);
  CHECK(summary.at("nonfinite").get<int>() > 0);
  CHECK(summary.at("state_hash") == json_of(clean.out).at("state_hash"));
  const bool same = read_text(out + "/final.obj") == read_text(clean_out + "/final.obj");
  CHECK(same);
  CHECK(names_in(out) == names_in(clean_out));
  check_video(out);
}

/// A run that is under way: three pictures are there, a million frames are not.
struct LongRun {
  TemporaryFolder folder;
  std::string scene = put(folder, "a.json", tiny_scene());
  std::string out = folder.path("out");
  Child child{weft_command({"run", scene, "--frames", "1000000", "--out", out, "--json"}), on_lavapipe({})};

  LongRun() {
    REQUIRE(eventually([&] { return count_frames(out) >= 3; }));
  }
};

/// The effect of this signal on a long run.
void check_interrupt(int number) {
  LongRun run;
  run.child.signal(number);
  const Ended ended = run.child.wait();
  CHECK(ended.code == 130);
  CHECK(check_message(ended.err) == "");
  CHECK(ended.err.find("Interrupted after ") != std::string::npos);
  const auto summary = json_of(read_text(run.out + "/summary.json"));
  CHECK(summary == json_of(ended.out));
  CHECK(summary.at("end") == "interrupted");
  const std::size_t frames = summary.at("frames");
  CHECK(frames >= 3);
  CHECK(frames < 1000000);
  CHECK(count_frames(run.out) == frames);
  CHECK(read_obj_file(run.out + "/final.obj").positions.size() == 30);
  for (const std::string& name : names_in(run.out)) CHECK_FALSE(is_temporary(name));
  check_video(run.out);
}

}  // namespace

TEST_CASE("a run that diverges ends with exit code 6 and the last good state") { check_divergence(2); }
TEST_CASE("what a run that diverged says for people has no pace") {
  const TemporaryFolder folder;
  const Ended ended = run_weft({"run", put(folder, "a.json", tiny_scene()), "--fault", "nan@2"});
  CHECK(ended.code == 6);
  CHECK(ended.out.find("a.json: diverged\n") != std::string::npos);
  CHECK(ended.out.find("x real time") == std::string::npos);
}
TEST_CASE("a run that diverges in its first frame ends at rest") { check_divergence(0); }

TEST_CASE("a step far beyond the stable one diverges, and what is left can be read") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  const Ended ended = run_weft({"run", scene, "--out", out, "--json", "--frames", "1000", "--set",
                                "time.substeps=1", "--solver", "mass_spring", "--set", "contact.method=none",
                                "--set", "cloths.0.stiffness.structural=1e6"});
  CHECK(ended.code == 6);
  const std::size_t first = ended.err.find('\n') + 1;
  CHECK(check_message(ended.err.substr(0, first)) == "");
  CHECK(ended.err.find("weft: The step of 16.7 ms is longer than the largest stable one of ") == 0);
  CHECK(check_message(ended.err.substr(first)) == "");
  const auto summary = json_of(ended.out);
  CHECK(summary.at("end") == "diverged");
  CHECK(summary.at("step_s").get<double>() > summary.at("stable_step_s").get<double>());
  CHECK(count_frames(out) == summary.at("frames"));
  CHECK(read_obj_file(out + "/final.obj").positions.size() == 30);  // reads finite coordinates only
}

TEST_CASE("damping that no step is short enough for is refused, however strong") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  for (const std::string damping : {"1e6", "1e8", "1e9"}) {
    const Ended ended = run_weft({"run", scene, "--frames", "1", "--set", "time.substeps=\"auto\"",
                                  "--solver", "mass_spring", "--set", "cloths.0.damping=" + damping});
    CAPTURE(damping);
    CHECK(ended.code == 4);
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.find("Explicit steps need ") != std::string::npos);
    CHECK(ended.err.find("more than the limit of 65536") != std::string::npos);
  }
}

TEST_CASE("a lost device ends the run with exit code 5 and one sentence") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  for (const std::string frame : {"0", "1"}) {
    const Ended ended = run_weft({"run", scene, "--fault", "lost@" + frame});
    CHECK(ended.code == 5);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.find("The GPU device is lost") != std::string::npos);
  }
}

TEST_CASE("a device lost while pictures are on their way leaves whole files and exit code 5") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const Ended ended = run_weft({"run", scene, "--out", folder.path("out"), "--fault", "lost@1"});
  CHECK(ended.code == 5);
  CHECK(check_message(ended.err) == "");
  for (const std::string& name : names_in(folder.path("out"))) CHECK_FALSE(is_temporary(name));
  CHECK(!std::filesystem::exists(folder.path("out/summary.json")));
}

TEST_CASE("Ctrl-C ends a run with exit code 130 and keeps all that it has") { check_interrupt(SIGINT); }
TEST_CASE("SIGTERM ends a run as Ctrl-C does") { check_interrupt(SIGTERM); }

TEST_CASE("Ctrl-C and then SIGTERM end a run at once, in the middle of a frame") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  // A frame of 65,536 substeps of a large sheet is not done before both signals are there.
  Child child(weft_command({"run", scene, "--out", out, "--set", "time.substeps=65536", "--set",
                            "cloths.0.grid=[200,200]"}),
              on_lavapipe({}));
  REQUIRE(eventually([&] { return std::filesystem::exists(out + "/.weft.lock"); }));
  child.signal(SIGINT);
  child.signal(SIGTERM);
  const Ended ended = child.wait(60);
  CHECK((ended.code == -SIGTERM || ended.code == -SIGINT));  // whichever the system hands over last
  CHECK(ended.err.find("A frame takes up to 65536 substeps") != std::string::npos);
}

TEST_CASE("frames of more than ten thousand substeps are said, also those that something fast asks for") {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& members, const std::string& substeps) {
    const std::string scene = put(folder, "a.json", tiny_scene(members));
    const Ended ended = run_weft({"run", scene, "--frames", "0", "--set", "time.substeps=" + substeps});
    CHECK(ended.code == 0);
    return ended.err;
  };
  CHECK(said("", "10000") == "");
  CHECK(said("", "10001").find("A frame takes up to 10001 substeps") != std::string::npos);
  const std::string shot = R"("contact": {"method": "proximity", "thickness": 0.001}, "colliders": [
      {"kind": "sphere", "center": [0, 0, 9], "radius": 0.1,
       "motion": {"kind": "line", "direction": [0, 0, 1], "speed": 10000}}], )";
  CHECK(said(shot, "4").find("A frame takes up to 16384 substeps") != std::string::npos);  // 4 times the most
}

TEST_CASE("a run that is killed leaves no file half written under its name") {
  LongRun run;
  run.child.signal(SIGKILL);
  CHECK(run.child.wait().code == -SIGKILL);
  std::size_t whole = 0;
  for (const std::string& name : names_in(run.out)) {
    CAPTURE(name);
    if (is_temporary(name) || name == ".weft.lock") continue;
    if (name == "frames.csv") {
      CHECK(read_text(run.out + "/" + name).back() == '\n');
      continue;
    }
    REQUIRE(name.rfind("frame_", 0) == 0);  // no summary, mesh or video of a run without an end
    const std::string png = read_text(run.out + "/" + name);
    CHECK(png.substr(png.size() - 8, 4) == "IEND");
    ++whole;
  }
  CHECK(whole >= 3);
}
