#include "method/multigrid/kernels.hpp"

#include <algorithm>

#include "method/multigrid/mesh_lists.hpp"

namespace weft {

using multigrid::CycleKind;

namespace {

template <class Set>
struct Row {
  gpu::SharedKernel Set::*kernel;
  const char* name;  // src/method/multigrid/NAME.wgsl
  std::uint32_t size;
  std::vector<gpu::Constant> constants = {};
};

template <class Set>
Result<void> create_all(gpu::Device& device, std::span<const Row<Set>> table, Set& made) {
  for (const Row<Set>& row : table) {
    const std::string path = std::string("method/multigrid/") + row.name + ".wgsl";
    WEFT_SET(made.*row.kernel, gpu::create_shared_kernel(device, path, row.constants, row.size));
  }
  return {};
}

/// The size of a single workgroup that adds up.
std::uint32_t lone_workgroup_size(const gpu::Device& device) {
  return std::min(gpu::kDefaultWorkgroupSize, device.limits().max_invocations_per_workgroup);
}

/// The size of the single workgroup of a tail: the largest that the adapter has, up to kMost, and that has the memory
/// for two vectors of `nodes` (src/method/multigrid/tail.wgsl) and one of its invocations (mesh_operator.wgsl). On a
/// CPU, where more of them only wait for each other, the usual one: frames of small cloths take 0.6 times as long.
std::uint32_t tail_workgroup_size(const gpu::Device& device, std::uint32_t nodes) {
  constexpr std::uint32_t kMost = 1024, kVector = 3 * sizeof(float);
  const gpu::Limits& limits = device.limits();
  if (device.adapter().type == "CPU") return lone_workgroup_size(device);
  for (std::uint32_t size = kMost; size > gpu::kDefaultWorkgroupSize; size /= 2)
    if (size <= limits.max_invocations_per_workgroup &&
        kVector * (2 * nodes + size) <= limits.max_workgroup_storage)
      return size;
  return lone_workgroup_size(device);
}

/// Whether contact may hold nodes at obstacles, for the kernels that read the holds.
gpu::Constant holds(const CycleInputs& inputs) { return {"kHolds", inputs.presses != nullptr ? 1.0 : 0.0}; }

/// Whether elements are taken ahead of their nodes.
gpu::Constant lead(const CycleInputs& inputs) { return {"kLeads", leads(inputs) ? 1.0 : 0.0}; }

/// Whether the air pushes, for the kernels whose matrix has it.
gpu::Constant air(const CycleInputs& inputs) { return {"kAirPushes", inputs.corners != nullptr ? 1.0 : 0.0}; }

/// Whether pairs of cloth with cloth may be held apart, for the kernels that read the sums over them.
gpu::Constant pairs(const CycleInputs& inputs) { return {"kPairs", inputs.pairs != nullptr ? 1.0 : 0.0}; }

/// Whether a grid has bend springs, for the kernels that sum over the springs of a node.
gpu::Constant bend(const CycleInputs& inputs) {
  return {"kBend", any_bend_springs(inputs.model.host) ? 1.0 : 0.0};
}

bool any_strain_limit(const CycleInputs& inputs) {
  const auto& bodies = inputs.model.host.bodies;
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const Body& body) { return body.strain_limit.has_value(); });
}
/// Whether something in a cloth of fabric only pulls (model/cords.hpp).
bool any_cord(const CycleInputs& inputs) {
  const Model& model = inputs.model.host;
  return std::any_of(model.bodies.begin(), model.bodies.end(), [](const Body& body) {
    return body.fabric && (body.strain_limit || (body.pattern && !body.pattern->threads.empty()));
  });
}

/// Whether an edge has a strain limit, for the kernels that evaluate springs.
gpu::Constant limits(const CycleInputs& inputs) { return {"kLimits", any_strain_limit(inputs) ? 1.0 : 0.0}; }

