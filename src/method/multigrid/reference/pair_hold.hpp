// What holds two features of one cloth apart within an implicit step, and the force that stays of it, in double.
// Source: docs/solvers/multigrid.md, Contact.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "contact/reference/proximity/respond.hpp"
#include "method/multigrid/reference/transfer.hpp"

namespace weft::reference {

/// How stiffly a pair is held along its normal and across it, in the inertia of its sides.
inline constexpr double kPairStiffness = 2, kPairSlipStiffness = 1;
/// What the first system leaves of a gap, or of the thickness: with less, the second holds the pair by the stiffness of
/// its cloth.
inline constexpr double kCloses = 0.5;

/// A pair of bodies is held as its stiffer side, but no more than so much stiffer than the softer one.
inline constexpr double kMostStiffer = 10;
/// Of two sides, each the geometric mean of its inertia and its stiffness with all neighbours fixed; 0: that does not
/// move [N/m].
inline double stiffness_of_bodies(double a, double b) {
  const double stiffer = std::max(a, b), softer = std::min(a, b);
  return softer > 0 ? std::min(stiffer, kMostStiffer * softer) : stiffer;
}

/// Equation (16) for one pair: springs on the relative way of its sides, Σ w x.
class PairHold {
 public:
  /// Sums over a pair's nodes before its system is solved; fixed nodes have a way alone.
  struct Sides {
    std::size_t pair = 0;     // among those that were given
    std::uint32_t first = 0;  // node of the cloth
    Vec3d ahead;              // Σ w Δt v, of the velocities at the start [m]
    Vec3d start, pull;        // Σ w (the way to z, and d₀), Σ w R / a [m]
    double compliance = 0;    // Σ |w| S / a [m/N]; S: the sum of |w| of the node's pairs
    double mobility = 0;      // the same with the masses [1/kg]
    double local = 0;  // the same of the matrix's diagonal: Σ |w| S n·D⁻¹n [m/N]; 0: in the first system
    double of_bodies = 0;  // stiffness_of_bodies(); of cloth 0 [N/m]
  };
  /// None where nothing presses the pair together.
  static std::optional<PairHold> of(const NearPair& pair, const Sides& sides, double dt);

  std::size_t pair() const { return sides_.pair; }
  bool is_of_two_bodies() const { return near_.of_two_bodies; }
  void add_force(Field& residual, const std::vector<bool>& fixed) const;
  /// Adds the pair's part of A x.
  void add_product(const Field& x, Field& product, const std::vector<bool>& fixed) const;

  struct End {
    Vec3d force;    // on side A, but for what has stopped an approach [N]
    Vec3d impulse;  // on side A: what is taken out of the velocities [N s]
  };
  /// After the solution e [m].
  End end(const Field& unknown, double dt) const;

  /// call(node of the cloth, w)
  template <class Call>
  void for_each_node(const Call& call) const {
    for (std::uint32_t k = 0; k < near_.node_count; ++k)
      call(near_.nodes[k] - sides_.first, near_.weights[k]);
  }

 private:
  /// τ - k_t s, of a relative way [N].
  Vec3d reach(const Vec3d& way) const {
    return kept_along_ - slip_stiffness_ * part_across(way, near_.direction);
  }
  /// The part of friction that the residual gets [N].
  Vec3d applied() const;

  NearPair near_;
  Sides sides_;
  double stiffness_ = 0, slip_stiffness_ = 0;  // k, k_t [N/m]
  double lack_ = 0, restored_ = 0;             // g, z [m]
  double blow_ = 0;                            // g of the velocities at the start [m]
  double kept_normal_ = 0;                     // λ [N]
  Vec3d kept_along_;                           // τ [N]
  bool sticks_ = false;
};

}  // namespace weft::reference
