#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>

#include "weft.hpp"

using namespace weft;

namespace {

/// Whether the message names a limit, and gives a need that is over what there is.
bool gives_both_numbers(const std::string& message) {
  const std::size_t at = message.find("need");
  unsigned long long need = 0, limit = 0;
  return at != std::string::npos &&
         std::sscanf(message.c_str() + at,
                     "%*[a-z] %llu bytes, more than this adapter's max%*[A-Za-z] of %llu", &need,
                     &limit) == 2 &&
         need > limit;
}

/// Runs one frame into this folder, which must fail in these words and leave no temporary file.
void check_refused(const TemporaryFolder& folder, const std::string& out, const std::string& words) {
  CAPTURE(out);
  const std::string scene = put(folder, "a.json", tiny_scene());
  const Ended ended = run_weft({"run", scene, "--out", folder.path(out), "--frames", "1"});
  CHECK(ended.code == 1);
  CHECK(ended.out == "");
  CHECK(check_message(ended.err) == "");
  CHECK(ended.err.find(words) != std::string::npos);
  for (const std::string& name : names_in(folder.path(""))) CHECK(name.find(".tmp") == std::string::npos);
}

}  // namespace

TEST_CASE("a folder that cannot be made or written ends the run with exit code 1 and one sentence") {
  const TemporaryFolder folder;
  put(folder, "file", "in the way");
  std::filesystem::create_directories(folder.path("closed"));
  REQUIRE(::chmod(folder.path("closed").c_str(), 0555) == 0);
  check_refused(folder, "file", "file");
  check_refused(folder, "file/out", "file/out cannot be made: Not a directory");
  check_refused(folder, "closed", "closed");
  check_refused(folder, "closed/out", "closed/out cannot be made: Permission denied");
  CHECK(read_text(folder.path("file")) == "in the way");
}

TEST_CASE("a folder in the place of a result ends the run with exit code 1 and one sentence") {
  const TemporaryFolder folder;
  std::vector<std::string> names = {"final.obj", "frames.csv", "summary.json", "frame_00000.png"};
  if (has_program("ffmpeg")) names.emplace_back("run.mp4");
  for (const std::string& name : names) {
    std::filesystem::create_directories(folder.path("out-" + name + "/" + name + "/more"));
    check_refused(folder, "out-" + name, name);
  }
}

TEST_CASE("what the adapter cannot hold is refused with the limit and both numbers, and nothing is written") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  // 10 Mi nodes of 16 bytes, for which the host has room; 60 motions of 48 bytes in each of 65,536 substeps.
  const Ended grid =
      run_weft({"run", scene, "--set", "cloths.0.grid=[4096,2560]", "--out", folder.path("out")});
  CHECK(grid.code == 4);
  CHECK(gives_both_numbers(grid.err));
  CHECK(grid.peak < (std::size_t{kSanitized ? 1024 : 256} << 20U));  // and no gigabytes on the way
  std::string motions;
  for (int k = 0; k < 60; ++k)
    motions += std::string(k == 0 ? "" : ",") + R"({"nodes": [{"nodes": [)" + std::to_string(k + 10) +
               R"(]}], "kind": "line", "direction": [1, 0, 0], "speed": 1})";
  const Ended many = run_weft({"run", scene, "--set", "cloths.0.grid=[10,10]", "--set", "time.substeps=65536",
                               "--set", "cloths.0.motions=[" + motions + "]", "--out", folder.path("out")});
  CHECK(many.code == 4);
  CHECK(gives_both_numbers(many.err));
  // A drawn mesh of 3185 x 3185 vertices, through 200 x 200 nodes that do fit.
  const Ended fine =
      run_weft({"run", scene, "--frames", "0", "--set", "time.substeps=auto", "--set",
                "cloths.0.grid=[200,200]", "--set", "render.subdivide=4", "--out", folder.path("out")});
  CHECK(fine.code == 4);
  CHECK(gives_both_numbers(fine.err));
  for (const Ended& ended : {grid, many, fine}) {
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
  }
  CHECK(names_in(folder.path("")) == std::vector<std::string>{"a.json"});
}

