// Adapters, the device, and how its errors and its loss arrive.
#include "gpu/native/context.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace weft::gpu::backend {
namespace {

std::string lower(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return name;
}

WGPUInstance make_instance() {
  WGPUInstanceExtras extras = {};
  extras.chain.sType = static_cast<WGPUSType>(WGPUSType_InstanceExtras);
  extras.backends = WGPUInstanceBackend_Primary;  // Vulkan, Metal, D3D12: what WebGPU is made for
  WGPUInstanceDescriptor descriptor = WGPU_INSTANCE_DESCRIPTOR_INIT;
  descriptor.nextInChain = &extras.chain;
  wgpuSetLogLevel(WGPULogLevel_Off);  // what matters comes back as an error
  return wgpuCreateInstance(&descriptor);
}

int rank(const AdapterInfo& info) {
  return info.type == "discrete GPU" ? 0 : info.type == "integrated GPU" ? 1 : info.type == "unknown" ? 2 : 3;
}

std::vector<WGPUAdapter> enumerate(WGPUInstance instance) {
  std::vector<WGPUAdapter> adapters(wgpuInstanceEnumerateAdapters(instance, nullptr, nullptr));
  if (!adapters.empty()) wgpuInstanceEnumerateAdapters(instance, nullptr, adapters.data());
  return adapters;
}

void on_lost(WGPUDevice const*, WGPUDeviceLostReason reason, WGPUStringView message, void* user, void*) {
  if (reason == WGPUDeviceLostReason_CallbackCancelled) return;
  auto& context = *static_cast<Context*>(user);
  context.lost = true;
  context.lost_reason = text(message);
}

void on_error(WGPUDevice const*, WGPUErrorType type, WGPUStringView message, void* user, void*) {
  static_cast<Context*>(user)->record(type, text(message));
}

void on_scope(WGPUPopErrorScopeStatus, WGPUErrorType type, WGPUStringView message, void* user, void*) {
  if (type != WGPUErrorType_NoError) static_cast<Context*>(user)->record(type, text(message));
}

void on_adapter_device(WGPURequestDeviceStatus status, WGPUDevice device, WGPUStringView message, void* user,
                       void* why) {
  if (status == WGPURequestDeviceStatus_Success)
    *static_cast<WGPUDevice*>(user) = device;
  else
    *static_cast<std::string*>(why) = text(message);
}

/// The adapter that the options name, or the fastest kind there is.
Result<WGPUAdapter> choose(const std::vector<WGPUAdapter>& adapters, const std::string& wanted) {
  if (adapters.empty())
    return make_error(ErrorKind::NoAdapter,
                      "No WebGPU adapter was found: this machine has no Vulkan, Metal or D3D12 driver "
                      "(on Debian, package mesa-vulkan-drivers has one that needs no GPU).");
  WGPUAdapter best = nullptr;
  int best_rank = 0;
  std::string names;
  for (WGPUAdapter adapter : adapters) {
    const AdapterInfo info = describe(adapter);
    names += (names.empty() ? "" : ", ") + info.name;
    if (lower(info.name).find(lower(wanted)) == std::string::npos) continue;
    if (best != nullptr && best_rank <= rank(info)) continue;
    best = adapter;
    best_rank = rank(info);
  }
  if (best == nullptr)
    return make_error(ErrorKind::NoAdapter, "No adapter's name contains \"%s\"; there are: %s.",
                      wanted.c_str(), names.c_str());
  return best;
}

Result<void> open_device(Opened& opened, const DeviceOptions& options) {
  Context& context = *opened.context;
  WGPULimits limits = WGPU_LIMITS_INIT;
  wgpuAdapterGetLimits(context.adapter, &limits);
  opened.timestamps =
      options.timestamps && wgpuAdapterHasFeature(context.adapter, WGPUFeatureName_TimestampQuery) != 0;
  const WGPUFeatureName timestamp_query = WGPUFeatureName_TimestampQuery;

  WGPUDeviceDescriptor descriptor = WGPU_DEVICE_DESCRIPTOR_INIT;
  const std::string label = "weft";
  descriptor.label = view(label);
  descriptor.requiredLimits = options.default_limits ? nullptr : &limits;
  descriptor.requiredFeatures = &timestamp_query;
  descriptor.requiredFeatureCount = opened.timestamps ? 1 : 0;
  descriptor.deviceLostCallbackInfo.mode = WGPUCallbackMode_AllowSpontaneous;
  descriptor.deviceLostCallbackInfo.callback = on_lost;
  descriptor.deviceLostCallbackInfo.userdata1 = &context;
  descriptor.uncapturedErrorCallbackInfo.callback = on_error;
  descriptor.uncapturedErrorCallbackInfo.userdata1 = &context;

  std::string reason = "no reason given";
  WGPURequestDeviceCallbackInfo callback = WGPU_REQUEST_DEVICE_CALLBACK_INFO_INIT;
  callback.mode = WGPUCallbackMode_AllowSpontaneous;
  callback.callback = on_adapter_device;
  callback.userdata1 = &context.device;
  callback.userdata2 = &reason;
  wgpuAdapterRequestDevice(context.adapter, &descriptor, callback);
  if (context.device == nullptr)
    return make_error(ErrorKind::Failure, "Adapter %s gives no device: %s.", opened.adapter.name.c_str(),
                      reason.c_str());
  take_device(opened);
  return {};
}

}  // namespace

