// The start positions of `weft bench contact`: nothing crosses, and sheets keep their size.
#include <doctest/doctest.h>

#include <cmath>

#include "bench/folds.hpp"
#include "bench/round_object.hpp"
#include "contact/reference/proximity/audit.hpp"
#include "mesh/grid.hpp"

using namespace weft;

namespace {

/// A sheet of 1 m in these folds.
struct Folded {
  std::uint32_t side;
  std::vector<Vec3d> row, column, places;

  Folded(std::uint32_t side_, const bench::Folds& folds, double sway) : side(side_) {
    row = bench::fold_profile(side, 1.0 / (side - 1), folds);
    column = bench::fold_column(side, 1.0 / (side - 1), sway, 1);
    for (const Vec3d& along : column)
      for (const Vec3d& across : row) places.push_back(across + along);
  }
  std::size_t crossings() const {
    const std::vector<Vec3d> rounded = reference::rounded_to_f32(places);
    return reference::self_crossings({rounded, mesh::grid_triangles({side, side, 1, 1})}).size();
  }
};

double largest_error(const std::vector<Vec3d>& places, double spacing) {
  double error = 0;
  for (std::size_t i = 1; i < places.size(); ++i)
    error = std::max(error, std::abs(length(places[i] - places[i - 1]) - spacing));
  return error;
}

}  // namespace

TEST_CASE("folded and crumpled sheets of any size do not cross themselves, and keep their edges' lengths") {
  for (const std::uint32_t side : {32U, 70U, 100U})
    for (const double part : {0.125, 0.5, 1.0}) {
      CAPTURE(side);
      CAPTURE(part);
      const double spacing = 1.0 / (side - 1), gap = 0.35 * spacing;  // about half the shortest altitude
      for (const Folded& sheet : {Folded(side, bench::even_folds(1, gap, 8, part), 0),
                                  Folded(side, bench::crumpled_folds(1, 1.7 * gap, 8, part, 1), 0.1)}) {
        CHECK(largest_error(sheet.row, spacing) < 1e-12);
        CHECK(largest_error(sheet.column, spacing) < 1e-12);
        CHECK(sheet.crossings() == 0);
      }
    }
}

TEST_CASE("the layers of a folded sheet lie upon each other, a gap apart") {
  const double gap = 0.003;
  const Folded sheet(100, bench::even_folds(1, gap, 8, 1), 0);
  const double least = reference::least_self_distance({sheet.places, mesh::grid_triangles({100, 100, 1, 1})});
  CHECK(least < (1 + 1e-9) * gap);
  CHECK(least > 0.95 * gap);  // a step to the next layer goes up by the angle whose sine is gap / spacing
  Vec3d low = sheet.places[0], high = low;
  for (const Vec3d& p : sheet.places) {
    low = min(low, p);
    high = max(high, p);
  }
  CHECK(high.y - low.y == doctest::Approx(7 * gap));
  CHECK(high.x - low.x < 1.0 / 8 + 2.0 / 99);  // a layer, and the steps at its ends
  CHECK(high.z - low.z == doctest::Approx(1));
}

TEST_CASE("a round object has the triangles that are asked for, and its sheet lies above it") {
  for (const std::uint32_t count : {3000U, 20000U}) {
    const mesh::TriangleMesh object = bench::make_round_object(count);
    CHECK(std::abs(static_cast<double>(object.triangles.size()) / count - 1) < 0.02);
    REQUIRE(mesh::check_mesh(object));
    const mesh::TriangleMesh sheet = bench::make_round_sheet(40, 1, 0.003);
    const std::vector<Vec3d> places = reference::widened(sheet.positions),
                             corners = reference::widened(object.positions);
    CHECK(reference::crossings({places, sheet.triangles}, {corners, object.triangles}).empty());
    CHECK(reference::inside_mesh(places, object).count == 0);
  }
}