/// The first sweep of a smoothing, for the kernels that do it.
gpu::Constant first_sweep(const multigrid::Smoothing& smoothing) {
  return {"kBegin", sweep_of(smoothing, 0).take};
}
/// Another one.
std::vector<gpu::Constant> later_sweep(const multigrid::Smoothing& smoothing, std::uint32_t number) {
  const multigrid::Sweep sweep = sweep_of(smoothing, number);
  return {{"kKeep", sweep.keep}, {"kTake", sweep.take}};
}

std::vector<gpu::Constant> operator+(std::vector<gpu::Constant> a, const std::vector<gpu::Constant>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// The vectors of sweep `number` behind the first on a mesh: the solution goes from one to another and back, down from
/// where the first sweep has left it, which is d as well.
std::vector<gpu::Constant> vectors_of_sweep(std::uint32_t number, bool down) {
  using namespace multigrid;
  const std::uint32_t other = down ? kDirection : kSecond, kept = down ? kSecond : kDirection;
  const bool leaves = number % 2 == 1;
  return {{"kFrom", static_cast<double>(leaves ? other : kFirst)},
          {"kTo", static_cast<double>(leaves ? kFirst : other)},
          {"kStep", static_cast<double>(number == 1 ? kDirection : kept)},
          {"kNext", static_cast<double>(kept)}};
}

/// The sweeps of a mesh's level. `has_own_last`: another kernel does the last one on the way up.
Result<LevelSmoothing> create_smoothing(gpu::Device& device, const multigrid::Smoothing& smoothing,
                                        bool has_own_last, const gpu::Constant& general) {
  constexpr std::uint32_t kByLanes = multigrid::kLanes * multigrid::kChunk;
  LevelSmoothing made;
  const auto add = [&](std::vector<gpu::SharedKernel>& sweeps, const char* path,
                       const std::vector<gpu::Constant>& constants) -> Result<void> {
    gpu::SharedKernel kernel;
    WEFT_SET(kernel, gpu::create_shared_kernel(device, path, constants, kByLanes));
    sweeps.push_back(std::move(kernel));
    return {};
  };
  WEFT_CHECK(add(made.up, "method/multigrid/mesh_smooth_begin.wgsl", {first_sweep(smoothing), general}));
  for (const bool down : {true, false})
    for (std::uint32_t k = 1; k < smoothing.sweeps - (!down && has_own_last ? 1 : 0); ++k) {
      const gpu::Constant last{"kIsLast", k + 1 == smoothing.sweeps ? 1.0 : 0.0};
      WEFT_CHECK(add(
          down ? made.down : made.up, "method/multigrid/mesh_smooth.wgsl",
          later_sweep(smoothing, k) + vectors_of_sweep(k, down) + std::vector<gpu::Constant>{last, general}));
    }
  return made;
}

/// Whether the system is of bodies with volume, for the kernels that hold them.
gpu::Constant of_body(CycleKind kind) { return {"kBody", kind == CycleKind::Tets ? 1.0 : 0.0}; }

/// Of a second system; of the only or the second one.
gpu::Constant again() { return {"kAgain", 1}; }
gpu::Constant last() { return {"kLast", 1}; }
/// Of what Newton's method has left.
gpu::Constant measures() { return {"kMeasures", 1}; }

/// Which sum: src/method/multigrid/add_up.wgsl.
gpu::Constant sum(std::uint32_t number) { return {"kSum", static_cast<double>(number)}; }

}  // namespace

bool any_bend_springs(const Model& model) {
  return std::any_of(model.bodies.begin(), model.bodies.end(),
                     [](const Body& body) { return body.grid && body.stiffness.bend > 0; });
}

