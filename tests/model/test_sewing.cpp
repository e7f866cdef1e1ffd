// What seams are made of, and what a sewn model resists with, against cloth that was never cut.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "mesh/lumped.hpp"
#include "mesh/sides.hpp"
#include "method/mass_spring/reference/mass_spring.hpp"
#include "method/method.hpp"
#include "model/attachments.hpp"
#include "model/cloth_size.hpp"
#include "model/fabric.hpp"
#include "model/limited_edges.hpp"
#include "model/sewing.hpp"
#include "reference/simulation.hpp"
#include "scene/load.hpp"

using namespace weft;

namespace {

Result<Model> model_of(const std::string& cloth) {
  WEFT_TRY(scene,
           scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [{)" + cloth + "}]}", "test.json"));
  WEFT_TRY(assets, load_assets(scene, "models"));
  return build_model(scene, assets);
}
Model built(const std::string& cloth) {
  auto model = model_of(cloth);
  REQUIRE_MESSAGE(model, model.error().message);
  return std::move(*model);
}
std::string refusal(const std::string& cloth) {
  const auto model = model_of(cloth);
  return model ? "" : model.error().message;
}

/// Of the method that a scene names.
std::string method_refusal(const std::string& cloth, const std::string& kind) {
  auto scene = scene::parse_scene(
      R"({"format": "weft-scene/1", "solver": {"kind": ")" + kind + R"("}, "cloths": [{)" + cloth + "}]}",
      "test.json");
  REQUIRE(scene);
  const auto chosen = choose_method(*scene, built(cloth));
  return chosen ? "" : chosen.error().message;
}

Sewing all_sewn(const Model& model) {
  Sewing sewing;
  sewing.cloths.resize(1);
  for (const CutSeam& seam : model.bodies[0].pattern->seams)
    sewing.cloths[0].pairs.resize(sewing.cloths[0].pairs.size() + seam.pairs.size(), Sewing::kSewn);
  return sewing;
}
Model sewn(const std::string& cloth) {
  const Model model = built(cloth);
  auto made = sewn_model(model, all_sewn(model));
  REQUIRE_MESSAGE(made, made.error().message);
  return std::move(*made);
}

const std::string kSprings =
    R"("density": 0.2, "stiffness": {"structural": 900, "shear": 300, "bend": 40}, "damping": 0.1)";

/// Halves of a sheet of 0.2 by 0.1 m, 20 mm apart, and what joins them.
const std::string kHalves = R"("panels": [
    {"grid": [11, 11], "size": [0.1, 0.1], "transform": {"translate": [-0.05, 0, 0]}},
    {"grid": [11, 11], "size": [0.1, 0.1], "transform": {"translate": [0.07, 0, 0]}}],
  "seams": [{"first": {"panel": 0, "nodes": "right"}, "second": {"panel": 1, "nodes": "left"}}], )" +
                            kSprings;

