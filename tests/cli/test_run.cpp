#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "mesh/grid.hpp"
#include "source_path.hpp"
#include "weft.hpp"

using namespace weft;

namespace {

nlohmann::json run_json(const std::string& scene, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"run", scene, "--json"});
  const Ended ended = run_weft(more);
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  return json_of(ended.out);
}

}  // namespace

TEST_CASE("run leaves pictures, the final mesh, the summary and a video, and prints the summary as JSON") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const std::string out = folder.path("new/out");
  const Ended ended = run_weft({"run", scene, "--out", out, "--json"});
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  CHECK(ended.err ==
        (has_program("ffmpeg") ? "" : "weft: There is no ffmpeg on PATH, so there will be no run.mp4.\n"));

  std::vector<std::string> names = {"final.obj",       "frame_00000.png", "frame_00001.png",
                                    "frame_00002.png", "frames.csv",      "summary.json"};
  if (has_program("ffmpeg")) names.insert(names.begin() + 5, "run.mp4");
  CHECK(names_in(out) == names);
  CHECK(json_of(ended.out) == json_of(read_text(out + "/summary.json")));
  const mesh::TriangleMesh final_mesh = read_obj_file(out + "/final.obj");
  CHECK(final_mesh.positions.size() == 30);
  CHECK(final_mesh.triangles.size() == 40);
  const std::string png = read_text(out + "/frame_00002.png");  // signature, then IHDR with width and height
  CHECK(png.substr(0, 24) == std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x40\0\0\0\x30", 24));
}

TEST_CASE("frames are written as meshes too, without pictures where none are wanted") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  const auto files_of = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", scene, "-o", out, "-q", "--no-pictures"});
    const Ended ended = run_weft(more);
    CHECK(ended.code == 0);
    CHECK(ended.out == "");
    return names_in(out);
  };
  using Names = std::vector<std::string>;
  CHECK(files_of({}) == Names{"final.obj", "frames.csv", "summary.json"});
  CHECK(files_of({"--meshes-every", "2", "--mesh-format", "ply"}) ==
        Names{"final.obj", "frames.csv", "mesh_00000.ply", "mesh_00002.ply", "meshes.json", "summary.json"});
  CHECK(files_of({"--meshes-every", "1", "-n", "2"}) ==
        Names{"final.obj", "frames.csv", "mesh_00000.obj", "mesh_00001.obj", "meshes.json", "summary.json"});
  CHECK(read_text(out + "/mesh_00001.obj") == read_text(out + "/final.obj"));
  CHECK(read_text(out + "/mesh_00000.obj") != read_text(out + "/final.obj"));
}

TEST_CASE("shorthands stand for values of the scene, and a --set has the last word") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene()), out = folder.path("out");
  CHECK(run_json(scene, {"-n", "0", "--nodes", "4"}).at("nodes") == 16);
  CHECK(run_json(scene, {"-n", "0", "--nodes", "4x7"}).at("nodes") == 28);
  CHECK(run_json(scene, {"-n", "0", "--set", "cloths.0.grid=[3,3]", "--nodes", "4"}).at("nodes") == 9);
  run_json(scene, {"-n", "1", "-o", out, "--size", "32x16", "--view", "normals"});
  const std::string png = read_text(out + "/frame_00000.png");
  CHECK(png.substr(16, 8) == std::string("\0\0\0\x20\0\0\0\x10", 8));
  CHECK(run_weft({"run", scene, "--view", "nosuch"}).err.find("render.view is \"nosuch\"") !=
        std::string::npos);
}

TEST_CASE("the summary has what each cloth resisted with") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", R"({"format": "weft-scene/1", "cloths": [
    {"name": "shirt", "grid": [4, 4], "size": [1, 1], "fabric": {"name": "interlock", "friction": 0.2}},
    {"grid": [4, 4], "size": [1, 1], "density": 0.2,
     "stiffness": {"structural": 500, "shear": 200, "bend": 0, "bending": 1e-5}}]})");
  CHECK(run_weft({"run", scene, "--frames", "0"}).code == 3);  // friction is the cloth's, not the fabric's
  const nlohmann::json cloths =
      run_json(scene, {"--frames", "0", "--set", "cloths.0.fabric=interlock"}).at("cloths");
  REQUIRE(cloths.size() == 2);
  CHECK(cloths[0].at("name") == "shirt");
  CHECK(cloths[0].at("of") == "fabric");
  CHECK(cloths[0].at("fabric") == "interlock");
  CHECK(cloths[0].at("density") == 0.187);
  CHECK(cloths[0].at("shear") == 22.768457);
  CHECK(cloths[0].at("friction") == 0.3);
  CHECK(cloths[1].at("of") == "springs");
  CHECK(!cloths[1].contains("fabric"));
  CHECK(cloths[1].at("warp").get<double>() == doctest::Approx(700 - 200.0 * 200 / 700));
  CHECK(cloths[1].at("bending_warp") == 1e-5);
  CHECK(cloths[1].at("bending_twist") == 0);
  CHECK(!cloths[0].contains("yield_curvature"));
  const nlohmann::json kept =
      run_json(scene, {"--frames", "0", "--set",
                       R"(cloths.0.fabric={"name": "interlock", "plastic": {"yield_curvature": 40}})"})
          .at("cloths");
  CHECK(kept[0].at("yield_curvature") == 40);
  CHECK(kept[0].at("hardening") == 0);
}

