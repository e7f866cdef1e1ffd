// Whole scenes on the CPU: bits, energy, motions, contacts.
#include <cmath>

#include "element/triple/triple.hpp"
#include "rig.hpp"

using namespace weft;

TEST_CASE("six scenes have the bits that every machine must have") {
  // The browser tests ask the same of WebAssembly. What changes these on purpose: the method, or a scene.
  struct Golden {
    std::string scene, grid;
    int frames;
    std::string hash, method = "";  // of contact; none: the scene's
  };
  for (const Golden& golden : {Golden{"hanging", "[16,16]", 5, "1a811593b3634d9e"},
                               {"pull-sphere", "[16,16]", 12, "ab35bb2000e9b984", "\"bvh\""},
                               {"sheet", "[16,16]", 5, "6901d79edb53ce88"},
                               {"breeze", "[24,16]", 10, "453b402d469758d2"},
                               {"drag", "[16,16]", 40, "4c7d1a904baab260"},
                               {"pull-sphere", "[16,16]", 12, "c73a03dc3c1a71b1", "\"proximity\""}}) {
    CAPTURE(golden.scene);
    std::vector<scene::Override> overrides = {{"cloths.0.grid", golden.grid}};
    if (!golden.method.empty()) overrides.push_back({"contact.method", golden.method});
    auto simulation = simulation_of_file(golden.scene, overrides);
    advance(simulation, golden.frames);
    CHECK(simulation.hash() == golden.hash);
  }
}

TEST_CASE("a simulation repeats bit for bit, also after a reset") {
  const std::vector<scene::Override> small = {{"cloths.0.grid", "[14,11]"}};
  auto a = simulation_of_file("pull-sphere", small), b = simulation_of_file("pull-sphere", small);
  const std::string rest = a.hash();
  advance(a, 8);
  advance(b, 8);
  const std::string hash = a.hash();
  CHECK(a.contacts() > 0);
  CHECK(b.hash() == hash);
  advance(a, 1);
  CHECK(a.hash() != hash);
  CHECK(a.time() == doctest::Approx(9 / 60.0));
  a.reset();
  CHECK(a.hash() == rest);
  CHECK(a.frame() == 0);
  advance(a, 8);
  CHECK(a.hash() == hash);
}

TEST_CASE("paper and bvh are one method here, and none touches nothing") {
  const auto hash = [](const std::string& method) {
    auto simulation =
        simulation_of_file("pull-sphere", {{"cloths.0.grid", "[14,11]"}, {"contact.method", method}});
    advance(simulation, 4);
    CHECK((simulation.contacts() > 0) == (method != "none"));
    return simulation.hash();
  };
  CHECK(hash("paper") == hash("bvh"));
  CHECK(hash("none") != hash("bvh"));
}

TEST_CASE("a strip bent to an arc has the energy B/2 times curvature squared times its area") {
  constexpr std::uint32_t kAlong = 81, kAcross = 21;
  constexpr double kLength = 0.8, kWidth = 0.4, kBending = 3e-4, kRadius = 0.5;  // m, m, N·m, m
  reference::MassSpringSystem system;
  for (std::uint32_t j = 0; j < kAcross; ++j)
    for (std::uint32_t i = 0; i < kAlong; ++i) {
      const double angle = kLength * i / (kAlong - 1) / kRadius;
      system.position.push_back(
          {kRadius * std::sin(angle), kWidth * j / (kAcross - 1), kRadius * std::cos(angle)});
    }
  system.inverse_mass.assign(system.position.size(), 0);
  const ElementTable triples =
      build_triples({kAlong, kAcross, kLength, kWidth}, kBending, mesh::BoundaryWeights::Area, 0);
  for (std::size_t t = 0; t < triples.size(); ++t) {
    const auto nodes = triples.nodes_of(t);
    system.bending.push_back({nodes[0], nodes[1], nodes[2], static_cast<double>(triples.material[t])});
  }
  const double expected = 0.5 * kBending / (kRadius * kRadius) * kLength * kWidth;
  // The two end nodes of a line have no triple: one cell of 80 is missing; a chord is short by (a / R)² / 12.
  CHECK(reference::energy(system) ==
        doctest::Approx(expected * (kAlong - 2) / (kAlong - 1)).epsilon(1e-3).scale(0));
}

TEST_CASE("the energy of a sheet that hangs with drag never rises from frame to frame") {
  auto simulation = simulation_of_file("hanging", {{"cloths.0.grid", "[12,12]"}});
  const double start = simulation.energy();
  double before = start;
  for (int frame = 0; frame < 90; ++frame) {
    advance(simulation, 1);
    CAPTURE(frame);
    CHECK(simulation.energy() < before);
    before = simulation.energy();
  }
  CHECK(start - before > 1);  // J: 0.8 kg, of which the middle has sunk by half a metre or more
}

