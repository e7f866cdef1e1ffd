// The functions that packages/weft/src/core.ts calls. Each that can fail returns 0, or 1 + its ErrorKind, and
// leaves its sentence in weft_message. Texts come as UTF-8 with a length. Those marked "sleeps" return later
// (Asyncify): nothing else may be called in between.
#include <emscripten.h>
#include <malloc.h>

#include "session.hpp"

namespace {

using weft::web::Session;

Session* session = nullptr;
std::string message;  // a sentence, or the text that was asked for

std::uint32_t code(const weft::Result<void>& result) {
  if (result) return 0;
  message = result.error().message;
  return 1 + static_cast<std::uint32_t>(result.error().kind);
}

std::string text(const char* data, std::uint32_t size) { return {data, size}; }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* weft_message() { return message.data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_message_size() { return static_cast<std::uint32_t>(message.size()); }
/// Bytes of the module's heap that are in use.
EMSCRIPTEN_KEEPALIVE double weft_heap_bytes() {
  return static_cast<double>(static_cast<unsigned>(mallinfo().uordblks));
}

/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_open(const char* adapter, std::uint32_t size) {
  if (session == nullptr) session = new Session;
  return code(session->open(text(adapter, size)));
}
EMSCRIPTEN_KEEPALIVE void weft_close() {
  delete session;
  session = nullptr;
}
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_add_mesh(const char* name, std::uint32_t name_size,
                                                 const std::byte* bytes, std::uint32_t size) {
  return code(session->add_mesh(text(name, name_size), {bytes, size}));
}
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_load(const char* scene, std::uint32_t scene_size, const char* changes,
                                             std::uint32_t changes_size) {
  return code(session->load(text(scene, scene_size), text(changes, changes_size)));
}
EMSCRIPTEN_KEEPALIVE void weft_describe() { message = session->describe(); }

/// Whether weft_advance would go without waiting.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_has_room() { return session->world()->has_room() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_advance() { return code(session->advance()); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_poll() { return code(session->world()->poll()); }
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_finish() { return code(session->world()->finish()); }
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_reset() { return code(session->world()->reset()); }

/// frames reported, simulated s, contacts, contact hash, contact overflow, largest stretch, nodes that are
/// not finite, frames submitted.
EMSCRIPTEN_KEEPALIVE const double* weft_totals() {
  static double values[8];
  const weft::sim::World& world = *session->world();
  const weft::sim::Totals& totals = world.totals();
  values[0] = totals.frames;
  values[1] = totals.frames * world.scene().time.frame;
  values[2] = static_cast<double>(totals.contacts);
  values[3] = totals.contact_hash;
  values[4] = static_cast<double>(totals.contact_overflow);
  values[5] = static_cast<double>(totals.max_stretch);
  values[6] = totals.nonfinite;
  values[7] = world.frame();
  return values;
}
EMSCRIPTEN_KEEPALIVE double weft_gpu_bytes() {
  return static_cast<double>(session->world()->device().allocated_bytes());
}

/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_snapshot() {
  const std::uint32_t failed = code(session->take_snapshot());
  if (failed == 0) message = session->snapshot().hash();
  return failed;
}
EMSCRIPTEN_KEEPALIVE const weft::Vec4f* weft_positions() { return session->snapshot().position.data(); }
EMSCRIPTEN_KEEPALIVE const weft::Vec4f* weft_velocities() { return session->snapshot().velocity.data(); }
/// Sleeps.
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_export(const char* format, std::uint32_t size) {
  return code(session->export_mesh(text(format, size)));
}
EMSCRIPTEN_KEEPALIVE const std::byte* weft_exported() { return session->exported().data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_exported_size() {
  return static_cast<std::uint32_t>(session->exported().size());
}

}  // extern "C"
