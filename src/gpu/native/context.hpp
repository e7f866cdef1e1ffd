// The native back end's device, shared by its files. webgpu.h ends here.
#pragma once

#include <webgpu.h>
#include <wgpu.h>

#include <string>

#include "gpu/backend.hpp"

namespace weft::gpu::backend {

struct Context {
  WGPUInstance instance = nullptr;
  WGPUAdapter adapter = nullptr;
  WGPUDevice device = nullptr;
  WGPUQueue queue = nullptr;
  bool unchecked = false;

  // Written by wgpu-native's callbacks, which it calls inside our own calls and polls.
  bool lost = false;
  std::string lost_reason;
  bool failed = false;  // an error that no call has returned yet
  Error failure;

  /// The error that the last call left, if any; clears it.
  Result<void> take_error();
};

inline WGPUStringView view(const std::string& text) { return {text.data(), text.size()}; }
inline std::string text(WGPUStringView view_) {
  if (view_.data == nullptr) return {};
  return view_.length == WGPU_STRLEN ? std::string(view_.data) : std::string(view_.data, view_.length);
}
template <class Handle>
Handle handle(Id id) {
  return reinterpret_cast<Handle>(id);
}
template <class Handle>
Id id_of(Handle handle_) {
  return reinterpret_cast<Id>(handle_);
}

/// The result of a creating call, or its error.
template <class Handle>
Result<Id> made(Context& context, Handle handle_, const char* what, const std::string& label) {
  if (auto error = context.take_error(); !error)
    return error.error().while_doing(std::string("making ") + what + " " + label);
  if (handle_ == nullptr)
    return make_error(ErrorKind::Failure, "The GPU gives no %s for %s.", what, label.c_str());
  return id_of(handle_);
}

}  // namespace weft::gpu::backend
