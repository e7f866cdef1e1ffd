#pragma once

namespace weft {

/// The heavy cantilever of a rod that bends by large angles.
/// Clamped at `rise` above level: B φ'' = -w (L - s) λ cos φ with φ(0) = -rise, φ'(L) = 0, where φ is the angle below
/// level at the arc length s at rest, and λ = 1 + w (L - s) sin φ / E the stretch. By shooting from the free end, in
/// units of L and B; G = w L³ / B. A rod of softness w L / E = 0 is inextensible. With a rise of nearly a right angle
/// it stands, and falls where G is above Greenhill's 7.8373 (1881).
class Elastica {
 public:
  double drop = 0;   // of the tip below the clamp, by the length
  double reach = 0;  // of the tip from the clamp, level, by the length

  /// `rise` [rad]: 0 to pi/2, that excluded.
  explicit Elastica(double load, double softness = 0, double rise = 0);

 private:
  double stretch(double r, double phi) const;
  double bent(double r, double phi) const;
  double angle_at_clamp(double tip);

  double load_;      // G
  double softness_;  // w L / E
};

}  // namespace weft
