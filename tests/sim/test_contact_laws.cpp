// Contact obeys mechanics: energies, momenta and free fall. Friction and layers have files of their own.
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "contact_laws_rig.hpp"

using namespace weft;

// ---- What is too near

namespace {

constexpr double kThickness = 0.01;

struct Under {
  std::string name, collider;
};
const Under kUnders[] = {
    {"plane", kPlane},
    {"box", R"({"kind": "box", "center": [0.01, -0.1, 0.02], "size": [1, 0.2, 1]})"},
    {"ball", R"({"kind": "sphere", "center": [0.041, -0.3, 0.039], "radius": 0.3})"},  // a node right over it
    {"mesh", R"({"kind": "mesh", "mesh": "floor.obj"})"},
    {"sheet", ""},
};

/// A sheet at a fifth of its thickness over something, watched while it is pushed away.
void check_too_near(gpu::Device& device, const std::string& solver, const Under& under, int substeps) {
  const int part = substeps == 8 ? 4 : 20, frames = substeps == 8 ? 6 : 16;
  const bool alone = !under.collider.empty();
  Setting setting{.solver = solver, .substeps = substeps / part, .part = part, .colliders = under.collider};
  setting.cloths = lying_cloth(6, "[0, 0.002, 0]");
  if (!alone) {
    setting.gravity = "[0, 0, 0]";
    setting.cloths += "," + lying_cloth(6, "[0.013, 0, 0.017]");
  }
  auto world = world_on(device, setting);
  const Moment start(*world);
  const double mass = total(start.mass), before = energy_of(*world, start);
  double top = 0, gained = 0;
  for (int frame = 0; frame < frames; ++frame) {
    advance(*world, 1);
    const Moment now(*world);
    REQUIRE(now.finite());
    top = std::max(top, alone ? highest(now) : mean_height(now, 0, 36) - mean_height(now, 36, 72));
    gained = std::max(gained, energy_of(*world, now) - before);
  }
  MESSAGE(solver, " over ", under.name, ", ", substeps, " substeps: at most at ", 1e3 * top,
          " mm, energy gained ", gained / mass, " J/kg");
  CHECK(top > 0.8 * kThickness);
  CHECK(top < 2 * kThickness);
  // It is lifted by no more than its thickness, and has no more than half of the speed at which it is pushed.
  const double lift = alone ? mass * kGravity * kThickness : 0;
  CHECK(gained < lift + 0.5 * mass * 0.25 * 0.25);
}

}  // namespace

