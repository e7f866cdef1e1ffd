// The measure of detail, on shapes whose normals, lengths and energies are known.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "bench/sheet_errors.hpp"
#include "bench/upsample.hpp"
#include "mesh/primitives.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

/// A flat sheet of 2 m with two clips, as scenes/sheet.json has it.
Model make_sheet(std::uint32_t nx, std::uint32_t ny, double clip) {
  const auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"}, "contact": {"method": "none"},
      "cloths": [{"grid": [)" +
          std::to_string(nx) + ", " + std::to_string(ny) +
          R"(], "size": [2, 2], "plane": "xz", "density": 0.15,
      "stiffness": {"structural": 1500, "shear": 750, "bend": 0}, "pins": [
        {"near": {"point": [-1, 0, -1], "radius": )" +
          std::to_string(clip) + R"(}}, {"near": {"point": [1, 0, -1], "radius": )" + std::to_string(clip) +
          "}}]}]}",
      "test");
  REQUIRE_MESSAGE(scene, (scene ? "" : scene.error().message));
  auto model = build_model(*scene, {{}});
  REQUIRE_MESSAGE(model, (model ? "" : model.error().message));
  return std::move(*model);
}

template <class Map>
std::vector<Vec3d> mapped(const std::vector<Vec3d>& points, const Map& map) {
  std::vector<Vec3d> result;
  for (const Vec3d& p : points) result.push_back(map(p));
  return result;
}

/// About the axis of x.
Vec3d rotated(const Vec3d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x, c * p.y - s * p.z, s * p.y + c * p.z};
}

Vec3d affine(const Vec3d& p) {
  return {0.9 * p.x + 0.2 * p.z + 0.3, 0.5 * p.x - 1.1 * p.z - 0.7, 0.4 * p.x + 1.3 * p.z};
}

double largest_distance(const std::vector<Vec3d>& a, const std::vector<Vec3d>& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, length(a[k] - b[k]));
  return largest;
}

/// How far a coarse sheet's drawing by 129 x 129 nodes is from the smooth shape that both have, within the
/// part of the sheet where |x| and |z| are at most `reach`.
template <class Map>
double drawing_error(std::uint32_t coarse_side, double reach, const Map& map) {
  const Model coarse = make_sheet(coarse_side, coarse_side, 0.05), fine = make_sheet(129, 129, 0.05);
  const bench::SheetShape shape{1, mapped(coarse.rest_position, map), 2};
  const bench::SheetShape drawn = bench::upsampled(coarse, shape, fine);
  CHECK(drawn.time == 1);
  CHECK(drawn.kinetic_energy == 2);
  double largest = 0;
  for (std::size_t k = 0; k < drawn.position.size(); ++k) {
    const Vec3d& rest = fine.rest_position[k];
    if (std::abs(rest.x) > reach || std::abs(rest.z) > reach) continue;
    largest = std::max(largest, length(drawn.position[k] - map(rest)));
  }
  return largest;
}

}  // namespace

TEST_CASE("normals of a sheet that is turned differ by the angle, however small it is") {
  const Model sheet = make_sheet(12, 9, 0.05);
  for (const double angle : {1e-9, 0.01, 0.5, 2.0}) {
    const auto turned = mapped(sheet.rest_position, [&](const Vec3d& p) { return rotated(p, angle); });
    const double found = bench::mean_normal_angle(turned, sheet.rest_position, sheet.triangles);  // degrees
    CHECK(found * std::numbers::pi / 180 / angle == doctest::Approx(1).epsilon(1e-6).scale(0));
  }
  const std::vector<Vec3d> crushed(sheet.vertex_count());  // to a point, where nothing has a normal
  CHECK(bench::mean_normal_angle(crushed, sheet.rest_position, sheet.triangles) == doctest::Approx(90));
}

