// Bodies with volume that meet planes, obstacles, cloth and each other, held against mechanics.
// Without contact: tests/method/test_bodies.cpp.
#include <cmath>
#include <iterator>
#include <vector>

#include "contact_rig.hpp"

using namespace weft;

namespace {

constexpr double kThickness = 0.005;

struct Way {
  std::string name, solver;
  int substeps;
  std::string energy = "neo_hookean";
};
const Way kMethods[] = {{"mass_spring", R"({"kind": "mass_spring"})", 16},
                        {"vbd", R"({"kind": "vbd", "iterations": 20})", 8}};
const Way kImplicit[] = {{"multigrid", R"({"kind": "multigrid"})", 8}, {"fem", R"({"kind": "fem"})", 8}};
const Way kProjections[] = {{"xpbd", R"({"kind": "xpbd", "iterations": 1})", 16},
                            {"projective_dynamics", R"({"kind": "projective_dynamics"})", 16, "corotated"}};

std::string world_text(const Way& method, const std::string& rest,
                       const std::string& gravity = "[0, -9.81, 0]") {
  return R"("gravity": )" + gravity + R"(, "time": {"substeps": )" + std::to_string(method.substeps) +
         R"(}, "solver": )" + method.solver +
         R"(, "contact": {"method": "proximity", "thickness": 0.005}, )" + rest;
}

/// A block of 3 x 3 x 3 cells of 0.2 m with E of 60 kPa and 8 kg, whose middle is there.
std::string block(const std::string& energy, const std::string& place, const std::string& more = "",
                  const std::string& poisson = "0.4") {
  return R"({"block": [3, 3, 3], "size": [0.2, 0.2, 0.2], "density": 1000,
     "material": {"young": 6e4, "damping": 0.004, "poisson": )" +
         poisson + R"(, "energy": ")" + energy + R"("}, "transform": {"translate": )" + place + "}" + more +
         "}";
}

double lowest(const Moment& now) {
  double least = 1e9;
  for (const Vec3d& x : now.position) least = std::min(least, x.y);
  return least;
}

Vec3d centre(const Moment& now, std::size_t begin, std::size_t end) {
  Vec3d sum;
  double mass = 0;
  for (std::size_t n = begin; n < end; ++n) {
    sum += now.mass[n] * now.position[n];
    mass += now.mass[n];
  }
  return sum / mass;
}

constexpr std::size_t kBlockNodes = 64;

}  // namespace

