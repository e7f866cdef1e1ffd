#include <doctest/doctest.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "scene/load.hpp"
#include "scene/nearest.hpp"
#include "temporary_folder.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

std::string message(const std::string& text) {
  const auto scene = parse_scene(text, "a.json");
  REQUIRE_FALSE(scene);
  CHECK(scene.error().kind == ErrorKind::Input);
  return scene.error().message;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a text that is not JSON is refused with line and column") {
  CHECK(has(message(""), "a.json: line 1, column 1: "));
  CHECK(has(message("{\n  \"format\": }"), "a.json: line 2, column 13: "));
  CHECK(has(message("{\"a\": 1,}"), "a.json: line 1, column 9: "));
  CHECK(has(message("{} x"), "a.json: line 1, column 4: "));
  CHECK(has(message("// a comment\n{}"), "line 1, column 1: "));
  CHECK(has(message("{\"gravity\": [0, NaN, 0]}"), "line 1, column 17: "));
  CHECK(has(message("{\"gravity\": [0, 1e999, 0]}"), "line 1, column 21: number overflow"));
  CHECK(has(message("{\"title\": \"\xff\"}"), "ill-formed UTF-8"));
  CHECK(message("\"" + std::string(100000, 'x')).size() < 400);
}

TEST_CASE("a key given twice is refused with its path, at any depth") {
  CHECK(has(message(R"({"format": "weft-scene/1", "format": "weft-scene/1"})"),
            "a.json: format is given twice."));
  CHECK(has(message(cloth_with(R"("transform": {"scale": 1, "scale": 2})")),
            "a.json: cloths[0].transform.scale is given twice."));
  CHECK(has(message(R"({"a": [1, {"b c": {"d": 1, "e": 2, "d": 3}}]})"), R"(a[1]["b c"].d is given twice.)"));
}

TEST_CASE("absurd sizes are refused before any work") {
  CHECK(has(message(std::string(65, '[') + std::string(65, ']')), "deeper than the limit of 64 levels"));
  CHECK(has(message(std::string(64, '[') + std::string(64, ']')), "the scene is a list of 1, not an object"));
  CHECK(has(message(std::string(5000000, '[')), "deeper than the limit of 64 levels"));
  CHECK(has(message(std::string((std::size_t{16} << 20U) + 1, ' ')),
            "16777217 bytes are more than the limit of 16777216"));
  std::string many = "[0";
  for (int k = 0; k < 1 << 20; ++k) many += ",0";
  CHECK(has(message(many + "]"), "more values than the limit of 1048576"));
  std::string keys = "{\"k\": 0";  // a million keys in one object take no quadratic time
  for (int k = 0; k < 500000; ++k) keys += ",\"k" + std::to_string(k) + "\":0";
  CHECK(has(message(keys + "}"), "k is not known"));
}

TEST_CASE("strange keys and values are shown without control characters and cut short") {
  CHECK(has(message(R"({"a\nb": 1})"), R"(a.json: ["a\u000ab"] is not known)"));
  const std::string long_key(100000, 'k');
  CHECK(message("{\"" + long_key + "\": 1}").size() < 600);
  CHECK(message(scene_with("\"gravity\": \"" + long_key + "\"")).size() < 300);
  CHECK(in_quotes("\xc3\xa4") == "\"\xc3\xa4\"");
  std::string umlauts;
  for (int k = 0; k < 40; ++k) umlauts += "\xc3\xa4";
  CHECK(parse_json(in_quotes("x" + umlauts), "a"));  // cut between characters, so it is still UTF-8
}

TEST_CASE("numbers are written as short as they read back") {
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(-65536) == "-65536");
  CHECK(number_text(1.0 / 3) == "0.3333333333333333");
  CHECK(number_text(1e300) == "1e+300");
}

TEST_CASE("a file is loaded with a byte order mark, and its name stands in every message") {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.json");
  REQUIRE(write_file(path, "\xef\xbb\xbf" + minimal_scene()));
  const auto scene = load_scene(path);
  REQUIRE(scene);
  CHECK(scene->file == path);
  CHECK(scene->cloths[0].where == path + ": cloths[0]");
  CHECK(has(load_scene(folder.path("none.json")).error().message, "none.json cannot be read"));
  CHECK(load_scene(folder.path("")).error().kind == ErrorKind::Input);
}

TEST_CASE("the edit distance counts added, dropped, changed and swapped letters") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("bhv", "bvh") == 1);
  CHECK(edit_distance("stifness", "stiffness") == 1);
}

TEST_CASE(
    "the nearest word is found if at most a third of the letters change, or if one word begins the other") {
  const std::string_view known[] = {"grid", "size", "density", "node_mass"};
  CHECK(nearest("densty", known) == "density");
  CHECK(nearest("nodeMass", known) == "node_mass");
  CHECK(nearest("Grid", known) == "grid");
  CHECK(nearest("gridding", known) == "grid");
  CHECK(nearest("dens", known) == "density");
  CHECK(nearest("mass", known).empty());
  CHECK(nearest("", known).empty());
  CHECK(nearest(std::string(100, 'd'), known).empty());
}