TEST_CASE(
    "normals of half a sheet that is turned differ by half the angle in the mean, and by its mean at the "
    "fold") {
  const Model sheet = make_sheet(5, 9, 0.05);  // folded along z = 0, five of its 45 nodes
  const double angle = 0.6;
  const auto folded =
      mapped(sheet.rest_position, [&](const Vec3d& p) { return p.z > 0 ? rotated(p, angle) : p; });
  CHECK(bench::mean_normal_angle(folded, sheet.rest_position, sheet.triangles) ==
        doctest::Approx((20 * angle + 5 * angle / 2) / 45 * 180 / std::numbers::pi).epsilon(0.02).scale(0));
}

TEST_CASE("normals of a sphere point away from its middle, the better the finer it is") {
  double before = 1;  // [rad]
  for (const int rows : {12, 24, 48}) {
    const mesh::TriangleMesh sphere = mesh::make_sphere(2 * rows, rows);
    std::vector<Vec3d> x;
    for (const Vec3f& p : sphere.positions) x.push_back(p.to<double>());
    const std::vector<Vec3d> normals = bench::vertex_normals(x, sphere.triangles);
    double worst = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      CHECK(length(normals[k]) == doctest::Approx(1));
      worst = std::max(worst, std::acos(std::min(1.0, dot(normals[k], x[k]) / length(x[k]))));
    }
    CAPTURE(rows);
    CHECK(worst < before / 1.9);
    before = worst;
  }
  CHECK(before < 0.02);
}

TEST_CASE("a normal is the mean of those around it, weighted by area") {
  const std::vector<Vec3d> x = {
      {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 3, 0}};  // an L of two triangles at the axis of x
  const std::vector<mesh::Triangle> triangles = {{0, 2, 1}, {0, 1, 3}};  // ½ m² facing y, 1½ m² facing z
  const std::vector<Vec3d> normals = bench::vertex_normals(x, triangles);
  CHECK(length(normals[0] - Vec3d{0, 1, 3} / std::sqrt(10.0)) < 1e-15);
  CHECK(length(normals[1] - normals[0]) < 1e-15);
  CHECK(normals[2] == Vec3d{0, 1, 0});
  CHECK(normals[3] == Vec3d{0, 0, 1});
}

TEST_CASE("the error of positions is that of the way from the start") {
  const Model sheet = make_sheet(7, 7, 0.05);
  const auto reference = mapped(sheet.rest_position, affine);
  const auto ahead = mapped(sheet.rest_position, [&](const Vec3d& p) { return p + 1.03 * (affine(p) - p); });
  CHECK(bench::position_error(ahead, reference, sheet.rest_position) == doctest::Approx(0.03));
  CHECK(bench::position_error(reference, reference, sheet.rest_position) == 0);
}

TEST_CASE(
    "the free sides go from the last node of a clip to the corner, and their stretch is that of their "
    "length") {
  const Model sheet = make_sheet(9, 9, 0.3);  // nodes are 0.25 m apart: a clip holds three
  const std::vector<bench::Chain> sides = bench::free_sides(sheet, sheet.bodies[0]);
  CHECK(sides ==
        std::vector<bench::Chain>{{9, 18, 27, 36, 45, 54, 63, 72}, {17, 26, 35, 44, 53, 62, 71, 80}});
  const auto longer = mapped(sheet.rest_position, [](const Vec3d& p) {
    return Vec3d{2 * p.x, p.y, 1.2 * p.z};
  });
  CHECK(bench::stretch_of(sides, longer, sheet.rest_position) == doctest::Approx(0.2));
  std::vector<Vec3d> one = sheet.rest_position;
  one[0].z -= 1;  // pinned: no part of a free side
  CHECK(bench::stretch_of(sides, one, sheet.rest_position) == 0);
  one[80].z += 0.35;  // one side of 1.75 m
  CHECK(bench::stretch_of(sides, one, sheet.rest_position) == doctest::Approx(0.1));
}