TEST_CASE("what the host has no memory for is refused with both numbers, by check as by run, and not built") {
  if (kSanitized) return;  // its shadow memory is larger than any limit here
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()) + " --set cloths.0.grid=[8000,8000]";
  const std::string limited =
      "ulimit -v 4194304; exec " + weft_binary() + " ";  // KiB: a sixth of what it takes
  for (const std::string command : {"check ", "run "}) {
    const Ended ended = call({"/bin/sh", "-c", limited + command + scene}, on_lavapipe({}));
    CAPTURE(command);
    CHECK(ended.code == 4);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    unsigned long long nodes = 0, bytes = 0, limit = 0;
    CHECK(std::sscanf(ended.err.c_str(),
                      "weft: A cloth of %llu nodes needs about %llu bytes of the host's memory, more than "
                      "its limit of %llu.",
                      &nodes, &bytes, &limit) == 3);
    CHECK(nodes == 64000000);
    CHECK(bytes > limit);
    CHECK(limit <= 4194304ULL * 1024);
    CHECK(ended.peak < (std::size_t{64} << 20U));
  }
}

TEST_CASE("a host that runs out of memory ends the program with exit code 4 and one sentence") {
  if (kSanitized) return;  // as above
  const TemporaryFolder folder;
  std::string numbers = "0";
  for (int k = 0; k < 500000; ++k) numbers += ",0";
  const std::string scene = put(folder, "a.json", tiny_scene(R"("gravity": [)" + numbers + "], "));
  // KiB: enough to start, not for half a million values of JSON.
  const Ended ended = call({"/bin/sh", "-c", "ulimit -v 40000; exec " + weft_binary() + " check " + scene});
  CHECK(ended.code == 4);
  CHECK(ended.out == "");
  CHECK(ended.err == "weft: The host has no memory left.\n");
}

TEST_CASE("a second run into a folder is refused while the first one writes there, and nothing is lost") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  Child first(weft_command({"run", scene, "--frames", "1000000", "--out", out}), on_lavapipe({}));
  REQUIRE(eventually([&] { return count_frames(out) >= 2; }));
  const Ended second = run_weft({"run", scene, "--frames", "1", "--out", out});
  CHECK(second.code == 1);
  CHECK(second.out == "");
  CHECK(check_message(second.err) == "");
  CHECK(second.err.find("Folder " + out + " is in use: a run writes into it (process ") != std::string::npos);
  CHECK(count_frames(out) >= 2);
  first.signal(SIGINT);
  CHECK(first.wait().code == 130);
  CHECK(run_weft({"run", scene, "--frames", "1", "--out", out}).code == 0);  // it is free again
  for (const std::string& name : names_in(out)) CHECK(name != ".weft.lock");
}

TEST_CASE("a run that does not end well leaves nothing of the run before it, whole or half") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  REQUIRE(run_weft({"run", scene, "--frames", "3", "--out", out}).code == 0);
  // Leftovers of a killed run, and files that are not weft's.
  for (const char* name :
       {"run.mp4.tmp4711", "frame_00002.png.tmp4711", "summary.json.tmp4711", "final.obj.tmp4711",
        "frames.csv", ".weft.lock", "notes.txt", "notes.tmp4711", "frame_last.png", "final.obj.tmp"})
    put(folder, std::string("out/") + name, "4711");
  const Ended ended = run_weft({"run", scene, "--out", out, "--fault", "lost@0"});
  CHECK(ended.code == 5);
  CHECK(names_in(out) == std::vector<std::string>{"final.obj.tmp", "frame_last.png", "frames.csv",
                                                  "notes.tmp4711", "notes.txt"});
  CHECK(read_text(out + "/frames.csv").find('\n') == read_text(out + "/frames.csv").size() - 1);  // a heading
}