AdapterInfo describe(WGPUAdapter adapter) {
  WGPUAdapterInfo raw = WGPU_ADAPTER_INFO_INIT;
  wgpuAdapterGetInfo(adapter, &raw);
  AdapterInfo info;
  info.name = text(raw.device);
  info.vendor = text(raw.vendor);
  info.driver = text(raw.description);
  info.backend = raw.backendType == WGPUBackendType_Vulkan  ? "Vulkan"
                 : raw.backendType == WGPUBackendType_Metal ? "Metal"
                 : raw.backendType == WGPUBackendType_D3D12 ? "D3D12"
                                                            : "other";
  info.type = raw.adapterType == WGPUAdapterType_DiscreteGPU     ? "discrete GPU"
              : raw.adapterType == WGPUAdapterType_IntegratedGPU ? "integrated GPU"
              : raw.adapterType == WGPUAdapterType_CPU           ? "CPU"
                                                                 : "unknown";
  wgpuAdapterInfoFreeMembers(raw);
  return info;
}

void take_device(Opened& opened) {
  Context& context = *opened.context;
  context.queue = wgpuDeviceGetQueue(context.device);
  WGPULimits limits = WGPU_LIMITS_INIT;
  wgpuDeviceGetLimits(context.device, &limits);
  opened.limits.max_buffer_size = limits.maxBufferSize;
  opened.limits.max_storage_binding_size = limits.maxStorageBufferBindingSize;
  opened.limits.max_storage_buffers_per_stage = limits.maxStorageBuffersPerShaderStage;
  opened.limits.max_invocations_per_workgroup =
      std::min(limits.maxComputeInvocationsPerWorkgroup, limits.maxComputeWorkgroupSizeX);
  opened.limits.max_workgroup_storage = limits.maxComputeWorkgroupStorageSize;
  opened.limits.max_workgroups_per_dimension = limits.maxComputeWorkgroupsPerDimension;
  opened.limits.max_texture_size = limits.maxTextureDimension2D;
  opened.limits.min_uniform_offset_alignment = limits.minUniformBufferOffsetAlignment;
}

ErrorScope::~ErrorScope() {
  WGPUPopErrorScopeCallbackInfo callback = WGPU_POP_ERROR_SCOPE_CALLBACK_INFO_INIT;
  callback.mode = WGPUCallbackMode_AllowSpontaneous;
  callback.callback = on_scope;
  callback.userdata1 = &context_;
  for (int scope = 0; scope < 2; ++scope) wgpuDevicePopErrorScope(context_.device, callback);
}

void Context::record(WGPUErrorType type, const std::string& what) {
  // wgpu-native reports a loss and a lack of memory as validation errors; their words tell them apart.
  if (what.find("device is lost") != std::string::npos) {
    lost = true;
    lost_reason = what;
    return;
  }
  if (failed) return;  // the first error is the cause
  failed = true;
  const bool memory =
      type == WGPUErrorType_OutOfMemory || what.find("Not enough memory") != std::string::npos;
  failure = {memory ? ErrorKind::OutOfMemory : ErrorKind::Shader,
             memory ? "The GPU has no memory left (" + what + ")." : what};
}

Result<void> Context::take_error() {
  if (lost) return make_error(ErrorKind::DeviceLost, "The GPU device is lost: %s.", lost_reason.c_str());
  if (!failed) return {};
  failed = false;
  return failure;
}

void ContextDeleter::operator()(Context* context) const {
  if (context->queue != nullptr) wgpuQueueRelease(context->queue);
  if (context->device != nullptr) wgpuDeviceRelease(context->device);
  if (context->adapter != nullptr) wgpuAdapterRelease(context->adapter);
  if (context->instance != nullptr) wgpuInstanceRelease(context->instance);
  delete context;
}

Result<std::vector<AdapterInfo>> list_adapters() {
  WGPUInstance instance = make_instance();
  std::vector<AdapterInfo> infos;
  for (WGPUAdapter adapter : enumerate(instance)) {
    infos.push_back(describe(adapter));
    wgpuAdapterRelease(adapter);
  }
  wgpuInstanceRelease(instance);
  return infos;
}

Result<Opened> open(const DeviceOptions& options) {
  Opened opened;
  opened.context = ContextPointer(new Context);
  Context& context = *opened.context;
  context.unchecked = options.unchecked;
  if (options.given) {
    WEFT_CHECK(take_given_device(opened, options));
    return opened;
  }
  context.instance = make_instance();
  const std::vector<WGPUAdapter> adapters = enumerate(context.instance);
  auto chosen = choose(adapters, options.adapter);
  if (chosen) {
    context.adapter = *chosen;
    wgpuAdapterAddRef(context.adapter);
  }
  for (WGPUAdapter adapter : adapters) wgpuAdapterRelease(adapter);
  if (!chosen) return chosen.error();
  opened.adapter = describe(context.adapter);
  WEFT_CHECK(open_device(opened, options));
  return opened;
}

DeviceHandles handles(Context& context) { return {id_of(context.adapter), id_of(context.device)}; }

Result<void> status(Context& context) { return context.take_error(); }

void lose(Context& context) {
  wgpuDeviceDestroy(context.device);
  context.lost = true;  // wgpu-native tells of it only at the next call
  context.lost_reason = "it was given up";
}

}  // namespace weft::gpu::backend
