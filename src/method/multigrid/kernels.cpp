#include "method/multigrid/kernels.hpp"

#include "method/multigrid/kernel_set.hpp"
#include "method/multigrid/level.hpp"

namespace weft {

Result<MultigridKernels> MultigridKernels::create(gpu::Device& device, bool holds,
                                                  std::uint32_t workgroup_size) {
  const std::uint32_t one_group = lone_workgroup_size(device);
  const std::vector<gpu::Constant> hold = hold_constant(holds);
  using K = MultigridKernels;
  const WantedKernel<K> table[] = {
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
  return make_kernels<K>(device, table);
}

}  // namespace weft