namespace {

/// The most energy after one of so many frames [J]; 0 where there is never any.
double most_energy(sim::World& world, int frames) {
  double most = 0;
  for (int frame = 0; frame < frames; ++frame) {
    advance(world, 1);
    const Moment now(world);
    REQUIRE(now.finite());
    most = std::max(most, energy_of(world, now));
  }
  return most;
}

/// From the middle of the first sheet, or of what does not move, to that of the last [m].
Vec3d between_sheets(const Moment& now) {
  Vec3d sum;
  const std::size_t last = now.position.size() - 36;
  for (std::size_t i = 0; i < 36; ++i)
    sum += (now.position[last + i] - (last > 0 ? now.position[i] : Vec3d{})) / 36;
  return sum;
}

std::string sheet(const std::string& plane, const std::string& transform) {
  return R"({"grid": [6,6], "size": [0.4, 0.4], "plane": ")" + plane + R"(", "density": 0.3, "damping": 0.01,
    "stiffness": {"structural": 40, "shear": 10, "bend": 0.3}, "transform": {)" +
         transform + "}}";
}

/// Sheets that begin in one plane and in each other, or in an open mesh.
void check_in_each_other(gpu::Device& device, int substeps) {
  const std::string turned =
      R"("rotate": [0.2, 0.3, -0.1, 0.9273618495495703], "translate": [0.3, 0.5, 0.2])";
  const std::string floor = R"({"kind": "mesh", "mesh": "floor.obj")";
  const std::array<std::string, 2> cases[] = {
      // cloths, and an obstacle
      {sheet("xy", R"("translate": [0.1, 2.3, -0.7])") + "," +
       sheet("xy", R"("translate": [0.1, 2.3, -0.7])")},
      {sheet("xz", turned) + "," + sheet("xz", turned)},
      {sheet("xz", R"("rotate": [0.2, 0.3, -0.1, 0.9273618495495703])") + "," +
       sheet("xz", R"("rotate": [0.2, 0.3, -0.1, 0.9273618495495703])")},         // through the origin
      {lying_cloth(6, "[0, 0, 0]") + "," + lying_cloth(6, "[0.013, 0, 0.021]")},  // not node on node
      // Fronts that look away from each other, and at each other.
      {sheet("xz", R"("rotate": [0, 0, 0, 1])") + "," + sheet("xz", R"("rotate": [1, 0, 0, 0])")},
      {sheet("xz", R"("rotate": [0, 0, 1, 0])") + "," + sheet("xz", R"("rotate": [0, 0, 0, 1])")},
      {lying_cloth(6, "[0.013, 0, 0.021]"), floor + "}"},
      {sheet("xy", R"("translate": [0.013, 0.021, 0])"),
       floor + R"(, "transform": {"rotate": [0.7071067811865476, 0, 0, 0.7071067811865476]}})"}};
  for (const std::string solver : kSolvers)
    for (const auto& [cloths, obstacle] : cases) {
      CAPTURE(cloths);
      auto world = world_on(device, {.solver = solver,
                                     .gravity = "[0, 0, 0]",
                                     .substeps = substeps,
                                     .cloths = cloths,
                                     .colliders = obstacle});
      const Moment start(*world);
      const double mass = total(start.mass);
      const double gained = most_energy(*world, 8);
      const Moment now(*world);
      const double apart = length(between_sheets(now) - between_sheets(start));
      MESSAGE(solver, ": energy gained ", gained / mass, " J/kg, apart by ", 1e3 * apart, " mm");
      // As above: half of the speed at which what is too near is brought out.
      CHECK(gained < 0.5 * mass * 0.25 * 0.25);
      CHECK(tangles(*world, now) == 0);
      CHECK(apart > 0.8 * kThickness);
    }
}

}  // namespace

TEST_CASE("sheets that begin exactly in each other come apart across their plane, and gain no energy") {
  GpuFixture fixture;
  check_in_each_other(fixture.device(), 8);
}

TEST_CASE("long: the same in 40 substeps a frame") {
  GpuFixture fixture;
  check_in_each_other(fixture.device(), 40);
}

TEST_CASE(
    "a sheet that begins exactly in a face of a closed body comes out on its outside, and gains no energy") {
  GpuFixture fixture;
  const auto hull = [](double half) {
    std::string points;
    for (int corner = 0; corner < 8; ++corner)
      points += (corner > 0 ? ", [" : "[") + text_of(corner & 1 ? half : -half) + ", " +
                (corner & 2 ? "0" : "-0.2") + ", " + text_of(corner & 4 ? half : -half) + "]";
    return R"({"kind": "convex", "points": [)" + points + "]}";
  };
  for (const std::string solver : kSolvers)
    for (const double half : {1.0, 0.13, 0.03})       // all of the sheet, a part, less than a triangle of it
      for (const double lies : {0.0, 5e-5, -5e-5}) {  // within h/100
        if (lies < 0 && half < 1)
          continue;  // crosses the hull's sides: equation (7), at a speed that is kept
        CAPTURE(solver);
        CAPTURE(half);
        CAPTURE(lies);
        auto world =
            world_on(fixture.device(), {.solver = solver,
                                        .gravity = "[0, 0, 0]",
                                        .substeps = 20,
                                        .cloths = lying_cloth(6, "[0.013, " + text_of(lies) + ", 0.021]"),
                                        .colliders = hull(half)});
        const double gained = most_energy(*world, 12);
        const Moment now(*world);
        double lowest = HUGE_VAL;  // over the face
        for (const Vec3d& p : now.position)
          if (std::abs(p.x) < half && std::abs(p.z) < half) lowest = std::min(lowest, p.y);
        MESSAGE(solver, ", ", half, " m, ", lies, " m: energy gained ", gained / total(now.mass), " J/kg, ",
                1e3 * lowest, " mm over it, tangles ", tangles(*world, now));
        CHECK(gained < 0.5 * total(now.mass) * 0.25 * 0.25);
        CHECK(tangles(*world, now) == 0);
        CHECK(lowest > 0.8 * kThickness);
      }
}

