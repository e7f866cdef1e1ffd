#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "mesh/mesh_files.hpp"
#include "mesh/obj.hpp"
#include "mesh/ply.hpp"
#include "source_path.hpp"
#include "weft.hpp"

using namespace weft;

namespace {

const std::vector<std::string> kCommands = {"run",      "view",   "check", "scenes", "fabrics",   "validate",
                                            "adapters", "schema", "bench", "export", "completion"};

/// All commands, also those of `bench`, each as its words.
std::vector<std::vector<std::string>> every_command() {
  std::vector<std::vector<std::string>> all;
  for (const std::string& command : kCommands) all.push_back({command});
  for (const char* experiment :
       {"hanging", "pull", "contact", "multigrid", "scene", "copy", "largest", "compare"})
    all.push_back({"bench", experiment});
  return all;
}

std::vector<std::string> help_of(std::vector<std::string> command) {
  command.emplace_back("--help");
  return command;
}

/// The words of small letters that follow "--" in a text.
std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> options;
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 2)) {
    const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz", at + 2);
    options.insert(text.substr(at + 2, end - at - 2));
  }
  options.erase("");
  return options;
}

}  // namespace

TEST_CASE("check reads a scene and its meshes without any adapter") {
  const TemporaryFolder folder;
  put(folder, "cube.obj", mesh::text_of(mesh::write_obj(mesh::cube())));
  const std::string scene =
      put(folder, "a.json", tiny_scene(R"("colliders": [{"kind": "mesh", "mesh": "cube.obj"}], )"));
  const Ended ended = run_without_driver({"check", scene});
  CHECK(ended.code == 0);
  CHECK(ended.err == "");
  const std::string first =
      scene + " is a valid scene: 1 cloth with 30 nodes and 40 triangles, 1 collider with 12 triangles.\n";
  CHECK(ended.out.substr(0, first.size()) == first);
}

TEST_CASE("check says what each cloth resists with, and why its explicit step is so long") {
  const TemporaryFolder folder;
  put(folder, "sheet.obj", mesh::text_of(mesh::write_obj(mesh::cube())));
  // Squares: along a row k + 4 b + d of springs, less the part of d² that lets the other direction give way.
  const std::string scene = put(folder, "a.json", R"({"format": "weft-scene/1", "cloths": [
    {"name": "lattice", "grid": [6, 6], "size": [1, 1], "density": 0.2, "copies": {"count": 3, "offset": [0, 0, 2]},
     "stiffness": {"structural": 500, "shear": 200, "bend": 50}},
    {"mesh": "sheet.obj", "density": 0.2},
    {"grid": [6, 6], "size": [1, 1], "fabric": {"name": "denim_11oz", "warp": 1234}}]})");
  const Ended ended = run_without_driver({"check", scene});
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < ended.out.size(); at = ended.out.find('\n', at) + 1)
    lines.push_back(ended.out.substr(at, ended.out.find('\n', at) - at));
  REQUIRE(lines.size() == 7);  // copies are the same cloth
  // C11 = 500 + 4 * 50 + 200 = 900, C12 = C33 = 200: 900 - 200² / 900 = 855.6
  CHECK(lines[1] ==
        "  cloths[0] \"lattice\", of springs: 855.6 N/m along i and 855.6 along j, Poisson's ratio 0.222, "
        "shear 200 N/m; "
        "bending 0 for slight folds; 200 g/m²; friction 0.3");
  CHECK(lines[2].find("because of springs; the least height of a triangle is 141.4 mm") != std::string::npos);
  CHECK(lines[3].find("cloths[1], of springs: at most ") != std::string::npos);
  CHECK(lines[3].find("in the mean over directions") != std::string::npos);
  CHECK(lines[5].find("cloths[2], of fabric denim_11oz: 1234 N/m along i and 410.5 along j") !=
        std::string::npos);
  CHECK(lines[5].find("16.05 and 24.24 µN·m, twist 8.736; 324 g/m²; friction 0.3") != std::string::npos);
  CHECK(lines[6].find("because of membranes (hinges alone: ") != std::string::npos);
  CHECK(lines[6].find("; 0 slivers") != std::string::npos);
}

