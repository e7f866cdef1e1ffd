// The functions that packages/weft/src/core.ts calls. Each that can fail returns 0, or 1 + its ErrorKind, and
// leaves its sentence in weft_message. Texts come as UTF-8 with a length. Those marked "sleeps" return later
// (Asyncify): nothing else may be called in between. What needs a world or a view says so where there is
// none.
#include <emscripten.h>
#include <malloc.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "inputs.hpp"
#include "message.hpp"
#include "reference/simulation.hpp"
#include "render/orbit.hpp"
#include "session/describe.hpp"
#include "session/session.hpp"
#include "sim/probe.hpp"

namespace {

using weft::Session;
using weft::web::code;
using weft::web::message;
using weft::web::text;

constexpr const char* kBuild = WEFT_VERSION ", the package";  // as saved states name what they come from

Session* session = nullptr;
std::optional<weft::reference::MassSpringSystem>
    elements;                  // of the world, once it has been measured or probed
std::vector<std::byte> saved;  // a state, until it has been fetched
std::vector<double>
    reported;  // of each frame that has reported since this was fetched: its number, its end [s], totals

/// Numbers for the other side to read at once, as many as there are.
template <class... Numbers>
const double* give(Numbers... numbers) {
  static std::array<double, sizeof...(numbers)> given;
  given = {static_cast<double>(numbers)...};
  return given.data();
}

/// The result of `use` on the session, if it has a world. What sleeps in it comes as a lambda: a call by pointer cannot
/// (Asyncify).
template <class Use>
std::uint32_t with_world(Use use) {
  if (session == nullptr || session->world() == nullptr)
    return code(weft::make_error(weft::ErrorKind::Failure, "No scene is loaded."));
  return code(use(*session));
}

weft::view::CanvasView* view() { return session != nullptr ? session->canvas_view() : nullptr; }

void report(const weft::sim::World& world, std::uint32_t frame) {
  reported.push_back(frame + 1);
  reported.push_back(world.plan().begin_of(frame + 1));
  weft::for_each(world.totals(),
                 [](const char*, auto value) { reported.push_back(static_cast<double>(value)); });
}

weft::Result<void> load(const std::string& text, const std::string& changes) {
  WEFT_TRY(source, weft::web::scene_text(text, changes));
  reported.clear();
  session->on_world([](weft::sim::World& world) {
    elements.reset();
    world.on_report([&world](std::uint32_t frame) { report(world, frame); });
  });
  WEFT_CHECK(session->load(std::move(source), [](const weft::SceneText& given) {
    return weft::web::read_inputs(given, weft::kWorldBytesPerNode);
  }));
  return {};
}

/// Leaves what came of it as JSON in `message`.
weft::Result<void> change_mesh(Session& of) {
  WEFT_TRY(change, of.change_mesh(kBuild));
  message = nlohmann::ordered_json{{"changed", change.changed}, {"news", change.news}}.dump();
  return {};
}

/// A collider's number, then a position and a rotation or the 16 numbers of a matrix.
weft::Result<void> set_collider(Session& of, std::span<const double> numbers) {
  weft::Placement placement;
  if (numbers.size() == 17) {
    WEFT_SET(placement, weft::Placement::from_matrix(numbers.subspan<1, 16>()));
  } else {
    placement = {{numbers[1], numbers[2], numbers[3]}, {numbers[4], numbers[5], numbers[6], numbers[7]}};
  }
  return of.world()->set_collider(static_cast<std::size_t>(numbers[0]), placement);
}

std::string describe() {
  nlohmann::ordered_json json = weft::web::json_of(weft::describe(*session->world()));
  json["view"] = weft::scene::name_of(session->shown());
  json["refusedViews"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; view() != nullptr && i < weft::render::kViewCount; ++i) {
    const auto shown = static_cast<weft::scene::View>(i);
    if (const auto can = view()->can_show(shown); !can)
      json["refusedViews"][weft::scene::name_of(shown)] = can.error().message;
  }
  json["changesMesh"] = session->changes_mesh();
  json["adapter"] = session->device().adapter().name;
  json["gpuBytes"] = session->device().allocated_bytes();
  json["timestamps"] = session->device().has_timestamps();
  return json.dump();
}

/// Leaves the times as JSON in `message`.
weft::Result<void> time_passes(Session& of) {
  WEFT_TRY(kernels, of.time_passes());
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const weft::sim::KernelTime& one : kernels)
    json.push_back({{"kernel", one.kernel},
                    {"per", one.per},
                    {"dispatches", one.dispatches},
                    {"milliseconds", one.milliseconds}});
  message = json.dump();
  return {};
}

