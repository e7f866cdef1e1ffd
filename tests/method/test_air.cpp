// The air on triangles: kernels beside the double reference, and laws that neither was written from (docs/air.md).
#include <array>
#include <cmath>
#include <cstdio>

#include "gpu/gpu_fixture.hpp"
#include "mesh/irregular_meshes.hpp"
#include "mesh/lumped.hpp"
#include "method/stepper.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81, kDensity = 0.05;  // of the scenes below [m/s²], [kg/m²]

std::string text(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.9g", value);
  return buffer.data();
}

/// The ways to move cloth, each on a grid and on meshes.
struct Way {
  const char* name;
  std::string solver, material;
  bool on_mesh;
  int order;  // of the step
};
const std::string kSprings = R"("damping": 0.001, "stiffness": {"structural": 2, "shear": 1, "bend": 0.1})";
const std::string kFabric =
    R"("fabric": {"warp": 3, "weft": 2, "shear": 0.5, "poisson": 0.2, "bending_warp": 1e-6})";
std::vector<Way> ways() {
  const std::string explicit_steps = R"("solver": {"kind": "mass_spring"}, )";
  const std::string implicit_steps = R"("solver": {"kind": "multigrid", "residual": 1e-4}, )";
  return {{"mass_spring, a grid", explicit_steps, kSprings, false, 1},
          {"mass_spring, a mesh", explicit_steps, kSprings, true, 1},
          {"mass_spring, a grid of fabric", explicit_steps, kFabric, false, 1},
          {"mass_spring, sums by springs",
           R"("solver": {"kind": "mass_spring", "forces": "spring_centric"}, )", kSprings, true, 1},
          {"xpbd, a grid", R"("solver": {"kind": "xpbd"}, )", kSprings, false, 1},
          {"multigrid, a grid", implicit_steps, kSprings, false, 2},
          {"multigrid, a mesh", implicit_steps, kSprings, true, 2},
          {"multigrid, a mesh of fabric", implicit_steps, kFabric, true, 2}};
}

/// A free sheet of 1 m by 0.8 m in the plane y = 0, by one of the ways.
SolverRig sheet(gpu::Device& device, const Way& way, const std::string& world, double dt) {
  const std::string shape =
      way.on_mesh ? R"("mesh": "a.obj")" : R"("grid": [9, 8], "size": [1, 0.8], "plane": "xz")";
  const scene::Scene scene = scene_of(way.solver + world + R"("cloths": [{)" + shape + R"(, "density": )" +
                                      text(kDensity) + ", " + way.material + "}]");
  return SolverRig(device, scene, dt, {way.on_mesh ? jittered_sheet(10, 8, 1, 0.8) : mesh::TriangleMesh{}});
}

void set_velocity(SolverRig& rig, const Vec3d& velocity) {
  const std::vector<Vec4f> x = rig.positions();
  rig.set(x, std::vector<Vec4f>(x.size(), Vec4f::from(velocity.to<float>(), 0)));
}

Vec3d mean_velocity(SolverRig& rig) {
  Vec3d sum;
  const std::vector<Vec4f> v = rig.velocities();
  for (const Vec4f& one : v) sum += one.xyz().to<double>();
  return sum / static_cast<double>(v.size());
}

/// How far the fastest node is from the mean [m/s].
double spread(SolverRig& rig) {
  const Vec3d mean = mean_velocity(rig);
  double most = 0;
  for (const Vec4f& v : rig.velocities()) most = std::max(most, length(v.xyz().to<double>() - mean));
  return most;
}

/// The order by which what `value` returns for steps of h, h/2 and h/4 goes to `exact`.
template <class Value>
void check_order(const Way& way, double exact, double h, const Value& value) {
  const double a = std::abs(value(h) - exact), b = std::abs(value(h / 2) - exact),
               c = std::abs(value(h / 4) - exact);
  CAPTURE(a);
  CAPTURE(b);
  CAPTURE(c);
  // Of the second order the first step, by backward Euler, counts as its square too.
  CHECK(std::log2(b / c) > way.order - 0.3);
  CHECK(std::log2(a / c) > 2 * (way.order - 0.3));
}

}  // namespace

