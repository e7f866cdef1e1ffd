#include "bench/upsample.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace weft::bench {
namespace {

/// The coarse nodes along one axis that a fine one follows.
struct Taps {
  std::array<std::uint32_t, 4> node;
  std::array<double, 4> weight;
};

/// Of fine node `index`, both grids from end to end of the same length.
Taps taps_at(std::uint32_t index, std::uint32_t fine_count, std::uint32_t coarse_count) {
  const std::uint64_t place = std::uint64_t{index} * (coarse_count - 1);  // in parts of a coarse cell
  const std::uint32_t parts = fine_count - 1;
  const auto cell = static_cast<std::uint32_t>(std::min<std::uint64_t>(place / parts, coarse_count - 2));
  const double f = static_cast<double>(place - std::uint64_t{cell} * parts) / parts;
  Taps taps;
  // Catmull-Rom: the cubic through the two nodes of the cell with the slopes between their neighbours.
  std::array<double, 4>& w = taps.weight;
  w = {((2 - f) * f - 1) * f / 2, ((3 * f - 5) * f * f + 2) / 2, ((4 - 3 * f) * f + 1) * f / 2,
       (f - 1) * f * f / 2};
  if (cell == 0) {  // the node before the first is twice the first less the second
    w[1] += 2 * w[0];
    w[2] -= w[0];
    w[0] = 0;
  }
  if (cell == coarse_count - 2) {
    w[2] += 2 * w[3];
    w[1] -= w[3];
    w[3] = 0;
  }
  for (std::uint32_t k = 0; k < 4; ++k) taps.node[k] = std::min(std::max(cell + k, 1U) - 1, coarse_count - 1);
  return taps;
}

std::vector<Taps> taps_of(std::uint32_t fine_count, std::uint32_t coarse_count) {
  std::vector<Taps> taps;
  for (std::uint32_t k = 0; k < fine_count; ++k) taps.push_back(taps_at(k, fine_count, coarse_count));
  return taps;
}

}  // namespace

std::vector<Vec3d> upsample(const mesh::Grid& coarse, std::span<const Vec3d> coarse_rest,
                            std::span<const Vec3d> coarse_position, const mesh::Grid& fine,
                            std::span<const Vec3d> fine_rest) {
  const std::vector<Taps> along_i = taps_of(fine.nx, coarse.nx), along_j = taps_of(fine.ny, coarse.ny);
  std::vector<Vec3d> position(fine_rest.begin(), fine_rest.end());
  for (std::uint32_t j = 0; j < fine.ny; ++j)
    for (std::uint32_t i = 0; i < fine.nx; ++i) {
      Vec3d displacement;
      for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t a = 0; a < 4; ++a) {
          const std::uint32_t node = mesh::node_index(coarse, along_i[i].node[a], along_j[j].node[b]);
          displacement +=
              along_i[i].weight[a] * along_j[j].weight[b] * (coarse_position[node] - coarse_rest[node]);
        }
      position[mesh::node_index(fine, i, j)] += displacement;
    }
  return position;
}

}  // namespace weft::bench
