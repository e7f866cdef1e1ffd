// The oracle of the multigrid solver: its substep as plain loops in double. Source:
// docs/solvers/multigrid.md.
#pragma once

#include <optional>
#include <vector>

#include "contact/reference/proximity/press.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "method/multigrid/element_pairs.hpp"
#include "method/multigrid/reference/conjugate_gradients.hpp"
#include "method/multigrid/reference/hold.hpp"
#include "method/multigrid/reference/pair_hold.hpp"
#include "method/pieces/free_pieces.hpp"
#include "method/stepper.hpp"
#include "model/model.hpp"

namespace weft::reference {

/// A linear system of a substep, for one cloth: A dz = r, where the nodes have come to place + start + dz.
struct StepStart {
  Field place, start, start_velocity;  // [m], [m], [m/s]
  Field way;                           // of place from where the substep begins [m]
  Field residual;                      // r [N]
  Field guess;                         // of dz: velocities change on as in the step before [m]
  std::vector<double> inertia;         // its part of the diagonal of A [N/m]
  std::vector<Sym3> air;               // the same of the air, where it pushes [N/m]; else empty
  std::vector<bool> fixed;
  std::vector<std::optional<Hold>>
      holds;                    // of nodes that an obstacle holds: in the matrix, and no history after it
  std::vector<PairHold> pairs;  // of cloth with cloth
  bool leads = false;           // elements are taken ahead of the nodes, since no second system follows
};

/// The linear system of a grid.
struct LinearStep : StepStart {
  GridOperator matrix;  // A [N/m]
  GridOperator source;  // of the coarser levels: with bend springs as structural ones
};

/// The linear system of a mesh.
struct MeshStep : StepStart {
  MeshOperator matrix;
};

/// The coefficients of BDF2 for a step and the one before it: x' = x + s + he v', with s = c (x - x before).
struct StepFormula {
  double he = 0;  // [s]
  double c = 0;
};
/// `ratio` is that of the step to the one before it; 0: there is none, backward Euler.
StepFormula step_formula(double dt, double ratio);

/// Steps the cloths of a model by BDF2, linearised at the start of the substep; with contact, which may change on the
/// way, in two Newton steps: the second from where the first leads.
class ImplicitStepper : public Stepper {
 public:
  /// `step`: the length of a substep, where frames are not cut [s]. `residual`: what a substep may leave of its linear
  /// system's.
  /// `newton_steps`: so many at most where no contact is in the matrix, until the equation itself has no more than
  /// `residual` left, which is measured; 0: one system a substep, with contact two.
  ImplicitStepper(const Model& model, double step, double residual = scene::Solver{}.residual,
                  std::uint32_t newton_steps = 0);

  void advance(const Substep& substep) override;
  /// The state a step before the one that is advanced next.
  void remember(std::vector<Vec3d> position, std::vector<Vec3d> velocity);
  /// The next step is backward Euler: the state is not one that advance has left.
  void forget() override;
  /// The same for one node.
  void forget(std::size_t node) override { known_[node] = false; }
  void begin_anew() override { known_.assign(known_.size(), false); }
  void forget_hold(std::size_t node) override {
    const HoldForce& had = hold_forces_[node];
    hold_forces_[node] = {0, {}, had.normal > 0 || had.under_cloth};
  }
  std::vector<bool> held() const override { return held_; }
  std::vector<Vec3d> pair_forces() const override { return pair_forces_; }
  /// Whether the next step may read the state before the last one.
  bool has_history(std::size_t node) const { return known_[node]; }
  /// The forces that holds have left, of each node.
  const std::vector<HoldForce>& hold_forces() const { return hold_forces_; }
  void set_hold_forces(std::vector<HoldForce> forces) { hold_forces_ = std::move(forces); }

  /// The first linear system of cloth c, a grid, that advance would solve; with the ways of all nodes that it leads to
  /// [m], the second.
  LinearStep linearise(const MassSpringSystem& system, const std::vector<Vec3d>& places, double dt,
                       double ratio, std::size_t c, std::span<const Press> presses = {},
                       std::span<const Vec3d> ways = {}) const;
  /// The same for a mesh.
  MeshStep linearise_mesh(const MassSpringSystem& system, const std::vector<Vec3d>& places, double dt,
                          double ratio, std::size_t c, std::span<const Press> presses = {},
                          std::span<const Vec3d> ways = {}) const;

