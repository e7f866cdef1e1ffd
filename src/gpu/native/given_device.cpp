// A device that the caller made: weft refers to it and checks that its limits are enough.
#include "gpu/native/context.hpp"

namespace weft::gpu::backend {
namespace {

/// What weft's shaders need whatever the scene: WebGPU's defaults, or less. How large buffers and textures may be
/// depends on the scene, so that is checked where they are made.
Result<void> check_limits(const WGPULimits& limits) {
  const struct {
    const char* name;
    std::uint64_t has, needed;
  } rows[] = {
      {"maxStorageBuffersPerShaderStage", limits.maxStorageBuffersPerShaderStage, 8},
      {"maxComputeInvocationsPerWorkgroup", limits.maxComputeInvocationsPerWorkgroup, 256},
      {"maxComputeWorkgroupSizeX", limits.maxComputeWorkgroupSizeX, 256},
      {"maxComputeWorkgroupsPerDimension", limits.maxComputeWorkgroupsPerDimension, 65535},
      {"maxComputeWorkgroupStorageSize", limits.maxComputeWorkgroupStorageSize, 16384},
      {"maxUniformBufferBindingSize", limits.maxUniformBufferBindingSize, 65536},
      {"maxBindingsPerBindGroup", limits.maxBindingsPerBindGroup, 16},
  };
  for (const auto& row : rows)
    if (row.has < row.needed)
      return make_error(ErrorKind::Limit, "The device's %s is %llu, and weft's shaders need %llu.", row.name,
                        static_cast<unsigned long long>(row.has),
                        static_cast<unsigned long long>(row.needed));
  return {};
}

}  // namespace

Result<void> take_given_device(Opened& opened, const DeviceOptions& options) {
  Context& context = *opened.context;
  if (options.given->adapter == 0 || options.given->device == 0)
    return input_error("The handle of the %s is null.", options.given->adapter == 0 ? "adapter" : "device");
  context.adapter = handle<WGPUAdapter>(options.given->adapter);
  context.device = handle<WGPUDevice>(options.given->device);
  wgpuAdapterAddRef(context.adapter);
  wgpuDeviceAddRef(context.device);
  opened.adapter = describe(context.adapter);
  opened.timestamps =
      options.timestamps && wgpuDeviceHasFeature(context.device, WGPUFeatureName_TimestampQuery) != 0;
  take_device(opened);
  WGPULimits limits = WGPU_LIMITS_INIT;
  wgpuDeviceGetLimits(context.device, &limits);
  return check_limits(limits);
}

}  // namespace weft::gpu::backend