Result<SharedKernels> SharedKernels::create(const CycleInputs& inputs, CycleKind kind,
                                            const multigrid::Smoothing& finest) {
  const std::uint32_t size = inputs.workgroup_size, lone = lone_workgroup_size(inputs.device);
  const gpu::Constant scales{"kScales", kind == CycleKind::Tets ? 1.0 : 0.0};
  using K = SharedKernels;
  const Row<K> table[] = {
      {&K::predict, "predict", size},
      {&K::finish, "finish", size, {holds(inputs)}},
      {&K::begin_solve, "begin_solve", size, {pairs(inputs), scales}},
      {&K::go_on, "go_on", size, {pairs(inputs), holds(inputs)}},
      {&K::predict_again, "predict_again", size, {pairs(inputs), holds(inputs)}},
      {&K::begin_again,
       "begin_solve",
       size,
       {pairs(inputs), holds(inputs), again(), first_sweep(finest), scales}},
      {&K::begin_measure, "begin_solve", size, {again(), measures(), scales}},
      {&K::advance, "advance", size, {first_sweep(finest), scales}},
      {&K::first_norm, "add_up", lone, {sum(0)}},
      {&K::square, "add_up", lone, {sum(1)}},
      {&K::first_norm_again, "add_up", lone, {sum(0), again(), last()}},
      {&K::measure, "add_up", lone, {sum(0), again(), last(), measures()}},
      {&K::norm, "add_up", lone, {sum(2)}},
      {&K::last_norm, "add_up", lone, {sum(2), last()}},
      {&K::rho, "add_up", lone, {sum(3)}},
  };
  SharedKernels made;
  WEFT_CHECK(create_all<K>(inputs.device, table, made));
  const Row<K> of_contact[] = {{&K::begin_anew, "begin_anew", size}};
  if (meets_contact(inputs)) WEFT_CHECK(create_all<K>(inputs.device, of_contact, made));
  const Row<K> of_pairs[] = {
      {&K::pair_force, "pair_force", size, {of_body(kind)}},
      {&K::pair_force_again, "pair_force", size, {again(), of_body(kind)}},
      {&K::pair_product, "pair_product", size},
      {&K::pair_end, "pair_end", size},
      {&K::pair_finish, "pair_finish", size},
  };
  if (inputs.pairs != nullptr) WEFT_CHECK(create_all<K>(inputs.device, of_pairs, made));
  const Row<K> of_gas[] = {{&K::add_gas, "add_gas", size}};
  if (inputs.gas != nullptr) WEFT_CHECK(create_all<K>(inputs.device, of_gas, made));
  const Row<K> of_air[] = {{&K::add_air, "add_air", size}, {&K::add_air_again, "add_air", size, {again()}}};
  if (inputs.corners != nullptr) WEFT_CHECK(create_all<K>(inputs.device, of_air, made));
  return made;
}

Result<GridKernels> GridKernels::create(const CycleInputs& inputs) {
  const std::uint32_t size = inputs.workgroup_size;
  const multigrid::Smoothing finest =
      multigrid::finest_smoothing(inputs.model.host, CycleKind::Grid, inputs.step);
  const std::vector<gpu::Constant> of_springs = {holds(inputs), air(inputs), bend(inputs), limits(inputs)};
  using K = GridKernels;
  const Row<K> table[] = {
      {&K::gradient,
       "gradient",
       size,
       {holds(inputs), air(inputs), bend(inputs), limits(inputs), lead(inputs)}},
      {&K::galerkin_fine, "galerkin_fine", size, of_springs},
      {&K::galerkin, "galerkin", size},
      {&K::smooth_fine, "smooth_fine", size, of_springs + later_sweep(finest, 1)},
      {&K::residual_fine, "residual_fine", size, of_springs},
      {&K::correct_fine, "correct_fine", size},
      {&K::prolong_fine, "prolong_fine", size, of_springs + std::vector{first_sweep(finest)}},
      {&K::smooth_last, "smooth_last_fine", size, of_springs + later_sweep(finest, 1)},
      {&K::search,
       "search_fine",
       size,
       {holds(inputs), air(inputs), bend(inputs), limits(inputs), pairs(inputs)}},
      {&K::restrict_residual, "restrict_residual", size},
      {&K::descend, "descend_coarse", size},
      {&K::ascend, "ascend_coarse", size},
      {&K::cycle_tail, "cycle_tail", tail_workgroup_size(inputs.device, multigrid::kGridTail)},
  };
  K made;
  made.smoothing = finest;
  WEFT_CHECK(create_all<K>(inputs.device, table, made));
  WEFT_SET(made.shared, SharedKernels::create(inputs, CycleKind::Grid, finest));
  return made;
}

