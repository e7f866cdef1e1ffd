#pragma once

#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "closed_forms/rope_over_capsule.hpp"

namespace weft {

/// A strip of equal cells over a round rail along z, as it begins: stretched as a rope is that friction holds with one
/// part of it everywhere, or that begins to slide, so that it neither falls nor swings. Edges are tangents of the
/// rail's upper half, the first and the last of them upright.
class StripOverCapsule {
 public:
  /// Of a rope that hangs about so far on both sides, with the radius of the edges' middles; so many edges turn over
  /// the rail; what a strip stretches by the square of a speed, density over modulus [s²/m²].
  StripOverCapsule(const RopeOverCapsule& about, std::uint32_t touching, double compliance);

  std::uint32_t rows() const { return static_cast<std::uint32_t>(along_.size()); }
  double cell() const { return cell_; }  // at rest [m]
  /// With what hangs free in fact.
  const RopeOverCapsule& rope() const { return rope_; }
  /// By which a rope has as much of it as a chain of these edges, which turns at its masses alone: with T and T' on
  /// both sides of one N = (T + T') sin(turn/2), and T' - T = μ N / cos(turn/2). 1.4 % more on 8 edges, 0.4 % on 16.
  double friction_of_chain() const;
  /// Where a node begins that lies at this place while the strip is flat, with its middle at 0 and along x.
  Vec3d draped(const Vec3d& flat) const;

 private:
  RopeOverCapsule rope_;
  double turn_, edge_, cell_;  // from an edge to the next; as it is stretched on the rail [m]; at rest [m]
  std::uint32_t touching_;
  std::vector<double> along_;  // of each row, from where it first touches [m]
};

}  // namespace weft
