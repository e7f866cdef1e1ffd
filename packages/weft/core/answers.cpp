// What packages/weft/src/core.ts calls in either module: the text that a call has left, and the meshes that scenes
// name.
#include <emscripten.h>

#include <cstddef>
#include <cstdint>

#include "inputs.hpp"
#include "message.hpp"

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* weft_message() { return weft::web::message.data(); }
EMSCRIPTEN_KEEPALIVE std::uint32_t weft_message_size() {
  return static_cast<std::uint32_t>(weft::web::message.size());
}

EMSCRIPTEN_KEEPALIVE std::uint32_t weft_add_mesh(const char* name, std::uint32_t name_size,
                                                 const std::byte* bytes, std::uint32_t size) {
  return weft::web::code(weft::web::meshes().add(weft::web::text(name, name_size), {bytes, size}));
}

}  // extern "C"