TEST_CASE("check says which bends a cloth keeps, and how far its tethers reach") {
  const TemporaryFolder folder;
  const std::string scene =
      put(folder, "a.json", R"({"format": "weft-scene/1", "solver": {"kind": "xpbd"}, "cloths": [
    {"grid": [4, 3], "size": [3, 2], "pins": ["top_left", "top_right"], "tethers": {"slack": 0.1},
     "fabric": {"name": "interlock", "plastic": {"yield_curvature": 40, "hardening": 0.25}}},
    {"grid": [4, 3], "size": [3, 2], "density": 1}]})");
  const std::string out = run_without_driver({"check", scene}).out;
  const auto line = out.find(
      "\n    keeps of a bend what is beyond a curvature of 40 1/m, a radius of 25 mm; hardening 0.25\n"
      "    20 tethers to held nodes, at most 3.966 m long\n");  // 1.1 times the diagonal of 3 m and 2 m
  CHECK(line != std::string::npos);
  CHECK(out.find("tether", out.find("cloths[1]")) == std::string::npos);
}

TEST_CASE("check says by how many times a method without a stiffness of its own resists") {
  const TemporaryFolder folder;
  // Springs of 50 N/m, half of a cell's each, and nodes of 0.1 kg: a = h² 50/0.1 = 0.00868 upright, twice that below,
  // where both nodes are free; two sweeps resist with 2 + a.
  const std::string scene = put(folder, "a.json", R"({"format": "weft-scene/1", "time": {"substeps": 4},
    "cloths": [{"grid": [2, 2], "size": [1, 1], "density": 0.4, "pins": ["top"],
                "stiffness": {"structural": 100, "shear": 0, "bend": 0}}]})");
  const Ended ended =
      run_without_driver({"check", scene, "--set", R"(solver={"kind": "pbd", "iterations": 2})"});
  REQUIRE_MESSAGE(ended.code == 0, ended.err);
  CHECK(ended.out.find(
            "  By \"pbd\" in 4 substeps of 2 sweeps, an element of cloths[0] that nothing else pulls at "
            "resists with 2.01 to 2.02 times its stiffness.\n") != std::string::npos);
  CHECK(run_without_driver({"check", scene, "--solver", "xpbd"}).out.find("  By ") == std::string::npos);
  const Ended once = run_without_driver(
      {"check", scene, "--set", R"(solver={"kind": "pbd", "iterations": 1})", "--set", "time.substeps=1"});
  CHECK(once.out.find("  By \"pbd\" in 1 substep of 1 sweep, an element") != std::string::npos);
}

TEST_CASE("check says of which Poisson's ratio a body may creep by vbd") {
  const TemporaryFolder folder;
  const auto said = [&](const char* poisson, const char* solver) {
    const std::string scene = put(folder, "a.json",
                                  R"({"format": "weft-scene/1", "bodies": [{"block": [1, 1, 1],
      "size": [1, 1, 1], "density": 1000, "material": {"young": 1e5, "poisson": )" +
                                      std::string(poisson) + "}}]}");
    const Ended ended = run_without_driver({"check", scene, "--solver", solver});
    CHECK_MESSAGE(ended.code == 0, ended.err);
    return ended.out.find(
               "  By \"vbd\" a slender body of Poisson's ratio 0.495, as bodies[0] has, may creep for many "
               "seconds; one of 0.49 does not.\n") != std::string::npos;
  };
  CHECK(said("0.495", "vbd"));
  CHECK_FALSE(said("0.49", "vbd"));
  CHECK_FALSE(said("0.495", "mass_spring"));
}