TEST_CASE(
    "a run with subdivide moves as one without, and its final mesh has the finer vertices through the "
    "nodes") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto run_of = [&](const char* level, const std::string& out) {
    const Ended ended =
        run_weft({"run", scene, "--set", std::string("render.subdivide=") + level, "--out", out, "--json"});
    REQUIRE_MESSAGE(ended.code == 0, ended.err);
    return json_of(ended.out).at("state_hash");
  };
  const std::string coarse_out = folder.path("coarse"), fine_out = folder.path("fine");
  CHECK(run_of("0", coarse_out) == run_of("2", fine_out));
  CHECK(read_text(coarse_out + "/frame_00002.png") != read_text(fine_out + "/frame_00002.png"));
  const mesh::TriangleMesh coarse = read_obj_file(coarse_out + "/final.obj");
  const mesh::TriangleMesh fine = read_obj_file(fine_out + "/final.obj");
  REQUIRE(fine.positions.size() == 21 * 17);  // cells of 6 x 5 nodes, each halved twice
  CHECK(fine.triangles.size() == 2 * 20 * 16);
  for (std::size_t j = 0; j < 5; ++j)
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(fine.positions[4 * j * 21 + 4 * i] == coarse.positions[j * 6 + i]);
}

TEST_CASE("the summary has every documented member, with the values that follow from the scene") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto summary = run_json(scene);
  CHECK(summary.at("scene") == scene);
  CHECK(summary.at("end") == "complete");
  CHECK(summary.at("solver") == "mass_spring");
  CHECK(summary.at("forces") == "node_centric");
  CHECK(summary.at("contact_method") == "proximity");
  CHECK(summary.at("adapter").get<std::string>().find("llvmpipe") != std::string::npos);
  CHECK(summary.at("nodes") == 30);      // 6 * 5
  CHECK(summary.at("triangles") == 40);  // 2 * 5 * 4
  // Structural 5 * 5 + 6 * 4, shear 2 * 5 * 4, bend 4 * 5 + 6 * 3.
  CHECK(summary.at("springs") == 49 + 40 + 38);
  CHECK(summary.at("frames") == 3);
  CHECK(summary.at("substeps") == 4);
  CHECK(summary.at("simulated_s").get<double>() == doctest::Approx(3.0 / 60));
  CHECK(summary.at("step_s").get<double>() == doctest::Approx(1.0 / 240));
  CHECK(summary.at("stable_step_s").get<double>() > 1.0 / 240);
  const double median = summary.at("ms_per_frame").at("median"), least = summary.at("ms_per_frame").at("min");
  CHECK(least > 0);
  CHECK(median >= least);
  const double wall = summary.at("wall_s");  // holds three frames, of which two take at least the median
  CHECK(wall >= (2 * median + least) / 1000);
  CHECK(wall < 20);
  const double factor = summary.at("real_time_factor");
  CHECK(factor >= 0.05 / wall);
  CHECK(factor <= 0.05 / ((2 * median + least) / 1000) * 1.0001);
  const std::string hash = summary.at("state_hash");
  CHECK(hash.size() == 16);
  CHECK(hash.find_first_not_of("0123456789abcdef") == std::string::npos);
  CHECK(summary.at("max_stretch").get<double>() > 1);
  CHECK(summary.at("max_stretch").get<double>() < 1.5);
  CHECK(summary.at("nonfinite") == 0);
  CHECK(summary.at("contacts") == 0);
  CHECK(summary.at("contact_hash") == 0);
  CHECK(summary.at("contact_overflow") == 0);
  CHECK(summary.at("gpu_bytes").get<std::uint64_t>() > 30 * 16 * 4);
}