TEST_CASE("without drag and damping the energy of a sheet does not drift") {
  auto simulation =
      simulation_of_file("hanging", {{"cloths.0.grid", "[12,12]"}, {"drag", "0"}, {"cloths.0.damping", "0"}});
  const double start = simulation.energy();
  for (int frame = 0; frame < 60; ++frame) {
    advance(simulation, 1);
    // Semi-implicit Euler keeps an energy that differs from the true one by O(omega h) of what is in motion.
    CHECK(std::abs(simulation.energy() - start) < 0.1);
  }
}

TEST_CASE("moved edges are where their motions say at the end of every frame") {
  auto simulation = simulation_of_text(R"("contact": {"method": "none"}, "time": {"substeps": 5},
    "cloths": [{"grid": [5, 5], "size": [1, 1], "density": 1, "damping": 0,
      "stiffness": {"structural": 20, "shear": 10, "bend": 1}, "pins": [{"nodes": [12]}],
      "motions": [{"nodes": "top", "kind": "line", "direction": [1, 0, 0], "speed": 0.6},
                  {"nodes": "bottom", "kind": "rotation", "axis": [0, 1, 0], "center": [0, 0, 0], "speed": 2}]}])");
  const std::vector<Vec3d> start = simulation.positions();
  for (int frame = 1; frame <= 4; ++frame) {
    advance(simulation, 1);
    const double time = frame / 60.0;
    CHECK(simulation.positions()[12] == start[12]);
    CHECK(simulation.velocities()[12] == Vec3d{});
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(simulation.positions()[i].x == doctest::Approx(start[i].x + 0.6 * time).epsilon(1e-12).scale(0));
      CHECK(simulation.velocities()[i].x == doctest::Approx(0.6).epsilon(1e-9).scale(0));
      const Vec3d after = simulation.positions()[20 + i];
      CHECK(after.x == doctest::Approx(start[20 + i].x * std::cos(2 * time)).epsilon(1e-12));
      CHECK(after.z == doctest::Approx(-start[20 + i].x * std::sin(2 * time)).epsilon(1e-12));
    }
  }
}

TEST_CASE("a corner that the scene holds closes in on its target at 20 /s, and falls when it is let go") {
  auto simulation = simulation_of_text(R"("contact": {"method": "none"}, "time": {"substeps": 10},
    "cloths": [{"grid": [6, 6], "size": [1, 1], "plane": "xy", "density": 0.2, "damping": 0.01, "pins": ["top"],
      "stiffness": {"structural": 50, "shear": 20, "bend": 1},
      "grabs": [{"node": "bottom_left", "end": 0.5001, "path": [{"time": 0, "point": [-0.4, -0.2, 0.2]}]}]}])");
  const std::uint32_t corner = 5 * 6;
  const Vec3d target{-0.4, -0.2, 0.2}, start = simulation.positions()[corner];
  double factor = 1;
  for (int frame = 1; frame <= 30; ++frame) {
    advance(simulation, 1);
    for (int s = 0; s < 10; ++s)
      factor *= 1 - 20.0 / 600;  // 20 /s, as long as that is below the bound of 10 m/s
    const Vec3d expected = target + factor * (start - target);
    CHECK(length(simulation.positions()[corner] - expected) < 1e-12);
  }
  advance(simulation, 10);
  CHECK(simulation.positions()[corner].y < target.y - 0.05);  // it alone would fall 0.136 m
}

TEST_CASE("a sheet that falls on a plane and a sphere stays on their outer side in double") {
  auto simulation = simulation_of_text(R"("contact": {"method": "bvh", "thickness": 0.01},
    "cloths": [{"grid": [16, 16], "size": [1, 1], "plane": "xz", "density": 0.3, "damping": 0.01,
      "transform": {"translate": [0, 0.55, 0]}, "stiffness": {"structural": 100, "shear": 50, "bend": 5}}],
    "colliders": [{"kind": "sphere", "center": [0, 0.2, 0], "radius": 0.3},
                  {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])");
  advance(simulation, 60);
  CHECK(simulation.contacts() > 0);
  for (const Vec3d& node : simulation.positions()) {
    CHECK(node.y > 0);
    CHECK(length(node - Vec3d{0, 0.2, 0}) > 0.3);
  }
}

TEST_CASE("a frame that ends with nodes that are not finite is taken back and named") {
  // One substep of 10 s: far beyond the stable step, so the state overflows within a few frames.
  auto simulation = simulation_of_text(R"("time": {"frame": 10, "substeps": 1}, "contact": {"method": "none"},
    "cloths": [{"grid": [4, 4], "size": [1, 1], "density": 0.1, "pins": ["top_left"]}])");
  Result<void> advanced;
  std::string before;
  while (advanced && simulation.frame() < 1000) {
    before = simulation.hash();
    advanced = simulation.advance_frame();
  }
  REQUIRE_FALSE(advanced);
  CHECK(advanced.error().kind == ErrorKind::Diverged);
  CHECK(advanced.error().message.find("In frame " + std::to_string(simulation.frame())) == 0);
  CHECK(simulation.hash() == before);
}

TEST_CASE("an object's triangle without area is refused") {
  auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
      "contact": {"method": "bvh"},
    "cloths": [{"grid": [4, 4], "size": [1, 1], "density": 0.1}],
    "colliders": [{"kind": "mesh", "mesh": "flat.obj"}]})",
                                  "test.json");
  REQUIRE_OK(scene);
  mesh::TriangleMesh flat;
  flat.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  const auto refused = reference::Simulation::create(
      *scene, {.cloths = {{}}, .objects = {flat}, .object_colliders = {0}, .deformations = {{}}});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().kind == ErrorKind::Input);
}