TEST_CASE("cloth that an obstacle leaves behind falls as a stone, and flies on where it stops") {
  GpuFixture fixture;
  const std::string down = R"([0.1, [0, 0, 0]], [0.4, [0, -1.5, 0]])";  // at 5 m/s from 0.1 s on
  const std::string up = R"([0, [0, 0, 0]], [0.25, [0, 0.25, 0]], [1, [0, 0.25, 0]])";
  const double falls = kGravity * 0.1 * 0.1 / 2;
  for (const std::string solver : kSolvers)
    for (const std::string floor : {R"("kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0])",
                                    R"("kind": "box", "center": [0, -0.1, 0], "size": [1, 0.2, 1])",
                                    R"("kind": "mesh", "mesh": "floor.obj")"})
      for (const bool sinks : {true, false}) {
        Setting setting{.solver = solver, .substeps = 24, .cloths = lying_cloth(6, "[0, 0.01, 0]")};
        setting.colliders =
            "{" + floor + R"(, "motion": {"kind": "path", "points": [)" + (sinks ? down : up) + "]}}";
        auto world = world_on(fixture.device(), setting);
        advance(*world, sinks ? 12 : 21);
        const double end = mean_height(Moment(*world), 0, 36), law = kThickness + (sinks ? 0 : 0.35) - falls;
        MESSAGE(solver << " on " << floor << (sinks ? ", which sinks: " : ", which stops: ") << end << " of "
                       << law);
        CHECK(std::abs(end - law) < 0.03 * falls);
      }
}

namespace {

/// A sheet in free space that an obstacle strikes, and one that flies into the obstacle instead: after four frames.
struct BothWays {
  double apart = 0;  // the middles of both sheets [thicknesses]
  Totals struck, flying;
};
BothWays both_ways(gpu::Device& device, const std::string& solver, const std::string& obstacle,
                   double travel) {
  const double speed = travel * kThickness * 8 * 60;
  const auto start = [&](bool obstacle_flies) {
    const std::string motion =
        R"(, "motion": {"kind": "line", "direction": [0, 1, 0], "speed": )" + text_of(speed) + "}";
    auto world = world_on(device, {.solver = solver,
                                   .gravity = "[0, 0, 0]",
                                   .substeps = 8,
                                   .cloths = lying_cloth(13, "[0, 0, 0]"),
                                   .colliders = "{" + obstacle + (obstacle_flies ? motion : "") + "}"});
    if (!obstacle_flies) push(*world, 0, 169, {0, -speed, 0});
    return world;
  };
  const auto struck = start(true), flying = start(false);
  advance(*struck, 4);
  advance(*flying, 4);
  const Moment a(*struck), b(*flying);
  BothWays found;
  Vec3d sum;
  for (std::size_t v = 0; v < a.position.size(); ++v)
    sum += a.position[v] - Vec3d{0, 4 * speed / 60, 0} - b.position[v];
  found.apart = length(sum) / static_cast<double>(a.position.size()) / kThickness;
  found.struck = struck->totals();
  found.flying = flying->totals();
  MESSAGE(solver, ", ", obstacle, ", by ", travel, " thicknesses a substep: ", found.apart,
          " thicknesses apart, truncated ", found.struck.truncated, " and ", found.flying.truncated,
          ", longest edges ", found.struck.max_stretch, " and ", found.flying.max_stretch);
  CHECK(struck->most_substeps() == 8);  // no frame is cut
  CHECK(found.struck.driven == 0);
  return found;
}
constexpr const char* kFlying[] = {
    R"("kind": "sphere", "center": [0.01, -0.13, 0.02], "radius": 0.1)",
    R"("kind": "capsule", "a": [-0.1, -0.05, 0.02], "b": [0.1, -0.06, 0], "radius": 0.02)",
    R"("kind": "box", "center": [0.01, -0.13, 0.02], "size": [0.1, 0.2, 0.1])"};

}  // namespace