weft::reference::MassSpringSystem& elements_of(const weft::sim::World& world) {
  if (!elements) elements = weft::reference::elements_of(world.model().host);
  return *elements;
}
/// Gravity and the external force [m/s²].
weft::Vec3d acceleration_of(const weft::sim::World& world) {
  return world.scene().gravity + world.scene().external_force;
}

/// Leaves what frames.csv of weft run has of a frame, as JSON in `message`.
weft::Result<void> measure(Session& of) {
  const weft::sim::World& world = *of.world();
  WEFT_TRY(nodes, world.node_state());
  const weft::reference::EnergySums e = weft::reference::energies_at(
      elements_of(world), nodes.position, nodes.velocity, nodes.creases, acceleration_of(world));
  const weft::Statistics& frame = world.last_report();
  message = nlohmann::ordered_json{{"frame", world.frame()},
                                   {"seconds", world.time()},
                                   {"kinetic", e.kinetic},
                                   {"potential", e.potential},
                                   {"springs", e.springs},
                                   {"membranes", e.membranes},
                                   {"bending", e.bending},
                                   {"tetrahedra", e.tetrahedra},
                                   {"gas", e.gas},
                                   {"maxStretch", frame.max_stretch},
                                   {"contacts", frame.contacts},
                                   {"residual", frame.residual}}
                .dump();
  return {};
}

/// Leaves what a node does as JSON in `message`.
weft::Result<void> probe(Session& of, std::uint32_t node) {
  const weft::sim::World& world = *of.world();
  WEFT_TRY(nodes, world.node_state());
  WEFT_TRY(found, weft::sim::probe(world.model().host, nodes, node));
  const weft::Vec3d force =
      weft::reference::forces_at(elements_of(world), nodes.position, nodes.velocity, nodes.creases,
                                 world.model().host.mass, acceleration_of(world))[node];
  const auto three = [](const weft::Vec3d& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
  message = nlohmann::ordered_json{{"position", three(found.position)},
                                   {"rest", three(found.rest)},
                                   {"velocity", three(found.velocity)},
                                   {"mass", found.mass},
                                   {"stretch", found.stretch},
                                   {"tension", found.tension},
                                   {"force", three(force)}}
                .dump();
  return {};
}

weft::Result<void> save_state(Session& of) {
  WEFT_SET(saved, of.save_state(kBuild));
  return {};
}

/// Leaves what was opened as JSON in `message`.
weft::Result<void> open_state(Session& of, std::span<const std::byte> bytes) {
  WEFT_TRY(other, of.open_state(bytes, kBuild));
  nlohmann::ordered_json json{{"grabs", nlohmann::ordered_json::array()}, {"otherOrigin", nullptr}};
  for (const auto& [node, target] : of.world()->grabbed())
    json["grabs"].push_back({{"node", node}, {"target", {target.x, target.y, target.z}}});
  if (!other.empty())
    json["otherOrigin"] =
        "The state was saved " + other + ": bits may differ from those of a run that goes on there.";
  message = json.dump();
  return {};
}

}  // namespace

