#include "element/membrane/law.hpp"

#include <algorithm>
#include <cmath>

namespace weft::membrane {
namespace {

/// What is crushed to less of its area is taken for as large, where stress by length would leave all bounds.
constexpr double kLeastArea = 1e-3;

Strain green_strain(const Axes& f) {
  return {{(dot(f.warp, f.warp) - 1) / 2, (dot(f.weft, f.weft) - 1) / 2, dot(f.warp, f.weft)},
          {f.warp, {}},
          {{}, f.weft},
          {f.weft, f.warp}};
}

/// The axes' directions and stretches.
struct Yarns {
  double warp_stretch, weft_stretch;
  Vec3d warp, weft;
  double cosine;  // of the angle between them
};

Yarns yarns_of(const Axes& f) {
  const double a = std::max(length(f.warp), kMinStretch), b = std::max(length(f.weft), kMinStretch);
  const Vec3d n = f.warp / a, m = f.weft / b;
  return {a, b, n, m, dot(n, m)};
}

Strain yarn_strain(const Axes& f) {
  const Yarns y = yarns_of(f);
  return {{y.warp_stretch - 1, y.weft_stretch - 1, y.cosine},
          {y.warp, {}},
          {{}, y.weft},
          {(y.weft - y.cosine * y.warp) / y.warp_stretch, (y.warp - y.cosine * y.weft) / y.weft_stretch}};
}

Triple operator*(const Stiffness& c, const Triple& e) {
  return {c.warp * e.warp + c.coupled * e.weft, c.coupled * e.warp + c.weft * e.weft, c.shear * e.shear};
}

double dot(const Triple& a, const Triple& b) { return a.warp * b.warp + a.weft * b.weft + a.shear * b.shear; }
double dot(const Axes& a, const Axes& b) { return dot(a.warp, b.warp) + dot(a.weft, b.weft); }

/// Σ s_k ∂ε_k/∂F
Axes along(const Triple& s, const Strain& e) {
  return {s.warp * e.warp.warp + s.weft * e.weft.warp + s.shear * e.shear.warp,
          s.warp * e.warp.weft + s.weft * e.weft.weft + s.shear * e.shear.weft};
}

/// (a bᵀ + b aᵀ) / 2
Hessian product(const Axes& a, const Axes& b) {
  return {0.5 * (Mat3::outer(a.warp, b.warp) + Mat3::outer(b.warp, a.warp)),
          0.5 * (Mat3::outer(a.warp, b.weft) + Mat3::outer(b.warp, a.weft)),
          0.5 * (Mat3::outer(a.weft, b.weft) + Mat3::outer(b.weft, a.weft))};
}

/// Σ C_kl ∂ε_k/∂F ∂ε_l/∂F: positive semidefinite since C is positive.
Hessian material_part(const Stiffness& c, const Strain& e) {
  return c.warp * product(e.warp, e.warp) + 2 * c.coupled * product(e.warp, e.weft) +
         c.weft * product(e.weft, e.weft) + c.shear * product(e.shear, e.shear);
}

/// A symmetric 2 x 2 matrix.
struct Sym2 {
  double xx = 0, xy = 0, yy = 0;
};

/// Without its negative principal value.
Sym2 positive_part(const Sym2& s) {
  const double middle = (s.xx + s.yy) / 2, radius = std::hypot((s.xx - s.yy) / 2, s.xy);
  if (middle - radius >= 0) return s;
  if (middle + radius <= 0) return {};
  const double low = middle - radius, scale = (middle + radius) / (2 * radius);
  return {scale * (s.xx - low), scale * s.xy, scale * (s.yy - low)};
}

bool presses(const Sym2& s) { return s.xx < 0 || s.xx * s.yy < s.xy * s.xy; }

/// Its principal values without their signs, and none above `most`.
Sym2 absolute(const Sym2& s, double most) {
  const double middle = (s.xx + s.yy) / 2, radius = std::hypot((s.xx - s.yy) / 2, s.xy);
  const double high = std::min(most, std::abs(middle + radius)),
               low = std::min(most, std::abs(middle - radius));
  const double scale = radius > 0 ? (high - low) / (2 * radius) : 0, mean = (high + low) / 2;
  return {mean + scale * (s.xx - middle), scale * s.xy, mean + scale * (s.yy - middle)};
}

/// What holds a direction that is stressed by `now` here and `then` where a step leads, if only pressure makes it
/// resist by its size.
double held(double now, double then, double most) {
  return std::min(now, then) < 0 ? std::min(std::abs(then), most) : now;
}
Sym2 held(const Sym2& now, const Sym2& then, double most) {
  return presses(now) || presses(then) ? absolute(then, most) : now;
}

Hessian kronecker(const Sym2& s, const Mat3& m) { return {s.xx * m, s.xy * m, s.yy * m}; }

Sym2 second_stress(const Triple& s) { return {s.warp, s.shear, s.weft}; }

/// Σ σ_k ∂²ε_k/∂F² of Green's strain: S I. Clamped it is positive.
Hessian green_geometry(const Triple& s, bool clamped) {
  const Sym2 second = second_stress(s);
  return kronecker(clamped ? positive_part(second) : second, Mat3::identity(1));
}

/// I - n nᵀ
Mat3 across(const Vec3d& n) { return Mat3::identity(1) + -1.0 * Mat3::outer(n, n); }

/// How the slope of the cosine changes. Equation 6.
Hessian cosine_curvature(const Yarns& y) {
  const Mat3 p = across(y.warp), q = across(y.weft);
  const auto own = [&](const Vec3d& n, const Vec3d& other, const Mat3& across_n, double stretch) {
    const Vec3d slope = across_n * other;
    return -1 / (stretch * stretch) * (Mat3::outer(n, slope) + Mat3::outer(slope, n) + y.cosine * across_n);
  };
  return {own(y.warp, y.weft, p, y.warp_stretch), 1 / (y.warp_stretch * y.weft_stretch) * (p * q),
          own(y.weft, y.warp, q, y.weft_stretch)};
}

/// Yarns with this tension are held straight.
Hessian straightening(const Yarns& y, double warp, double weft) {
  return {warp / y.warp_stretch * across(y.warp), {}, weft / y.weft_stretch * across(y.weft)};
}

/// Clamped: pressure and shear would make it indefinite.
Hessian yarn_geometry(const Axes& f, const Triple& s, bool clamped) {
  const Yarns y = yarns_of(f);
  if (clamped) return straightening(y, std::max(0.0, s.warp), std::max(0.0, s.weft));
  return straightening(y, s.warp, s.weft) + s.shear * cosine_curvature(y);
}

/// Stable neo-Hookean: µ/2 (tr FᵀF - 2) - µ (J - 1) + λ/2 (J - 1)², where J is the area by that at rest. Equation 5.
struct NeoHookean {
  double mu, lambda;
  double area;   // J
  Vec3d normal;  // unit
  Axes slope;    // of J
  double s;      // the energy's derivative by J