TEST_CASE("an obstacle that flies into cloth does to it what it does to cloth that flies into it") {
  GpuFixture fixture;
  for (const char* solver : {"multigrid", "vbd"})
    for (const char* obstacle : kFlying)
      for (const double travel : {0.49, 1.99}) {
        const BothWays found = both_ways(fixture.device(), solver, obstacle, travel);
        CHECK(found.apart < 0.5 * travel);  // half of a substep's way, of 32
        CHECK(found.struck.max_stretch < 1.1 * found.flying.max_stretch);
        CHECK(static_cast<double>(found.struck.truncated) < 0.01 * 169 * 32);
      }
}

TEST_CASE("a plane that turns carries cloth and lifts it, wherever its point is, as a box does") {
  GpuFixture fixture;
  const auto turned = [](const std::string& axis, double speed, double angle, double ramp) {
    return R"(, "motion": {"kind": "rotation", "axis": )" + axis + R"(, "center": [0, 0, 0], "speed": )" +
           text_of(speed) + R"(, "angle": )" + text_of(angle) + R"(, "ramp": )" + text_of(ramp) + "}}";
  };
  for (const std::string solver : kSolvers)
    for (const std::string under :
         {R"({"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "friction": 0.5)",
          R"({"kind": "plane", "point": [2, 0, 1], "normal": [0, 1, 0], "friction": 0.5)",
          R"({"kind": "box", "center": [0, -0.1, 0], "size": [2.4, 0.2, 2.4], "friction": 0.5)"}) {
      CAPTURE(solver);
      CAPTURE(under);
      // About its normal: 2 rad/s after a ramp of 0.3 s. It holds a sheet at r = 0.3 m, since r w^2 < 0.5 g.
      Setting table{.solver = solver, .cloths = lying_cloth(4, "[0.3, 0.01, 0]")};
      table.colliders = under + turned("[0, 1, 0]", 2, 10, 0.3);
      auto world = world_on(fixture.device(), table);
      advance(*world, 60);
      Vec3d middle;
      for (const Vec3d& p : Moment(*world).position) middle += p / 16;
      MESSAGE(solver << ": carried by " << std::atan2(-middle.z, middle.x)
                     << " of 1.7 rad, to r = " << std::hypot(middle.x, middle.z));
      CHECK(std::atan2(-middle.z, middle.x) == doctest::Approx(1.7).epsilon(0.01));
      CHECK(std::hypot(middle.x, middle.z) == doctest::Approx(0.3).epsilon(0.02));
      // About a line in it, 1 m from the sheet: by 0.3 rad at 2 rad/s.
      Setting lid{.solver = solver, .cloths = lying_cloth(4, "[0.9, 0.01, 0]")};
      lid.colliders = under + turned("[0, 0, 1]", 2, 0.3, 0);
      auto lifted = world_on(fixture.device(), lid);
      advance(*lifted, 9);
      double lowest = HUGE_VAL;
      for (const Vec3d& p : Moment(*lifted).position)
        lowest = std::min(lowest, p.y * std::cos(0.3) - p.x * std::sin(0.3));
      MESSAGE(solver << ": lifted to at least " << lowest << " m over it");
      CHECK(lowest > 0);
    }
}

TEST_CASE("a sheet that starts at a fifth of its thickness comes away from anything, and gains no speed") {
  GpuFixture fixture;
  for (const Under& under : kUnders)
    for (const std::string solver : kSolvers) check_too_near(fixture.device(), solver, under, 8);
  for (const Under& under : {kUnders[0], kUnders[4]})
    check_too_near(fixture.device(), "mass_spring", under, 300);
}

TEST_CASE("long: the same in 40, 300 and 2,000 substeps a frame") {
  GpuFixture fixture;
  for (const Under& under : kUnders)
    for (const std::string solver : kSolvers)
      for (const int substeps : {40, 300, 2000}) check_too_near(fixture.device(), solver, under, substeps);
}

