#include "method/multigrid/solver_multigrid.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "method/corners.hpp"
#include "method/multigrid/solve_limits.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kAtFirst = 4;      // iterations recorded, of the last system
constexpr std::uint32_t kSpare = 1;        // iterations beyond those of the last frames
constexpr std::uint32_t kFramesSeen = 12;  // before fewer are recorded

/// After a frame that took more.
std::uint32_t raised(std::uint32_t iterations) { return iterations + std::max(2U, iterations / 2); }

}  // namespace

void SolverMultigrid::record(gpu::ComputePass& pass, const contact::Stages& contact, std::uint32_t) const {
  contact.press(pass);
  gas_.record(pass);
  for (const MeshCycle& cycle : meshes_) cycle.record_creases(pass);
  for (const GridCycle& cycle : grids_) cycle.record_first(pass);
  for (const MeshCycle& cycle : meshes_) cycle.record_first(pass);
  contact.press_again(pass);
  const auto record_rest = [&](const Cycle& cycle) {
    if (inputs_->newton_steps > 0) return cycle.record_newton(pass, inputs_->newton_steps, iterations_);
    cycle.record_last(pass, iterations_);
  };
  for (const GridCycle& cycle : grids_) record_rest(cycle);
  for (const MeshCycle& cycle : meshes_) record_rest(cycle);
  joined_.record(pass);
  pieces_.record(pass);
  contact.search(pass);
  contact.measure(pass);
  contact.answer(pass);
  contact.hold_back(pass);
  for (const GridCycle& cycle : grids_) cycle.record_anew(pass);
  for (const MeshCycle& cycle : meshes_) cycle.record_anew(pass);
}

bool SolverMultigrid::adapt(gpu::Device& device, const Statistics& report) {
  const std::uint32_t before = iterations_;
  most_seen_ = std::max(most_seen_, report.corrections);
  if (report.rolled_back != 0) {
    if (report.corrections >= iterations_)
      set_iterations(device, std::min(raised(iterations_), multigrid::kMostIterations));
  } else if (++frames_seen_ >= kFramesSeen) {
    set_iterations(device, std::min(iterations_, most_seen_ + kSpare));
  }
  return iterations_ != before;
}

void SolverMultigrid::set_iterations(gpu::Device& device, std::uint32_t iterations) {
  const bool may_retry = iterations < multigrid::kMostIterations;
  for (const GridCycle& cycle : grids_) cycle.set_iterations(device, iterations, may_retry);
  for (const MeshCycle& cycle : meshes_) cycle.set_iterations(device, iterations, may_retry);
  iterations_ = iterations;
  most_seen_ = frames_seen_ = 0;
}

Result<void> SolverMultigrid::bind_lists() {
  if (inputs_->pairs == nullptr) return {};
  for (GridCycle& cycle : grids_) WEFT_CHECK(cycle.bind_pairs(*inputs_));
  for (MeshCycle& cycle : meshes_) WEFT_CHECK(cycle.bind_pairs(*inputs_));
  return {};
}

Result<void> SolverMultigrid::create_cycles(const CycleInputs& inputs) {
  std::optional<GridKernels> grid_kernels;
  std::map<multigrid::CycleKind, MeshKernels> mesh_kernels;
  const std::span<const Body> bodies = inputs.model.host.bodies;
  const std::vector<multigrid::SystemBodies> systems = multigrid::systems_of(inputs.model.host);
  for (std::size_t s = 0; s < systems.size();) {
    const Body& body = systems[s].first();
    const multigrid::CycleKind kind = multigrid::kind_of(body);
    if (kind == multigrid::CycleKind::Grid) {
      const std::uint32_t count =
          equal_grids(bodies.subspan(static_cast<std::size_t>(&body - bodies.data())),
                      most_cloths(body, inputs.device.limits(), inputs.corners != nullptr));
      if (!grid_kernels) WEFT_SET(grid_kernels, GridKernels::create(inputs));
      WEFT_TRY(cycle, GridCycle::create(inputs, *grid_kernels, {body, count}));
      grids_.push_back(std::move(cycle));
      s += count;
    } else {
      if (!mesh_kernels.contains(kind)) WEFT_SET(mesh_kernels[kind], MeshKernels::create(inputs, kind));
      WEFT_TRY(cycle, MeshCycle::create(inputs, mesh_kernels[kind], systems[s]));
      meshes_.push_back(std::move(cycle));
      ++s;
    }
  }
  set_iterations(inputs.device, kAtFirst);
  return {};
}

Result<std::unique_ptr<Solver>> SolverMultigrid::create(const SolverInputs& inputs, double residual,
                                                        std::uint32_t newton_steps) {
  auto made = std::make_unique<SolverMultigrid>();
  if (inputs.air) WEFT_SET(made->corners_, air_corners(inputs.device, inputs.model.host));
  WEFT_SET(made->gas_, EnclosedGas::create(inputs, EnclosedGas::At::Ahead));
  made->inputs_.emplace(CycleInputs{
      inputs.device, inputs.model, inputs.state, inputs.step, inputs.predicted(), inputs.presses(),
      inputs.pairs(), residual, inputs.workgroup_size, inputs.air ? &made->corners_ : nullptr,
      made->gas_.any() ? &made->gas_ : nullptr, inputs.presses() == nullptr ? newton_steps : 0});
  WEFT_CHECK(made->create_cycles(*made->inputs_));
  if (inputs.pairs() != nullptr)
    WEFT_SET(made->joined_, PieceMotion::create_of_steps(inputs, PiecesOf::Solids));
  WEFT_SET(made->pieces_, PieceMotion::create_of_steps(inputs, PiecesOf::Bodies));
  return std::unique_ptr<Solver>(std::move(made));
}

}  // namespace weft
