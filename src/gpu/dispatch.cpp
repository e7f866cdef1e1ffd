#include "gpu/dispatch.hpp"

namespace weft::gpu {

Result<Dispatch> Dispatch::create_with(SharedKernel kernel, const Workgroups& workgroups,
                                       std::span<const Bindings> bindings) {
  Dispatch made;
  for (const Bindings& own : bindings) {
    WEFT_TRY(group, kernel->bind(std::span(own)));
    made.groups_.push_back(std::move(group));
  }
  made.kernel_ = std::move(kernel);
  made.workgroups_ = workgroups;
  return made;
}

Result<SharedKernel> create_shared_kernel(Device& device, const std::string& path,
                                          std::vector<Constant> constants, std::uint32_t workgroup_size) {
  WEFT_TRY(kernel, Kernel::create(device, path, std::move(constants), workgroup_size));
  return std::make_shared<const Kernel>(std::move(kernel));
}

}  // namespace weft::gpu