TEST_CASE("a sheet that moves as a whole has the energy of its mass") {
  const Model sheet = make_sheet(9, 6, 0.05);
  const std::vector<Vec4f> velocity(sheet.vertex_count(), Vec4f{1, -2, 2, 1});  // w is no part of it
  CHECK(bench::kinetic_energy(sheet.mass, velocity) ==
        doctest::Approx(0.15 * 4 * 9 / 2));  // ½ · 0.6 kg · 9 m²/s²
}

TEST_CASE("a coarse sheet drawn finely keeps affine maps, whatever the grids") {
  const Model fine = make_sheet(23, 12, 0.05);
  for (const auto& [nx, ny] : {std::pair{2U, 2U}, {3U, 2U}, {7U, 12U}, {10U, 5U}}) {
    const Model coarse = make_sheet(nx, ny, 0.05);
    const auto drawn =
        bench::upsample(*coarse.bodies[0].grid, coarse.rest_position, mapped(coarse.rest_position, affine),
                        *fine.bodies[0].grid, fine.rest_position);
    CHECK(largest_distance(drawn, mapped(fine.rest_position, affine)) < 1e-14);
  }
}

TEST_CASE("a coarse sheet drawn finely goes through its nodes, and is smooth between them") {
  const auto wavy = [](const Vec3d& p) {
    return p + Vec3d{0, 0.1 * std::sin(3 * p.x) * std::cos(2 * p.z), 0};
  };
  const Model coarse = make_sheet(5, 5, 0.05), fine = make_sheet(9, 9, 0.05);
  const auto places = mapped(coarse.rest_position, wavy);
  const auto drawn = bench::upsample(*coarse.bodies[0].grid, coarse.rest_position, places,
                                     *fine.bodies[0].grid, fine.rest_position);
  for (std::uint32_t j = 0; j < 5; ++j)
    for (std::uint32_t i = 0; i < 5; ++i) CHECK(length(drawn[2 * j * 9 + 2 * i] - places[j * 5 + i]) < 1e-15);
  const auto bowl = [](const Vec3d& p) { return p + Vec3d{0, p.x * p.x + p.x * p.z - 2 * p.z * p.z, 0}; };
  CHECK(drawing_error(9, 0.75, bowl) < 1e-14);  // a cell away from the boundary parabolas are kept
  CHECK(drawing_error(17, 0.75, wavy) < drawing_error(9, 0.75, wavy) / 7);  // third order
  CHECK(drawing_error(17, 1, wavy) < drawing_error(9, 1, wavy) / 3.5);      // second at the boundary
}

TEST_CASE("the errors of a sheet stand beside its reference at the same times") {
  const Model sheet = make_sheet(6, 6, 0.05);
  const auto at = [&](double time, double drop, double energy) {
    return bench::SheetShape{time,
                             mapped(sheet.rest_position,
                                    [&](const Vec3d& p) {
                                      return Vec3d{p.x, -drop, p.z * (1 + drop)};
                                    }),
                             energy};
  };
  const std::vector<bench::SheetShape> reference = {at(0.25, 0.1, 1), at(0.5, 0.2, 2)};
  const std::vector<bench::SheetShape> shapes = {at(0.25, 0.1, 1.5), at(0.5, 0.3, 1)};
  const auto errors = bench::sheet_errors(sheet, shapes, reference);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0].time == 0.25);
  CHECK(errors[0].position == 0);
  CHECK(errors[0].kinetic_energy == 1.5);
  CHECK(errors[0].kinetic_energy_reference == 1);
  CHECK(errors[1].time == 0.5);
  CHECK(errors[1].position == doctest::Approx(0.5));
  CHECK(errors[1].normal_degrees == doctest::Approx(0));
  CHECK(errors[1].edge_stretch == doctest::Approx(0.3));
  CHECK(errors[1].edge_stretch_reference == doctest::Approx(0.2));
}