TEST_CASE("in gusts, with held nodes, a step in air equals the reference") {
  GpuFixture fixture;
  const std::string world = R"("drag": 0.5, "wind": {"velocity": [-2, 1.5, 6], "gusts": 0.9}, "air": {}, )";
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    if (way.order == 2) continue;  // tests of the kernels of multigrid have wind
    SolverRig rig = sheet(fixture.device(), way, world, 1e-3);
    rig.perturb(7, 0.02, 3.0);
    rig.hold(20, {0.3, 0.1, 0.2}, 20, 10);
    reference::MassSpringSystem expected = rig.reference();
    const std::vector<Vec3d> before = expected.velocity;
    const scene::Scene settings =
        scene_of(way.solver + R"("cloths": [{"grid": [2, 2], "size": [1, 1], "density": 1}])");
    const auto stepper = reference::make_stepper(settings.solver, rig.model().host, rig.dt());
    const std::vector<Vec3d> places = expected.position;
    stepper->advance({expected, places, rig.dt()});
    rig.advance(1);
    const std::vector<Vec4f> found = rig.velocities();
    double most = 0, change = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
      most = std::max(most, length(found[n].xyz().to<double>() - expected.velocity[n]));
      change = std::max(change, length(expected.velocity[n] - before[n]));
    }
    // Of the air: 3 * 4e-6 by the margin of its inverse (method/symmetric.wgsl). Velocities of some 10 m/s round to
    // 1e-6; of xpbd, ways of 0.01 m to 1e-9 m, twice, in 1 ms.
    CAPTURE(change);
    CHECK(most < 2e-5 * change + 1e-5);
  }
}

TEST_CASE("a sheet that falls broadside goes as v∞ tanh(g t / v∞)") {
  GpuFixture fixture;
  const double terminal = std::sqrt(2 * kDensity * kGravity / (1.1 * 1.3)), time = 0.1;
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    check_order(way, -terminal * std::tanh(kGravity * time / terminal), time / 20, [&](double h) {
      SolverRig rig = sheet(fixture.device(), way,
                            R"("air": {"density": 1.1, "pressure": 1.3, "lift": 2, "friction": 0.5}, )", h);
      rig.advance(static_cast<std::uint32_t>(std::lround(time / h)));
      // All nodes alike, whatever their triangles: to the rounding of 80 steps of some 0.8 m/s, and of places that
      // stand for velocities, 1e-7 m by h.
      CHECK(spread(rig) < 80 * 2e-7 + 1e-7 / h);
      return mean_velocity(rig).y;
    });
  }
}

TEST_CASE("a sheet that flies edge-on is slowed as 1/v = 1/v0 + C_F ρ t / 2 ρ_s") {
  GpuFixture fixture;
  const double v0 = 12, time = 0.4, rate = 0.3 * 1.2 / (2 * kDensity), exact = 1 / (1 / v0 + rate * time);
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    const auto speed_after = [&](double h) {
      SolverRig rig = sheet(fixture.device(), way,
                            R"("gravity": [0, 0, 0], "air": {"density": 1.2, "friction": 0.3}, )", h);
      set_velocity(rig, {v0 * 0.6, 0, v0 * 0.8});
      rig.advance(static_cast<std::uint32_t>(std::lround(time / h)));
      const Vec3d v = mean_velocity(rig);
      CHECK(std::abs(v.y) < 1e-5);
      CHECK(v.x / v.z == doctest::Approx(0.75).epsilon(1e-4));
      return length(v);
    };
    // 1/v' = (1 + h k v)/v = 1/v + h k by equation 3: exact, but for 3 * 4e-6 of each change by the inverse's margin.
    if (way.order == 1)
      CHECK(std::abs(speed_after(time / 200) - exact) < 1.2e-5 * v0);
    else
      check_order(way, exact, time / 20, speed_after);
  }
}

TEST_CASE("a sheet at an angle to the wind begins to move by pressure, lift and friction") {
  GpuFixture fixture;
  const double angle = 0.3, speed = 8, h = 1e-5;
  const Vec3d wind{speed * std::cos(angle), speed * std::sin(angle), 0};
  // ½ ρ u² (C_D sin² + C_L sin cos) along the normal, ½ ρ u² C_F cos along the sheet, by its mass.
  const double pressure = 0.5 * 1.2 * speed * speed / kDensity;
  const Vec3d expected{pressure * 0.02 * std::cos(angle),
                       pressure * std::sin(angle) * (1.1 * std::sin(angle) + 1.5 * std::cos(angle)), 0};
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    SolverRig rig =
        sheet(fixture.device(), way,
              R"("gravity": [0, 0, 0], "wind": {"velocity": [)" + text(wind.x) + ", " + text(wind.y) +
                  R"(, 0]}, "air": {"density": 1.2, "pressure": 1.1, "lift": 1.5, "friction": 0.02}, )",
              h);
    rig.advance(1);
    for (const Vec4f& v : rig.velocities()) {
      // A step is off by h times the rate, some 1000 /s; xpbd's velocity is a way of 1e-10 m by 1e-5 s.
      const Vec3d acceleration = v.xyz().to<double>() / h;
      CHECK(length(acceleration - expected) < 0.01 * length(expected));
      CHECK(std::abs(acceleration.x - expected.x) < 0.02 * expected.x + 1e-3 * expected.y);
    }
  }
}