TEST_CASE("long: sixteen layers at rest stay as they are where frames are cut finer by fifty") {
  GpuFixture fixture;
  for (const std::string solver : kSolvers) {
    auto world = world_of(
        fixture.device(),
        shipped_scene("stack", {{"cloths.0.grid", "[6,6]"},
                                {"cloths.0.copies.offset", "[0.004, 0.006, 0.003]"},
                                {"time.substeps", "16"},
                                {"solver.kind", "\"" + solver + "\""},
                                {"colliders", R"([{"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]},
      {"kind": "sphere", "center": [50, 50, 50], "radius": 0.2,
       "motion": {"kind": "line", "direction": [1, 0, 0], "speed": 120, "distance": 6, "start": 4}}])"}}));
    advance(*world, 240);
    const Moment before(*world);
    const double mean = before.mean_position().y, top = mean_height(before, 540, 576);
    double least = mean, most = mean, least_top = top, most_top = top;
    for (int frame = 0; frame < 6; ++frame) {
      advance(*world, 1);
      const Moment now(*world);
      least = std::min(least, now.mean_position().y);
      most = std::max(most, now.mean_position().y);
      least_top = std::min(least_top, mean_height(now, 540, 576));
      most_top = std::max(most_top, mean_height(now, 540, 576));
    }
    MESSAGE(solver, ": mean ", 1e3 * mean, " mm, then ", 1e3 * least, " to ", 1e3 * most, ", top ", 1e3 * top,
            " mm, then ", 1e3 * least_top, " to ", 1e3 * most_top, ", speed ", before.largest_speed());
    CHECK(least > 0.98 * mean);
    CHECK(most < 1.02 * mean);
    CHECK(least_top > 0.98 * top);
    CHECK(most_top < 1.02 * top);
  }
}

// ---- Free fall

TEST_CASE("cloth falls freely with self-contact, whatever its shape") {
  GpuFixture fixture;
  // So fine that a reach of its own would end its fall at 2.4 m/s; 0.03 of a cell is noise that its springs survive.
  constexpr std::uint32_t kFrames = 24;
  constexpr double kSize = 0.2, kCell = kSize / 9;
  const auto sheet = [](const char* plane, const char* at) {
    return R"({"grid": [10, 10], "size": [0.2, 0.2], "density": 0.3, "damping": 0.0005,
        "stiffness": {"structural": 4, "shear": 1, "bend": 0.03}, "plane": ")" +
           std::string(plane) + R"(", "transform": {"translate": )" + at + "}}";
  };
  struct Shape {
    std::string name, cloths;
    bool stays;  // in its shape
  };
  const std::string flat = sheet("xz", "[0, 0, 0]");
  const Shape shapes[] = {
      {"flat", flat, true},
      {"vertical", sheet("xy", "[0, 0, 0]"), true},
      {"crumpled", flat, false},
      {"folded", flat, false},
      {"stack", flat + "," + sheet("xz", "[0.02, 0.006, 0.01]") + "," + sheet("xz", "[0.04, 0.012, 0.02]"),
       false},
  };
  for (const std::string& solver : every_solver())
    for (const Shape& shape : shapes) {
      auto world = world_on(fixture.device(),
                            {.solver = solver, .contact = R"("thickness": 0.005)", .cloths = shape.cloths});
      Random random(3);
      change_state(*world, [&](std::size_t, Vec3d& x, Vec3d&) {
        if (shape.name == "crumpled")
          x += 0.03 * kCell * Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (shape.name != "folded") return;
        constexpr double kRadius = 0.02, kHalf = 0.5 * std::numbers::pi * kRadius;  // of the fold; of its arc
        const double along = x.x, angle = (along + kHalf) / kRadius;
        if (along > kHalf)
          x = {kHalf - along, 2 * kRadius, x.z};
        else if (along > -kHalf)
          x = {kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), x.z};
        else
          x.x = along + kHalf;
      });
      const Moment start(*world);
      CHECK(tangles(*world, start) == 0);
      advance(*world, kFrames);
      const Moment now(*world);
      const double mass = total(now.mass), time = kFrames / 60.0, dt = 1.0 / 480;
      // Steps of first order: g dt² n (n + 1) / 2. What meets nothing by multigrid and fem flies as a stone, and what
      // meets itself begins anew, by one of first order.
      const bool is_second_order = solver == "multigrid" || solver == "fem";
      const double least = 0.5 * kGravity * time * (time + (is_second_order ? 0 : dt));
      const double most =
          !is_second_order || shape.stays ? least : 0.5 * kGravity * time * (time + 1 / 360.0);
      Vec3d fallen;
      for (std::size_t i = 0; i < now.position.size(); ++i)
        fallen += (now.mass[i] / mass) * (now.position[i] - start.position[i]);
      const Vec3d momentum = momentum_of(now) / mass;
      MESSAGE(solver, " ", shape.name, ": falls ", -fallen.y / least, " of what it should, speed ",
              -momentum.y / (kGravity * time), ", aside ", std::hypot(momentum.x, momentum.z),
              " m/s, truncated ", world->totals().truncated, ", contacts ", world->totals().contacts);
      CHECK(-fallen.y > least * (1 - 1e-3));
      CHECK(-fallen.y < most * (1 + 1e-3));
      CHECK(-momentum.y == doctest::Approx(kGravity * time).epsilon(1e-3).scale(0));
      CHECK(std::hypot(momentum.x, momentum.z) < 1e-3 * kGravity * time);
      if (shape.stays) CHECK(world->totals().truncated == 0);
    }
}

