// How long tethers are: never shorter than the way along the sheet, and not much longer.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "mesh/primitives.hpp"
#include "model/tethers.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Model model_of(const std::string& cloth, const mesh::TriangleMesh& mesh = {}) {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "cloths": [{"density": 0.2, )" + cloth + "}]}", "a.json");
  REQUIRE_MESSAGE(static_cast<bool>(scene), scene.error().message);
  auto model = build_model(*scene, {mesh});
  REQUIRE_MESSAGE(static_cast<bool>(model), model.error().message);
  return std::move(*model);
}

/// A flat grid as a mesh, in the plane of x and z, with one diagonal a cell, from (0, 0).
mesh::TriangleMesh flat_mesh(std::uint32_t n, float cell) {
  mesh::TriangleMesh made;
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i)
      made.positions.push_back({cell * static_cast<float>(i), 0, cell * static_cast<float>(j)});
  for (std::uint32_t j = 0; j + 1 < n; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = a + n, d = c + 1;
      made.triangles.push_back({a, c, d});
      made.triangles.push_back({a, d, b});
    }
  return made;
}

}  // namespace

TEST_CASE("a grid's tethers are straight, one to the nearest node of each island, longer by the slack") {
  const Model model = model_of(R"("grid": [9, 7], "size": [0.8, 0.6], "pins": ["top", "bottom_left"],
      "tethers": {"slack": 0.05})");
  const TetherRows rows = tethers_of(model);
  for (std::uint32_t v = 0; v < 63; ++v) {
    const std::uint32_t i = v % 9, j = v / 9, count = rows.starts[v + 1] - rows.starts[v];
    if (model.kinematic(v)) {
      CHECK(count == 0);
      continue;
    }
    REQUIRE(count == 2);
    for (std::uint32_t k = rows.starts[v]; k < rows.starts[v + 1]; ++k) {
      const Tether& tether = rows.tethers[k];
      const bool up = tether.to < 9;
      CHECK(tether.to == (up ? i : 54));  // the one above it, or the corner
      const double way = up ? 0.1 * j : 0.1 * std::hypot(i, 6.0 - j);
      CHECK(tether.length == doctest::Approx(1.05 * way).epsilon(2e-6).scale(0));
      CHECK(tether.length >= 1.05 * length(model.rest_position[v] - model.rest_position[tether.to]));
    }
  }
}

TEST_CASE("a cloth without tethers has none, and copies have their own") {
  CHECK_FALSE(tethers_of(model_of(R"("grid": [5, 5], "size": [1, 1], "pins": ["top"])")).any());
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [{"density": 0.2, "grid": [4, 4],
      "size": [1, 1], "pins": ["top"], "tethers": {}, "copies": {"count": 2, "offset": [0, 0, 1]}}]})",
                                  "a.json");
  REQUIRE(scene);
  const auto model = build_model(*scene, {{}, {}});
  REQUIRE(model);
  const TetherRows rows = tethers_of(*model);
  REQUIRE(rows.tethers.size() == 24);
  for (std::size_t k = 0; k < 12; ++k) CHECK(rows.tethers[12 + k].to == rows.tethers[k].to + 16);
}

TEST_CASE("a mesh's tethers are never shorter than the way along it, and at most 8.3 % longer in the plane") {
  constexpr std::uint32_t kNodes = 12;
  const TetherRows rows = tethers_of(
      model_of(R"("mesh": "m", "pins": [{"nodes": [0]}], "tethers": {})", flat_mesh(kNodes, 0.05F)));
  double most = 0;
  for (std::uint32_t v = 1; v < kNodes * kNodes; ++v) {
    REQUIRE(rows.starts[v + 1] - rows.starts[v] == 1);
    const double straight = 0.05 * std::hypot(v % kNodes, v / kNodes);
    const double by = rows.tethers[rows.starts[v]].length / straight;
    CHECK(by > 1 - 1e-7);
    most = std::max(most, by);
  }
  // Ways go along 0°, 27°, 45°, 63° and 90° here; between the last two but one quarter turn 45° apart elsewhere.
  CHECK(most < 1 / std::cos(std::acos(-1.0) / 8) + 1e-5);
  // Along a sphere they are never shorter than the arc of its skin's chords, nor longer than along the edges.
  const Model ball =
      model_of(R"("mesh": "m", "pins": [{"nodes": [0]}], "tethers": {})", mesh::make_sphere(24, 17));
  const TetherRows around = tethers_of(ball);
  for (std::uint32_t v = 1; v < ball.vertex_count(); ++v) {
    REQUIRE(around.starts[v + 1] - around.starts[v] == 1);
    const double chord = length(ball.rest_position[v] - ball.rest_position[0]),
                 radius = length(ball.rest_position[0]);
    const double arc = 2 * radius * std::asin(std::min(1.0, chord / (2 * radius)));
    CHECK(around.tethers[around.starts[v]].length > chord);
    CHECK(around.tethers[around.starts[v]].length < 1.09 * arc);
  }
}

TEST_CASE("no node has more than four tethers, to the islands that are nearest") {
  const Model model = model_of(R"("grid": [21, 3], "size": [2, 0.2],
      "pins": [{"nodes": [0]}, {"nodes": [4]}, {"nodes": [8]}, {"nodes": [12]}, {"nodes": [16]}, {"nodes": [20]}],
      "tethers": {})");
  const TetherRows rows = tethers_of(model);
  const std::uint32_t v = 21 + 9;  // below the tenth of the upper row
  REQUIRE(rows.starts[v + 1] - rows.starts[v] == kMostTethers);
  std::vector<std::uint32_t> to;
  for (std::uint32_t k = rows.starts[v]; k < rows.starts[v + 1]; ++k) to.push_back(rows.tethers[k].to);
  CHECK(to == std::vector<std::uint32_t>{4, 8, 12, 16});
}

TEST_CASE("a turned cloth far away has the tethers of the same cloth at the origin, in the same order") {
  const std::string sheet =
      R"("grid": [9, 9], "size": [0.4, 0.4], "pins": ["top_left", "top_right"], "tethers": {})";
  const TetherRows here = tethers_of(model_of(sheet));
  for (const char* transform : {R"({"rotate": [0, 0.5, 0, 0.866]})",
                                R"({"rotate": [0.1, 0.2, 0.3, 0.9274], "translate": [10, 3, -7]})"}) {
    CAPTURE(transform);
    const TetherRows there = tethers_of(model_of(sheet + R"(, "transform": )" + transform));
    REQUIRE(there.tethers.size() == here.tethers.size());
    for (std::size_t k = 0; k < here.tethers.size(); ++k) {
      CHECK(there.tethers[k].to == here.tethers[k].to);
      CHECK(there.tethers[k].length == doctest::Approx(here.tethers[k].length).epsilon(1e-5).scale(0));
    }
  }
}