TEST_CASE("a block that lies on a plane sinks in as much as its weight says, and lies still") {
  GpuFixture fixture;
  const std::string few = R"({"kind": "vbd", "iterations": 2})";
  const Way ways[] = {kMethods[0],
                      kImplicit[0],
                      kImplicit[1],
                      {"vbd", few, 8},
                      {"vbd", few, 32},
                      {"xpbd", R"({"kind": "xpbd", "iterations": 2})", 32},
                      {"projective_dynamics", R"({"kind": "projective_dynamics"})", 32}};
  for (const Way& method : ways) {
    auto world = world_of(
        fixture.device(),
        contact_scene(world_text(
            method, R"("bodies": [)" + block("corotated", "[0, 0.105, 0]", "", "0") +
                        R"(], "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])")));
    advance(*world, 45);
    const Moment now(*world);
    // ρ g H²/(2 E) = 3.27 mm by a column, whose top is even since ν = 0. Contact holds it 5 mm above the plane.
    double top = 0;
    for (const Vec3d& x : now.position) top = std::max(top, x.y);
    const double sunk = 0.2 + kThickness - top, law = 1000 * kGravity * 0.2 * 0.2 / (2 * 6e4);
    MESSAGE(method.name << ": sunk by " << 1e3 * sunk << " mm, by its weight " << 1e3 * law
                        << "; lowest node at " << 1e3 * lowest(now) << " mm; " << now.largest_speed()
                        << " m/s");
    // Cells are as stiff as Hooke's law at their middle, and shrink by 1.6 % there: a few parts of a hundred.
    CHECK(std::abs(sunk - law) < 0.05 * law);
    CHECK(lowest(now) > 0.9 * kThickness);
    CHECK(lowest(now) < 1.1 * kThickness);
    CHECK(now.largest_speed() < 1e-3);
    CHECK(passed(*world) == 0);
  }
}

TEST_CASE("a block slides down a plane as Coulomb says, and lies where the plane is less steep") {
  GpuFixture fixture;
  constexpr double kSlope = 0.5;  // rad; its tangent is 0.546
  std::vector<Way> ways(std::begin(kMethods), std::end(kMethods));
  ways.insert(ways.end(), std::begin(kProjections), std::end(kProjections));
  ways.insert(ways.end(), std::begin(kImplicit), std::end(kImplicit));
  for (const Way& method : ways)
    for (const double friction : {0.3, 0.8}) {
      const bool creeps = method.name != kMethods[0].name && method.name != kMethods[1].name &&
                          method.name != kProjections[1].name;
      if (creeps && friction > std::tan(kSlope)) continue;  // its feet do: docs/bodies.md, Limits
      // Gravity is turned instead of the plane.
      const std::string gravity =
          "[" + text_of(kGravity * std::sin(kSlope)) + ", " + text_of(-kGravity * std::cos(kSlope)) + ", 0]";
      auto world =
          world_of(fixture.device(),
                   contact_scene(world_text(
                       method,
                       R"("bodies": [)" +
                           block(method.energy, "[0, 0.1045, 0]", R"(, "friction": )" + text_of(friction)) +
                           R"(], "colliders": [{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])",
                       gravity)));
      advance(*world, friction > std::tan(kSlope) ? 90 : 40);  // its swinging dies down
      const Moment first(*world);
      advance(*world, 30);
      const Moment second(*world);
      if (friction > std::tan(kSlope)) {
        double crept = 0;
        for (std::size_t n = 0; n < kBlockNodes; ++n)
          if (first.position[n].y < 1.02 * kThickness)
            crept = std::max(crept, std::abs(second.position[n].x - first.position[n].x));
        MESSAGE(method.name << ", friction " << friction << ": its feet have crept by " << crept << " m");
        CHECK(crept < 1e-4);
        continue;
      }
      double mass = 0;
      for (const double m : second.mass) mass += m;
      const double gained = (second.momentum(0, kBlockNodes).x - first.momentum(0, kBlockNodes).x) / mass;
      const double law = kGravity * (std::sin(kSlope) - friction * std::cos(kSlope)) * 0.5;
      MESSAGE(method.name << ", friction " << friction << ": " << gained
                          << " m/s gained in half a second, by Coulomb " << law);
      CHECK(std::abs(gained - law) < 0.02 * kGravity * std::cos(kSlope) * 0.5 * friction);
    }
}

TEST_CASE("two blocks that meet in flight keep their momentum, and neither enters the other") {
  GpuFixture fixture;
  std::vector<Way> ways(std::begin(kMethods), std::end(kMethods));
  ways.insert(ways.end(), std::begin(kImplicit), std::end(kImplicit));
  for (const Way& method : ways) {
    auto world = world_of(fixture.device(),
                          contact_scene(world_text(method,
                                                   R"("bodies": [)" + block(method.energy, "[-0.12, 0, 0]") +
                                                       "," + block(method.energy, "[0.12, 0.03, 0.02]") + "]",
                                                   "[0, 0, 0]")));
    push(*world, 0, kBlockNodes, {0.7, 0, 0});
    push(*world, kBlockNodes, 2 * kBlockNodes, {-0.7, 0, 0});
    const Moment start(*world);
    double most = energy_of(*world, start);
    const double begun = most;
    for (int frame = 0; frame < 30; ++frame) {
      advance(*world, 1);
      REQUIRE(passed(*world) == 0);
      most = std::max(most, energy_of(*world, Moment(*world)));
    }
    const Moment end(*world);
    const Vec3d drift = end.momentum(0, 2 * kBlockNodes) - start.momentum(0, 2 * kBlockNodes);
    const double each = start.momentum(0, kBlockNodes).x;
    MESSAGE(method.name << ": momentum off by " << length(drift) / each << " of each; energy at most "
                        << most / begun << "; they part with " << (end.momentum(0, kBlockNodes).x) / each
                        << " of what came");
    CHECK(length(drift) < 1e-5 * each);
    CHECK(most < 1.001 * begun);
    CHECK(end.momentum(0, kBlockNodes).x < 0);  // each goes back
  }
}

TEST_CASE("stiff plates and rods that fall on a ball and a floor give that no more energy than they had") {
  GpuFixture fixture;
  const std::string plate = R"("block": [12, 1, 12], "size": [0.5, 0.02, 0.5], "density": 100, "friction": 0,
      "transform": {"rotate": [0.02, 0, 0.03, 0.99935], "translate": [0.01, 0.15, 0.02]})",
                    rod = R"("block": [20, 1, 1], "size": [0.6, 0.03, 0.03], "density": 100, "friction": 0,
      "transform": {"rotate": [0.02, 0, 0.7546, 0.6559], "translate": [0.02, 0.43, 0.01]})";
  struct Falling {
    std::string shape, material;
    double fall;  // m g h of what falls on the ball [J]
  };
  for (const Way& method : {kImplicit[0], kImplicit[1]})
    for (const Falling& falling : {Falling{plate, R"("young": 1e7, "energy": "neo_hookean")", 0.25},
                                   {plate, R"("young": 1e7, "energy": "corotated")", 0.25},
                                   {rod, R"("young": 1e6, "energy": "neo_hookean")", 0.2}}) {
      CAPTURE(method.name);
      CAPTURE(falling.shape);
      CAPTURE(falling.material);
      auto world = world_of(
          fixture.device(),
          contact_scene(world_text(method, R"("bodies": [{)" + falling.shape + R"(, "material": {)" +
                                               falling.material + R"(, "poisson": 0.4, "damping": 0}}],
            "colliders": [{"kind": "sphere", "center": [0, 0, 0], "radius": 0.1},
                          {"kind": "plane", "point": [0, -0.3, 0], "normal": [0, 1, 0]}])")));
      const double begun = energy_of(*world, Moment(*world));
      double most = begun;
      for (int frame = 0; frame < 30; ++frame) {
        advance(*world, 1);
        most = std::max(most, energy_of(*world, Moment(*world)));
      }
      MESSAGE(method.name << ": energy at most " << (most - begun) / falling.fall << " of the fall's more");
      CHECK(most <= begun + 0.01 * falling.fall);
    }
}

TEST_CASE("stiff bodies that fall on each other give that no more energy than they had") {
  GpuFixture fixture;
  struct Body {
    std::string young, density;
  };
  const Body light{"1e7", "50"}, heavy{"1e5", "2000"};
  struct Pair {
    Body below, above;
    std::string rotate;
  };
  const auto text = [](const Body& body, const std::string& translate, const std::string& rotate) {
    return R"({"block": [2, 2, 2], "size": [0.2, 0.2, 0.2], "density": )" + body.density +
           R"(, "material": {"damping": 0, "poisson": 0.4, "young": )" + body.young +
           R"(}, "transform": {"translate": )" + translate + R"(, "rotate": )" + rotate + "}}";
  };
  const std::string flat = "[0, 0, 0, 1]", tilted = "[0.1826, 0, 0.3651, 0.9129]";
  for (const Way& method : {Way{"multigrid", kImplicit[0].solver, 6}, Way{"fem", kImplicit[1].solver, 6},
                            Way{"multigrid", kImplicit[0].solver, 2}})
    for (const Pair& pair : {Pair{light, light, tilted}, {light, heavy, flat}, {heavy, light, flat}}) {
      CAPTURE(method.name);
      CAPTURE(method.substeps);
      CAPTURE(pair.above.density);
      CAPTURE(pair.below.density);
      auto world = world_of(
          fixture.device(),
          contact_scene(world_text(method, R"("bodies": [)" + text(pair.below, "[0, 0.11, 0]", flat) + "," +
                                               text(pair.above, "[0.03, 0.45, 0.02]", pair.rotate) +
                                               R"(], "colliders": [{"kind": "plane", "point": [0, 0, 0],
                                                 "normal": [0, 1, 0]}])")));
      const double begun = energy_of(*world, Moment(*world));
      double most = begun;
      for (int frame = 0; frame < 24; ++frame) {
        advance(*world, 1);
        most = std::max(most, energy_of(*world, Moment(*world)));
        CHECK(passed(*world) == 0);
      }
      MESSAGE(method.name << " in " << method.substeps << ": energy at most " << most / begun
                          << " of it at first");
      CHECK(most < 1.001 * begun);
    }
}

TEST_CASE("cloth that is held at its edges carries a block, and the block nothing but the cloth") {
  GpuFixture fixture;
  for (const Way& method : kMethods) {
    const std::string cloth =
        R"("cloths": [{"grid": [17, 17], "size": [0.8, 0.8], "plane": "xz", "density": 0.5, "damping": 0.05,
        "stiffness": {"structural": 3000, "shear": 1000, "bend": 10}, "pins": ["edges"]}], )";
    auto world = world_of(
        fixture.device(),
        contact_scene(world_text(
            {method.name, method.solver, 2 * method.substeps},
            cloth + R"("drag": 1, "bodies": [{"block": [2, 2, 2], "size": [0.16, 0.16, 0.16], "density": 500,
          "material": {"young": 4e4, "poisson": 0.4, "energy": ")" +
                method.energy + R"("},
          "transform": {"translate": [0.01, 0.16, 0.02], "rotate": [0.2706, 0, 0.2706, 0.9239]}}])")));
    for (int frame = 0; frame < 120; ++frame) {
      advance(*world, 1);
      if (frame % 10 == 9) REQUIRE(passed(*world) == 0);
    }
    const Moment now(*world);
    const Vec3d middle = centre(now, 289, 289 + 27);
    MESSAGE(method.name << ": the block's middle is at " << middle.x << ", " << middle.y << ", " << middle.z
                        << " with " << length(now.momentum(289, 289 + 27)) / 2.05 << " m/s");
    CHECK(std::abs(middle.x) < 0.1);
    CHECK(std::abs(middle.z) < 0.1);
    CHECK(middle.y > -0.4);
    CHECK(middle.y < 0.1);
  }
}