/// The springs of a sheet, by the columns and rows of their ends on it.
using Row = std::tuple<long, long, long, long, long, long, long>;
std::vector<Row> rows_of(const Model& model, const std::vector<Vec3d>& place) {
  std::vector<Row> rows;
  const auto cell = [](double length) { return std::lround(length * 100); };
  for (const Spring s : model.springs()) {
    Vec3d a = place[s.node_a], b = place[s.node_b];
    if (std::pair(cell(b.x), cell(b.y)) < std::pair(cell(a.x), cell(a.y))) std::swap(a, b);
    rows.emplace_back(cell(a.x), cell(a.y), cell(b.x), cell(b.y), std::lround(1e6 * s.rest_length),
                      std::lround(10 * s.stiffness), std::lround(1e4 * s.damping));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

TEST_CASE("a sheet that is sewn of two halves has the springs and the masses of one that was never cut") {
  const Model model = sewn(kHalves);
  Model whole = built(R"("grid": [21, 11], "size": [0.2, 0.1], "strength": 1e6, )" + kSprings);
  REQUIRE(model.vertex_count() == whole.vertex_count());
  std::vector<Vec3d> places(model.vertex_count());
  const CutPattern& pattern = *model.bodies[0].pattern;
  for (std::size_t node = 0; node < pattern.node.size(); ++node)
    places[pattern.node[node]] = pattern.position[node] - (node < 121 ? Vec3d{} : Vec3d{0.02, 0, 0});
  CHECK(rows_of(model, places) == rows_of(whole, whole.rest_position));
  const std::vector<double> areas =
      mesh::vertex_areas(cloth_mesh(whole, whole.bodies[0]));  // panels are meshes
  std::size_t found = 0;
  for (std::size_t node = 0; node < places.size(); ++node)
    for (std::size_t other = 0; other < places.size(); ++other) {
      if (length(places[node] - whole.rest_position[other]) > 1e-6) continue;
      ++found;
      CHECK(model.mass[node] == doctest::Approx(0.2 * areas[other]).epsilon(1e-6));
    }
  CHECK(found == places.size());
  CHECK(area_of(model, model.bodies[0]) == doctest::Approx(0.02).epsilon(1e-6));
}

TEST_CASE(
    "a tube that is sewn from a sheet is at rest as wide as the sheet, and stretches as the sheet does") {
  constexpr double kWidth = 0.3, kHeight = 0.1;
  const std::string cut = R"("grid": [61, 21], "size": [0.3, 0.1], "density": 0.2,
    "stiffness": {"structural": 900, "shear": 300, "bend": 0})";
  const Model tube = sewn(cut + R"(, "seams": [{"first": {"nodes": "left"}, "second": {"nodes": "right"}}])");
  CHECK(tube.vertex_count() == 60 * 21);
  const Model sheet = built(cut);
  const CutPattern& pattern = *tube.bodies[0].pattern;
  const auto energy = [](const Model& model, std::vector<Vec3d> places) {
    reference::MassSpringSystem system = reference::elements_of(model);
    system.velocity.assign(model.vertex_count(), {});
    system.position = std::move(places);
    return reference::energies(system).springs;
  };
  const double edge = 2 * 30 * std::sin(M_PI / 60) / M_PI;  // of the polygon, by its circle's diameter
  const auto of_tube = [&](double strain) {
    std::vector<Vec3d> places(tube.vertex_count());
    for (std::size_t node = 0; node < pattern.node.size(); ++node) {
      const double angle = 2 * M_PI * (pattern.position[node].x / kWidth),
                   radius = (1 + strain) * kWidth / (2 * M_PI) / edge;
      places[pattern.node[node]] = {radius * std::cos(angle), pattern.position[node].y,
                                    radius * std::sin(angle)};
    }
    return energy(tube, places);
  };
  const auto of_sheet = [&](double strain) {
    std::vector<Vec3d> places = sheet.rest_position;
    for (Vec3d& place : places) place.x *= 1 + strain;
    return energy(sheet, places);
  };
  CHECK(of_tube(0) < 1e-9);
  for (const double strain : {0.01, 0.05}) {
    CAPTURE(strain);
    CHECK(of_tube(strain) == doctest::Approx(of_sheet(strain)).epsilon(0.01));
  }
  CHECK(area_of(tube, tube.bodies[0]) == doctest::Approx(kWidth * kHeight).epsilon(1e-6));
}

namespace {

const std::string kFabric =
    R"("density": 0.2, "fabric": {"warp": 900, "weft": 500, "shear": 120, "poisson": 0.2,
    "bending_warp": 2e-4, "bending_weft": 1e-4, "bending_twist": 5e-5})";

reference::EnergySums energies_at(const Model& model, std::vector<Vec3d> places) {
  reference::MassSpringSystem system = reference::elements_of(model);
  system.velocity.assign(model.vertex_count(), {});
  system.position = std::move(places);
  return reference::energies(system);
}

/// What a sewn model is moved to: of each node by where the first of its parts was cut.
template <class Place>
std::vector<Vec3d> placed(const Model& model, const Place& place) {
  const CutPattern& pattern = *model.bodies[0].pattern;
  std::vector<Vec3d> places(model.vertex_count());
  for (std::size_t node = pattern.node.size(); node-- > 0;)
    places[pattern.node[node]] = place(pattern.position[node], node);
  return places;
}

}  // namespace

