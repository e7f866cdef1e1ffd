#include <doctest/doctest.h>

#include <filesystem>
#include <set>

#include "base/file.hpp"
#include "hostile.hpp"
#include "scene/format.hpp"
#include "scene/load.hpp"
#include "scene/schema.hpp"
#include "schema_validator.hpp"
#include "source_path.hpp"
#include "texts.hpp"

using namespace weft;
using namespace weft::scene;

namespace {

const Json& schema() {
  static const Json json = *parse_json(schema_json(), "the schema");
  return json;
}

bool accepts(const std::string& text) {
  const auto json = parse_json(text, "a.json");
  if (!json) FAIL(json.error().message);
  std::string unknown;
  const bool fine = valid(*json, schema(), schema(), unknown);
  CHECK(unknown == "");
  return fine;
}

void keys_of_schema(const Json& json, std::set<std::string>& keys) {
  if (const Json* properties = json.find("properties"))
    if (json.find("additionalProperties")) keys.insert(properties->names.begin(), properties->names.end());
  for (const Json& inner : json.values) keys_of_schema(inner, keys);
}

void keys_of_table(const Type& type, std::set<std::string>& keys) {
  for (const Type* inner : type.types) keys_of_table(*inner, keys);
  const auto all = [&](std::span<const Key> some) {
    for (const Key& key : some) {
      keys.insert(key.name);
      keys_of_table(*key.type, keys);
    }
  };
  all(type.keys);
  for (const Variant& variant : type.variants) all(variant.keys);
}

}  // namespace

TEST_CASE("the schema is JSON, of draft 2020-12, and has the keys of the loader and no others") {
  CHECK(schema().find("$schema")->text == "https://json-schema.org/draft/2020-12/schema");
  std::set<std::string> in_schema, in_table;
  keys_of_schema(schema(), in_schema);
  keys_of_table(scene_type(), in_table);
  CHECK(in_schema == in_table);
  CHECK(in_table.size() > 50);
}

TEST_CASE("the schema accepts what the loader accepts") {
  CHECK(accepts(minimal_scene()));
  CHECK(accepts(cloth_of(R"("mesh": "shirt.obj", "node_mass": 1)")));
  CHECK(accepts(cloth_of(R"("mesh": "shirt.obj", "fabric": "blanket")")));
  CHECK(
      accepts(cloth_of(R"("mesh": "shirt.obj", "node_mass": 1, "fabric": {"name": "blanket", "weft": 3})")));
  CHECK(accepts(cloth_of(
      R"("mesh": "shirt.obj", "density": 1, "fabric": {"warp": 3, "shear": 1, "bending_warp": 0})")));
  CHECK(accepts(scene_with(R"("solver": {"forces": "spring_centric"})")));
  CHECK(accepts(scene_with(R"("time": {"substeps": 4.0})")));
  CHECK(
      accepts(cloth_with(R"("pins": ["top", {"nodes": [1]}, {"near": {"point": [0, 0, 0], "radius": 1}}])")));
  CHECK(accepts(motion_with(R"("kind": "path", "points": [[0, [0, 0, 0]]])")));
  CHECK(accepts(
      motion_with(R"("kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 1, "angle": 2)")));
  CHECK(accepts(scene_with(R"("colliders": [{"kind": "mesh", "mesh": "dragon"},
                               {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])")));
  CHECK(accepts(scene_with(R"("contact": {"method": "proximity", "self": false, "restitution": 1})")));
  CHECK(accepts(
      proximity_with(R"({"kind": "capsule", "a": [0, 0, 0], "b": [1, 0, 0], "radius": 1, "friction": 0.5,
                                   "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 1}})")));
  CHECK(accepts(
      proximity_with(R"({"kind": "box", "center": [0, 0, 0], "size": [1, 2, 3], "rotate": [0, 0, 0, 1]})")));
  CHECK(accepts(
      proximity_with(R"({"kind": "convex", "mesh": "a", "transform": {"scale": 2}, "friction": 1})")));
  CHECK(accepts(
      proximity_with(R"({"kind": "convex", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]})")));
  CHECK(accepts(proximity_with(R"({"kind": "mesh", "mesh": "a", "keyframes": [{"time": 1, "mesh": "b"}]})")));
  for (const auto& entry : std::filesystem::directory_iterator(source_path("scenes"))) {
    const auto bytes = read_file(entry.path().string(), 1 << 20);
    REQUIRE(bytes);
    CHECK(accepts({reinterpret_cast<const char*>(bytes->data()), bytes->size()}));
  }
}

TEST_CASE("the schema refuses what the loader refuses, but for what no schema can say") {
  for (const Hostile& hostile : hostile_scenes()) {
    CAPTURE(hostile.text.substr(0, 300));
    CHECK(accepts(hostile.text) == !hostile.schema_refuses);
  }
}

TEST_CASE("each kind of solver, motion and collider in the table has its variant, and each default is good") {
  const auto check_type = [](auto&& self, const Type& type) -> void {
    if (!type.variants.empty()) {
      REQUIRE(type.keys[0].name == std::string("kind"));
      const auto choices = type.keys[0].type->choices;
      REQUIRE(choices.size() == type.variants.size());
      for (std::size_t k = 0; k < choices.size(); ++k)
        CHECK(std::string(choices[k]) == type.variants[k].value);
    }
    const auto all = [&](std::span<const Key> keys) {
      for (const Key& key : keys) {
        CAPTURE(key.name);
        CHECK((!key.required || !key.fallback));
        CHECK(std::string(key.doc).size() > 3);
        if (key.fallback) CHECK(parse_json(key.fallback, key.name));
        self(self, *key.type);
      }
    };
    all(type.keys);
    for (const Variant& variant : type.variants) all(variant.keys);
    for (const Type* inner : type.types) self(self, *inner);
  };
  check_type(check_type, scene_type());
}
