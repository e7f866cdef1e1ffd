#include "element/membrane/form.hpp"

#include <algorithm>
#include <cmath>

namespace weft::membrane {
namespace {

/// |F|² - 2 J = (F11 - F22)² + (F12 + F21)² in any frame of the plane that the axes span; here its first vector is that
/// of the warp. The frame may turn: both squares have one sum, so it does no work. Equation 22.
Strain neo_hookean_form(const Axes& f) {
  const double along = std::max(length(f.warp), kMinStretch);
  const Vec3d spanned = cross(f.warp, f.weft), first = f.warp / along;
  const double area = length(spanned);
  const Vec3d normal = spanned / std::max(area, kMinStretch * kMinStretch), second = cross(normal, first);
  return {{length(f.warp) - dot(f.weft, second), dot(f.weft, first), area - 1},
          {first, -1.0 * second},
          {second, first},
          {cross(f.weft, normal), cross(normal, f.warp)}};
}

Strain form_strain(Energy energy, const Axes& f) {
  return energy == Energy::NeoHookean ? neo_hookean_form(f) : strain_of(energy, f);
}

/// The axes where they are pressed as long as at rest, and no nearer to a line than 60°: where they close on it,
/// Green's strains ask for changes that only a long way along it makes.
Axes opened(const Axes& f) {
  const Axes longer = unpressed(f);
  const double a = std::max(length(longer.warp), kMinStretch), b = std::max(length(longer.weft), kMinStretch);
  const Vec3d n = longer.warp / a, m = longer.weft / b;
  const double cosine = dot(n, m), sign = cosine < 0 ? -1 : 1;
  if (std::abs(cosine) <= 0.5) return longer;
  const Vec3d middle = (n + sign * m) / length(n + sign * m);
  Vec3d aside = n - sign * m;
  if (length(aside) < 1e-3)  // any direction is as good
    aside = cross(middle, std::abs(middle.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
  aside = aside / length(aside);
  const Vec3d along = std::sqrt(0.75) * middle;
  return {a * (along + 0.5 * aside), sign * b * (along - 0.5 * aside)};
}

/// The slope of the angle between yarns, instead of its cosine's.
Strain by_angle(Strain e) {
  const double sine = std::sqrt(std::max(1 - e.value.shear * e.value.shear, kMinStretch));
  e.shear = {e.shear.warp / sine, e.shear.weft / sine};
  return e;
}

}  // namespace

Form form(const Law& law, const Axes& f) {
  const Stiffness& c = law.stiffness;
  return {form_strain(law.energy, f),
          law.energy == Energy::NeoHookean ? Stiffness{c.shear, 0, c.shear, c.coupled + c.shear} : c};
}

Strain steep_slopes(Energy energy, const Axes& f) {
  if (energy == Energy::Yarn) return by_angle(strain_of(energy, f));
  return form_strain(energy, energy == Energy::Green ? opened(f) : unpressed(f));
}

}  // namespace weft::membrane