TEST_CASE(
    "validate prints numbers beside the laws', as a table and as JSON, and refuses what it does not know") {
  const Ended table = run_weft({"validate", "--only", "fall", "--solver", "multigrid"});
  CHECK(table.code == 0);
  CHECK(table.out.find("2 of 2 numbers hold.") != std::string::npos);
  const Ended json = run_weft({"validate", "--only", "fall", "--solver", "multigrid", "--json"});
  CHECK(json.code == 0);
  const nlohmann::json all = json_of(json.out);
  CHECK(all.at("laws").size() > 10);
  REQUIRE(all.at("rows").size() == 2);
  for (const nlohmann::json& row : all.at("rows")) {
    CHECK(row.at("law") == "fall");
    CHECK(row.at("holds") == true);
    CHECK(row.at("value").get<double>() == doctest::Approx(row.at("expected").get<double>()).epsilon(0.01));
  }
  for (const auto& [option, value, near] :
       {std::tuple{"--only", "slop", "slope"}, {"--solver", "auto", "mass_spring"}}) {
    const Ended refused = run_weft({"validate", option, value});
    CHECK(refused.code == 2);
    CHECK(refused.out == "");
    CHECK(check_message(refused.err) == "");
    CHECK(refused.err.find(near) != std::string::npos);
  }
}

TEST_CASE("fabrics prints every fabric, as a table and as JSON with the source of each number") {
  const Ended table = run_without_driver({"fabrics"}), json = run_without_driver({"fabrics", "--json"});
  CHECK(table.code == 0);
  CHECK(json.code == 0);
  CHECK(table.err + json.err == "");
  const nlohmann::json all = json_of(json.out);
  CHECK(all.at("fabrics").size() >= 10);
  for (const nlohmann::json& fabric : all.at("fabrics")) {
    const auto name = fabric.at("name").get<std::string>();
    CAPTURE(name);
    CHECK(table.out.find("\n" + name + " ") != std::string::npos);
    for (const char* key : {"density", "warp", "weft", "shear", "poisson", "bending_warp", "bending_weft",
                            "bending_twist", "friction"}) {
      const nlohmann::json& number = fabric.at(key);
      CHECK(number.at("value").is_number());
      CHECK(all.at("sources").contains(number.at("source")));
      CHECK(number.at("guess") == (number.at("source") == "guess"));
    }
    // A scene of this name has these numbers, and so would say check.
    const TemporaryFolder folder;
    const std::string scene = put(folder, "a.json", R"({"format": "weft-scene/1", "cloths": [{"grid": [3, 3],
      "size": [1, 1], "fabric": ")" + name + "\"}]}");
    CHECK(run_without_driver({"check", scene}).out.find("of fabric " + name + ": ") != std::string::npos);
  }
}

TEST_CASE("a bench that there is not, or that is not said, is answered with those there are") {
  for (const auto& [arguments, begin] :
       {std::pair<std::vector<std::string>, const char*>{
            {"bench", "foo"}, "weft: There is no bench \"foo\"; there are: hanging, pull, "},
        {{"bench"}, "weft: Which bench is not said; there are: hanging, pull, "}}) {
    const Ended ended = run_without_driver(arguments);
    CHECK(ended.code == 2);
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.rfind(begin, 0) == 0);
    CHECK(ended.err.find("methods, scene, copy, largest, compare;") != std::string::npos);
  }
  CHECK(run_without_driver({"bench", "hanging", "--sides", "1"}).err.find("There is no") ==
        std::string::npos);
}

TEST_CASE("--nodes is refused where the first cloth has no grid, with what it is of") {
  const TemporaryFolder folder;
  put(folder, "cube.obj", mesh::text_of(mesh::write_obj(mesh::cube())));
  const std::string scene = put(folder, "a.json", R"({"format": "weft-scene/1", "cloths": [
    {"mesh": "cube.obj", "density": 0.2}, {"grid": [3, 3], "size": [1, 1], "density": 0.2}]})");
  const Ended ended = run_without_driver({"check", scene, "--nodes", "20"});
  CHECK(ended.code == 3);
  CHECK(ended.err ==
        "weft: " + scene + ": cloths[0] has no grid, and --nodes [20,20] is of a sheet with one.\n");
  // Where --set has given it one it has.
  const Ended sheet = run_without_driver({"check", scene, "--nodes", "20", "--set",
                                          R"(cloths=[{"grid": [3, 3], "size": [1, 1], "density": 1}])"});
  CHECK_MESSAGE(sheet.code == 0, sheet.err);
}