  /// Of the last substep: the most that a cloth took in both systems, and the largest part that one left of the
  /// residual of its first.
  std::uint32_t iterations() const { return iterations_; }
  double residual() const { return residual_; }

  double wanted_residual;

 private:
  struct Cloth {
    std::uint32_t first = 0, count = 0;
    std::uint32_t nx = 0, ny = 0;  // of a grid
    GridBending bending;
    std::vector<MeshLevel> levels;            // of a mesh
    std::size_t first_spring = 0;             // of a mesh, in the system's
    std::optional<std::size_t> fabric;        // in the system's
    std::size_t first_solid = 0, solids = 0;  // in the system's: bodies that it has instead of a cloth
    std::vector<float> norm_scales;           // of bodies: multigrid::norm_scales; else none
    ElementPairs parts;                       // of the fabric's or the bodies' matrix
    std::vector<double> hinge_bounds;         // [N·m]
    std::vector<Cord> cords;                  // of fabric
    multigrid::Bottom bottom;                 // of its cycles
    multigrid::Smoothing finest;
  };

  struct Solved {
    StepStart step;
    Solution solution;
    /// How far the system leads a node from where the substep begins [m].
    Vec3d way(std::size_t a) const { return step.way[a] + step.start[a] + solution.x[a]; }
  };

  StepStart begin(const MassSpringSystem& system, const std::vector<Vec3d>& places, double dt, double ratio,
                  const Cloth& cloth, std::span<const Vec3d> ways) const;
  /// Adds the gas in closed cloths to the residual: the same in all systems of a substep.
  static void add_gas(StepStart& step, const MassSpringSystem& system, double dt, const Cloth& cloth);
  /// Adds the air to the residual, and keeps its part of the matrix. `again`: in the second system.
  void add_air(StepStart& step, const MassSpringSystem& system, double dt, double ratio, const Cloth& cloth,
               bool again) const;
  /// A system of cloth c: the first, without `ways`, or the second.
  template <class Enough>
  Solved solved(const Substep& substep, const Pressed& pressed, std::size_t c, std::span<const Vec3d> ways,
                std::uint32_t most_iterations, const Enough& enough) const;
  /// The second systems, after the first.
  std::vector<Solved> correct(const Substep& substep);
  /// By Newton's method: the last systems, which are not solved, with what is left of the equation.
  std::vector<Solved> newton(const Substep& substep);
  /// No history of nodes in these pairs: both sides take the force in the same formula.
  void forget(const std::vector<NearPair>& pairs);
  /// Of the pieces that nothing holds: docs/momentum.md.
  void keep_momentum(const Substep& substep, const std::vector<Solved>& found,
                     const std::vector<Vec3d>& position, std::vector<Vec3d>& velocity) const;
  /// The new state of cloth c, in the place of the old one; adds the nodes that contact has stopped.
  void finish(const Substep& substep, const Solved& found, std::size_t c, std::vector<Vec3d>& position,
              std::vector<Vec3d>& velocity, std::vector<std::size_t>& stopped);

  std::uint32_t newton_steps_;
  std::vector<Cloth> cloths_;
  FreePieces joined_, pieces_;  // all bodies together; each cloth and body
  std::vector<Vec3d> position_before_, velocity_before_;
  std::vector<bool> known_;  // whether they are those of the step before
  std::vector<HoldForce> hold_forces_;
  std::vector<Vec3d> pair_forces_;  // of each pair of the last substep; 0: it was not held
  /// `inverse`: of the matrix's diagonal, D⁻¹. `again`: in the second system.
  std::vector<PairHold> held_apart(const StepStart& step, const MassSpringSystem& system,
                                   std::span<const NearPair> pairs, double dt, const Cloth& cloth,
                                   const std::vector<Sym3>& inverse, bool again) const;

  std::vector<bool> held_;  // in the last substep, where all that pressed the node was alike
  std::uint32_t iterations_ = 0;
  double residual_ = 0;
};

}  // namespace weft::reference