namespace {

/// Implicit sheets of these densities, each on a larger one, on a slope of this part of the angle of friction.
reference::Simulation sheets_on_slope(const std::vector<double>& densities, double part) {
  const double slope = part * std::atan(0.5);
  std::string cloths;
  for (std::size_t k = 0; k < densities.size(); ++k)
    cloths += std::string(k > 0 ? "," : "") + R"({"grid": [9, )" + (k % 2 == 0 ? "9" : "8") +
              R"(], "size": [0.4, )" + std::to_string(0.4 - 0.05 * static_cast<double>(k)) +
              R"(], "plane": "xz", "damping": 0.02, "friction": 0.5,
      "stiffness": {"structural": 300, "shear": 80, "bend": 2}, "density": )" +
              std::to_string(densities[k]) + R"(, "transform": {"translate": [0, )" +
              std::to_string(0.005 * static_cast<double>(k + 1)) + ", 0]}}";
  return simulation_of_text(
      R"("solver": {"kind": "multigrid"}, "contact": {"method": "proximity", "thickness": 0.005},
    "gravity": [)" +
      std::to_string(9.81 * std::sin(slope)) + "," + std::to_string(-9.81 * std::cos(slope)) +
      R"(, 0], "cloths": [)" + cloths +
      R"(], "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "friction": 0.5}])");
}

/// Of each of these sheets the mean along the slope.
std::vector<double> along_slope(const std::vector<Vec3d>& all) {
  std::vector<double> means;
  for (std::size_t first = 0; first < all.size();) {
    const std::size_t count = means.size() % 2 == 0 ? 81 : 72;
    double sum = 0;
    for (std::size_t node = first; node < first + count; ++node) sum += all[node].x;
    means.push_back(sum / static_cast<double>(count));
    first += count;
  }
  return means;
}

}  // namespace

TEST_CASE("in double, sheets of any densities on each other hold on a slope, and slide as they should") {
  struct Pile {
    std::vector<double> densities;
    int settled;  // frames
  };
  for (const Pile& pile : {Pile{{0.05, 5}, 50}, {{5, 0.05}, 15}, {{0.2, 2}, 50}, {{0.05, 0.05, 5}, 60}}) {
    CAPTURE(pile.densities[0]);
    auto simulation = sheets_on_slope(pile.densities, 0.98);
    advance(simulation, pile.settled);
    const std::vector<double> begin = along_slope(simulation.positions());
    advance(simulation, 15);
    const std::vector<double> end = along_slope(simulation.positions());
    for (std::size_t k = 0; k < begin.size(); ++k) {
      MESSAGE("sheet ", k, " creeps at ", 4e6 * (end[k] - begin[k]), " um/s");
      CHECK(std::abs(end[k] - begin[k]) < 0.25 * 1e-5);
    }
  }
  for (const double part : {1.05, 1.1}) {
    auto simulation = sheets_on_slope({0.05, 5}, part);
    advance(simulation, 20);
    const std::vector<double> begin = along_slope(simulation.velocities());
    advance(simulation, 15);
    const std::vector<double> end = along_slope(simulation.velocities());
    const double slope = part * std::atan(0.5), exact = 9.81 * (std::sin(slope) - 0.5 * std::cos(slope));
    // Whether it slides on the light sheet or with that is a hundredth of a hundredth of its friction.
    const double lower = 4 * (end[0] - begin[0]), upper = 4 * (end[1] - begin[1]);
    MESSAGE("the lower gains ", lower / exact, " of the acceleration, the upper ", upper / exact);
    const double light = 0.05 * 0.4 / (0.05 * 0.4 + 5 * 0.35);  // part of the mass
    // What friction takes, within a quarter of the 2 % that it is promised to.
    const double friction = 0.5 * 9.81 * std::cos(slope);
    CHECK(std::abs(light * lower + (1 - light) * upper - exact) < 0.005 * friction);
  }
}