  NeoHookean(const Stiffness& c, const Axes& f) : mu(c.shear), lambda(c.coupled + c.shear) {
    const Vec3d n = cross(f.warp, f.weft);
    area = std::max(length(n), kMinStretch * kMinStretch);
    normal = n / area;
    slope = {cross(f.weft, normal), cross(normal, f.warp)};
    s = lambda * (area - 1) - mu;
  }
};

double neo_hookean_energy(const Stiffness& c, const Axes& f) {
  const NeoHookean n(c, f);
  return n.mu / 2 * (dot(f, f) - 2) - n.mu * (n.area - 1) + n.lambda / 2 * (n.area - 1) * (n.area - 1);
}

Axes neo_hookean_stress(const Stiffness& c, const Axes& f) {
  const NeoHookean n(c, f);
  return {n.mu * f.warp + n.s * n.slope.warp, n.mu * f.weft + n.s * n.slope.weft};
}

/// Across the plane: µ I + s J (FᵀF)⁻¹, which is the second Piola-Kirchhoff stress.
Sym2 across_plane(const NeoHookean& n, const Axes& f) {
  const double by_area = n.s / n.area;
  return {n.mu + by_area * dot(f.weft, f.weft), -by_area * dot(f.warp, f.weft),
          n.mu + by_area * dot(f.warp, f.warp)};
}
/// The same of a stress by F, (FᵀF)⁻¹ FᵀP.
Sym2 across_plane(const NeoHookean& n, const Axes& f, const Axes& stress) {
  const double area = std::max(n.area, kLeastArea), scale = 1 / (area * area);
  const double a = dot(f.warp, f.warp), b = dot(f.warp, f.weft), c = dot(f.weft, f.weft);
  const double first = dot(f.warp, stress.warp), last = dot(f.weft, stress.weft);
  const double over = dot(f.warp, stress.weft), under = dot(f.weft, stress.warp);
  return {scale * (c * first - b * under), scale * (c * over - b * last + a * under - b * first) / 2,
          scale * (a * last - b * over)};
}

Hessian neo_hookean_parts(const NeoHookean& n, double keeps, double turns, const Sym2& out) {
  const Hessian plane{(keeps + turns) / 2 * across(n.normal), (turns - keeps) / 2 * Mat3::cross(n.normal),
                      (keeps + turns) / 2 * across(n.normal)};
  return n.lambda * product(n.slope, n.slope) + plane + kronecker(out, Mat3::outer(n.normal, n.normal));
}

/// µ I + s J'' falls into parts that know nothing of each other: in the plane the changes of F that keep angles
/// (J'' = 1) and those that turn them round (-1), across it the 2 x 2 matrix J (FᵀF)⁻¹. Each is clamped on its own.
Hessian neo_hookean_hessian(const Stiffness& c, const Axes& f, bool clamped) {
  const NeoHookean n(c, f);
  const double keeps = n.mu + n.s, turns = n.mu - n.s;
  const Sym2 out = across_plane(n, f);
  if (!clamped) return neo_hookean_parts(n, keeps, turns, out);
  return neo_hookean_parts(n, std::max(0.0, keeps), std::max(0.0, turns), positive_part(out));
}

Hessian held_neo_hookean(const Stiffness& c, const Axes& f, const Axes& way) {
  const NeoHookean n(c, f);
  const Axes stress = neo_hookean_stress(c, f), more = neo_hookean_hessian(c, f, true) * way;
  const Sym2 out = across_plane(n, f, {stress.warp + more.warp, stress.weft + more.weft});
  const double then = n.s + n.lambda * dot(n.slope, way), most = n.mu + n.lambda;
  return neo_hookean_parts(n, held(n.mu + n.s, n.mu + then, most), std::max(0.0, n.mu - n.s),
                           held(across_plane(n, f), out, most));
}

/// Of Green's or yarns' energy, what is left without stress; clamped it takes pressed axes for as long as at rest.
Hessian stiff_part(const Law& law, const Axes& f, const Strain& e, bool clamped) {
  const bool takes_unpressed = clamped && law.energy == Energy::Green;
  return material_part(law.stiffness, takes_unpressed ? green_strain(unpressed(f)) : e);
}

/// What stresses by the strains of an energy make of it: those that damp neo-Hookean cloth are Green's.
Hessian geometry_part(Energy energy, const Axes& f, const Triple& s, bool clamped) {
  return energy == Energy::Yarn ? yarn_geometry(f, s, clamped) : green_geometry(s, clamped);
}

Hessian hessian_of(const Law& law, const Axes& f, bool clamped) {
  if (law.energy == Energy::NeoHookean) return neo_hookean_hessian(law.stiffness, f, clamped);
  const Strain e = strain_of(law.energy, f);
  return stiff_part(law, f, e, clamped) + geometry_part(law.energy, f, law.stiffness * e.value, clamped);
}

}  // namespace

Hessian operator+(const Hessian& a, const Hessian& b) {
  return {a.warp + b.warp, a.mixed + b.mixed, a.weft + b.weft};
}
Hessian operator*(double s, const Hessian& a) { return {s * a.warp, s * a.mixed, s * a.weft}; }
Axes operator*(const Hessian& h, const Axes& f) {
  return {h.warp * f.warp + h.mixed * f.weft, transposed(h.mixed) * f.warp + h.weft * f.weft};
}

Strain strain_of(Energy energy, const Axes& f) {
  return energy == Energy::Yarn ? yarn_strain(f) : green_strain(f);
}

Axes unpressed(const Axes& f) {
  const Yarns y = yarns_of(f);
  return {std::max(1.0, 1 / y.warp_stretch) * f.warp, std::max(1.0, 1 / y.weft_stretch) * f.weft};
}

double energy(const Law& law, const Axes& f) {
  if (law.energy == Energy::NeoHookean) return neo_hookean_energy(law.stiffness, f);
  const Triple e = strain_of(law.energy, f).value;
  return dot(e, law.stiffness * e) / 2;
}

Axes stress(const Law& law, const Axes& f) {
  if (law.energy == Energy::NeoHookean) return neo_hookean_stress(law.stiffness, f);
  const Strain e = strain_of(law.energy, f);
  return along(law.stiffness * e.value, e);
}

Hessian hessian(const Law& law, const Axes& f) { return hessian_of(law, f, false); }
Hessian positive_hessian(const Law& law, const Axes& f) { return hessian_of(law, f, true); }

Hessian held_hessian(const Law& law, const Axes& f, const Axes& way) {
  if (law.energy == Energy::NeoHookean) return held_neo_hookean(law.stiffness, f, way);
  const Strain e = strain_of(law.energy, f);
  const Triple more{dot(e.warp, way), dot(e.weft, way), dot(e.shear, way)};
  const Triple now = law.stiffness * e.value,
               then = law.stiffness *
                      Triple{e.value.warp + more.warp, e.value.weft + more.weft, e.value.shear + more.shear};
  const Hessian stiff = stiff_part(law, f, e, true);
  const double warp = law.stiffness.warp, weft = law.stiffness.weft;
  if (law.energy == Energy::Yarn)
    return stiff +
           straightening(yarns_of(f), held(now.warp, then.warp, warp), held(now.weft, then.weft, weft));
  return stiff +
         kronecker(held(second_stress(now), second_stress(then), std::max(warp, weft)), Mat3::identity(1));
}

Axes damping_stress(const Law& law, const Axes& f, const Axes& rate) {
  const Strain e = strain_of(law.energy, f);
  const Triple strain_rate{dot(e.warp, rate), dot(e.weft, rate), dot(e.shear, rate)};
  const Triple s = law.stiffness * strain_rate;
  return along({law.delay * s.warp, law.delay * s.weft, law.delay * s.shear}, e);
}

StepStress step_stress(const Law& law, const Axes& f, const Axes& start, double rate) {
  const Strain e = strain_of(law.energy, f);
  const Triple before = strain_of(law.energy, start).value;
  const double delays = law.delay * rate;
  const Triple damping =
      law.stiffness * Triple{delays * (e.value.warp - before.warp), delays * (e.value.weft - before.weft),
                             delays * (e.value.shear - before.shear)};
  const Axes elastic = stress(law, f), damped = along(damping, e);
  const Axes both{elastic.warp + damped.warp, elastic.weft + damped.weft};
  const Hessian by_strain = delays * material_part(law.stiffness, e);
  if (law.energy == Energy::NeoHookean)
    return {both, positive_hessian(law, f) + by_strain + geometry_part(law.energy, f, damping, true)};
  const Triple own = law.stiffness * e.value;
  const Triple all{own.warp + damping.warp, own.weft + damping.weft, own.shear + damping.shear};
  return {both, stiff_part(law, f, e, true) + by_strain + geometry_part(law.energy, f, all, true)};
}

Hessian damping_hessian(const Law& law, const Axes& f) {
  return law.delay * material_part(law.stiffness, strain_of(law.energy, f));
}

Rest Rest::of(const std::array<MaterialPoint, 3>& corners) {
  Rest rest;
  const auto& [a, b, c] = corners;
  const double twice = (b.warp - a.warp) * (c.weft - a.weft) - (b.weft - a.weft) * (c.warp - a.warp);
  rest.area = std::abs(twice) / 2;
  for (std::size_t i = 0; i < 3; ++i) {
    const MaterialPoint &next = corners[(i + 1) % 3], &last = corners[(i + 2) % 3];
    rest.slope[i] = {(next.weft - last.weft) / twice, (last.warp - next.warp) / twice};
  }
  return rest;
}

Axes deformation(const Rest& rest, const Corners& corners) {
  Axes f;
  for (std::size_t i = 0; i < 3; ++i) {
    f.warp += rest.slope[i].warp * corners[i];
    f.weft += rest.slope[i].weft * corners[i];
  }
  return f;
}

Corners forces(const Rest& rest, const Axes& stress) {
  Corners all;
  for (std::size_t i = 0; i < 3; ++i)
    all[i] = -rest.area * (rest.slope[i].warp * stress.warp + rest.slope[i].weft * stress.weft);
  return all;
}

Blocks blocks(const Rest& rest, const Hessian& h) {
  Blocks all;
  const Mat3 mixed = transposed(h.mixed);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const MaterialPoint &a = rest.slope[i], &b = rest.slope[j];
      all[i][j] = rest.area * (a.warp * b.warp * h.warp + a.warp * b.weft * h.mixed +
                               a.weft * b.warp * mixed + a.weft * b.weft * h.weft);
    }
  return all;
}

}  // namespace weft::membrane