TEST_CASE(
    "fabric that is sewn of two halves resists as fabric that was never cut, stretched, sheared and bent") {
  const std::string halves = kHalves.substr(0, kHalves.find(kSprings)) + kFabric;
  const Model model = sewn(halves);
  const Model whole = built(R"("grid": [21, 11], "size": [0.2, 0.1], "strength": 1e6, )" + kFabric);
  const auto wave = [](const Vec3d& p) {
    return Vec3d{1.02 * p.x + 0.05 * p.y, 0.97 * p.y + 0.01 * std::sin(30 * p.x),
                 0.02 * std::sin(20 * p.x + 15 * p.y)};
  };
  const reference::EnergySums own = energies_at(model, placed(model, [&](const Vec3d& p, std::size_t node) {
                                                  return wave(p - (node < 121 ? Vec3d{} : Vec3d{0.02, 0, 0}));
                                                }));
  std::vector<Vec3d> places = whole.rest_position;
  for (Vec3d& p : places) p = wave(p);
  const reference::EnergySums never_cut = energies_at(whole, places);
  CHECK(own.membranes > 1e-3);
  CHECK(own.membranes == doctest::Approx(never_cut.membranes).epsilon(1e-6));
  CHECK(own.bending > 1e-4);
  CHECK(own.bending == doctest::Approx(never_cut.bending).epsilon(1e-6));
}

TEST_CASE("each panel of fabric has its own warp, as it is turned") {
  // The second half lies a quarter turn off, so that its weft runs across the seam.
  const Model model = sewn(R"("panels": [{"grid": [11, 11], "size": [0.1, 0.1]},
      {"grid": [11, 11], "size": [0.1, 0.1], "transform":
        {"translate": [0.12, 0, 0], "rotate": [0, 0, 0.70710678, 0.70710678]}}],
    "seams": [{"first": {"panel": 0, "nodes": "right"}, "second": {"panel": 1, "nodes": "top"}}],
    "density": 0.2, "fabric": {"warp": 900, "weft": 100, "shear": 50, "bending_warp": 0})");
  CHECK(model.vertex_count() == 231);
  constexpr double kStrain = 0.01;
  const reference::EnergySums stretched =
      energies_at(model, placed(model, [&](const Vec3d& p, std::size_t node) {
                    const double x = p.x - (node < 121 ? 0 : 0.02);
                    return Vec3d{(1 + kStrain) * x, p.y, p.z};
                  }));
  CHECK(stretched.membranes == doctest::Approx((900 + 100) * 0.01 * kStrain * kStrain / 2).epsilon(1e-4));
}

TEST_CASE(
    "a tube sewn of fabric has the energy of its curvature, half of B by the square of its radius, at its "
    "seam too") {
  constexpr double kWidth = 0.3, kHeight = 0.1, kPi = 3.14159265358979323846;
  const Model tube = sewn(R"("grid": [91, 31], "size": [0.3, 0.1], )" + kFabric +
                          R"(, "seams": [{"first": {"nodes": "left"}, "second": {"nodes": "right"}}])");
  const double radius = kWidth / (2 * kPi);
  const auto round = [&](const Vec3d& p, std::size_t) {
    const double angle = p.x / radius;
    return Vec3d{radius * std::cos(angle), p.y, radius * std::sin(angle)};
  };
  const reference::EnergySums rolled = energies_at(tube, placed(tube, round));
  const double bending = 2e-4 / (radius * radius) * kWidth * kHeight / 2;
  CHECK(rolled.bending == doctest::Approx(bending).epsilon(0.01));
  CHECK(rolled.membranes < 0.01 * bending);
  std::size_t seam = 0;
  const hinge::Plate& plate = tube.plate(tube.bodies[0]);
  const FabricSheet sheet = fabric_sheet(tube, tube.bodies[0]);
  for (const hinge::Hinge& hinge : plate.hinges) {
    if (hinge::rest_corners(sheet.rest(), hinge)) continue;
    ++seam;
    CHECK(hinge.rest_angle == 0);
  }
  CHECK(seam == 30);
}

