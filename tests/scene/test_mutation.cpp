#include <doctest/doctest.h>

#include <filesystem>

#include "base/file.hpp"
#include "base/random.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

std::string text_of(const std::string& path) {
  const auto bytes = read_file(path, 1 << 20);
  REQUIRE(bytes);
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

/// One to four random changes: a byte, a piece cut out, a piece repeated, or a token put in.
std::string mutated(std::string text, Random& random) {
  static const char* const tokens[] = {"null", "-1",      "1e308", "1e-320", "{}",      "[]",
                                       "\"\"", "true",    "0",     ",",      ":",       "{",
                                       "}",    "[",       "]",     "\"",     "\\u0000", "9007199254740993",
                                       "-0.0", "\"grid\""};
  const std::uint32_t changes = 1 + random.below(4);
  for (std::uint32_t k = 0; k < changes; ++k) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(text.size() + 1));
    const std::size_t count = random.below(12);
    switch (random.below(4)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        text.erase(at, count);
        break;
      case 2:
        text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size() + 1)), count * 4));
        break;
      default:
        text.replace(at, random.below(6), tokens[random.below(std::size(tokens))]);
    }
  }
  return text;
}

}  // namespace

TEST_CASE("six thousand mutated scenes are read or refused with one sentence, and never crash") {
  std::vector<std::string> texts = {
      motion_with(R"("kind": "path", "points": [[1, [0, 0, 1]], [2, [0, 1, 0]]])"),
      scene_with(
          R"("colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 1}], "camera": {"eye": [0, 0, 1],
                    "target": [0, 0, 0]}, "render": {"view": "normals"})"),
      proximity_with(R"({"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 1},
                        {"kind": "box", "center": [0, 0, 0], "size": [1, 1, 1], "friction": 0.5,
                         "motion": {"kind": "path", "points": [[1, [0, 0, 1]], [2, [0, 1, 0]]]}},
                        {"kind": "convex", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]},
                        {"kind": "mesh", "mesh": "a",
                        "keyframes": [{"time": 1, "mesh": "b"}, {"time": 2, "mesh": "a"}]})")};
  for (const auto& entry : std::filesystem::directory_iterator(source_path("scenes")))
    texts.push_back(text_of(entry.path().string()));
  Random random(2024);
  int read = 0, refused = 0;
  for (int k = 0; k < 6000; ++k) {
    const std::string text = mutated(texts[random.below(static_cast<std::uint32_t>(texts.size()))], random);
    const auto scene = parse_scene(text, "a.json");
    if (scene) {
      ++read;
      CHECK(!scene->cloths.empty());
      continue;
    }
    ++refused;
    const Error& error = scene.error();
    if (error.kind != ErrorKind::Input || error.message.rfind("a.json: ", 0) != 0 ||
        error.message.size() > 1500 || error.message.find('\n') != std::string::npos)
      FAIL(error.message << "\n" << text);
  }
  CHECK(read > 100);
  CHECK(refused > 1000);
}

TEST_CASE("two thousand random overrides never crash") {
  static const char* const parts[] = {"cloths", "0", "1", "grid", "time",   "frame",
                                      "x",      "",  "[", "]",    "solver", "kind"};
  static const char* const values[] = {"1",  "[]",    "{}",           "null", "paper",
                                       "\"", "[1,2]", "{\"kind\":1}", "-",    "1e400"};
  Random random(7);
  for (int k = 0; k < 2000; ++k) {
    std::vector<Override> overrides(1 + random.below(3));
    for (Override& change : overrides) {
      for (std::uint32_t n = 0, count = random.below(5); n < count; ++n)
        change.key += (n ? "." : "") + std::string(parts[random.below(std::size(parts))]);
      change.value = values[random.below(std::size(values))];
    }
    const auto scene = parse_scene(minimal_scene(), "a.json", overrides);
    if (!scene) CHECK(!scene.error().message.empty());
  }
}
