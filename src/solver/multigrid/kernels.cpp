#include "solver/multigrid/kernels.hpp"

#include <algorithm>
#include <string>

#include "solver/multigrid/level.hpp"

namespace weft {

Result<MultigridKernels> MultigridKernels::create(gpu::Device& device, bool holds,
                                                  std::uint32_t workgroup_size) {
  MultigridKernels made;
  const std::uint32_t one_group =
      std::min(gpu::kDefaultWorkgroupSize, device.limits().max_invocations_per_workgroup);
  struct Wanted {
    gpu::Kernel MultigridKernels::*kernel;
    const char* name;
    std::uint32_t size;
    std::vector<gpu::Constant> constants = {};
  };
  const std::vector<gpu::Constant> hold = {{"kHolds", holds ? 1.0 : 0.0}};
  using K = MultigridKernels;
  const Wanted all[] = {
      {&K::predict, "predict", workgroup_size},
      {&K::gradient, "gradient", workgroup_size, hold},
      {&K::galerkin_fine, "galerkin_fine", workgroup_size, hold},
      {&K::galerkin, "galerkin", workgroup_size},
      {&K::smooth_fine, "smooth_fine", workgroup_size, hold},
      {&K::residual_fine, "residual_fine", workgroup_size, hold},
      {&K::correct_fine, "correct_fine", workgroup_size},
      {&K::prolong_fine, "prolong_fine", workgroup_size, hold},
      {&K::finish, "finish", workgroup_size, hold},
      {&K::smooth_down,
       "smooth_coarse",
       workgroup_size,
       {{"kFrom", multigrid::kDirection}, {"kTo", multigrid::kFirst}}},
      {&K::residual, "residual_coarse", workgroup_size},
      {&K::prolong, "prolong_coarse", workgroup_size},
      {&K::smooth_up,
       "smooth_coarse",
       workgroup_size,
       {{"kFrom", multigrid::kSecond}, {"kTo", multigrid::kFirst}}},
      {&K::restrict_residual, "restrict_residual", workgroup_size},
      {&K::cycle_tail, "cycle_tail", one_group},
  };
  for (const Wanted& wanted : all) {
    const std::string path = std::string("multigrid/") + wanted.name + ".wgsl";
    WEFT_TRY(kernel, gpu::Kernel::create(device, path, wanted.constants, wanted.size));
    made.*wanted.kernel = std::move(kernel);
  }
  return made;
}

}  // namespace weft