TEST_CASE(
    "the edges of what is sewn are as long at their strain limit as the sides that they were cut from") {
  for (const std::string& material : {kSprings, kFabric}) {
    CAPTURE(material);
    const Model tube = sewn(R"("grid": [61, 21], "size": [0.3, 0.1], "strain_limit": 0.1, )" + material +
                            R"(, "seams": [{"first": {"nodes": "left"}, "second": {"nodes": "right"}}])");
    for (const LimitedEdge& edge : limited_edges(tube)) {
      const double length = edge.longest / 1.1;  // of cells of 5 mm, and their diagonals
      CHECK((std::abs(length - 0.005) < 1e-6 || std::abs(length - 0.005 * std::sqrt(2.0)) < 1e-6));
    }
    CHECK(limited_edges(tube).size() == 60 * 21 + 60 * 20 * 2);
  }
}

TEST_CASE("rows that go all the way round are sewn from where they are nearest, however they begin") {
  const auto cushion = [](const std::string& back, const std::string& grid) {
    return built(
        R"("density": 0.2, "panels": [{"grid": [9, 9], "size": [0.4, 0.4]}, {"grid": )" + grid +
        R"(, "size": [0.4, 0.4], "transform": {"translate": [0, 0, -0.03], "rotate": )" + back +
        R"(}}], "seams": [{"first": {"nodes": "edges"}, "second": {"panel": 1, "nodes": "edges"}}])");
  };
  for (const char* back :
       {"[0, 1, 0, 0]", "[1, 0, 0, 0]", "[0, 0, 0, 1]", "[0, 0, 0.70710678, 0.70710678]"}) {
    CAPTURE(back);
    const Model model = cushion(back, "[9, 9]");
    const CutPattern& pattern = *model.bodies[0].pattern;
    REQUIRE(pattern.seams[0].pairs.size() == 32);
    for (const auto& [a, b] : pattern.seams[0].pairs)
      CHECK(length(pattern.position[a] - pattern.position[b]) == doctest::Approx(0.03).epsilon(1e-4));
    CHECK(sewn_model(model, all_sewn(model))->vertex_count() == 2 * 81 - 32);
    // Of fewer nodes it gets as many; its own meet those that are nearest by length.
    const Model eased = cushion(back, "[6, 6]");
    REQUIRE(eased.bodies[0].pattern->seams[0].pairs.size() == 32);
    for (const auto& [a, b] : eased.bodies[0].pattern->seams[0].pairs)
      CHECK(length(eased.bodies[0].pattern->position[a] - eased.bodies[0].pattern->position[b]) < 0.055);
  }
  const Model bag = built(R"("density": 0.2, "panels": [{"grid": [33, 9], "size": [1.6, 0.4]},
      {"grid": [9, 9], "size": [0.4, 0.4], "transform": {"translate": [0, -0.4, 0]}}],
    "seams": [{"first": {"nodes": "left"}, "second": {"nodes": "right"}},
              {"first": {"nodes": "bottom"}, "second": {"panel": 1, "nodes": "edges"}}])");
  REQUIRE(bag.bodies[0].pattern->seams[1].pairs.size() == 33);  // a row with two ends, which meet
  const Model closed = *sewn_model(bag, all_sewn(bag));
  CHECK(closed.vertex_count() == 33 * 9 + 81 - 9 - 32);
  std::size_t rim = 0;
  mesh::for_each_edge(mesh::sorted_sides(closed.triangles),
                      [&](std::span<const mesh::Side> sides) { rim += sides.size() == 1 ? 1 : 0; });
  CHECK(rim == 32);  // the bag's mouth alone
}