TEST_CASE("cloth that meets nothing errs by hardly more than without contact, however suddenly it is moved") {
  // A row of a fine sheet sets off at 1.1 m/s. The step takes along what is behind it, which was at rest: in a substep
  // of 1/480 s by three times as much as it could go if it had only the slack of a vertex at rest.
  GpuFixture fixture;
  scene::Scene scene = scene_of(
      {.solver = "multigrid",
       .gravity = "[0, 0, 0]",
       .contact = R"("thickness": 0.005)",
       .substeps = 8,
       .cloths = R"({"grid": [40, 40], "size": [0.2, 0.2], "plane": "xy", "density": 0.3, "damping": 0.01,
           "stiffness": {"structural": 450, "shear": 60, "bend": 2},
           "motions": [{"nodes": "top", "kind": "line", "direction": [0, 1, 0], "speed": 1.1}]})"});
  auto with = world_from(fixture.device(), scene, Assets{{{}}});
  scene.contact.method = scene::ContactMethod::None;
  auto without = world_from(fixture.device(), scene, Assets{{{}}});
  REQUIRE(with->substeps() == without->substeps());
  advance(*with, 10);
  advance(*without, 10);
  scene.time.substeps = 16 * without->substeps();
  auto finest = world_from(fixture.device(), scene, Assets{{{}}});
  advance(*finest, 10);
  const Moment there(*with), free(*without), truth(*finest);
  double error = 0, free_error = 0;
  for (std::size_t i = 0; i < there.position.size(); ++i) {
    error = std::max(error, length(there.position[i] - truth.position[i]));
    free_error = std::max(free_error, length(free.position[i] - truth.position[i]));
  }
  MESSAGE("with contact ", error, " m from a sixteenth of the step, without ", free_error, " m, truncated ",
          with->totals().truncated, ", contacts ", with->totals().contacts);
  CHECK(with->totals().truncated == 0);
  // With contact a substep has two linear systems, the second from where the first leads; but what is pressed buckles
  // more slowly by (6a) of docs/solvers/multigrid.md, and the rows behind the one that sets off are.
  CHECK(error < 1.1 * free_error);
}

// ---- Momentum and energy

TEST_CASE("cloths that collide keep their momentum, without friction their spin, and gain no energy") {
  GpuFixture fixture;
  for (const std::string& solver : every_solver())
    for (const double friction : {0.0, 0.4})
      for (const double restitution : {0.0, 1.0}) {
        const std::string more = R"(, "friction": )" + text_of(friction);
        auto world = world_on(fixture.device(),
                              {.solver = solver,
                               .gravity = "[0, 0, 0]",
                               .contact = R"("thickness": 0.01, "restitution": )" + text_of(restitution),
                               .cloths = lying_cloth(7, "[0, 0, 0]", more) + "," +
                                         lying_cloth(9, "[0.113, 0.02, 0.117]", more)});
        push(*world, 0, 49, {0.3, 1, 0.1});
        push(*world, 49, 49 + 81, {0, -0.5, 0});
        const Moment start(*world);
        const double mass = total(start.mass), before = energy_of(*world, start);
        double least = before, rise = 0;
        for (int frame = 0; frame < 12; ++frame) {
          advance(*world, 1);
          const double energy = energy_of(*world, Moment(*world));
          rise = std::max(rise, energy - least);
          least = std::min(least, energy);
        }
        const Moment now(*world);
        const double given = length(now.momentum(0, 49) - start.momentum(0, 49));
        const double off = length(momentum_of(now) - momentum_of(start));
        const double turned = length(spin_of(now) - spin_of(start));
        MESSAGE(solver, " friction ", friction, " restitution ", restitution, ": given ", given,
                " N s, momentum off by ", off / given, " of it, spin by ", turned / (0.4 * given),
                ", energy from ", before, " J to ", least, ", rises by ", rise / before, ", truncated ",
                world->totals().truncated);
        CHECK(given > 0.2 * mass / 4);
        // Each of some 10^3 changes of a node is rounded to 2^-22 m/s, and each f32 velocity to 2^-25. Friction acts at
        // both surfaces, which are apart: it turns.
        CHECK(off < 1e-4 * given);
        if (friction == 0) CHECK(turned < 1e-2 * 0.4 * given);
        CHECK(rise < 0.01 * before);
        CHECK(least <= before);
      }
}