TEST_CASE("check accepts every shipped scene") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("scenes"))) {
    const Ended ended = run_without_driver({"check", entry.path().string()});
    CHECK_MESSAGE(ended.code == 0, ended.err);
    ++count;
  }
  CHECK(count >= 3);
}

TEST_CASE("check says how many triangles of a collider have no area, and goes on") {
  const TemporaryFolder folder;
  put(folder, "flat.obj", mesh::text_of(mesh::write_obj(mesh::cube())) + "f 1 1 2\nf 1 2 2\n");
  put(folder, "a.json", tiny_scene(R"("colliders": [{"kind": "mesh", "mesh": "flat.obj"}], )"));
  const Ended ended = run_without_driver({"check", "a.json"}, {{}, folder.path(""), false});
  CHECK(ended.code == 0);
  CHECK(ended.err == "weft: 2 triangles of the colliders have no area and are left out.\n");
  CHECK(ended.out.find("1 collider with 12 triangles") != std::string::npos);
}

TEST_CASE("check says how many vertices of a collider are where others are") {
  const TemporaryFolder folder;
  mesh::TriangleMesh apart;
  const mesh::TriangleMesh cube = mesh::cube();
  for (const mesh::Triangle& t : cube.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.positions.size());
    for (const std::uint32_t vertex : t) apart.positions.push_back(cube.positions[vertex]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  put(folder, "apart.obj", mesh::text_of(mesh::write_obj(apart)));
  put(folder, "a.json", tiny_scene(R"("colliders": [{"kind": "mesh", "mesh": "apart.obj"}], )"));
  const Ended ended = run_without_driver({"check", "a.json"}, {{}, folder.path(""), false});
  CHECK(ended.code == 0);
  CHECK(ended.err ==
        "weft: 28 vertices of the colliders are where others of the same mesh are, and are one with "
        "them.\n");
}

TEST_CASE("meshes lie beside their scene and models beside the program, wherever weft is run from") {
  const TemporaryFolder folder;
  for (const char* name : {"bin", "models", "scenes", "elsewhere", "others"})
    std::filesystem::create_directory(folder.path(name));
  const std::filesystem::path binary = weft_binary();
  std::filesystem::copy_file(binary, folder.path("bin/weft"));
  std::filesystem::create_symlink(binary.parent_path() / "libwgpu_native.so",
                                  folder.path("bin/libwgpu_native.so"));
  std::filesystem::create_symlink("bin/weft", folder.path("link"));
  put(folder, "models/block.ply", mesh::text_of(mesh::write_ply(mesh::cube())));
  put(folder, "scenes/cube.obj", mesh::text_of(mesh::write_obj(mesh::cube())));
  put(folder, "scenes/a.json", tiny_scene(R"("colliders": [{"kind": "mesh", "mesh": "cube.obj"},
                                                            {"kind": "mesh", "mesh": "block"}], )"));
  const CallOptions elsewhere = on_lavapipe({{"WEFT_MODELS"}, folder.path("elsewhere"), false});
  for (const char* program : {"bin/weft", "link"}) {
    const Ended ended = call({folder.path(program), "check", "../scenes/a.json"}, elsewhere);
    CHECK_MESSAGE(ended.code == 0, ended.err);
    CHECK(ended.out.find("2 colliders with 24 triangles") != std::string::npos);
  }
  // WEFT_MODELS goes before the place beside the program.
  const Ended other = call({folder.path("bin/weft"), "check", "../scenes/a.json"},
                           on_lavapipe({{"WEFT_MODELS=../others"}, folder.path("elsewhere"), false}));
  CHECK(other.code == 3);
  CHECK(check_message(other.err) == "");
  CHECK(other.err.find("block") != std::string::npos);
}

TEST_CASE("adapters names the adapter on stdout and says nothing else") {
  const Ended ended = run_weft({"adapters"});
  CHECK(ended.code == 0);
  CHECK(ended.out.find("llvmpipe") != std::string::npos);
  CHECK(ended.out.find("(CPU, Vulkan, ") != std::string::npos);
  CHECK(ended.err == "");
}

TEST_CASE("without a driver adapters and run end with exit code 4 and one sentence") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"adapters"},
                                             {"run", scene},
                                             {"run", scene, "--out", folder.path("out")},
                                             {"bench", "hanging", "--quick"}}) {
    const Ended ended = run_without_driver(arguments);
    CHECK(ended.code == 4);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
    CHECK(ended.err.find("No WebGPU adapter was found") != std::string::npos);
  }
  CHECK(!std::filesystem::exists(folder.path("out")));
}