extern "C" {

/// Bytes of the module's heap that are in use.
EMSCRIPTEN_KEEPALIVE double weft_heap_bytes() {
  return static_cast<double>(static_cast<unsigned>(mallinfo().uordblks));
}

/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_open(const char* adapter, std::uint32_t size) {
  if (session == nullptr) session = new Session;
  return code(session->open({.adapter = text(adapter, size)}));
}
EMSCRIPTEN_KEEPALIVE void weft_close() {
  elements.reset();
  delete session;
  session = nullptr;
  weft::web::meshes().clear();
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_load(const char* scene, std::uint32_t scene_size, const char* changes,
                                             std::uint32_t changes_size) {
  if (session == nullptr) session = new Session;
  return code(load(text(scene, scene_size), text(changes, changes_size)));
}
EMSCRIPTEN_KEEPALIVE void weft_describe() {
  if (session != nullptr && session->world() != nullptr) message = describe();
}

/// Whether weft_advance would go without waiting.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_has_room() {
  return session != nullptr && session->world() != nullptr && session->world()->has_room() ? 1 : 0;
}
/// Sleeps. Before each frame of a scene that changesMesh; leaves {"changed", "news"} in weft_message.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_change_mesh() {
  return with_world([](Session& s) { return change_mesh(s); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_advance() {
  return with_world([](Session& s) { return s.advance(false); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_advance_and_draw() {
  return with_world([](Session& s) { return s.advance(true); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_draw() {
  return with_world([](Session& s) { return s.draw(); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_poll() {
  return with_world([](Session& s) { return s.world()->poll(); });
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_finish() {
  return with_world([](Session& s) { return s.world()->finish(); });
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reset() {
  return with_world([](Session& s) { return s.reset(); });
}

EMSCRIPTEN_KEEPALIVE std::uint32_t weft_set(const char* key, std::uint32_t key_size, const char* value,
                                            std::uint32_t value_size) {
  return with_world([&](Session& s) { return s.set(text(key, key_size), text(value, value_size)); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_grab(std::uint32_t node, double x, double y, double z) {
  return with_world([&](Session& s) { return s.world()->grab(node, {x, y, z}); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_drag(std::uint32_t node, double x, double y, double z) {
  return with_world([&](Session& s) { return s.world()->drag(node, {x, y, z}); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_release(std::uint32_t node) {
  return with_world([&](Session& s) { return s.world()->release(node); });
}

/// `size` bytes: the doubles of set_collider.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_set_collider(const double* numbers, std::uint32_t size) {
  return with_world([&](Session& s) { return set_collider(s, {numbers, size / sizeof(double)}); });
}
/// The handles of the buffers with the state at the end of the last frame: position, velocity, normal, stretch and
/// triangles; null where there is no world.
EMSCRIPTEN_KEEPALIVE const double* weft_buffers() {
  if (session == nullptr || session->world() == nullptr) return nullptr;
  const weft::sim::World& world = *session->world();
  return give(world.state().position[world.parity()].id(), world.state().velocity[world.parity()].id(),
              world.surface().normal().id(), world.surface().stretch().id(), world.model().triangles.id());
}

/// How many numbers there are of frames that have reported, and where, until weft_drop_reported.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reported_count() {
  return static_cast<std::uint32_t>(reported.size());
}
EMSCRIPTEN_KEEPALIVE const double* weft_reported() { return reported.data(); }
EMSCRIPTEN_KEEPALIVE void weft_drop_reported() { reported.clear(); }

/// The totals of packages/weft/src/totals.ts, in their order; null where there is no world.
EMSCRIPTEN_KEEPALIVE const double* weft_totals() {
  if (session == nullptr || session->world() == nullptr) return nullptr;
  static std::vector<double> given;
  given.clear();
  weft::for_each(session->world()->totals(),
                 [](const char*, auto value) { given.push_back(static_cast<double>(value)); });
  return given.data();
}
EMSCRIPTEN_KEEPALIVE double weft_gpu_bytes() {
  if (session == nullptr || session->world() == nullptr) return 0;
  return static_cast<double>(session->world()->device().allocated_bytes());
}

/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_snapshot() {
  const std::uint32_t failed = with_world([](Session& s) { return s.take_snapshot(); });
  if (failed == 0) message = session->snapshot().hash();
  return failed;
}
/// Sleeps. Leaves the times in weft_message.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_time_passes() {
  return with_world([](Session& s) { return time_passes(s); });
}
/// Sleeps. Leaves the numbers in weft_message.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_measure() {
  return with_world([](Session& s) -> weft::Result<void> {
    WEFT_CHECK(s.world()->finish());
    return measure(s);
  });
}
/// Sleeps. Leaves the numbers in weft_message.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_probe(std::uint32_t node) {
  return with_world([node](Session& s) -> weft::Result<void> {
    WEFT_CHECK(s.world()->finish());
    return probe(s, node);
  });
}
/// After weft_open and before weft_load. `format`: a gpu::TextureFormat.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_canvas(std::uint32_t target, std::uint32_t format,
                                               std::uint32_t width, std::uint32_t height) {
  session->set_canvas({target, static_cast<weft::gpu::TextureFormat>(format), width, height});
  return 0;
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_resize(std::uint32_t width, std::uint32_t height) {
  return session != nullptr ? code(session->resize(width, height)) : 0;
}
/// Sleeps. `number`: a scene::View.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_view(std::uint32_t number) {
  return session != nullptr ? code(session->set_view(static_cast<weft::scene::View>(number))) : 0;
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_pick(double x, double y) {
  return with_world([&](Session& s) { return s.pick(x, y); });
}
/// node or -1; x, y, z [m].
EMSCRIPTEN_KEEPALIVE const double* weft_picked() {
  const auto& picked = session->picked();
  if (!picked) return give(-1, 0, 0, 0);
  return give(picked->node, picked->point.x, picked->point.y, picked->point.z);
}
/// Sleeps. In clip coordinates.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_pick_within(double ax, double ay, double bx, double by) {
  return with_world([&](Session& s) { return s.pick_within({ax, ay, bx, by}); });
}
EMSCRIPTEN_KEEPALIVE const std::uint32_t* weft_picked_within() { return session->picked_within().data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_picked_count() {
  return static_cast<std::uint32_t>(session->picked_within().size());
}
EMSCRIPTEN_KEEPALIVE const double* weft_point_at(double x, double y, double rx, double ry, double rz) {
  if (view() == nullptr) return nullptr;
  const weft::Vec3d point = view()->point_at(x, y, {rx, ry, rz});
  return give(point.x, point.y, point.z);
}
EMSCRIPTEN_KEEPALIVE const double* weft_project(double x, double y, double z) {
  if (view() == nullptr) return nullptr;
  const weft::render::Projected projected = view()->project({x, y, z});
  return give(projected.x, projected.y);
}

/// eye, target [m], vertical field of view [degrees].
EMSCRIPTEN_KEEPALIVE const double* weft_camera() {
  if (view() == nullptr) return nullptr;
  const weft::scene::Camera& c = view()->camera();
  return give(c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y, c.target.z, c.fov_degrees);
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_set_camera(double ex, double ey, double ez, double tx, double ty,
                                                   double tz, double fov) {
  if (view() != nullptr) view()->set_camera({{ex, ey, ez}, {tx, ty, tz}, fov});
  return 0;
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reset_camera() {
  if (view() != nullptr) view()->reset_camera();
  return 0;
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_orbit(double dx, double dy) {
  if (view() != nullptr) view()->set_camera(weft::render::orbit(view()->camera(), dx, dy));
  return 0;
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_pan(double dx, double dy) {
  if (view() != nullptr) view()->set_camera(weft::render::pan(view()->camera(), dx, dy));
  return 0;
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_zoom(double factor) {
  if (view() != nullptr) view()->set_camera(weft::render::zoom(view()->camera(), factor));
  return 0;
}

/// Where nodes are at rest, x, y, z in double [m]; after weft_load.
EMSCRIPTEN_KEEPALIVE const weft::Vec3d* weft_rest_positions() {
  return session->world()->model().host.rest_position.data();
}
EMSCRIPTEN_KEEPALIVE const weft::Vec4f* weft_positions() { return session->snapshot().position.data(); }
EMSCRIPTEN_KEEPALIVE const weft::Vec4f* weft_velocities() { return session->snapshot().velocity.data(); }
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_export(const char* format, std::uint32_t size) {
  return with_world([&](Session& s) { return s.export_mesh(text(format, size)); });
}
EMSCRIPTEN_KEEPALIVE const std::byte* weft_exported() { return session->exported().data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_exported_size() {
  return static_cast<std::uint32_t>(session->exported().size());
}

/// Sleeps. weft_saved then has the bytes, until weft_drop_saved.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_save_state() {
  return with_world([](Session& s) { return save_state(s); });
}
EMSCRIPTEN_KEEPALIVE const std::byte* weft_saved() { return saved.data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_saved_size() { return static_cast<std::uint32_t>(saved.size()); }
EMSCRIPTEN_KEEPALIVE void weft_drop_saved() { saved = {}; }
/// The most bytes that a state of this scene has.
EMSCRIPTEN_KEEPALIVE double weft_most_saved_bytes() {
  if (session == nullptr || session->world() == nullptr) return 0;
  const weft::sim::World& world = *session->world();
  return static_cast<double>(
      weft::sim::most_saved_bytes(world.model().vertex_count(), world.state().creases.size(), 0));
}
/// Sleeps; the bytes stay until it returns. Leaves what was opened as JSON in weft_message.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_open_state(const std::byte* bytes, std::uint32_t size) {
  return with_world([&](Session& s) { return open_state(s, {bytes, size}); });
}

}  // extern "C"