TEST_CASE("a sheet folded like a fan gains no energy and passes nowhere through itself") {
  GpuFixture fixture;
  for (const std::string& solver : every_solver()) {
    if (solver == "pbd") continue;  // what its springs have is no energy: it depends on the sweeps
    auto world = world_on(fixture.device(), {.solver = solver,
                                             .gravity = "[0, 0, 0]",
                                             .contact = R"("thickness": 0.02)",
                                             .cloths = lying_cloth(10, "[0, 0, 0]")});
    Random random(5);
    // Folded like a fan, with noise.
    change_state(*world, [&](std::size_t i, Vec3d& x, Vec3d& v) {
      const std::size_t column = i % 10;
      x.x = 0.12 * x.x;
      x.y = (column % 2 == 0 ? 1 : -1) * 0.02205;  // as long as at rest
      x += 0.001 * Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      v = {-4 * x.x, 0, 0};
    });
    const Moment start(*world);
    REQUIRE(tangles(*world, start) == 0);
    const double before = energy_of(*world, start);
    double least = before, rise = 0;
    for (int frame = 0; frame < 30; ++frame) {
      advance(*world, 1);
      const Moment now(*world);
      CHECK(tangles(*world, now) == 0);
      const double energy = energy_of(*world, now);
      rise = std::max(rise, energy - least);
      least = std::min(least, energy);
    }
    const Moment now(*world);
    MESSAGE(solver, ": energy ", before, " J to ", least, ", rises by ", rise / before, ", momentum off by ",
            length(momentum_of(now) - momentum_of(start)) / total(now.mass), " m/s, contacts ",
            world->totals().contacts, ", truncated ", world->totals().truncated);
    CHECK(world->totals().contacts > 0);
    CHECK(rise < 0.01 * before);
  }
}

TEST_CASE("a sheet that falls on a ball or a box gains no energy, by methods whose sweeps have converged") {
  GpuFixture fixture;
  constexpr double kPart = 0.02;  // of the fall's energy
  struct Steps {
    std::string solver, iterations, substeps;
  };
  // Position-based dynamics has no energy to gain.
  for (const Steps& steps :
       {Steps{"mass_spring", "", R"("auto")"}, Steps{"multigrid", "", "8"}, Steps{"fem", "", "8"},
        Steps{"vbd", R"(, "iterations": 10)", "8"}, Steps{"xpbd", R"(, "iterations": 16)", "16"},
        Steps{"projective_dynamics", R"(, "iterations": 20)", "24"}})
    for (const std::string obstacle :
         {R"({"kind": "sphere", "center": [0, 0, 0], "radius": 0.12})",
          R"({"kind": "box", "center": [0, 0, 0], "size": [0.24, 0.24, 0.24]})"}) {
      auto world = world_of(
          fixture.device(),
          contact_scene(
              R"("time": {"substeps": )" + steps.substeps + R"(}, "solver": {"kind": ")" + steps.solver +
              "\"" + steps.iterations +
              R"(}, "contact": {"method": "proximity", "thickness": 0.005}, "cloths": [{"grid": [21, 21],
        "size": [0.5, 0.5], "plane": "xz", "transform": {"translate": [0, 0.35, 0]}, "density": 0.2, "damping": 0.01,
        "stiffness": {"structural": 500, "shear": 200, "bend": 0.5}, "friction": 0.3}], "colliders": [)" +
              obstacle + "]"));
      const Moment start(*world);
      double least = energy_of(*world, start), rise = 0;
      for (int frame = 0; frame < 26; ++frame) {
        advance(*world, 1);
        const double energy = energy_of(*world, Moment(*world));
        rise = std::max(rise, energy - least);
        least = std::min(least, energy);
      }
      const double fall = total(start.mass) * kGravity * 0.22;
      MESSAGE(steps.solver, ", ", obstacle.substr(9, 7), ": energy rises by ", rise / fall, " of the fall");
      CHECK(rise < kPart * fall);
    }
}