TEST_CASE(
    "an adapter is named by any part of its name, and a name that fits none is answered with those there "
    "are") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  CHECK(run_weft({"run", scene, "--frames", "0", "--adapter", "LLVMpipe"}).code == 0);
  const Ended ended = run_weft({"run", scene, "--adapter", "nosuch"});
  CHECK(ended.code == 4);
  CHECK(check_message(ended.err) == "");
  CHECK(ended.err.find("\"nosuch\"") != std::string::npos);
  CHECK(ended.err.find("llvmpipe") != std::string::npos);
}

TEST_CASE("schema prints a JSON Schema that knows the keys of a scene") {
  const Ended ended = run_without_driver({"schema"});
  CHECK(ended.code == 0);
  CHECK(ended.err == "");
  const auto schema = json_of(ended.out);
  CHECK(schema.at("$schema") == "https://json-schema.org/draft/2020-12/schema");
  for (const char* key : {"format", "time", "solver", "contact", "cloths", "colliders"})
    CHECK(schema.at("properties").contains(key));
}

TEST_CASE("the help of every command begins with an example") {
  std::vector<std::vector<std::string>> calls = {{"--help"}};
  for (const auto& command : every_command()) calls.push_back(help_of(command));
  for (const auto& arguments : calls) {
    const Ended ended = run_without_driver(arguments);
    CAPTURE(arguments[0]);
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    CHECK(ended.out.rfind("Example: ", 0) == 0);
    CHECK(ended.out.substr(0, ended.out.find('\n')).find("weft ") != std::string::npos);
    std::string command = "weft";
    for (std::size_t k = 0; k + 1 < arguments.size(); ++k) command += " " + arguments[k];
    CHECK(ended.out.find(command) != std::string::npos);
    CHECK(ended.out.find("--fault") == std::string::npos);
  }
  const std::string version = run_without_driver({"--version"}).out;
  char commit[32] = "";
  int major = 0;
  INFO(version);
  CHECK(std::sscanf(version.c_str(), "weft 0.%*d.%*d (commit %31[^,], wgpu-native %d.", commit, &major) == 2);
  CHECK(std::string(commit) != "");
  CHECK(major > 0);
  CHECK(version.find('\n') == version.size() - 1);
}

TEST_CASE("completion prints scripts that shells accept and that know every command and option") {
  const TemporaryFolder folder;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Ended ended = run_without_driver({"completion", shell});
    CAPTURE(shell);
    CHECK(ended.code == 0);
    CHECK(ended.err == "");
    const std::string script = put(folder, "weft." + shell, ended.out);
    const std::string checker = shell == "fish"                        ? "fish"
                                : shell == "zsh" && has_program("zsh") ? "zsh"
                                                                       : "bash";
    if (has_program(checker)) CHECK(call({"/usr/bin/env", checker, "-n", script}).code == 0);
    for (const auto& command : every_command()) {
      CHECK(ended.out.find(command.back()) != std::string::npos);
      for (const std::string& option : options_in(run_without_driver(help_of(command)).out)) {
        if (shell == "fish" && option == "help") continue;
        INFO(command.back() << " --" << option);
        CHECK(ended.out.find((shell == "fish" ? "-l " : "--") + option) != std::string::npos);
      }
    }
  }
  const std::string words =
      "source " + folder.path("weft.bash") + "; COMP_WORDS=(weft run --f); COMP_CWORD=2; _weft; ";
  CHECK(call({"/bin/bash", "-c", words + "echo ${COMPREPLY[@]}"}).out == "--frames\n");
  const std::string only = "source " + folder.path("weft.bash") +
                           "; COMP_WORDS=(weft bench pull --only prox); COMP_CWORD=4; _weft; ";
  CHECK(call({"/bin/bash", "-c", only + "echo ${COMPREPLY[@]}"}).out == "proximity proximity_self\n");
}

