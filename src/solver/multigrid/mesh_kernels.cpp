#include "solver/multigrid/mesh_kernels.hpp"

#include <algorithm>
#include <string>

#include "solver/multigrid/level.hpp"

namespace weft {

Result<MeshKernels> MeshKernels::create(gpu::Device& device, bool holds, std::uint32_t workgroup_size) {
  MeshKernels made;
  const std::uint32_t one_group =
      std::min(gpu::kDefaultWorkgroupSize, device.limits().max_invocations_per_workgroup);
  struct Wanted {
    gpu::Kernel MeshKernels::*kernel;
    const char* name;
    std::uint32_t size;
    std::vector<gpu::Constant> constants = {};
  };
  const std::vector<gpu::Constant> hold = {{"kHolds", holds ? 1.0 : 0.0}};
  using K = MeshKernels;
  const Wanted all[] = {
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
  for (const Wanted& wanted : all) {
    const std::string path = std::string("multigrid/") + wanted.name + ".wgsl";
    WEFT_TRY(kernel, gpu::Kernel::create(device, path, wanted.constants, wanted.size));
    made.*wanted.kernel = std::move(kernel);
  }
  return made;
}

}  // namespace weft
