#include "method/mass_spring/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random.hpp"

namespace weft {
namespace {

constexpr std::size_t kMostSteps = 128;
constexpr std::size_t kStandsFor = 6;  // steps in which the estimate must have grown
constexpr double kGrowth = 1e-4;       // by less than this part of itself

/// A spring's share of A is r r^T with r = √k n (e_b / √m_b - e_a / √m_a).
struct Row {
  std::uint32_t node_a, node_b;
  Vec3d part_a, part_b;
};

std::vector<Row> rows_of(const SpringNetwork& network, float Spring::*strength) {
  std::vector<Row> rows;
  for (const Spring spring : Springs(network.springs)) {
    const Vec4f &a = network.position[spring.node_a], &b = network.position[spring.node_b];
    const Vec3d span = b.xyz().to<double>() - a.xyz().to<double>();
    const double len = length(span), k = static_cast<double>(spring.*strength);
    if (!(k > 0)) continue;
    const auto add = [&](const Vec3d& direction) {
      rows.push_back({spring.node_a, spring.node_b, std::sqrt(k * static_cast<double>(a.w)) * direction,
                      std::sqrt(k * static_cast<double>(b.w)) * direction});
    };
    if (len > 0) {
      add(span / len);
    } else {  // a thread, whose ends have one place at rest: it may come to lie along any of these
      for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) add(axis);
    }
  }
  return rows;
}

/// A triple's share of A, the same along each axis: r r^T with r = √k (e_a / √m_a - 2 e_b / √m_b + e_c /
/// √m_c).
struct TripleRow {
  std::array<std::uint32_t, 3> nodes;
  std::array<double, 3> parts;
};

std::vector<TripleRow> triple_rows_of(const SpringNetwork& network) {
  std::vector<TripleRow> rows;
  for (std::size_t triple = 0; triple < network.triples.size(); ++triple) {
    const auto nodes = network.triples.nodes_of(triple);
    TripleRow row{{nodes[0], nodes[1], nodes[2]}, {1, -2, 1}};
    const auto stiffness = static_cast<double>(network.triples.material[triple]);
    for (std::size_t k = 0; k < 3; ++k)
      row.parts[k] *= std::sqrt(stiffness * static_cast<double>(network.position[row.nodes[k]].w));
    rows.push_back(row);
  }
  return rows;
}

/// A symmetric matrix as a sum of such shares.
struct Shares {
  std::vector<Row> rows;
  std::vector<TripleRow> triples;
};

double norm_of(const std::vector<Vec3d>& x) {
  double squares = 0;
  for (const Vec3d& v : x) squares += dot(v, v);
  return std::sqrt(squares);
}

/// The largest eigenvalue of the symmetric tridiagonal matrix with this diagonal and these entries beside it,
/// by bisection: `at` is above all of them where no pivot of (at - T) is negative.
double largest_of_tridiagonal(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  double low = diagonal[0], high = diagonal[0];
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const double reach = (i > 0 ? beside[i - 1] : 0) + (i + 1 < diagonal.size() ? beside[i] : 0);
    low = std::max(low, diagonal[i]);
    high = std::max(high, diagonal[i] + reach);  // Gershgorin
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double at = 0.5 * (low + high);
    double pivot = at - diagonal[0];
    bool above = pivot > 0;
    for (std::size_t i = 1; above && i < diagonal.size(); ++i) {
      pivot = at - diagonal[i] - beside[i - 1] * beside[i - 1] / pivot;
      above = pivot > 0;
    }
    (above ? high : low) = at;
  }
  return high;
}

/// y = A x.
void apply(const Shares& shares, const std::vector<Vec3d>& x, std::vector<Vec3d>& y) {
  std::fill(y.begin(), y.end(), Vec3d{});
  for (const TripleRow& row : shares.triples) {
    Vec3d along;
    for (std::size_t k = 0; k < 3; ++k) along += row.parts[k] * x[row.nodes[k]];
    for (std::size_t k = 0; k < 3; ++k) y[row.nodes[k]] += row.parts[k] * along;
  }
  for (const Row& row : shares.rows) {
    const double along = dot(row.part_b, x[row.node_b]) - dot(row.part_a, x[row.node_a]);
    y[row.node_b] += along * row.part_b;
    y[row.node_a] -= along * row.part_a;
  }
}

double largest_of(const Shares& shares, std::size_t count) {
  if (shares.rows.empty() && shares.triples.empty()) return 0;
  return largest_eigenvalue([&](const std::vector<Vec3d>& x, std::vector<Vec3d>& y) { apply(shares, x, y); },
                            count);
}

}  // namespace

double largest_eigenvalue(const SymmetricProduct& product, std::size_t count) {
  Random random(1);
  std::vector<Vec3d> x(count), before(count), y(count);
  for (Vec3d& v : x)
    for (int axis = 0; axis < 3; ++axis) v[axis] = random.uniform(-1, 1);
  const double start = norm_of(x);
  for (Vec3d& v : x) v = v / start;
  std::vector<double> diagonal, beside, estimates;
  while (diagonal.size() < std::min(kMostSteps, 3 * count)) {
    product(x, y);
    double along = 0;
    for (std::size_t n = 0; n < count; ++n) along += dot(x[n], y[n]);
    diagonal.push_back(along);
    const double last = beside.empty() ? 0 : beside.back();
    for (std::size_t n = 0; n < count; ++n) y[n] = y[n] - along * x[n] - last * before[n];
    estimates.push_back(largest_of_tridiagonal(diagonal, beside));
    const double estimate = estimates.back(), rest = norm_of(y);
    if (!(rest > 1e-12 * estimate)) break;  // the start lay in a subspace that is exhausted
    if (estimates.size() > kStandsFor &&
        estimate - estimates[estimates.size() - 1 - kStandsFor] < kGrowth * estimate)
      break;
    beside.push_back(rest);
    for (Vec3d& v : y) v = v / rest;
    std::swap(before, x);
    std::swap(x, y);
  }
  return estimates.back();
}

NetworkSpectrum find_spectrum(const SpringNetwork& network) {
  const std::size_t count = network.position.size();
  return {largest_of({rows_of(network, &Spring::stiffness), triple_rows_of(network)}, count),
          largest_of({rows_of(network, &Spring::damping), {}}, count)};
}

}  // namespace weft
