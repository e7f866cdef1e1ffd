#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "gpu/dispatch.hpp"
#include "method/enclosed_gas.hpp"
#include "method/multigrid/bottom.hpp"
#include "method/multigrid/solve_limits.hpp"
#include "method/predicted.hpp"
#include "scene/scene.hpp"
#include "state/state.hpp"

namespace weft {

namespace multigrid {

/// Vectors that each level has, one vec4f a node each: src/method/multigrid/cloth.wgsl.
inline constexpr std::uint32_t kResidual = 0, kInverse = 1, kDirection = 3, kFirst = 4, kSecond = 5;
inline constexpr std::uint32_t kVectors = 6, kWay = 10;
inline constexpr std::uint32_t kFineVectors = 11;  // of the finest level, with those of conjugate gradients
/// At the end of the vectors: src/method/multigrid/solve.wgsl.
inline constexpr std::uint32_t kSolveWords = 3;
inline constexpr std::uint32_t kChunk = 64;  // nodes of a partial sum: src/method/multigrid/partial_sums.wgsl

inline constexpr std::uint32_t kAir = 11, kAirVectors = 2;  // and what the air adds, where it pushes

/// Of level `l`, the finest being 0.
inline std::uint32_t vector_count(std::size_t l, bool air) {
  return l > 0 ? kVectors : kFineVectors + (air ? kAirVectors : 0);
}

}  // namespace multigrid

/// Mirror of src/method/multigrid/cloth.wgsl: the nodes of a cycle's cloths among the vertices.
struct ClothNodes {
  std::uint32_t first_vertex = 0, count = 0;  // of the first cloth, of each
  float residual = 0;
  std::uint32_t may_retry = 1;
  std::uint32_t vectors = 0;                              // of each cloth [vec4f]
  std::uint32_t iterations = multigrid::kMostIterations;  // recorded, of the last system
  float first_part = 1;
  std::uint32_t padding = 0;
};
static_assert(sizeof(ClothNodes) == 32);

/// Mirror of src/method/multigrid/tail.wgsl: the sweeps of the last level, and the middle of the eigenvalues that they
/// are for and half of what these span.
struct BottomSweeps {
  std::uint32_t count = 0;
  float middle = 0, half = 0;

  explicit BottomSweeps(const multigrid::Bottom& bottom)
      : count(bottom.sweeps),
        middle(static_cast<float>((multigrid::kSmoothHigh + bottom.low) / 2)),
        half(static_cast<float>((multigrid::kSmoothHigh - bottom.low) / 2)) {}
};
static_assert(sizeof(BottomSweeps) == 12);

/// The vertices of a cycle's cloths, which follow each other and have as many each.
struct CycleVertices {
  std::uint32_t first = 0, each = 0, cloths = 1;
};

struct SharedKernels;

/// The inputs of the cycles of a model's bodies.
struct CycleInputs {
  gpu::Device& device;
  const GpuModel& model;
  const State& state;
  double step;  // the length of a substep [s]
  Predicted predicted;
  const gpu::Buffer<std::int32_t>* presses = nullptr;  // obstacles' demands on vertices; null: none
  const ContactPairs* pairs = nullptr;                 // of cloth with cloth, that are held apart; null: none
  double residual = scene::Solver{}.residual;
  std::uint32_t workgroup_size = gpu::kDefaultWorkgroupSize;
  const gpu::Buffer<std::uint32_t>* corners =
      nullptr;                       // around each vertex (src/method/air.wgsl); null: no air pushes
  const EnclosedGas* gas = nullptr;  // in closed cloths; null: none
  std::uint32_t newton_steps = 0;    // of Newton's method; 0: one system a substep, with contact two
};

/// Whether contact may change what a substep predicts, which is aside then.
inline bool meets_contact(const CycleInputs& inputs) {
  return inputs.predicted[0] != &inputs.state.velocity[1];
}

/// Whether elements are taken ahead of their nodes, since no other system follows.
inline bool leads(const CycleInputs& inputs) { return inputs.presses == nullptr && inputs.newton_steps == 0; }

/// One implicit substep of a cloth, or of several equal ones: a linear system and conjugate gradients with a V-cycle in
/// each iteration, with contact or by Newton's method others from where the one before leads, and the new state.
/// GridCycle and MeshCycle define its levels and the kernel of each stage.
/// Source  docs/solvers/multigrid.md, docs/solvers/fem.md.
/// Reads   steps, motions; position and velocity of both parities, of which [1 - parity] are those of a step
///         before; rest_position.
/// Writes  position[1 - parity] [m], predicted[parity] [m/s] of the cloth's vertices; statistics.
class Cycle {
 public:
  /// The first of two systems: how far it takes the nodes is in `predicted` then, as velocities, for contact.
  void record_first(gpu::ComputePass& pass) const;
  /// The last system, with so many iterations at most, and the new state; iterations behind the last that is needed do
  /// nothing.
  void record_last(gpu::ComputePass& pass, std::uint32_t iterations) const;
  /// By Newton's method, after record_first: `steps` - 1 systems more with so many iterations each at most, what is
  /// then left of the equation, and the new state.
  void record_newton(gpu::ComputePass& pass, std::uint32_t steps, std::uint32_t iterations) const;
  /// After contact: where cloth has met cloth, the next substep begins anew.
  void record_anew(gpu::ComputePass& pass) const { begin_anew_.record(pass); }
  /// How many iterations of the last are recorded, and whether a frame whose system they do not solve is to be rolled
  /// back.
  void set_iterations(gpu::Device& device, std::uint32_t iterations, bool may_retry) const;
  /// Takes over lists of pairs with other room. Errors  OutOfMemory.
  Result<void> bind_pairs(const CycleInputs& inputs);
  // Its parts.
  void record_system(gpu::ComputePass& pass) const;
  void record_system_again(gpu::ComputePass& pass) const;
  void record_gradient(gpu::ComputePass& pass) const;
  void record_matrices(gpu::ComputePass& pass) const;
  void record_guess(gpu::ComputePass& pass) const;
  void record_down(gpu::ComputePass& pass) const;
  void record_up(gpu::ComputePass& pass) const;
  void record_iteration(gpu::ComputePass& pass) const;

