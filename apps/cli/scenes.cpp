#include "scenes.hpp"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "common.hpp"
#include "scene_source.hpp"

namespace weft::cli {
namespace {

struct Listed {
  std::string name, title, description;
  std::uint64_t nodes = 0;          // of all sheets and blocks
  std::vector<std::string> meshes;  // of cloths and bodies that are none, each once
};

Listed about(const std::string& name, const scene::Scene& scene) {
  Listed listed{name, scene.title, scene.description, 0, {}};
  for (const scene::Cloth& cloth : scene.cloths) {
    if (cloth.grid) {
      listed.nodes += std::uint64_t{cloth.grid->nx} * cloth.grid->ny;
    } else if (cloth.solid && cloth.solid->block) {
      const auto& [x, y, z] = cloth.solid->block->cells;
      listed.nodes += (std::uint64_t{x} + 1) * (std::uint64_t{y} + 1) * (std::uint64_t{z} + 1);
    } else {
      const std::string& mesh = !cloth.solid                       ? cloth.mesh
                                : !cloth.solid->tetrahedra.empty() ? cloth.solid->tetrahedra
                                                                   : cloth.solid->surface;
      if (std::find(listed.meshes.begin(), listed.meshes.end(), mesh) == listed.meshes.end())
        listed.meshes.push_back(mesh);
    }
  }
  return listed;
}

std::string size_text(const Listed& listed) {
  std::string text = listed.nodes > 0 ? std::to_string(listed.nodes) + " nodes" : "";
  for (const std::string& mesh : listed.meshes) text += (text.empty() ? "mesh " : ", mesh ") + mesh;
  return text;
}

Result<std::vector<Listed>> read_all() {
  const std::vector<std::string> names = shipped_scenes();
  if (names.empty())
    return input_error("There are no shipped scenes in %s.", folder_beside_program("scenes").c_str());
  std::vector<Listed> all;
  for (const std::string& name : names) {
    WEFT_TRY(scene, read_scene(name, {}));
    all.push_back(about(name, scene));
  }
  return all;
}

void print_json(const std::vector<Listed>& all) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Listed& listed : all)
    rows.push_back({{"name", listed.name},
                    {"title", listed.title},
                    {"description", listed.description},
                    {"nodes", listed.nodes},
                    {"meshes", listed.meshes}});
  std::printf("%s\n", rows.dump(2).c_str());
}

}  // namespace

int list_scenes(bool json) {
  const auto all = read_all();
  if (!all) return report(all.error());
  if (json) {
    print_json(*all);
    return 0;
  }
  for (const Listed& listed : *all)
    std::printf("%-16s %-28s %s\n", listed.name.c_str(), size_text(listed).c_str(), listed.title.c_str());
  return 0;
}

}  // namespace weft::cli
