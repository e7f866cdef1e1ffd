// make_models RAW_FOLDER MODELS_FOLDER: the meshes that scenes name, as binary PLY. Run by ./dev build.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

#include "base/file.hpp"
#include "mannequin.hpp"
#include "mesh/glb.hpp"
#include "mesh/gzip.hpp"
#include "mesh/ply.hpp"
#include "mesh/primitives.hpp"
#include "mesh/read_mesh.hpp"
#include "mesh/simplify.hpp"

namespace weft::mesh {
namespace {

constexpr int kVersion = 1;  // of the recipes below: raise it, and every folder makes its models again
constexpr int kMannequinVersion = 1;               // likewise of hers
constexpr std::size_t kDragonTriangles = 100'000;  // at most, as in Sung et al.

Result<TriangleMesh> make_unit_sphere(const std::string&) { return make_sphere(20, 20); }

// Upright as it comes (y up), but with its back to the viewer: a half turn about y, which only flips signs.
Result<TriangleMesh> make_armadillo(const std::string& raw) {
  WEFT_TRY(mesh, read_mesh(raw + "/armadillo.off"));
  for (Vec3f& p : mesh.positions) p = {-p.x, p.y, -p.z};
  return mesh;
}

// Upright as it comes (y up), its side to the viewer and its head on the left.
Result<TriangleMesh> make_dragon(const std::string& raw) {
  WEFT_TRY(mesh, read_mesh(raw + "/dragon.ply.gz"));
  return simplify(mesh, kDragonTriangles);
}

Result<TriangleMesh> make_the_skirt(const std::string&) { return make_skirt(); }

struct Recipe {
  const char* name;
  Result<TriangleMesh> (*make)(const std::string& raw_folder);
  bool closed = true;
};

// Written into the file itself, so that model and stamp are there together or not at all.
std::string stamp(const Recipe& recipe) {
  return std::string("weft model ") + recipe.name + ", version " + std::to_string(kVersion);
}

bool is_made(const std::string& path, const Recipe& recipe) {
  const auto bytes = read_file(path, kMaxMeshBytes);
  const std::string begin = ply_begin(stamp(recipe));
  if (!bytes || bytes->size() < begin.size()) return false;
  return std::string(reinterpret_cast<const char*>(bytes->data()), begin.size()) == begin;
}

Result<void> make_model(const Recipe& recipe, const std::string& raw_folder,
                        const std::string& models_folder) {
  const std::string path = models_folder + "/" + recipe.name + ".ply";
  if (is_made(path, recipe)) return {};
  WEFT_TRY(mesh, recipe.make(raw_folder));
  const std::size_t dropped = drop_degenerate_triangles(mesh);
  WEFT_CHECK(check_mesh(mesh));
  const double volume = signed_volume(mesh);
  if (recipe.closed && !(volume > 0.0))
    return input_error("Model %s has the volume %g m³, so it faces inward.", recipe.name, volume);
  WEFT_CHECK(write_file(path, write_ply(mesh, stamp(recipe))));
  const auto [low, high] = bounds(mesh);
  std::fprintf(stderr,
               "weft: made %s: %zu vertices, %zu triangles (%zu of no area dropped), from (%g, %g, %g) to "
               "(%g, %g, %g), volume %g\n",
               path.c_str(), mesh.positions.size(), mesh.triangles.size(), dropped,
               static_cast<double>(low.x), static_cast<double>(low.y), static_cast<double>(low.z),
               static_cast<double>(high.x), static_cast<double>(high.y), static_cast<double>(high.z), volume);
  return {};
}

/// The one model that moves, as GLB.
Result<void> make_the_mannequin(const std::string& models_folder) {
  const std::string path = models_folder + "/mannequin.glb";
  const std::string generator = "weft model mannequin, version " + std::to_string(kMannequinVersion);
  if (const auto bytes = read_file(path, kMaxMeshBytes);
      bytes && std::string_view(reinterpret_cast<const char*>(bytes->data()),
                                std::min<std::size_t>(bytes->size(), 200))
                       .find(generator) != std::string_view::npos)
    return {};
  const std::vector<std::byte> file = make_mannequin(generator);
  WEFT_TRY(mesh, read_glb(file));
  WEFT_CHECK(write_file(path, file));
  const auto [low, high] = bounds(mesh);
  std::fprintf(stderr,
               "weft: made %s: %zu vertices, %zu triangles, from (%g, %g, %g) to (%g, %g, %g), volume %g\n",
               path.c_str(), mesh.positions.size(), mesh.triangles.size(), static_cast<double>(low.x),
               static_cast<double>(low.y), static_cast<double>(low.z), static_cast<double>(high.x),
               static_cast<double>(high.y), static_cast<double>(high.z), signed_volume(mesh));
  return {};
}

Result<void> make_models(const std::string& raw_folder, const std::string& models_folder) {
  static constexpr Recipe kRecipes[] = {{"sphere", make_unit_sphere},
                                        {"armadillo", make_armadillo},
                                        {"dragon", make_dragon},
                                        {"skirt", make_the_skirt, false}};
  WEFT_CHECK(make_folder(models_folder));
  for (const Recipe& recipe : kRecipes)
    if (auto made = make_model(recipe, raw_folder, models_folder); !made)
      return made.error().while_doing(std::string("making model ") + recipe.name);
  return make_the_mannequin(models_folder);
}

}  // namespace
}  // namespace weft::mesh

int main(int argument_count, char** arguments) {
  if (argument_count != 3) {
    std::fputs("usage: make_models RAW_FOLDER MODELS_FOLDER\n", stderr);
    return weft::exit_code(weft::ErrorKind::Usage);
  }
  const auto made = weft::mesh::make_models(arguments[1], arguments[2]);
  if (made) return 0;
  std::fprintf(stderr, "weft: %s\n", made.error().message.c_str());
  return weft::exit_code(made.error().kind);
}
