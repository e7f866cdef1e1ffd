// The functions that packages/weft/src/files.ts calls: what is in a file that a user brings, before a world
// gets it. No device is needed, so that a worker can ask, which can be ended. Of the form of bindings.cpp;
// none sleeps.
#include <emscripten.h>

#include <nlohmann/json.hpp>

#include "inputs.hpp"
#include "mesh/lumped.hpp"
#include "mesh/merge.hpp"
#include "mesh/ply.hpp"
#include "mesh/read_mesh.hpp"
#include "message.hpp"

namespace {

using weft::web::message;

std::vector<std::byte> file;  // the mesh as binary PLY, kept until the next call

nlohmann::json point(const weft::Vec3f& p) { return {p.x, p.y, p.z}; }

/// Counts of what a cloth cannot use: triangles without area, then vertices without triangles.
weft::Result<void> clean(weft::mesh::TriangleMesh& mesh, std::size_t& dropped) {
  const std::size_t before = mesh.triangles.size();
  dropped = weft::mesh::drop_degenerate_triangles(mesh);
  if (mesh.triangles.empty())
    return weft::input_error("None of the %zu triangles of the mesh has an area.", before);
  weft::mesh::drop_unused_vertices(mesh);
  return {};
}

weft::Result<void> read(const std::string& name, std::span<const std::byte> bytes, bool cleaned) {
  file = {};
  WEFT_TRY(mesh, weft::mesh::read_mesh(bytes, name));
  std::size_t dropped = 0;
  if (cleaned) WEFT_CHECK(clean(mesh, dropped));
  double area = 0.0;
  for (const double part : weft::mesh::vertex_areas(mesh)) area += part;
  const weft::mesh::Bounds box = weft::mesh::bounds(mesh);
  file = weft::mesh::write_ply(mesh);
  message = nlohmann::json{
      {"vertices", mesh.positions.size()},
      {"triangles", mesh.triangles.size()},
      {"dropped", dropped},
      {"low", point(box.low)},
      {"high", point(box.high)},
      {"area",
       area}}.dump();
  return {};
}

weft::Result<void> check(const std::string& text) {
  WEFT_TRY(source, weft::web::scene_text(text, {}));
  WEFT_TRY(inputs, weft::web::read_inputs(source, weft::kWorldBytesPerNode));
  std::size_t triangles = 0;
  for (const auto& object : inputs.assets.objects) triangles += object.triangles.size();
  message = nlohmann::json{{"nodes", weft::node_count(inputs.scene, inputs.assets)},
                           {"obstacleTriangles", triangles}}
                .dump();
  return {};
}

}  // namespace

extern "C" {

/// Reads a mesh; weft_message then has what it is like, and weft_mesh_file its bytes.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_read_mesh(const char* name, std::uint32_t name_size,
                                                  const std::byte* bytes, std::uint32_t size,
                                                  std::uint32_t cleaned) {
  return weft::web::code(read(weft::web::text(name, name_size), {bytes, size}, cleaned != 0));
}
EMSCRIPTEN_KEEPALIVE const std::byte* weft_mesh_file() { return file.data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_mesh_file_size() { return static_cast<std::uint32_t>(file.size()); }

/// Reads a scene with the meshes that were added.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_check_scene(const char* scene, std::uint32_t size) {
  return weft::web::code(check(weft::web::text(scene, size)));
}

}  // extern "C"
