// The functions that packages/weft/src/reference.ts calls: a scene on the CPU, without a device. Of the form
// of bindings.cpp; none sleeps.
#include <emscripten.h>

#include <optional>

#include "inputs.hpp"
#include "message.hpp"
#include "model/sewn.hpp"
#include "model/tears.hpp"
#include "reference/simulation.hpp"
#include "session/describe.hpp"

namespace {

using weft::reference::Simulation;
using weft::web::message;

/// Measured at 256² to 1024² nodes: a reference takes 380, and the heap has grown to 744 once it is built.
constexpr std::uint64_t kBytesPerNode = 750;

std::optional<Simulation> simulation;
std::size_t dropped_triangles = 0;
std::vector<weft::Vec3f> positions;  // as f32, kept until the next call

weft::Result<void> load(const std::string& text, const std::string& lines) {
  simulation.reset();
  WEFT_TRY(source, weft::web::scene_text(text, lines));
  WEFT_TRY(inputs, weft::web::read_inputs(source, kBytesPerNode));
  WEFT_CHECK(weft::check_whole(inputs.scene));
  WEFT_CHECK(weft::check_unsewn(inputs.scene));
  WEFT_TRY(made, Simulation::create(inputs.scene, inputs.assets));
  simulation.emplace(std::move(made));
  dropped_triangles = inputs.assets.dropped_triangles;
  return {};
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reference_load(const char* scene, std::uint32_t scene_size,
                                                       const char* changes, std::uint32_t changes_size) {
  return weft::web::code(load(weft::web::text(scene, scene_size), weft::web::text(changes, changes_size)));
}
/// Facts of the loaded scene, as JSON.
EMSCRIPTEN_KEEPALIVE void weft_reference_describe() {
  message = weft::web::json_of(weft::describe(*simulation, simulation->positions().size(),
                                              simulation->triangles().size(), dropped_triangles))
                .dump();
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reference_advance() {
  return weft::web::code(simulation->advance_frame());
}
EMSCRIPTEN_KEEPALIVE void weft_reference_reset() { simulation->reset(); }
EMSCRIPTEN_KEEPALIVE double weft_reference_seconds() { return simulation->time(); }
EMSCRIPTEN_KEEPALIVE double weft_reference_energy() { return simulation->energy(); }

/// Three numbers a node [m].
EMSCRIPTEN_KEEPALIVE const weft::Vec3f* weft_reference_positions() {
  positions.clear();
  for (const weft::Vec3d& p : simulation->positions()) positions.push_back(p.to<float>());
  return positions.data();
}
/// Three nodes a triangle.
EMSCRIPTEN_KEEPALIVE const weft::mesh::Triangle* weft_reference_triangles() {
  return simulation->triangles().data();
}
EMSCRIPTEN_KEEPALIVE void weft_reference_hash() { message = simulation->hash(); }

EMSCRIPTEN_KEEPALIVE void weft_reference_close() {
  simulation.reset();
  positions = {};
  weft::web::meshes().clear();
}

}  // extern "C"