  // Their results on the GPU, for tests.
  const gpu::Buffer<Vec4f>& vectors() const { return vectors_; }
  /// The first of the levels whose cycle one workgroup does, and the last.
  std::size_t tail() const { return tail_; }
  const multigrid::Bottom& bottom() const { return bottom_; }
  const multigrid::Smoothing& finest() const { return finest_; }

 protected:
  /// A level with the next coarser one. Those of the tail have `coarsen` alone.
  struct Level {
    gpu::RawBuffer levels;            // both, a uniform
    gpu::Dispatch coarsen;            // the coarser level's matrix
    std::vector<gpu::Dispatch> down;  // x = 0 smoothed, whose first sweep is done; r - A x, its Pᵀ
    std::vector<gpu::Dispatch> up;    // x + P e, smoothed
  };

  /// Appends what was created.
  static Result<void> add_stage(std::vector<gpu::Dispatch>& stages, Result<gpu::Dispatch> made) {
    if (!made) return Error(made.error());
    stages.push_back(std::move(*made));
    return {};
  }
  /// The part that grids and meshes share: `shapes` are the levels as kernels read them, the finest first; a tail's
  /// have `most_of_tail` nodes at most.
  template <class Shape>
  Result<void> create_buffers(const CycleInputs& inputs, const CycleVertices& vertices,
                              const std::vector<Shape>& shapes, std::uint32_t most_of_tail);
  /// The same workgroups for each cloth.
  gpu::Workgroups for_each_cloth(const gpu::Workgroups& one) const { return {one.x, one.y, cloths_}; }
  /// The buffer bound for `presses` where nothing presses.
  const gpu::RawBuffer& presses(const CycleInputs& inputs) const {
    return inputs.presses != nullptr ? *inputs.presses : no_presses_;
  }
  /// The buffer bound for sums over held pairs where there are none.
  const gpu::RawBuffer& pair_sums(const CycleInputs& inputs) const {
    return inputs.pairs != nullptr ? static_cast<const gpu::RawBuffer&>(inputs.pairs->pair_sums)
                                   : no_pair_sums_;
  }
  /// What grids and meshes do alike: all but the matrix.
  Result<void> create_shared(const CycleInputs& inputs, const SharedKernels& kernels);

  std::vector<Level> levels_;  // all but the coarsest; at least one
  std::size_t tail_ = 1;
  multigrid::Bottom bottom_;
  multigrid::Smoothing finest_;
  gpu::Buffer<ClothNodes> nodes_;
  gpu::RawBuffer tail_levels_, sweeps_;
  gpu::Buffer<std::int32_t> no_presses_, no_pair_sums_;
  gpu::Buffer<Vec4f> place_, holds_, vectors_;
  gpu::Buffer<std::array<float, 2>> partials_;
  gpu::Buffer<float> norm_scales_;       // multigrid::norm_scales; of one element where all count alike
  std::vector<gpu::Dispatch> elements_;  // what the gradient adds up, where it is not of springs
  gpu::Dispatch add_gas_, add_air_, add_air_again_;  // none: record nothing
  gpu::Dispatch predict_, gradient_, tail_cycle_, finish_, begin_anew_;
  gpu::Dispatch go_on_, predict_again_, begin_again_;  // the second system, and those behind it
  gpu::Dispatch begin_solve_, search_, advance_;       // of conjugate gradients
  gpu::Dispatch first_norm_, square_, norm_, rho_;     // sums over the nodes
  gpu::Dispatch first_norm_again_, last_norm_, begin_measure_, measure_;
  gpu::SharedKernel pair_force_kernel_, pair_force_again_kernel_, pair_product_kernel_, pair_end_kernel_;
  gpu::Dispatch pair_force_, pair_force_again_, pair_product_, pair_end_,
      pair_finish_;  // none: record nothing
  ClothNodes own_nodes_;
  std::uint32_t cloths_ = 1;
  bool corrects_ = false;  // a substep has more than one system