TEST_CASE("the summary's tables have all of its members, and none that it has not") {
  const std::string docs = read_text(source_path("docs/cli.md"));
  const std::size_t begin = docs.find("\n## The summary\n"), end = docs.find("\n## ", begin + 1);
  std::set<std::string> documented;
  for (std::size_t row = docs.find("\n| `", begin); row < end; row = docs.find("\n| `", row + 1)) {
    const std::string cell = docs.substr(row + 3, docs.find(" |", row + 3) - row - 3);
    for (std::size_t at = cell.find('`'); at != std::string::npos;) {
      const std::size_t after = cell.find('`', at + 1);
      documented.insert(cell.substr(at + 1, after - at - 1));
      at = cell.find('`', after + 1);
    }
  }
  // What only some runs have: of a method with settings; chosen by "auto", of cloth that may tear, gone on with.
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  std::set<std::string> given;
  const auto add = [&](const nlohmann::json& summary) {
    for (const auto& [name, value] : summary.items()) given.insert(name);
  };
  add(run_json(scene));
  const std::vector<std::string> torn = {"--set", "solver={}", "--set", "cloths.0.strength=1000"};
  std::vector<std::string> first = torn, second = torn;
  first.insert(first.end(), {"--no-pictures", "--checkpoint-every", "1", "--out", folder.path("out")});
  add(run_json(scene, first));
  second.insert(second.end(), {"--resume", folder.path("out/checkpoint_00001.weft")});
  add(run_json(scene, second));
  CHECK(documented == given);
}

TEST_CASE("a run counts its contacts, and those of the paper's method are the tree's") {
  const std::string scene = source_path("scenes/pull-sphere.json");
  const std::vector<std::string> small = {"--frames", "2", "--set", "cloths.0.grid=[16,16]"};
  std::vector<std::string> with_tree = small;
  with_tree.insert(with_tree.end(), {"--set", "contact.method=bvh"});
  const auto tree = run_json(scene, with_tree);
  std::vector<std::string> with_paper = small;
  with_paper.insert(with_paper.end(), {"--set", "contact.method=paper"});
  const auto paper = run_json(scene, with_paper);
  CHECK(tree.at("contacts").get<std::uint64_t>() > 0);
  CHECK(paper.at("contact_method") == "paper");
  for (const char* member : {"contacts", "contact_hash", "state_hash"})
    CHECK(paper.at(member) == tree.at(member));
}

TEST_CASE("a run says since when cloth is in a tangle and whether it ends in one, and counts what is left") {
  const TemporaryFolder folder;
  const auto sheet = [](const char* transform) {
    return std::string(R"({"grid": [8, 8], "size": [0.4, 0.4], "plane": "xz", "density": 0.3, "damping": 0.01,
      "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": )") +
           transform + "}";
  };
  const std::string scene =
      put(folder, "a.json",
          R"({"format": "weft-scene/1", "gravity": [0, 0, 0], "time": {"substeps": 8},
    "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
              sheet("{}") + "," +
              sheet(R"({"translate": [0.12, 0.03, 0.05], "rotate": [0, 0, 0.3, 0.954]})") + "]}");
  const Ended tangled = run_weft({"run", scene, "--frames", "2", "--json"});
  CHECK(tangled.code == 0);
  const auto early = json_of(tangled.out);
  CHECK(early.at("crossings").get<int>() > 5);
  CHECK(early.at("crossings_left").get<int>() > 5);
  CHECK(tangled.err.find("weft: Cloth is in a tangle since frame 0: ") == 0);
  CHECK(tangled.err.find("\nweft: Cloth ends in a tangle: ") != std::string::npos);
  const Ended apart = run_weft({"run", scene, "--frames", "45", "--json"});
  CHECK(json_of(apart.out).at("crossings_left") == 0);
  CHECK(apart.err.find("Cloth is in a tangle since frame 0: ") != std::string::npos);
  CHECK(apart.err.find("Cloth ends in a tangle") == std::string::npos);
}

TEST_CASE("two runs end in the same bits, and a longer one in others") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto first = run_json(scene), again = run_json(scene, {"--out", folder.path("out")});
  CHECK(first.at("state_hash") == again.at("state_hash"));
  CHECK(run_json(scene, {"--frames", "4"}).at("state_hash") != first.at("state_hash"));
}

TEST_CASE("a shorter run, or one without a video, leaves nothing of the run before it") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const std::string out = folder.path("out");
  run_json(scene, {"--out", out, "--frames", "4"});
  CHECK(count_frames(out) == 4);
  const Ended without =
      run_weft({"run", scene, "--out", out, "--frames", "2"}, {{"PATH=/nonexistent"}, "", false});
  CHECK(without.code == 0);
  CHECK(without.err == "weft: There is no ffmpeg on PATH, so there will be no run.mp4.\n");
  CHECK(names_in(out) == std::vector<std::string>{"final.obj", "frame_00000.png", "frame_00001.png",
                                                  "frames.csv", "summary.json"});
  put(folder, "out/run.mp4", "old");
  run_json(scene, {"--out", out, "--frames", "0"});
  CHECK(names_in(out) == std::vector<std::string>{"final.obj", "frames.csv", "summary.json"});
}