TEST_CASE(
    "threads pull no harder than their seam may, begin and end when it says, and their work is counted") {
  const std::string cloth = kHalves.substr(0, kHalves.find("}}],")) +
                            R"(}}], "seams": [{"first": {"panel": 0, "nodes": "right"},
      "second": {"panel": 1, "nodes": "left"}, "force": 30, "start": 0.5, "patience": 2}], )" +
                            kSprings;
  const Model model = built(cloth);
  const double most = 30 * 0.01;  // of a pair, by the 10 mm between pairs [N]
  std::vector<Vec3d> places = model.start_position;
  CHECK(sew(model, {}, places, 0.4, 0.1).sewing.sewn() == 0);
  const Sewn begun = sew(model, {}, places, 0.5, 0.1);
  auto pulled = sewn_model(model, begun.sewing);
  REQUIRE(pulled);
  const std::vector<Thread>& threads = pulled->bodies[0].pattern->threads;
  REQUIRE(threads.size() == 11);
  double work = 0;
  for (const Thread& thread : threads) {
    const double gap = length(places[thread.b] - places[thread.a]);
    CHECK(gap == doctest::Approx(0.02));
    CHECK(thread.stiffness * gap <= most);
    CHECK(thread.stiffness * gap > most / 2);
    CHECK(most / thread.damping <= 0.5);
    work += thread.stiffness * gap * gap / 2;
  }
  CHECK(begun.sewing.work == doctest::Approx(work).epsilon(1e-9));
  for (std::size_t node = 121; node < places.size(); ++node) places[node].x -= 0.02 - 0.99e-4;
  places[121].x += 1e-3;  // one pair is open
  const Sewn waits = sew(*pulled, begun.sewing, places, 2.4, 0.1);
  CHECK(waits.sewing.sewn() == 0);
  CHECK(waits.news.empty());
  const Sewn given_up = sew(*pulled, begun.sewing, places, 2.5, 0.1);
  CHECK(given_up.sewing.sewn() == 10);
  REQUIRE(given_up.news.size() == 1);
  CHECK(given_up.news[0].open == 1);
  CHECK(given_up.news[0].widest == doctest::Approx(1.099e-3));
  CHECK(sew(*pulled, begun.sewing, places, 2.7, 0.1).news.empty());
  places[121].x -= 1e-3;
  const Sewn closed = sew(*pulled, begun.sewing, places, 1, 0.1);
  CHECK(closed.sewing.sewn() == 11);
  REQUIRE(closed.news.size() == 1);
  CHECK(closed.news[0].open == 0);
}

TEST_CASE(
    "a row that has fewer nodes gets as many as the other one, where those are by length, and keeps its "
    "mass") {
  const std::string cloths = R"("panels": [{"grid": [4, 12], "size": [0.3, 0.33]},
      {"grid": [4, 5], "size": [0.3, 0.36], "transform": {"translate": [1, 0, 0]}}], "density": 0.2,
      "seams": [{"first": {"nodes": "right"}, "second": {"panel": 1, "nodes": "left"}}]}, {"grid": [3, 3],
      "size": [1, 1], "density": 1)";
  const Model model = built(cloths);
  const Body& body = model.bodies[0];
  const CutPattern& pattern = *body.pattern;
  CHECK(body.vertex_count == 4 * 12 + 4 * 5 + 7);
  CHECK(body.triangle_count == 2 * 3 * 11 + 2 * 3 * 4 + 7);
  CHECK(model.bodies[1].first_vertex == body.vertex_count);
  CHECK(mass_of(model, body) == doctest::Approx(0.2 * (0.3 * 0.33 + 0.3 * 0.36)).epsilon(1e-6));
  CHECK(mass_of(model, model.bodies[1]) == doctest::Approx(1).epsilon(1e-9));
  CHECK(area_of(model, body) == doctest::Approx(0.3 * 0.33 + 0.3 * 0.36).epsilon(1e-6));
  for (const mesh::Triangle& t : pattern.triangles) {
    const Vec3d &a = pattern.position[t[0]], &b = pattern.position[t[1]], &c = pattern.position[t[2]];
    CHECK(cross(b - a, c - a).z > 1e-4);
  }
  REQUIRE(pattern.seams[0].pairs.size() == 12);
  double before = 1;
  for (const auto& [a, b] : pattern.seams[0].pairs) {
    const double along = (pattern.position[a].y + 0.165) / 0.33,
                 other = (pattern.position[b].y + 0.18) / 0.36;
    CHECK(std::abs(along - other) < 0.5 / 11 + 1e-6);  // its own nodes go to the nearest
    CHECK(std::abs(other - before) > 1e-3);
    before = other;
  }
  const Model whole = sewn(R"("panels": [{"grid": [4, 12], "size": [0.3, 0.33]},
      {"grid": [4, 5], "size": [0.3, 0.36], "transform": {"translate": [1, 0, 0]}}], "density": 0.2,
      "seams": [{"first": {"nodes": "right"}, "second": {"panel": 1, "nodes": "left"}}])");
  CHECK(whole.vertex_count() == body.vertex_count - 12);
  // The edge of a seam that is eased has the mean of both lengths.
  double seam = 0;
  for (const Spring s : whole.springs()) {
    std::size_t ends = 0;
    for (const auto& [a, b] : pattern.seams[0].pairs)
      ends += (whole.bodies[0].pattern->node[a] == s.node_a) + (whole.bodies[0].pattern->node[a] == s.node_b);
    const std::vector<mesh::Triangle> triangles = own_triangles(whole, whole.bodies[0]);
    const auto has_both = [&](const mesh::Triangle& t) {
      return std::count(t.begin(), t.end(), s.node_a) + std::count(t.begin(), t.end(), s.node_b) == 2;
    };
    if (ends == 2 && std::any_of(triangles.begin(), triangles.end(), has_both)) seam += s.rest_length;
  }
  CHECK(seam == doctest::Approx((0.33 + 0.36) / 2).epsilon(1e-5));
}