TEST_CASE("a block falls on the edge of a box and on a ball, and passes through neither") {
  GpuFixture fixture;
  for (const Way& method : kMethods)
    for (const std::string collider :
         {R"({"kind": "box", "center": [0.1, -0.2, 0], "size": [0.2, 0.4, 0.6]})",
          R"({"kind": "sphere", "center": [0.03, -0.1, 0.02], "radius": 0.1})"}) {
      auto world = world_of(
          fixture.device(),
          contact_scene(world_text(method, R"("bodies": [)" +
                                               block(method.energy, "[0, 0.3, 0]", R"(, "friction": 0.5)") +
                                               R"(], "colliders": [)" + collider + "]")));
      double most = 0;
      for (int frame = 0; frame < 40; ++frame) {
        advance(*world, 1);
        REQUIRE(passed(*world) == 0);
        most = std::max(most, Moment(*world).largest_speed());
      }
      MESSAGE(method.name << " on " << collider << ": at most " << most << " m/s");
      CHECK(most < 12);  // free fall of 0.67 s and the swing of a corner
    }
}

TEST_CASE(
    "what is squeezed between boxes and let go has its shape again; tetrahedra that were flat meanwhile are "
    "told") {
  GpuFixture fixture;
  const Way method = {"vbd", R"({"kind": "vbd", "iterations": 6})", 8};
  for (const std::string energy : {"neo_hookean", "corotated"})
    for (const double gap : {0.12, 0.004}) {
      const std::string way = text_of((0.212 - gap) / 2);
      const auto box = [&](const std::string& y, const std::string& sign) {
        return R"({"kind": "box", "center": [0, )" + y +
               R"(, 0], "size": [0.6, 0.2, 0.6], "motion": {"kind": "path",
           "points": [[0, [0, 0, 0]], [0.2, [0, )" +
               sign + way + R"(, 0]], [0.25, [0, )" + sign + way + R"(, 0]], [0.5, [0, 0, 0]]]}})";
      };
      auto world = world_of(
          fixture.device(),
          contact_scene(world_text(method,
                                   R"("drag": 4, "bodies": [{"block": [2, 2, 2], "size": [0.2, 0.2, 0.2],
             "density": 1000, "material": {"young": 2e4, "poisson": 0.45, "damping": 0.004, "energy": ")" +
                                       energy + R"("}}], "colliders": [)" + box("0.206", "-") + "," +
                                       box("-0.206", "") + "]",
                                   "[0, 0, 0]")));
      advance(*world, 14);
      const std::uint32_t flattened = world->totals().flattened;
      advance(*world, 46);
      const double left = reference::energy(system_of(*world, Moment(*world)));
      MESSAGE(energy << " in a gap of " << gap << " m: " << flattened << " tetrahedra flattened; " << left
                     << " J left in the end");
      CHECK(left < 0.05);  // of some tens; a lump that stays has more
      CHECK((flattened > 0) == (gap < 0.01));
    }
}

TEST_CASE("long: the jelly of scenes/jelly.json falls into its net, and nothing passes through anything") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), shipped_scene("jelly"));
  double highest_speed = 0;
  for (int frame = 0; frame < 180; ++frame) {
    advance(*world, 1);
    REQUIRE(passed(*world) == 0);
    highest_speed = std::max(highest_speed, Moment(*world).largest_speed());
  }
  const Body& jelly = world->model().host.bodies[1];
  const Vec3d middle = centre(Moment(*world), jelly.first_vertex, jelly.first_vertex + jelly.vertex_count);
  MESSAGE("middle at " << middle.x << ", " << middle.y << ", " << middle.z << "; at most " << highest_speed
                       << " m/s");
  CHECK(std::abs(middle.x) < 0.5);  // still over its net
  CHECK(std::abs(middle.z) < 0.5);
  CHECK(middle.y > -0.5);
}
