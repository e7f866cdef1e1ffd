// A heavy strip that is clamped at one end, against the elastica.
#include "sheets.hpp"

using namespace weft;

namespace {

/// How far the end of a clamped rod of length 1 hangs down: θ'' + G (1 - s) cos θ = 0, θ(0) = 0, θ'(1) = 0, by shooting
/// for θ'(0) (Bickley 1934, The Heavy Elastica).
double elastica_drop(double g) {
  constexpr int kSteps = 20000;
  double drop = 0;
  const auto end_curvature = [&](double first) {
    double angle = 0, curvature = first;
    drop = 0;
    for (int k = 0; k < kSteps; ++k) {  // the midpoint rule
      const double h = 1.0 / kSteps, s = k * h;
      const double middle = angle + 0.5 * h * curvature;
      const double middle_curvature = curvature - 0.5 * h * g * (1 - s) * std::cos(angle);
      drop += h * std::sin(middle);
      angle += h * middle_curvature;
      curvature -= h * g * (1 - s - 0.5 * h) * std::cos(middle);
    }
    return curvature;
  };
  double low = 0, high = g;  // the curvature at the clamp is that of the moment of the weight, at most G / 2
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (end_curvature(middle) < 0 ? low : high) = middle;
  }
  return drop;
}

struct Hanging {
  double drop = 0;  // of the end, by the length
  std::uint32_t iterations = 0;
  double residual = 0;
};

/// A strip of 80 by 4 cells, its first two columns pinned, after 5 s in 8 substeps a frame, which bring it to rest.
Hanging hang(double g) {
  constexpr std::uint32_t kCells = 80, kRows = 5, kColumns = kCells + 2;
  constexpr double kLength = 0.5, kDensity = 0.2, kSpacing = kLength / kCells;
  const double bending = kDensity * 9.81 * kLength * kLength * kLength / g;
  std::string second;
  for (std::uint32_t j = 0; j < kRows; ++j) second += (j > 0 ? ", " : "") + std::to_string(j * kColumns + 1);
  Sheet strip(R"("cloths": [{"grid": [82, 5], "size": [)" + std::to_string(kLength + kSpacing) + ", " +
              std::to_string(kSpacing * (kRows - 1)) + R"(], "plane": "xz", "density": 0.2, "damping": 0.01,
              "stiffness": {"structural": 2000, "shear": 500, "bend": 0, "bending": )" +
              std::to_string(bending) + R"(}, "pins": ["left", {"nodes": [)" + second + "]}]}]");
  strip.system.drag = 3;
  constexpr std::size_t kEnd = kRows / 2 * kColumns + kColumns - 1;
  const double start = strip.system.position[kEnd].y;
  Hanging found;
  for (int step = 0; step < 300 * 8; ++step) {
    strip.advance(1.0 / 480, 1);
    found.iterations = std::max(found.iterations, strip.stepper.iterations());
    found.residual = std::max(found.residual, strip.stepper.residual());
  }
  found.drop = (start - strip.system.position[kEnd].y) / kLength;
  return found;
}

}  // namespace

TEST_CASE("a heavy strip clamped at one end hangs as the elastica does, in 8 substeps") {
  CHECK(std::abs(elastica_drop(1e-3) / (1e-3 / 8) - 1) < 1e-4);  // a beam: g / 8
  for (const double g : {5.0, 20.0, 100.0}) {
    CAPTURE(g);
    const Hanging strip = hang(g);
    MESSAGE("G = ", g, ": ", strip.drop, ", elastica ", elastica_drop(g), "; at most ", strip.iterations,
            " iterations");
    CHECK(std::abs(strip.drop / elastica_drop(g) - 1) < 0.02);
    CHECK(strip.residual <= scene::Solver{}.residual);
  }
}
