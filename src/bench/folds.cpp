#include "bench/folds.hpp"

#include <numbers>

#include "base/random.hpp"
#include "base/trig.hpp"

namespace weft::bench {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;  // rad

/// How far to go from `from`, forwards or backwards (`direction` is 1 or -1), until the curve is `distance`
/// [m] away from `start`. The curve begins nearer than that, and leaves it once.
template <class Curve>
double go(const Curve& curve, const Vec3d& start, double from, double direction, double distance) {
  double near = 0, far = 2 * distance;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (near + far);
    (length(curve(from + direction * middle) - start) < distance ? near : far) = middle;
  }
  return from + direction * near;
}

}  // namespace

Folds even_folds(double size, double gap, std::uint32_t layer_count, double part) {
  return {gap, std::vector<double>(layer_count, part * size / layer_count)};
}

Folds crumpled_folds(double size, double gap, std::uint32_t layer_count, double part, std::uint64_t seed) {
  Random random(seed);
  Folds folds{gap};
  for (std::uint32_t k = 0; k < layer_count; ++k)
    folds.layers.push_back(random.uniform(0.5, 1.5) * part * size / layer_count);
  folds.slope = 1.5;
  folds.wave_length = 0.15 * size;
  folds.phase = random.uniform(0, kTurn);
  return folds;
}

std::vector<Vec3d> fold_profile(std::uint32_t count, double spacing, const Folds& folds) {
  const double wave = kTurn / folds.wave_length, height = folds.slope / wave;
  const auto layer_at = [&](std::size_t layer) {
    return [&, layer](double x) {
      return Vec3d{x, static_cast<double>(layer) * folds.gap + height * turn_of(wave * x + folds.phase).sine,
                   0};
    };
  };
  std::size_t layer = 0;
  double x = 0, direction = 1, gone = 0;
  std::vector<Vec3d> places = {layer_at(0)(0)};
  while (places.size() < count) {
    gone += spacing;
    const bool turns = layer + 1 < folds.layers.size() && gone > folds.layers[layer];
    if (turns) {
      ++layer;
      gone = 0;
    }
    x = go(layer_at(layer), places.back(), x, direction, spacing);
    places.push_back(layer_at(layer)(x));
    if (turns) direction = -direction;
  }
  return places;
}

std::vector<Vec3d> fold_column(std::uint32_t count, double spacing, double slope, std::uint64_t seed) {
  Random random(seed);
  const double across = kTurn * random.uniform(2, 4), up = kTurn * random.uniform(2, 4);  // rad/m
  const double phase_x = random.uniform(0, kTurn), phase_y = random.uniform(0, kTurn);
  const auto line = [&](double z) {
    return Vec3d{slope / across * turn_of(across * z + phase_x).sine,
                 slope / up * turn_of(up * z + phase_y).sine, z};
  };
  double z = 0;
  std::vector<Vec3d> places = {line(0)};
  while (places.size() < count) {
    z = go(line, places.back(), z, 1, spacing);
    places.push_back(line(z));
  }
  return places;
}

}  // namespace weft::bench