 private:
  Result<gpu::Dispatch> create_air(const CycleInputs& inputs, const gpu::SharedKernel& kernel) const;
  Result<void> create_second(const CycleInputs& inputs, const SharedKernels& kernels);
  void begin_guess(gpu::ComputePass& pass) const;
  void record_cycle(gpu::ComputePass& pass) const;
  void record_step(gpu::ComputePass& pass, const gpu::Dispatch& norm) const;
  void record_solve_again(gpu::ComputePass& pass, std::uint32_t iterations) const;
  void record_last_iterations(gpu::ComputePass& pass, std::uint32_t iterations) const;
};

template <class Shape>
Result<void> Cycle::create_buffers(const CycleInputs& inputs, const CycleVertices& vertices,
                                   const std::vector<Shape>& shapes, std::uint32_t most_of_tail) {
  gpu::Device& device = inputs.device;
  const std::uint32_t nodes = vertices.each;
  const std::size_t all_nodes = std::size_t{vertices.cloths} * nodes;
  cloths_ = vertices.cloths;
  corrects_ = !leads(inputs);
  while (tail_ + 1 < shapes.size() && node_count(shapes[tail_]) > most_of_tail) ++tail_;
  std::size_t vectors = 0;
  for (std::size_t l = 0; l < shapes.size(); ++l) {
    vectors += std::size_t{multigrid::vector_count(l, inputs.corners != nullptr)} * node_count(shapes[l]);
    if (l > 0 && l + 1 == shapes.size()) continue;
    std::array<Shape, 2> pair = {shapes[l]};
    if (l + 1 < shapes.size()) pair[1] = shapes[l + 1];
    Level level;
    WEFT_SET(level.levels, gpu::create_uniform(device, pair, "multigrid levels"));
    levels_.push_back(std::move(level));
  }
  WEFT_SET(tail_levels_, gpu::Buffer<Shape>::create_from(device, std::span(shapes).subspan(tail_),
                                                         "coarsest multigrid levels"));
  WEFT_SET(sweeps_, gpu::create_uniform(device, BottomSweeps(bottom_), "sweeps of the coarsest level"));
  const double residual = (inputs.presses != nullptr ? multigrid::kHeldPart : 1) * inputs.residual;
  own_nodes_ = {vertices.first, nodes, static_cast<float>(residual * residual), 1,
                static_cast<std::uint32_t>(vectors)};
  own_nodes_.first_part = static_cast<float>(
      std::max(1.0, multigrid::kFirstPart * multigrid::kFirstPart / (residual * residual)));
  WEFT_SET(nodes_, gpu::create_uniform(device, own_nodes_, "cloth nodes"));
  WEFT_SET(partials_,
           (gpu::Buffer<std::array<float, 2>>::create(
               device, std::size_t{cloths_} * ((nodes + multigrid::kChunk - 1) / multigrid::kChunk),
               "partial sums")));
  WEFT_SET(place_, gpu::Buffer<Vec4f>::create(device, all_nodes, "multigrid place"));
  // One element each where nothing holds: kernels bind buffers that they do not read.
  const std::size_t count = inputs.presses != nullptr ? 3 * all_nodes : 1;
  WEFT_SET(holds_, gpu::Buffer<Vec4f>::create(device, count, "multigrid holds"));
  WEFT_SET(norm_scales_, gpu::Buffer<float>::create(device, 1, "no scales of norms"));
  WEFT_SET(no_presses_, gpu::Buffer<std::int32_t>::create(device, 1, "no presses"));
  WEFT_SET(no_pair_sums_, gpu::Buffer<std::int32_t>::create(device, 1, "no sums of pairs"));
  WEFT_SET(vectors_, gpu::Buffer<Vec4f>::create(device, cloths_ * (vectors + multigrid::kSolveWords),
                                                "multigrid vectors"));
  return {};
}

}  // namespace weft
