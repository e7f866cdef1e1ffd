// A player with a small sheet that hangs from two corners across the picture's middle.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "player/player.hpp"
#include "scene/load.hpp"

namespace weft::window {

constexpr std::uint32_t kWidth = 160, kHeight = 90;

inline std::string sheet(int side) {
  const std::string n = std::to_string(side);
  return R"({"format": "weft-scene/1", "time": {"substeps": 4, "frames": 3}, "drag": 0.5, "contact": {"method": "none"},
    "cloths": [{"grid": [)" +
         n + "," + n + R"(], "size": [1, 1], "density": 0.2, "damping": 0.01,
      "stiffness": {"structural": 20, "shear": 8, "bend": 2}, "pins": ["top_left", "top_right"]}],
    "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "fov_degrees": 35}})";
}

inline Result<Inputs> read(const SceneText& source, const OwnMesh* mesh) {
  WEFT_TRY(scene, scene::parse_scene(source.text, source.file, source.changes));
  WEFT_TRY(assets, load_assets(scene, [&](const std::string&) -> Result<mesh::TriangleMesh> {
             if (mesh == nullptr) return input_error("There are no meshes here.");
             return mesh->mesh;
           }));
  return Inputs{std::move(scene), std::move(assets)};
}

inline Wanted wanted(const std::string& name, const std::string& text) {
  Wanted made;
  made.name = name;
  made.scene.text = text;
  made.scene.file = name + ".json";
  return made;
}

struct Opened {
  Opened() : player(read, "test") {
    REQUIRE(player.begin({}, kWidth, kHeight, scene::View::Textured));
    const auto opened = player.open(wanted("sheet", sheet(9)));
    REQUIRE_MESSAGE(opened, (opened ? "" : opened.error().message));
  }
  ~Opened() { CHECK(player.device().status()); }

  std::string hash_after(std::uint32_t frames) {
    player.play(true);
    while (player.world().frame() < frames) REQUIRE(player.tick(0, true));
    player.play(false);
    auto hash = player.state_hash();
    REQUIRE(hash);
    return *hash;
  }

  Player player;
};

}  // namespace weft::window
