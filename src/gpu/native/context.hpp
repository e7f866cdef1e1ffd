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

  // Written inside our own calls and polls: by error scopes and by the callbacks of a device that weft made.
  bool lost = false;
  std::string lost_reason;
  bool failed = false;  // an error that no call has returned yet
  Error failure;

  /// Keeps the first error, or the loss, for take_error.
  void record(WGPUErrorType type, const std::string& what);
  /// The error that the last call left, if any; clears it.
  Result<void> take_error();
};

/// Records the errors of the calls that are made while it lives. A device may be the caller's, and then so is the
/// callback that gets the errors of no scope. wgpu-native has scopes for these two kinds, and answers at once.
class ErrorScope {
 public:
  explicit ErrorScope(Context& context) : context_(context) {
    wgpuDevicePushErrorScope(context.device, WGPUErrorFilter_OutOfMemory);
    wgpuDevicePushErrorScope(context.device, WGPUErrorFilter_Validation);
  }
  ~ErrorScope();
  ErrorScope(const ErrorScope&) = delete;
  ErrorScope& operator=(const ErrorScope&) = delete;

 private:
  Context& context_;
};

template <class Call>
auto watched(Context& context, const Call& call) {
  const ErrorScope scope(context);
  return call();
}

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

/// The result of a creating call, or its error; an error that an earlier call left comes first.
template <class Create>
Result<Id> make(Context& context, const char* what, const std::string& label, const Create& create) {
  WEFT_CHECK(context.take_error());
  const auto handle_ = watched(context, create);
  if (auto error = context.take_error(); !error)
    return error.error().while_doing(std::string("making ") + what + " " + label);
  if (handle_ == nullptr)
    return make_error(ErrorKind::Failure, "The GPU gives no %s for %s.", what, label.c_str());
  return id_of(handle_);
}

// Of context.cpp, for given_device.cpp.
AdapterInfo describe(WGPUAdapter adapter);
/// Takes the queue and the limits of the device that the context has.
void take_device(Opened& opened);
/// Refers to a device that the caller made.
/// Errors  Input: a handle is null. Limit: a limit of the device is less than weft's shaders need.
Result<void> take_given_device(Opened& opened, const DeviceOptions& options);

}  // namespace weft::gpu::backend
