// The functions that packages/weft/src/catalog.ts calls: what there is to choose from. They need neither
// device nor scene, and leave their answer in weft_message.
#include <emscripten.h>

#include <array>
#include <nlohmann/json.hpp>

#include "message.hpp"
#include "method/method.hpp"
#include "render/color_map.hpp"
#include "render/fabric.hpp"
#include "render/renderer.hpp"
#include "scene/fabrics.hpp"
#include "scene/grab.hpp"
#include "scene/looks.hpp"
#include "scene/names.hpp"
#include "scene/schema.hpp"

namespace {

constexpr int kShades = 33;  // of the map: between them sRGB is close enough to linear

/// The rows of the methods, and their solvers' needs with each of their settings.
nlohmann::ordered_json methods_json() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const weft::Method& method : weft::methods()) {
    nlohmann::ordered_json row{{"kind", weft::scene::name_of(method.kind)}};
    row["memory"] = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < std::size(weft::scene::kForcesNames); ++i) {
      weft::scene::Solver settings;
      settings.kind = method.kind;
      settings.forces = static_cast<weft::scene::Forces>(i);
      const weft::SolverMemory memory = method.memory(settings);
      row["memory"][method.settings_word(settings)] = {{"node", memory.node},
                                                       {"buffer", memory.largest_buffer}};
    }
    row["holdsContact"] = method.holds_obstacles;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

extern "C" {

/// The JSON Schema of scenes.
EMSCRIPTEN_KEEPALIVE void weft_schema() { weft::web::message = weft::scene::schema_json(); }

/// As JSON: the colour map as sRGB in [0, 1], from the lowest value to the highest, the values that stand at
/// its ends by view, how many nodes can be grabbed at once, the methods, and the fabrics and looks with names.
EMSCRIPTEN_KEEPALIVE void weft_catalog() {
  nlohmann::ordered_json json;
  json["colors"] = nlohmann::ordered_json::array();
  for (int i = 0; i < kShades; ++i) {
    const weft::Vec3f color = weft::render::map_color(static_cast<float>(i) / (kShades - 1));
    json["colors"].push_back({color.x, color.y, color.z});
  }
  for (std::size_t i = 0; i < weft::render::kViewCount; ++i) {
    const auto view = static_cast<weft::scene::View>(i);
    if (const auto field = weft::render::field_of(view))
      json["ranges"][weft::scene::name_of(view)] = {field->range.lowest, field->range.highest};
  }
  json["mostGrabs"] = weft::scene::kMaxGrabs;
  json["methods"] = methods_json();
  for (const weft::scene::NamedFabric& fabric : weft::scene::kFabrics)
    json["fabrics"].push_back({{"name", fabric.name},
                               {"what", fabric.what},
                               {"density", fabric.density.value},
                               {"look", weft::scene::look_of_fabric(fabric.name)}});
  for (const weft::scene::NamedLook& look : weft::scene::kLooks) {
    const weft::Vec3f color = weft::render::color_of(weft::scene::look_of(look.name), 0);
    json["looks"].push_back({{"name", look.name}, {"color", {color.x, color.y, color.z}}});
  }
  weft::web::message = json.dump();
}

}  // extern "C"