TEST_CASE("seams that cannot be are refused, each in one sentence") {
  const auto halves = [](const std::string& first, const std::string& second, const std::string& more = "") {
    return refusal(R"("panels": [{"grid": [4, 5], "size": [0.3, 0.4]},
      {"grid": [4, 3], "size": [0.3, 0.2], "transform": {"translate": [1, 0, 0]}}], "density": 0.2,
      "seams": [{"first": {)" +
                   first + R"(}, "second": {)" + second + "}}]" + more);
  };
  CHECK(halves(R"("nodes": "top")", R"("panel": 1, "nodes": "bottom")").empty());
  CHECK(halves(R"("nodes": "left")", R"("panel": 1, "nodes": "top_left")") ==
        "test.json: cloths[0].seams[0] sews a row of 5 nodes to one of 1, which cannot have more: it is one "
        "node, or "
        "its edges have more in another seam.");
  CHECK(halves(R"("nodes": "corners")", R"("panel": 1, "nodes": "left")") ==
        "test.json: cloths[0].seams[0].first selects 4 runs of the rim, which begin at nodes 0 and 3; a row "
        "is one "
        "run.");
  CHECK(halves(R"("nodes": {"nodes": [5]})", R"("panel": 1, "nodes": "left")") ==
        "test.json: cloths[0].seams[0].first selects 1 nodes, none of which is at the rim of its panel.");
  CHECK(halves(R"("nodes": "top")", R"("panel": 2, "nodes": "left")") ==
        "test.json: cloths[0].seams[0].second.panel is 2, and the cloth has 2, counted from 0.");
  CHECK(halves(R"("nodes": "top")", R"("nodes": "top")") ==
        "test.json: cloths[0].seams[0] sews a row to itself.");
  CHECK(halves(R"("nodes": {"nodes": [0, 1]})", R"("nodes": {"nodes": [1, 2]})") ==
        "test.json: cloths[0].seams join nodes 1 and 0, two corners of triangle 1.");
  CHECK(halves(R"("nodes": "top")", R"("panel": 1, "nodes": "top")", R"(, "pins": [{"nodes": [0, 20]}])") ==
        "test.json: cloths[0].seams join nodes 0 and 20, and the scene holds both of them.");
  CHECK(halves(R"("nodes": "top")", R"("panel": 1, "nodes": "top")", R"(, "strength": 100)") ==
        "test.json: cloths[0].seams are of a cloth that has \"strength\", which sewing cannot follow.");
  const std::string fabric =
      R"("panels": [{"grid": [3, 3], "size": [1, 1]}, {"grid": [3, 3], "size": [1, 1]}],
    "density": 0.2, "fabric": {"warp": 100, "shear": 50, "bending_warp": 1e-5},
    "seams": [{"first": {"nodes": "top"}, "second": {"panel": 1, "nodes": "top"}}])";
  CHECK(method_refusal(fabric, "vbd") ==
        "test.json: cloths[0] has fabric and seams, and solver.kind \"vbd\" sews no fabric; \"multigrid\", "
        "\"xpbd\", \"pbd\" or \"fem\" does.");
  CHECK(method_refusal(fabric, "multigrid").empty());
}