TEST_CASE(
    "a free sheet that strikes a ball has no more energy after it, whatever restitution, by methods with "
    "sweeps") {
  GpuFixture fixture;
  struct Steps {
    std::string solver;
    int iterations, substeps;
  };
  for (const Steps& steps :
       {Steps{"vbd", 20, 16}, Steps{"xpbd", 32, 32}, Steps{"projective_dynamics", 40, 32}})
    for (const double restitution : {0.0, 0.5, 1.0}) {
      auto world = world_of(
          fixture.device(),
          contact_scene(R"("gravity": [0, 0, 0], "time": {"substeps": )" + std::to_string(steps.substeps) +
                        R"(}, "solver": {"kind": ")" + steps.solver + R"(", "iterations": )" +
                        std::to_string(steps.iterations) +
                        R"(}, "contact": {"method": "proximity", "thickness": 0.005, "restitution": )" +
                        text_of(restitution) +
                        R"(}, "cloths": [{"grid": [21, 21], "size": [0.5, 0.5], "plane": "xz", "density": 0.2,
        "damping": 0, "stiffness": {"structural": 500, "shear": 200, "bend": 0.5}}],
        "colliders": [{"kind": "sphere", "center": [0.013, -0.2, 0.007], "radius": 0.1}])"));
      change_state(*world, [](std::size_t, Vec3d&, Vec3d& velocity) { velocity = {0, -2, 0}; });
      const double before = energy_of(*world, Moment(*world));
      double most = 0, least = before;
      for (int frame = 0; frame < 20; ++frame) {
        advance(*world, 1);
        const double energy = energy_of(*world, Moment(*world));
        most = std::max(most, energy - least);
        least = std::min(least, energy);
      }
      MESSAGE(steps.solver, " restitution ", restitution, ": energy rises by ", most / before,
              " of it, and is ", least / before, " then");
      CHECK(least < 0.99 * before);  // it has been struck
      CHECK(most < 0.02 * before);
      CHECK(world->totals().crossings == 0);
    }
}

TEST_CASE("a sheet that drops on a floor loses its energy, or keeps e² of it") {
  GpuFixture fixture;
  constexpr double kHeight = 0.05;  // above where it lies [m]
  for (const std::string& solver : every_solver())
    for (const double restitution : {0.0, 0.5, 1.0}) {
      auto world = world_on(fixture.device(),
                            {.solver = solver,
                             .contact = R"("thickness": 0.01, "restitution": )" + text_of(restitution),
                             .substeps = 16,
                             .cloths = lying_cloth(6, "[0, 0.06, 0]"),
                             .colliders = kPlane});
      const Moment start(*world);
      const double mass = total(start.mass), before = energy_of(*world, start);
      double least = before, rise = 0, rebound = 0;
      bool down = false;
      for (int frame = 0; frame < 14; ++frame) {
        advance(*world, 1);
        const Moment now(*world);
        const double energy = energy_of(*world, now), height = now.mean_position().y - 0.01;
        rise = std::max(rise, energy - least);
        least = std::min(least, energy);
        down = down || now.mean_velocity().y > -0.01;
        if (down) rebound = std::max(rebound, height);
      }
      // Semi-implicit Euler has an energy wrong by g v dt / 2 on the way up.
      const double rounding = mass * kGravity * 1.0 / 960 / 2;
      MESSAGE(solver, " restitution ", restitution, ": rebounds to ", 1e3 * rebound, " mm, energy rises by ",
              rise / mass, " J/kg");
      CHECK(rise < rounding);
      CHECK(rebound == doctest::Approx(restitution * restitution * kHeight).epsilon(0.03).scale(kHeight));
    }
}