Result<MeshKernels> MeshKernels::create(const CycleInputs& inputs, CycleKind kind) {
  const multigrid::Smoothing finest = multigrid::finest_smoothing(inputs.model.host, kind, inputs.step);
  const bool of_springs = kind == CycleKind::Springs, of_fabric = kind == CycleKind::Fabric;
  const std::uint32_t size = inputs.workgroup_size,
                      lone = tail_workgroup_size(inputs.device, multigrid::kMeshTail);
  constexpr std::uint32_t kByLanes = multigrid::kLanes * multigrid::kChunk;
  using K = MeshKernels;
  const gpu::Constant general{"kGeneral", of_springs ? 0.0 : 1.0};
  const gpu::Constant part{"kDiagonalPart", of_springs ? 1.0 : multigrid::kElementDiagonalPart};
  const gpu::Constant taps{"kTaps", static_cast<double>(multigrid::taps_of(kind == CycleKind::Tets))};
  const Row<K> table[] = {
      {&K::galerkin, "mesh_galerkin", size, {general, part}},
      {&K::residual, "mesh_residual", kByLanes, {general}},
      {&K::restrict_residual, "mesh_restrict", size},
      {&K::tail, "mesh_tail", lone, {general, taps}},
      {&K::tail_of_pieces, "mesh_tail", lone, {{"kShows", 0}, general, taps}},
      {&K::prolong, "mesh_prolong", size, {taps}},
      {&K::smooth_last, "mesh_smooth_last", kByLanes,
       later_sweep(finest, finest.sweeps - 1) + std::vector{general}},
      {&K::search, "mesh_search", kByLanes, {pairs(inputs), general}},
  };
  K made;
  made.smoothing = finest;
  WEFT_CHECK(create_all<K>(inputs.device, table, made));
  WEFT_SET(made.finest, create_smoothing(inputs.device, finest, true, general));
  WEFT_SET(made.coarse, create_smoothing(inputs.device, {}, false, general));
  const Row<K> gradient_of_springs[] = {
      {&K::gradient, "mesh_gradient", size, {holds(inputs), air(inputs), limits(inputs), lead(inputs)}}};
  const Row<K> gradient_of_elements[] = {
      {&K::gradient, "element_gradient", size, {holds(inputs), air(inputs), general, part, of_body(kind)}}};
  WEFT_CHECK(create_all<K>(inputs.device, of_springs ? gradient_of_springs : gradient_of_elements, made));
  using F = FabricKernels;
  const Row<F> fabric[] = {{&F::membranes, "membrane_terms", size, {lead(inputs)}},
                           {&F::hinges, "hinge_terms", size},
                           {&F::forces, "hinge_forces", size},
                           {&F::blocks, "fabric_blocks", size, {general}}};
  if (of_fabric) WEFT_CHECK(create_all<F>(inputs.device, fabric, made.fabric));
  const Row<F> of_cords[] = {{&F::cords, "cord_terms", size, {lead(inputs)}}};
  if (of_fabric && any_cord(inputs)) WEFT_CHECK(create_all<F>(inputs.device, of_cords, made.fabric));
  using S = SolidKernels;
  const Row<S> solid[] = {{&S::terms, "solid_terms", size, {lead(inputs)}},
                          {&S::blocks, "solid_blocks", size, {general}}};
  if (kind == CycleKind::Tets) WEFT_CHECK(create_all<S>(inputs.device, solid, made.solid));
  WEFT_SET(made.shared, SharedKernels::create(inputs, kind, finest));
  return made;
}

}  // namespace weft