TEST_CASE("a wrong command line ends with exit code 2 and one sentence") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  const std::vector<std::vector<std::string>> calls = {{},
                                                       {"walk"},
                                                       {"--nosuch"},
                                                       {"run"},
                                                       {"check"},
                                                       {"run", scene, "--nosuch"},
                                                       {"run", scene, "more"},
                                                       {"run", scene, "--frames", "x"},
                                                       {"run", scene, "--frames", "-1"},
                                                       {"run", scene, "--frames", "2.5"},
                                                       {"runn", scene},
                                                       {"run", scene, "--frames", "99999999999"},
                                                       {"run", scene, "--frames"},
                                                       {"run", scene, "--out"},
                                                       {"check", scene, "--set"},
                                                       {"check", scene, "--set", ""},
                                                       {"check", scene, "--set", "drag"},
                                                       {"check", scene, "--frames", "1"},
                                                       {"bench"},
                                                       {"bench", "nosuch"},
                                                       {"bench", "hanging", "--only", "nosuch"},
                                                       {"bench", "hanging", "--only", "bvh"},
                                                       {"bench", "hanging", "--objects", "sphere"},
                                                       {"bench", "hanging", "--sides", "1"},
                                                       {"bench", "hanging", "--sides", "64,x"},
                                                       {"bench", "pull", "--only", "grid"},
                                                       {"bench", "pull", "--objects", "sphere,cube"},
                                                       {"bench", "multigrid", "--only", "implicit"},
                                                       {"bench", "multigrid", "--objects", "sphere"},
                                                       {"bench", "copy", "--sides", "64"},
                                                       {"bench", "scene"},
                                                       {"bench", "scene", scene, "--frames", "0"},
                                                       {"bench", "largest", "--memory", "0"},
                                                       {"bench", "compare", scene},
                                                       {"completion"},
                                                       {"completion", "cmd"},
                                                       {"export"},
                                                       {"export", "out"},
                                                       {"export", "out", "--format", "fbx"},
                                                       {"export", "out", "--format", "glb", "--every", "0"},
                                                       {"run", scene, "--nodes", "0x"},
                                                       {"run", scene, "--nodes", "99999999999"},
                                                       {"run", scene, "--size", "64"},
                                                       {"run", scene, "--size", "-1x2"},
                                                       {"run", scene, "--no-pictures"},
                                                       {"run", scene, "--meshes-every", "2"},
                                                       {"run", scene, "-o", "out", "--meshes-every", "0"},
                                                       {"run", scene, "-o", "out", "--mesh-format", "ply"},
                                                       {"run", scene, "--checkpoint-every", "2"},
                                                       {"run", scene, "-o", "out", "--checkpoint-every", "x"},
                                                       {"check", scene, "--size", "64x48"},
                                                       {"run", scene, "--no\nsuch"}};
  for (const auto& arguments : calls) {
    std::string all;
    for (const std::string& argument : arguments) all += " " + argument;
    CAPTURE(all);
    const Ended ended = run_without_driver(arguments);
    CHECK(ended.code == 2);
    CHECK(ended.out == "");
    CHECK(check_message(ended.err) == "");
  }
}

