#include "method/projection/reference/solid_projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "element/tet/jacobi.hpp"
#include "method/tet_turning.hpp"

namespace weft::reference {
namespace {

using tet::matrix_of, tet::square_of;
using Square = tet::Square<3>;

/// What bounds how fast h² V times the stress, in the frame of the rotation that is nearest to F, grows with a change X
/// of F in that frame: `strain` (X + Xᵀ)/2 + `turn` (X - Xᵀ)/2 + Σ `along` c (c : X) [kg·m²].
struct Bound {
  double strain = 0, turn = 0;
  std::array<double, 2> along{};
  std::array<Mat3, 2> direction{};  // c
};

/// Not less than what n: |F|², J: det F make of second derivatives of s J by F, s = -1 or 1: the largest root of
/// t³ - n t - 2 s J, by Newton's method from above.
double most_of_volume(double square, double signed_volume) {
  square += 1e-12;  // so that F = 0 has one
  double t = std::sqrt(4 * square / 3);
  for (int k = 0; k < 4; ++k) t -= (t * (t * t - square) - 2 * signed_volume) / (3 * t * t - square);
  return t;
}

/// Of the energy by F = R `stretch`, [Pa].
Bound bound_of(const tet::Law& law, const Mat3& stretch) {
  Bound bound;
  if (law.energy == tet::Energy::Corotated) {
    bound.strain = 2 * law.mu;
    bound.along[0] = law.lambda;
    bound.direction[0] = Mat3::identity(1);
    return bound;
  }
  const Mat3 area = cofactor(stretch);
  const double volume = dot(stretch.x, area.x);
  const double slope = (law.lambda + law.mu) * (volume - 1) - law.mu;  // of the energy by J
  bound.strain =
      law.mu + std::abs(slope) * most_of_volume(contraction(stretch, stretch), slope < 0 ? -volume : volume);
  bound.along[0] = law.lambda + law.mu;
  bound.direction[0] = area;
  return bound;
}

/// X of X + B (X diag(s)) = Y, without what B does along its directions.
Mat3 softened(const Bound& bound, const std::array<double, 3>& s, const Mat3& right) {
  const double own = (bound.strain + bound.turn) / 2, other = (bound.strain - bound.turn) / 2;
  const Square y = square_of(right);
  Square x{};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i][i] = y[i][i] / (1 + bound.strain * s[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      if (j == i) continue;
      const double determinant = 1 + own * (s[i] + s[j]) + bound.strain * bound.turn * s[i] * s[j];
      x[i][j] = ((1 + own * s[i]) * y[i][j] - other * s[i] * y[j][i]) / determinant;
    }
  }
  return matrix_of(x);
}

/// X of X + B (X diag(s)) = Y.
Mat3 solved(const Bound& bound, const std::array<double, 3>& s, const Mat3& right) {
  const Mat3 weights{{s[0], 0, 0}, {0, s[1], 0}, {0, 0, s[2]}};
  const Mat3 first = softened(bound, s, right);
  const std::array<Mat3, 2> more = {softened(bound, s, bound.direction[0]),
                                    softened(bound, s, bound.direction[1])};
  const auto taken = [&](std::size_t k, const Mat3& x) {
    return bound.along[k] * contraction(bound.direction[k], x * weights);
  };
  const double a = 1 + taken(0, more[0]), b = taken(0, more[1]), c = taken(1, more[0]),
               d = 1 + taken(1, more[1]);
  const double p = taken(0, first), q = taken(1, first), determinant = a * d - b * c;
  return first + -(d * p - b * q) / determinant * more[0] + -(a * q - c * p) / determinant * more[1];
}

}  // namespace

void project_tet(Ways& ways, const tet::Tets& tets, std::size_t tet, std::uint32_t first, double dt,
                 Mat3& multiplier) {
  const mesh::Tet& nodes = tets.tets[tet];
  const tet::Rest& rest = tets.rests[tet];
  const tet::Law& law = tets.law;
  tet::Corners starts, moved;
  Mat3 weights{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t node = first + nodes[k];
    starts[k] = ways.start[node];
    moved[k] = ways.way[node];
    weights += ways.inverse_mass[node] * Mat3::outer(rest.slope[k], rest.slope[k]);
  }
  const Mat3 start = tet::deformation(rest, starts), change = tet::deformation(rest, moved),
             f = start + change;
  const Mat3 rotation = tet::nearest_rotation(f), back = transposed(rotation);
  const double elastic = dt * dt * rest.volume, damping = dt * law.delay * rest.volume;
  const Mat3 stretch = symmetric_part(back * f);
  const Mat3 pull =
      back * (elastic * tet::stress(law, f) + damping * delayed_stress(law, start, f, rotation));

  Bound bound = bound_of(law, stretch);
  bound.strain = elastic * bound.strain + damping * 2 * law.mu;
  bound.along = {elastic * bound.along[0], damping * law.lambda};
  bound.direction[1] = Mat3::identity(1);
  bound.turn = turning(stretch, symmetric_part(pull));

  const auto [axes, values] = tet::principal(weights);
  const Mat3 in = transposed(axes);
  for (Mat3& direction : bound.direction) direction = in * direction * axes;
  const Mat3 found = solved(bound, values, in * (back * multiplier + pull) * axes);
  const Mat3 pulled = -1.0 * (rotation * (axes * found * in));
  multiplier += pulled;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t node = first + nodes[k];
    ways.way[node] += ways.inverse_mass[node] * (pulled * rest.slope[k]);
  }
}

SolidProjection::SolidProjection(const Model& model, const Body& body, Multipliers multipliers)
    : multipliers_(multipliers),
      tets_(color_elements(model.elements(ElementKind::Tet, body), model.vertex_count())) {
  begin();
}

void SolidProjection::begin() { pulled_.assign(tets_.elements.size(), {}); }

void SolidProjection::sweep(Ways& ways, const SolidBody& solid, double dt) {
  const std::vector<std::uint32_t>& order = tets_.elements;
  const auto project = [&](std::uint32_t tet) {
    project_tet(ways, solid.tets, tet, solid.first, dt, pulled_[tet]);
  };
  if (multipliers_ == Multipliers::Forgotten) begin();
  std::for_each(order.begin(), order.end(), project);
  if (multipliers_ == Multipliers::Forgotten) begin();
  std::for_each(order.rbegin(), order.rend(), project);
}

}  // namespace weft::reference
