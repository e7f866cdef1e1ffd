// make_models RAW_FOLDER MODELS_FOLDER: the meshes that scenes name, as binary PLY. Run by ./dev build.
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
constexpr std::size_t kDragonTriangles = 100'000;  // at most, as in Sung et al.

Result<TriangleMesh> make_unit_sphere(const std::string&) { return make_sphere(20, 20); }

// Of 2,562 vertices, for cloths: triangles of nearly one size.
Result<TriangleMesh> make_ball(const std::string&) { return make_geodesic_sphere(16); }

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
std::string stamp(const char* name) {
  return std::string("weft model ") + name + ", version " + std::to_string(kVersion);
}

/// Whether a file has this text at its beginning, or so many bytes behind it at most.
bool is_made(const std::string& path, const std::string& text, std::size_t behind = 0) {
  const auto bytes = read_file(path, kMaxMeshBytes);
  if (!bytes) return false;
  const std::string_view all(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  return all.substr(0, behind + text.size()).find(text) != std::string_view::npos;
}

void say_made(const std::string& path, const TriangleMesh& mesh, std::size_t dropped) {
  const auto [low, high] = bounds(mesh);
  std::fprintf(stderr,
               "weft: made %s: %zu vertices, %zu triangles (%zu of no area dropped), from (%g, %g, %g) to "
               "(%g, %g, %g), volume %g\n",
               path.c_str(), mesh.positions.size(), mesh.triangles.size(), dropped,
               static_cast<double>(low.x), static_cast<double>(low.y), static_cast<double>(low.z),
               static_cast<double>(high.x), static_cast<double>(high.y), static_cast<double>(high.z),
               signed_volume(mesh));
}

Result<void> make_model(const Recipe& recipe, const std::string& raw_folder,
                        const std::string& models_folder) {
  const std::string path = models_folder + "/" + recipe.name + ".ply";
  if (is_made(path, ply_begin(stamp(recipe.name)))) return {};
  WEFT_TRY(mesh, recipe.make(raw_folder));
  const std::size_t dropped = drop_degenerate_triangles(mesh);
  WEFT_CHECK(check_mesh(mesh));
  const double volume = signed_volume(mesh);
  if (recipe.closed && !(volume > 0.0))
    return input_error("Model %s has the volume %g m³, so it faces inward.", recipe.name, volume);
  WEFT_CHECK(write_file(path, write_ply(mesh, stamp(recipe.name))));
  say_made(path, mesh, dropped);
  return {};
}

/// The one model that moves, as GLB.
Result<void> make_the_mannequin(const std::string& models_folder) {
  const std::string path = models_folder + "/mannequin.glb";
  constexpr std::size_t kBeforeGenerator = 100;  // bytes of a GLB file
  if (is_made(path, stamp("mannequin"), kBeforeGenerator)) return {};
  const std::vector<std::byte> file = make_mannequin(stamp("mannequin"));
  WEFT_TRY(mesh, read_glb(file));
  WEFT_CHECK(write_file(path, file));
  say_made(path, mesh, 0);
  return {};
}

Result<void> make_models(const std::string& raw_folder, const std::string& models_folder) {
  static constexpr Recipe kRecipes[] = {{"sphere", make_unit_sphere},
                                        {"ball", make_ball},
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