TEST_CASE("a word that is no command or no number is named, with the nearest command") {
  const auto message = [](std::vector<std::string> arguments) {
    return run_without_driver(std::move(arguments)).err;
  };
  CHECK(message({"runn", "a.json"}).find("There is no command \"runn\", but there is \"run\"") !=
        std::string::npos);
  CHECK(message({"chekc", "a.json"}).find("but there is \"check\"") != std::string::npos);
  CHECK(message({"help"}).find("There is no command \"help\"; weft --help") != std::string::npos);
  CHECK(message({"run", "a.json", "--frames", "ten"}).find("\"ten\" is not a whole number") !=
        std::string::npos);
  CHECK(message({"run", "a.json", "--frames", "-1"}).find("not in range") != std::string::npos);
}

TEST_CASE("an option takes one value, so that the scene may come after it") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  CHECK(run_without_driver({"check", "--set", "drag=1", scene}).code == 0);
  CHECK(run_without_driver({"check", "--set", "drag=1", "--set", "gravity=[0,0,0]", scene}).code == 0);
  CHECK(run_without_driver({"check", "--solver", "mass_spring", "--set=drag=1", scene}).code == 0);
}

TEST_CASE("shipped scenes are listed, and known by their names") {
  const Ended listed = run_without_driver({"scenes"});
  CHECK(listed.code == 0);
  CHECK(listed.out.find("hanging          4096 nodes                   Hanging cloth\n") !=
        std::string::npos);
  const auto json = json_of(run_without_driver({"scenes", "--json"}).out);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("scenes")))
    files += entry.path().extension() == ".json" ? 1U : 0U;
  CHECK(json.size() == files);
  CHECK(json[0].at("name") == "balloon");
  CHECK(json[0].at("title") == "A balloon in a sheet");
  const Ended checked = run_without_driver({"check", "hanging", "--nodes", "5x4"});
  CHECK(checked.out.rfind("hanging is a valid scene: 1 cloth with 20 nodes", 0) == 0);
  const Ended wrong = run_without_driver({"check", "hangin"});
  CHECK(wrong.code == 3);
  CHECK(wrong.err ==
        "weft: There is no shipped scene \"hangin\", but there is \"hanging\"; \"weft scenes\" lists them, "
        "and a path "
        "of a file has a \"/\" or a \".\".\n");
}

TEST_CASE("a scene may come from standard input, with its meshes in the current folder") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", scene_of_cloth(R"("mesh": "block.obj", "density": 0.2)"));
  put(folder, "block.obj", mesh::text_of(mesh::write_obj(mesh::cube())));
  const auto piped = [&](const std::string& file, const std::string& from) {
    return call({"/bin/sh", "-c", "cd " + folder.path(from) + " && " + weft_binary() + " check - < " + file});
  };
  CHECK(piped(scene, "").out.rfind("- is a valid scene: 1 cloth with 8 nodes", 0) == 0);
  std::filesystem::create_directories(folder.path("elsewhere"));
  CHECK(piped(scene, "elsewhere").code == 3);  // there is no block.obj
  const Ended empty = piped("/dev/null", "");
  CHECK(empty.code == 3);
  CHECK(empty.err.rfind("weft: standard input: line 1, column 1: ", 0) == 0);
  const Ended endless = piped("/dev/zero", "");
  CHECK(endless.code == 3);
  CHECK(endless.err == "weft: Standard input has more than the limit of 16777216 bytes.\n");
}

TEST_CASE("output that cannot be written whole is a failure") {
  const TemporaryFolder folder;
  const std::string scene = put(folder, "a.json", tiny_scene());
  for (const std::string command : {"schema", "completion bash", "run --help", "--version"}) {
    const Ended ended = call({"/bin/sh", "-c", weft_binary() + " " + command + " > /dev/full"});
    CAPTURE(command);
    CHECK(ended.code == 1);
    CHECK(ended.err == "weft: Standard output cannot be written: No space left on device.\n");
  }
  CHECK(call({"/bin/sh", "-c", weft_binary() + " check " + scene + " > /dev/full"}).code == 1);
}
