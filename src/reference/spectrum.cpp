#include "reference/spectrum.hpp"

#include <cmath>
#include <utility>

#include "base/random.hpp"

namespace weft::reference {
namespace {

/// A spring's share of A is r r^T with r = √k n (e_b / √m_b - e_a / √m_a).
struct Row {
  std::uint32_t node_a, node_b;
  Vec3d part_a, part_b;
};

std::vector<Row> rows_of(const SpringNetwork& network, float Spring::*strength) {
  std::vector<Row> rows;
  for (const Spring& spring : network.springs) {
    const Vec4f &a = network.position[spring.node_a], &b = network.position[spring.node_b];
    const Vec3d span = b.xyz().to<double>() - a.xyz().to<double>();
    const double len = length(span), k = static_cast<double>(spring.*strength);
    if (len == 0 || !(k > 0)) continue;
    const Vec3d direction = std::sqrt(k) * (span / len);
    rows.push_back({spring.node_a, spring.node_b, std::sqrt(static_cast<double>(a.w)) * direction,
                    std::sqrt(static_cast<double>(b.w)) * direction});
  }
  return rows;
}

double largest_eigenvalue(const std::vector<Row>& rows, std::size_t count, std::uint32_t iterations) {
  if (rows.empty()) return 0;
  Random random(1);
  std::vector<Vec3d> x(count), y(count);
  for (Vec3d& v : x)
    for (int axis = 0; axis < 3; ++axis) v[axis] = random.uniform(-1, 1);
  double norm = 0;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    y.assign(count, {});
    for (const Row& row : rows) {
      const double along = dot(row.part_b, x[row.node_b]) - dot(row.part_a, x[row.node_a]);
      y[row.node_b] += along * row.part_b;
      y[row.node_a] -= along * row.part_a;
    }
    double squares = 0;
    for (const Vec3d& v : y) squares += dot(v, v);
    norm = std::sqrt(squares);
    if (!(norm > 0)) return 0;
    for (std::size_t n = 0; n < count; ++n) x[n] = y[n] / norm;
  }
  return norm;
}

}  // namespace

NetworkSpectrum find_spectrum(const SpringNetwork& network, std::uint32_t iterations) {
  const std::size_t count = network.position.size();
  return {largest_eigenvalue(rows_of(network, &Spring::stiffness), count, iterations),
          largest_eigenvalue(rows_of(network, &Spring::damping), count, iterations)};
}

StepLimit step_limit(const HostModel& model, double drag) {
  std::vector<NetworkSpectrum> cloths;
  for (const ClothModel& cloth : model.cloths) cloths.push_back(find_spectrum(stiffest_part(model, cloth)));
  return least_step_limit(std::move(cloths), drag);
}

}  // namespace weft::reference