TEST_CASE("no frames at all leave the cloth as it lies at rest") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto summary = run_json(scene, {"--frames", "0", "--out", folder.path("out")});
  CHECK(summary.at("end") == "complete");
  CHECK(summary.at("frames") == 0);
  CHECK(summary.at("simulated_s") == 0);
  CHECK(summary.at("real_time_factor") == 0);
  const auto rest = read_obj_file(folder.path("out/final.obj"));
  const mesh::Grid grid{6, 5, 1.0, 0.8};
  REQUIRE(rest.positions.size() == 30);
  CHECK(rest.triangles == mesh::grid_triangles(grid));
  for (std::uint32_t j = 0; j < 5; ++j)
    for (std::uint32_t i = 0; i < 6; ++i) {  // the sheet is centred, and j goes down
      const Vec3f at = rest.positions[j * 6 + i];
      CHECK(at.x == doctest::Approx(-0.5 + 0.2 * i));
      CHECK(at.y == doctest::Approx(0.4 - 0.2 * j));
      CHECK(at.z == 0);
    }
}

TEST_CASE("--set changes a value, in order, and --solver replaces the whole solver") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene(R"("solver": {"forces": "spring_centric"}, )"));
  CHECK(run_json(scene, {"--frames", "1"}).at("forces") == "spring_centric");
  CHECK(run_json(scene, {"--frames", "1", "--solver", "mass_spring"}).at("forces") == "node_centric");
  const auto changed =
      run_json(scene, {"--set", "cloths.0.grid=[3,3]", "--set", "cloths[0].grid=[9,7]", "--set",
                       "time.frames=1", "--set", "contact.method=none", "--set", "time.substeps=8"});
  CHECK(changed.at("nodes") == 63);
  CHECK(changed.at("frames") == 1);
  CHECK(changed.at("substeps") == 8);
  CHECK(changed.at("contact_method") == "none");
}

TEST_CASE("auto says which solver it took and why, and multigrid needs no stable step") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto chosen = run_json(scene, {"--frames", "1", "--solver", "auto"});
  CHECK(chosen.at("solver") == "mass_spring");
  CHECK(chosen.at("solver_reason").get<std::string>().find("a frame is predicted to take ") == 0);
  CHECK(run_json(scene, {"--frames", "1"}).at("solver_reason") == chosen.at("solver_reason"));  // the default
  const auto implicit = run_json(scene, {"--frames", "1", "--solver", "multigrid"});
  CHECK(implicit.at("solver") == "multigrid");
  CHECK_FALSE(implicit.contains("forces"));
  CHECK_FALSE(implicit.contains("solver_reason"));
  const Ended told = run_weft({"run", scene, "--frames", "1", "--solver", "auto"});
  CHECK(told.out.find("chosen since a frame is predicted to take ") != std::string::npos);
}

TEST_CASE("a step beyond the largest stable one is said") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const auto said = [&](const char* substeps) {
    const Ended ended = run_weft({"run", scene, "--frames", "1", "--solver", "mass_spring", "--set",
                                  std::string("time.substeps=") + substeps});
    REQUIRE_MESSAGE(ended.code == 0, ended.err);
    return ended.err;
  };
  CHECK(said("1").find("substeps a frame are needed, not 1.") != std::string::npos);
  CHECK(said("4").empty());
}

TEST_CASE("run takes relative paths from where it is run, and its lines for people say what was written") {
  const TemporaryFolder folder;
  put(folder, "a.json", tiny_scene());
  const Ended ended =
      run_weft({"run", "a.json", "--out", "out", "--frames", "2"}, {{}, folder.path(""), false});
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  CHECK(count_frames(folder.path("out")) == 2);
  const auto summary = json_of(read_text(folder.path("out/summary.json")));
  CHECK(ended.out.rfind("a.json: complete\n", 0) == 0);
  CHECK(ended.out.find("state hash  " + summary.at("state_hash").get<std::string>()) != std::string::npos);
  CHECK(ended.out.find("out: 2 pictures") != std::string::npos);
}

TEST_CASE("a bar shows progress on a terminal, and clears its line at the end") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const Ended ended = run_weft({"run", scene, "--json"}, {{}, "", true});
  CHECK(ended.code == 0);
  CHECK(ended.err.find("\rsimulating [##########....................] 1/3") != std::string::npos);
  CHECK(ended.err.find("\rsimulating [##############################] 3/3") != std::string::npos);
  CHECK(ended.err.substr(ended.err.rfind('\r')) == "\r\x1b[K");
  CHECK(json_of(ended.out).at("frames") == 3);  // on stdout there is only data
  CHECK(run_weft({"run", scene, "--json"}).err == "");
}
