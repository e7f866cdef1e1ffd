#pragma once

#include <array>
#include <vector>

#include "gpu/kernel.hpp"

namespace weft::gpu {

/// A kernel with what it binds and with its workgroups, to be recorded in each substep. One that was not
/// made records nothing.
class Dispatch {
 public:
  using Bindings = std::vector<Binding>;

  Dispatch() = default;

  /// Binds the same in every substep. Errors  Shape: another number of things than the shader binds.
  /// OutOfMemory.
  static Result<Dispatch> create(SharedKernel kernel, const Workgroups& workgroups,
                                 const Bindings& bindings) {
    return create_with(std::move(kernel), workgroups, std::span(&bindings, 1));
  }
  /// Binds bindings_of(p) in substeps of parity p. Errors  As above.
  template <class BindingsOf>
  static Result<Dispatch> create_by_parity(SharedKernel kernel, const Workgroups& workgroups,
                                           const BindingsOf& bindings_of) {
    const std::array<Bindings, 2> both = {bindings_of(std::size_t{0}), bindings_of(std::size_t{1})};
    return create_with(std::move(kernel), workgroups, both);
  }

  void record(ComputePass& pass) const {
    if (kernel_ == nullptr) return;
    const BindGroup& group = groups_.size() == 1 ? groups_[0] : groups_[pass.parity()];
    kernel_->dispatch_groups(pass, group, workgroups_);
  }

 private:
  static Result<Dispatch> create_with(SharedKernel kernel, const Workgroups& workgroups,
                                      std::span<const Bindings> bindings);

  SharedKernel kernel_;
  Workgroups workgroups_{};
  std::vector<BindGroup> groups_;  // one for both parities, or one for each
};

/// A kernel for one dispatch or several. Errors  As Kernel::create.
Result<SharedKernel> create_shared_kernel(Device& device, const std::string& path,
                                          std::vector<Constant> constants, std::uint32_t workgroup_size);

}  // namespace weft::gpu
