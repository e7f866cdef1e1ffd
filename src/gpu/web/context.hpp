// The browser back end's device, shared by its files. There is one at a time: the module's.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gpu/backend.hpp"
#include "gpu/web/imports.hpp"

namespace weft::gpu::backend {

struct Context {
  std::uint32_t error = 0;  // set by the JavaScript side when there is an error to take
  std::vector<std::shared_ptr<MapState>> mapping;  // kept alive until the JavaScript side has written to them
  std::vector<web::ListView> lists;                // of the submit under way

  /// The error that earlier calls left, if any; clears it, but for a loss.
  Result<void> take_error();
};

inline web::Text text(const std::string& text_) {
  return {text_.data(), static_cast<std::uint32_t>(text_.size())};
}
inline std::uint32_t handle(Id id) { return static_cast<std::uint32_t>(id); }
/// The text that the JavaScript side has ready.
std::string take_text();

}  // namespace weft::gpu::backend
