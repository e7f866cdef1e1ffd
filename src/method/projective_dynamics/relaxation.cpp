#include "method/projective_dynamics/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "method/projective_dynamics/node_pairs.hpp"

namespace weft {
namespace {

/// The part, one in this many, that a cycle leaves at most of what it is tuned to. From 3 on a linear motion is stable
/// at any step (docs/solvers/projective_dynamics.md, Stable at any step).
constexpr double kReduction = 10;
/// The longest cycle. Springs turn between cycles only: by one cycle of 20 iterations a rope swings, in the steps that
/// "auto" then takes, with 1.07 of its period, by two of 10 with 1.00 (in double), and four of 5 reach less far.
constexpr std::uint32_t kCycle = 10;
/// Power iterations for the bound. It holds after any number, and these bring it within a few percent of where it goes.
constexpr int kRounds = 16;

/// Not less than the largest eigenvalue of M⁻¹ L, with L the matrix of a cloth's pairs: for every y > 0 that is at most
/// max (M⁻¹ |L| y)_i / y_i (Collatz 1942), which falls as y becomes the eigenvector of M⁻¹ |L|. `pull_of` says what
/// of a pair counts.
template <class PullOf>
double largest_rate(const Model& model, const Body& cloth, const std::vector<NodePair>& pairs,
                    const PullOf& pull_of) {
  std::vector<double> mobility(cloth.vertex_count), y(cloth.vertex_count, 1.0), product;
  for (std::uint32_t i = 0; i < cloth.vertex_count; ++i)
    mobility[i] = model.inverse_mass(cloth.first_vertex + i);
  double bound = HUGE_VAL;
  for (int round = 0; round < kRounds; ++round) {
    product.assign(y.size(), 0.0);
    for (const NodePair& pair : pairs) {
      // Both have the pull on their diagonals, and its absolute value beside.
      const double pull = pull_of(pair), size = std::abs(pull);
      const auto [a, b] = std::pair(pair.a, pair.b);
      product[a] += (pull > 0 ? size * (y[a] + y[b]) : size * (y[b] - y[a])) * mobility[a];
      product[b] += (pull > 0 ? size * (y[a] + y[b]) : size * (y[a] - y[b])) * mobility[b];
    }
    double ratio = 0, largest = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      ratio = std::max(ratio, product[i] / y[i]);
      largest = std::max(largest, product[i]);
    }
    if (largest == 0) return 0;
    bound = std::min(bound, ratio);
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] =
          std::max(product[i] / largest, 1e-9);  // nodes that do not move bring nothing, but y stays above 0
  }
  return bound;
}

/// Chebyshev's polynomial of the first kind, for z of at least 1.
double chebyshev(std::uint32_t degree, double z) {
  double before = 1, value = z;
  for (std::uint32_t n = 1; n < degree; ++n) {
    const double next = 2 * z * value - before;
    before = value;
    value = next;
    if (value > kReduction) break;  // it only grows
  }
  return value;
}

/// z with T_n(z) = kReduction, by halving: sums and products alone have the same bits on every host.
double tuned_to(std::uint32_t iterations) {
  double low = 1, high = kReduction;
  while (true) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return high;
    (chebyshev(iterations, middle) < kReduction ? low : high) = middle;
  }
}

/// A substep's cycles, as equal as they can be.
struct Cycles {
  explicit Cycles(std::uint32_t iterations)
      : count((iterations + kCycle - 1) / kCycle), shortest(iterations / count), longer(iterations % count) {}
  std::uint32_t count, shortest, longer;  // the first have an iteration more
};

}  // namespace

double ClothRates::step_of(double rate) const {
  const double sum = damping + std::sqrt(damping * damping + 4 * stiffness * rate);
  return sum > 0 ? 2 * rate / sum : HUGE_VAL;
}

double reached_rate(std::uint32_t iterations) { return 2 / (tuned_to(Cycles(iterations).shortest) - 1); }

ClothRates cloth_rates(const Model& model, const Body& cloth) {
  std::vector<NodePair> pairs;
  if (cloth.fabric) pairs = fabric_node_pairs(model, cloth);
  if (cloth.solid) pairs = solid_node_pairs(model, cloth);
  for (const Spring spring : model.springs(cloth))
    pairs.push_back({spring.node_a - cloth.first_vertex, spring.node_b - cloth.first_vertex,
                     static_cast<double>(spring.stiffness), static_cast<double>(spring.damping), 0});
  return {largest_rate(model, cloth, pairs, [](const NodePair& pair) { return pair.pull; }),
          largest_rate(model, cloth, pairs, [](const NodePair& pair) { return pair.damping; })};
}

Relaxation make_relaxation(double most_rate, std::uint32_t iterations) {
  const Cycles cycles(iterations);
  const double rate = std::min(most_rate, reached_rate(iterations));
  Relaxation made{rate / (2 + rate), {}};
  const double square = made.radius * made.radius;
  for (std::uint32_t cycle = 0; cycle < cycles.count; ++cycle) {
    std::vector<double> weights;
    const std::uint32_t count = cycles.shortest + (cycle < cycles.longer ? 1 : 0);
    for (std::uint32_t i = 1; i < count; ++i)
      weights.push_back(i == 1 ? 2 / (2 - square) : 4 / (4 - square * weights.back()));
    made.cycles.push_back(std::move(weights));
  }
  return made;
}

}  // namespace weft
