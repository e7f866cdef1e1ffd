#include "method/multigrid/mesh_kernels.hpp"

#include "method/multigrid/kernel_set.hpp"
#include "method/multigrid/level.hpp"

namespace weft {

Result<MeshKernels> MeshKernels::create(gpu::Device& device, bool holds, std::uint32_t workgroup_size) {
  const std::uint32_t one_group = lone_workgroup_size(device);
  const std::vector<gpu::Constant> hold = hold_constant(holds);
  using K = MeshKernels;
  const WantedKernel<K> table[] = {
      {&K::predict, "predict", workgroup_size},
      {&K::gradient, "mesh_gradient", workgroup_size, hold},
      {&K::galerkin, "mesh_galerkin", workgroup_size},
      {&K::smooth_down,
       "mesh_smooth_end",
       workgroup_size,
       {{"kFrom", multigrid::kDirection}, {"kTo", multigrid::kFirst}}},
      {&K::residual, "mesh_residual", workgroup_size},
      {&K::restrict_residual, "mesh_restrict", workgroup_size},
      {&K::tail, "mesh_tail", one_group},
      {&K::prolong, "mesh_prolong", workgroup_size},
      {&K::smooth_begin, "mesh_smooth_begin", workgroup_size},
      {&K::smooth_up,
       "mesh_smooth_end",
       workgroup_size,
       {{"kFrom", multigrid::kFirst}, {"kTo", multigrid::kSecond}}},
      {&K::finish, "mesh_finish", workgroup_size, hold},
  };
  return make_kernels<K>(device, table);
}

}  // namespace weft