TEST_CASE("cloth that moves with an even wind feels no air") {
  GpuFixture fixture;
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    const auto run = [&](const std::string& air) {
      SolverRig rig = sheet(fixture.device(), way,
                            R"("gravity": [0, 0, 0], "wind": {"velocity": [3, 2, -1]}, )" + air, 1.0 / 512);
      set_velocity(rig, {3, 2, -1});
      rig.advance(64);
      return mean_velocity(rig);
    };
    // What 64 steps round velocities by.
    CHECK(length(run(R"("air": {}, )") - Vec3d{3, 2, -1}) < 64 * 3 * 1.2e-7 * 2);
  }
}

TEST_CASE("the air's force on a closed box is the law's integral over its faces") {
  GpuFixture fixture;
  // Faces of 0.4 by 0.3, 0.4 by 0.5, 0.3 by 0.5 m, each of two triangles.
  const Vec3d size{0.4, 0.3, 0.5}, velocity{4, -2, 1};
  mesh::TriangleMesh box;
  for (int k = 0; k < 8; ++k)
    box.positions.push_back(
        Vec3d{(k & 1) * size.x, (k >> 1 & 1) * size.y, (k >> 2 & 1) * size.z}.to<float>());
  box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  Vec3d expected;  // of both faces across each axis
  for (int axis = 0; axis < 3; ++axis) {
    const double area = 2 * size[(axis + 1) % 3] * size[(axis + 2) % 3];
    Vec3d n;
    n[axis] = 1;
    const Vec3d across = velocity[axis] * n, along = velocity - across;
    expected -=
        0.5 * 1.2 * area *
        ((1.1 * std::abs(velocity[axis]) + 1.5 * length(along)) * across + 0.02 * length(velocity) * along);
  }
  for (const char* solver : {"mass_spring", "multigrid"}) {
    CAPTURE(std::string(solver));
    const double h = 1e-6;
    SolverRig rig(fixture.device(),
                  scene_of(R"("solver": {"kind": ")" + std::string(solver) +
                           R"("}, "gravity": [0, 0, 0], "air": {"density": 1.2, "pressure": 1.1, "lift": 1.5,
                              "friction": 0.02}, "cloths": [{"mesh": "a.obj", "density": 0.002}])"),
                  h, {box});
    set_velocity(rig, velocity);
    rig.advance(1);
    Vec3d force;
    const std::vector<Vec4f> x = rig.positions(), v = rig.velocities();
    for (std::size_t n = 0; n < x.size(); ++n)
      force += (v[n].xyz().to<double>() - velocity) / (h * static_cast<double>(x[n].w));
    // Velocities of 4 m/s round to 2.4e-7 of 0.005 m/s; a step is off by h times some 5000 /s.
    CHECK(length(force - expected) < 0.01 * length(expected));
  }
}

TEST_CASE("in still air thrown cloth loses energy, by explicit and implicit steps, however light it is") {
  GpuFixture fixture;
  for (const Way& way : ways()) {
    CAPTURE(std::string(way.name));
    // Of air as heavy as water the sheet's own mass is 1/1000 of what stops it in a step.
    for (const double density : {1.2, 1000.0}) {
      CAPTURE(density);
      const double h = way.order == 2 ? 1.0 / 60 : 1e-3;
      SolverRig rig = sheet(fixture.device(), way,
                            R"("gravity": [0, 0, 0], "air": {"density": )" + text(density) + "}, ", h);
      rig.perturb(11, 0.01, 5.0);
      double before = reference::energy(rig.reference());
      const double first = before;
      for (int part = 0; part < 20; ++part) {
        rig.advance(2);
        const double now = reference::energy(rig.reference());
        // f32: elongations of 0.1 m to 1e-7.
        CHECK(now < before + 1e-5 * first);
        before = now;
      }
      CHECK(before < 0.9 * first);  // without air free cloth keeps it, but for its own damping
    }
  }
}