TEST_CASE("in double, a folded mesh on a slope creeps no more than some tens of micrometres a second") {
  // Two layers of 12 by 12 nodes, 7 mm apart, with one side in common; 0.82 of the angle of friction.
  constexpr std::uint32_t kSide = 12;
  mesh::TriangleMesh fold;
  for (std::uint32_t node = 0; node < 2 * kSide * kSide; ++node) {
    const std::uint32_t i = node % kSide, j = node / kSide % kSide, layer = node / (kSide * kSide);
    fold.positions.push_back(
        Vec3d{0.4 / (kSide - 1) * i - 0.2, 0.0051 + 0.007 * layer, 0.4 / (kSide - 1) * j - 0.2}.to<float>());
  }
  const auto add_quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    fold.triangles.push_back({a, b, d});
    fold.triangles.push_back({a, d, c});
  };
  for (std::uint32_t layer = 0; layer < 2; ++layer)
    for (std::uint32_t j = 0; j + 1 < kSide; ++j)
      for (std::uint32_t i = 0; i + 1 < kSide; ++i) {
        const std::uint32_t a = (layer * kSide + j) * kSide + i;
        add_quad(a, a + 1, a + kSide, a + kSide + 1);
      }
  for (std::uint32_t j = 0; j + 1 < kSide; ++j) {
    const std::uint32_t a = j * kSide + kSide - 1;
    add_quad(a, a + kSide * kSide, a + kSide, a + kSide + kSide * kSide);
  }
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "multigrid"},
    "gravity": [3.6433, -9.1084, 0], "contact": {"method": "proximity", "thickness": 0.005},
    "cloths": [{"mesh": "fold", "density": 0.2, "damping": 0.02, "friction": 0.5,
      "stiffness": {"structural": 300, "shear": 80, "bend": 2}}],
    "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "friction": 0.5}]})",
                                        "test.json");
  REQUIRE_OK(scene);
  auto made = reference::Simulation::create(*scene, {.cloths = {fold}});
  REQUIRE_OK(made);
  const auto mean = [&] {
    double sum = 0;
    for (const Vec3d& x : made->positions()) sum += x.x;
    return sum / static_cast<double>(made->positions().size());
  };
  advance(*made, 20);
  const double begin = mean();
  advance(*made, 20);
  const double creep = 3 * (mean() - begin);
  MESSAGE("creeps at ", 1e6 * creep, " um/s");
  CHECK(std::abs(creep) < 1e-4);  // 2 mm/s when pairs of the mesh itself made the floor forget its friction
}

TEST_CASE("impulses take more iterations where heavy cloth may lie on light cloth, and only there") {
  const auto rule = [](const std::string& densities, double step, bool self = true) {
    std::string cloths;
    for (const char c : densities)
      cloths += std::string(cloths.empty() ? "" : ",") +
                R"({"grid": [3, 4], "size": [0.2, 0.3], "density": )" +
                (c == 'h'   ? "5"
                 : c == 'm' ? "0.51"
                            : "0.05") +
                "}";
    const auto scene =
        scene::parse_scene(R"({"format": "weft-scene/1", "cloths": [)" + cloths + "]}", "test.json");
    REQUIRE_OK(scene);
    const auto model = build_model(*scene, std::vector<mesh::TriangleMesh>(densities.size()));
    REQUIRE_OK(model);
    scene::Contact contact;
    contact.self = self;
    return impulse_rule(*model, contact, step);
  };
  CHECK(rule("llll", 1.0 / 360) == ImpulseRule{6, 6, false});
  CHECK(rule("mh", 1.0 / 360) == ImpulseRule{6, 6, false});
  CHECK(rule("lh", 1.0 / 360) == ImpulseRule{40, 40, true});
  CHECK(rule("lhl", 1.0 / 360) == ImpulseRule{57, 57, true});
  CHECK(rule("lllllllh", 1.0 / 360) == ImpulseRule{64, 64, true});
  CHECK(rule("lh", 1.0 / 360, false) == ImpulseRule{6, 6, false});
  CHECK(rule("lh", 1.0 / 1500) == ImpulseRule{2, 2, false});
  CHECK(rule("lh", 1.0 / 2880) == ImpulseRule{1, 6, false});  // six where cloth is pressed
  CHECK(rule("lh", 1.0 / 2880, false) == ImpulseRule{1, 1, false});
}
