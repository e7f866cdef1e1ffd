// Bodies with volume: kernels beside the same substeps in double, and both beside laws that neither was written from.
// The laws of one tetrahedron: tests/element/test_tet.cpp; bodies in contact: tests/sim/test_solids.cpp.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "gpu/gpu_fixture.hpp"
#include "method/method.hpp"
#include "method/projection/reference/projection_stepper.hpp"
#include "method/projective_dynamics/reference/projective_dynamics_stepper.hpp"
#include "method/vbd/node_colors.hpp"
#include "method/vbd/reference/vbd_stepper.hpp"
#include "model/solid.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kUlp = 1.0 / 16777216;  // 2^-24

/// A method, how often a substep moves each tetrahedron, and what it keeps to rounding.
struct Way {
  std::string solver;
  int moves = 1;
  bool angular_momentum = false, neo_hookean = true;
};
const Way kWays[] = {{R"("solver": {"kind": "mass_spring"})", 1, true},
                     {R"("solver": {"kind": "vbd", "iterations": 1})", 1, true},
                     {R"("solver": {"kind": "vbd", "iterations": 10})", 1, true},
                     {R"("solver": {"kind": "xpbd", "iterations": 1})", 2},
                     {R"("solver": {"kind": "xpbd", "iterations": 5})", 10},
                     {R"("solver": {"kind": "pbd", "iterations": 2})", 4},
                     {R"("solver": {"kind": "projective_dynamics", "iterations": 20})", 20, true, false},
                     {R"("solver": {"kind": "multigrid", "residual": 1e-4})"},
                     {R"("solver": {"kind": "fem", "residual": 1e-4})"}};
const std::string kEnergies[] = {"neo_hookean", "corotated"};

/// Each way with each energy that it takes.
template <class Test>
void by_each(const Test& test) {
  for (const Way& way : kWays)
    for (const std::string& energy : kEnergies)
      if (way.neo_hookean || energy != kEnergies[0]) test(way, energy);
}

std::string body(const std::string& energy, const std::string& more, double damping = 0.002) {
  return R"({"density": 1000, "material": {"young": 4e4, "poisson": 0.4, "damping": )" +
         std::to_string(damping) + R"(, "energy": ")" + energy + R"("}, )" + more + "}";
}

/// What a node's place may be wrong by after a substep: its tetrahedra's stresses, of some dozens of roundings, by what
/// they do in h². F has the roundings of three products and two sums; a stress those of F twice, of two products of F
/// and of their sums: fewer than 40 in all.
double rounding_of_step(const Model& model, const reference::MassSpringSystem& system, double h) {
  constexpr double kRoundings = 40;
  double worst = 0;
  std::vector<double> pull(system.position.size(), 0);
  for (const reference::SolidBody& solid : system.solids) {
    const tet::Tets& all = solid.tets;
    const double delays = 1 + all.law.delay / h;
    for (std::size_t t = 0; t < all.tets.size(); ++t) {
      const Mat3 f = all.deformation(t, std::span(system.position).subspan(solid.first, solid.count));
      const double size = 1 + length(f.x) + length(f.y) + length(f.z);
      const double stress = delays * (2 * all.law.mu + all.law.lambda) * size * size * size;
      for (std::size_t k = 0; k < 4; ++k)
        pull[solid.first + all.tets[t][k]] += all.rests[t].volume * stress * length(all.rests[t].slope[k]);
    }
  }
  for (std::size_t n = 0; n < pull.size(); ++n)
    worst = std::max(worst, kRoundings * kUlp * h * h * model.inverse_mass(n) * pull[n]);
  return worst;
}

std::vector<Vec3d> doubles(const std::vector<Vec4f>& values) {
  std::vector<Vec3d> made;
  for (const Vec4f& v : values) made.push_back(v.xyz().to<double>());
  return made;
}

struct Momenta {
  Vec3d linear, angular;  // about the origin
};
Momenta momenta(const Model& model, const std::vector<Vec3d>& x, const std::vector<Vec3d>& v) {
  Momenta sum;
  for (std::size_t n = 0; n < x.size(); ++n) {
    sum.linear += model.mass[n] * v[n];
    sum.angular += model.mass[n] * cross(x[n], v[n]);
  }
  return sum;
}

}  // namespace

TEST_CASE("bodies: three substeps equal the reference, by every method that takes them, of both energies") {
  GpuFixture fixture;
  by_each([&](const Way& method, const std::string& energy) {
    for (const double damping : {0.0, 0.003}) {
      CAPTURE(method.solver);
      CAPTURE(energy);
      const auto scene = scene_of(
          method.solver + R"(, "bodies": [)" +
          body(energy, R"("block": [4, 3, 5], "size": [0.4, 0.3, 0.5], "pins": [{"nodes": [0, 7]}])",
               damping) +
          "," +
          body(energy,
               R"("block": [1, 1, 1], "size": [0.1, 0.1, 0.1], "transform": {"translate": [1, 0, 0]})") +
          "]");
      SolverRig rig(fixture.device(), scene, 5e-4);
      rig.perturb(3, 0.01, 1);
      const std::vector<Vec3d> start = rig.reference().position;
      const double step = rounding_of_step(rig.model().host, rig.reference(), rig.dt());
      const reference::MassSpringSystem exact = exact_after(rig, scene, 3);
      rig.advance(3);
      const std::vector<Vec3d> end = doubles(rig.positions());
      double worst = 0, way = 0;
      for (std::size_t n = 0; n < end.size(); ++n) {
        worst = std::max(worst, length(end[n] - exact.position[n]));
        way = std::max(way, length(exact.position[n] - start[n]));
      }
      // What a step is off, its velocity carries on: 1 + 2 + 3 of them; a place below 1 m rounds by half an ulp.
      const double allowed = 6 * step + 3 * 2 * kUlp;
      MESSAGE(method.solver << ", " << energy << ": " << worst << " m off after a way of " << way
                            << " m; allowed " << allowed);
      CHECK(worst < allowed);
      CHECK(allowed < 0.01 * way);
    }
  });
}

TEST_CASE(
    "a bar that is let go under its weight swings as waves along it say, to twice its extension at rest") {
  GpuFixture fixture;
  // ν = 0: the bar is a line. Its end falls freely until the wave from its clamp comes; the rest is its mirror image.
  constexpr double kLong = 1, kSpeed = 10, kGravity = 0.5;  // c² = E/ρ
  const auto scene = scene_of(
      R"("gravity": [0, -0.5, 0], "solver": {"kind": "mass_spring"}, "bodies": [{"block": [1, 40, 1],
         "size": [0.025, 1, 0.025], "density": 1000,
         "material": {"young": 1e5, "poisson": 0, "damping": 0, "energy": "corotated"},
         "pins": [{"box": {"min": [-1, 0.4999, -1], "max": [1, 0.6, 1]}}]}])");
  SolverRig rig(fixture.device(), scene, 5e-4);
  double worst = 0;
  const double highest = kGravity * kLong * kLong / (kSpeed * kSpeed);  // 5 mm
  for (int k = 1; k <= 40; ++k) {                                       // a swing of 4 L/c
    rig.advance(20);
    const double t = std::fmod(k * 20 * rig.dt(), 4 * kLong / kSpeed),
                 half = t < 2 * kLong / kSpeed ? t : 4 * kLong / kSpeed - t;
    const double first = kGravity * half * half / 2,
                 second = highest - kGravity * std::pow(2 * kLong / kSpeed - half, 2) / 2;
    const double expected = half < kLong / kSpeed ? first : second;
    double end = 0;
    for (const Vec3d& x : doubles(rig.positions())) end = std::max(end, -0.5 - x.y);
    worst = std::max(worst, std::abs(end - expected) / highest);
  }
  MESSAGE("at most " << worst << " of the largest extension off");
  // Cells of L/40 smear the wave's front over some of them, each L/40/c of 2 L/c: a few parts of a hundred; strain of
  // 0.5 % makes the speed of waves differ by as much.
  CHECK(worst < 0.03);
}

TEST_CASE("a free body that spins and swings keeps its momentum, by three methods its angular momentum") {
  GpuFixture fixture;
  by_each([&](const Way& method, const std::string& energy) {
    const auto scene = scene_of(method.solver + R"(, "gravity": [0, 0, 0], "bodies": [)" +
                                body(energy, R"("block": [4, 4, 4], "size": [0.2, 0.2, 0.2])") + "]");
    SolverRig rig(fixture.device(), scene, 2.5e-4);
    const Model& model = rig.model().host;
    Random random(9);
    std::vector<Vec4f> x = rig.positions(), v;
    for (const Vec4f& p : x) {
      const Vec3d at = p.xyz().to<double>(), spin{3, 5, -2};
      const Vec3d jolt{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      v.push_back(Vec4f::from((cross(spin, at) + Vec3d{0.3, 0.1, 0} + 0.5 * jolt).to<float>(), 0));
    }
    rig.set(x, v);
    const Momenta before = momenta(model, doubles(x), doubles(v));
    constexpr int kSteps = 150;
    rig.advance(kSteps);
    const Momenta after = momenta(model, doubles(rig.positions()), doubles(rig.velocities()));
    const double total = std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
    const double drift = length(after.linear - before.linear),
                 turn = length(after.angular - before.angular) / length(before.angular);
    MESSAGE(method.solver << ", " << energy << ": momentum " << drift / (total * 0.33)
                          << ", angular momentum " << turn);
    // Each step rounds each velocity of about 1 m/s, and so does each projection of the 24 tetrahedra at a node.
    CHECK(drift < total * kSteps * 24 * method.moves * kUlp);
    // x and v of semi-implicit steps are of one moment, so x × Δv is exact but for rounding; vbd and
    // projective dynamics see to it. Others
    // turn what they found at the ways so far.
    CHECK(turn < (method.angular_momentum ? 1e-3 : 0.1));
  });
}

namespace {

/// Where the nodes of a body begin that has been mistreated.
Vec3d mistreated(const std::string& how, const Vec3d& x, Random& random) {
  const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), c = random.uniform(-1, 1);
  if (how == "flat") return {x.x, 1e-4 * a, x.z};
  if (how == "mirrored") return {-x.x, x.y + 1e-3 * a, x.z + 1e-3 * b};
  if (how == "scattered by a cell") return {x.x + 0.1 * a, x.y + 0.1 * b, x.z + 0.1 * c};
  return {0.15 * a, 0.15 * b, 0.15 * c};  // anywhere
}

std::size_t inside_out(const tet::Tets& tets, const std::vector<Vec3d>& places) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < tets.tets.size(); ++t)
    if (mesh::six_volumes(tets.corners(t, places)) <= 0) ++count;
  return count;
}

}  // namespace

TEST_CASE(
    "a body that was flattened, mirrored or scattered comes back to its shape; corotated, from anywhere") {
  GpuFixture fixture;
  const Way ways[] = {{R"("solver": {"kind": "vbd", "iterations": 20})"},
                      {R"("solver": {"kind": "xpbd", "iterations": 4})"},
                      {R"("solver": {"kind": "projective_dynamics", "iterations": 20})", 1, false, false},
                      {R"("solver": {"kind": "fem"})"}};
  for (const Way& way : ways)
    for (const std::string& energy : kEnergies) {
      if (!way.neo_hookean && energy == kEnergies[0]) continue;
      const auto scene = scene_of(way.solver + R"(, "gravity": [0, 0, 0], "drag": 2, "bodies": [)" +
                                  body(energy, R"("block": [3, 3, 3], "size": [0.3, 0.3, 0.3])", 0.01) + "]");
      SolverRig rig(fixture.device(), scene, 1.0 / 240);
      const Model& model = rig.model().host;
      const tet::Tets tets = body_tets(model, model.bodies[0]);
      const std::vector<Vec4f> rest = rig.positions(), still(rest.size());
      for (const std::string how : {"flat", "mirrored", "scattered by a cell", "anywhere"}) {
        // Of neo-Hookean bodies some that begin anywhere end twisted, at rest in a state of their own: docs/bodies.md.
        if (how == "anywhere" && energy == "neo_hookean") continue;
        if (how == "mirrored" && !way.neo_hookean) continue;  // docs/solvers/projective_dynamics.md, Limits
        Random random(21);
        std::vector<Vec4f> x = rest;
        for (Vec4f& p : x) p = Vec4f::from(mistreated(how, p.xyz().to<double>(), random).to<float>(), p.w);
        rig.set(x, still);
        const double before = tets.energy(doubles(x));
        CHECK(4 * inside_out(tets, doubles(x)) > tets.tets.size());
        std::vector<Vec3d> end;
        if (how == "mirrored" && way.neo_hookean) {
          rig.advance(160);
          end = doubles(rig.positions());
        } else {  // the same in double, which is quicker than so many dispatches
          end = exact_after(rig, scene, how == "anywhere" ? 720 : 240).position;
        }
        MESSAGE(way.solver << ", " << energy << ", " << how << ": energy " << before << " J at first, "
                           << tets.energy(end) << " J, " << inside_out(tets, end) << " of "
                           << tets.tets.size() << " inside out");
        CHECK(inside_out(tets, end) == 0);
        CHECK(tets.energy(end) < 1e-3 * before);
      }
    }
}

TEST_CASE(
    "many sweeps of xpbd over a body are backward Euler, to rounding, by few more the shorter the step") {
  GpuFixture fixture;
  for (const std::string& energy : kEnergies)
    for (const double damping : {0.0, 0.003})
      for (const auto& [step, sweeps] :
           {std::pair(5e-4, 6U), std::pair(4e-3, 20U), std::pair(1.0 / 60, 160U)}) {
        const auto scene = scene_of(R"("bodies": [)" +
                                    body(energy, R"("block": [3, 2, 3], "size": [0.3, 0.2, 0.3],
                                      "pins": [{"box": {"min": [-1, 0.099, -1], "max": [1, 1, 1]}}])",
                                         damping) +
                                    "]");
        SolverRig rig(fixture.device(), scene, step);
        rig.perturb(3, 0.02, 1);
        reference::MassSpringSystem system = rig.reference();
        const reference::MassSpringSystem start = system;
        reference::ProjectionStepper(rig.model().host, sweeps, Multipliers::Kept)
            .advance({system, start.position, step});
        // M ((v' - v)/h - g) is what the laws of element/tet say at its end: elastic forces, and where the strain has
        // changed, damping's.
        const tet::Tets& tets = system.solids[0].tets;
        std::vector<Vec3d> forces(system.position.size());
        tets.add_forces(system.position, forces);
        for (std::size_t t = 0; damping > 0 && t < tets.tets.size(); ++t) {
          // By how much it differs from its start, turned as it is nearest: 2 µ of that and λ of its reach.
          const Mat3 before = tets.deformation(t, start.position),
                     after = tets.deformation(t, system.position);
          const Mat3 turned = tet::nearest_rotation(after * transposed(before)) * before;
          const Mat3 now = transposed(tet::nearest_rotation(after)) * after,
                     then = transposed(tet::nearest_rotation(before)) * before;
          const double grown = now.x.x + now.y.y + now.z.z - (then.x.x + then.y.y + then.z.z);
          const Mat3 stress = 2 * tets.law.mu * (after + -1.0 * turned) +
                              tets.law.lambda * grown * tet::nearest_rotation(after);
          const tet::Corners own = tet::forces(tets.rests[t], (damping / step) * stress);
          for (std::size_t k = 0; k < 4; ++k) forces[tets.tets[t][k]] += own[k];
        }
        double left = 0, largest = 0;
        for (std::size_t n = 0; n < forces.size(); ++n) {
          if (system.inverse_mass[n] == 0) continue;
          const Vec3d needed = ((system.velocity[n] - start.velocity[n]) / step - system.acceleration) /
                               system.inverse_mass[n];
          left = std::max(left, length(needed - forces[n]));
          largest = std::max(largest, length(forces[n]));
        }
        MESSAGE(energy << ", damping " << damping << ", " << step << " s, " << sweeps
                       << " sweeps: " << left / largest << " of the forces left");
        CHECK(left < 1e-5 * largest);
      }
}

TEST_CASE(
    "one sweep of xpbd lets a hung bar be softer as equation 18 says, and no more; sweeps and steps mend "
    "it") {
  GpuFixture fixture;
  constexpr double kYoung = 4e4, kHigh = 0.4, kG = 9.81;
  const double law = 1000 * kG * kHigh * kHigh / (2 * kYoung);  // 19.6 mm
  double before = HUGE_VAL;
  for (const auto& [step, sweeps] :
       {std::pair(1.0 / 240, 1), std::pair(1.0 / 240, 4), std::pair(1.0 / 480, 4)}) {
    const auto scene =
        scene_of(R"("gravity": [0, -9.81, 0], "drag": 8, "solver": {"kind": "xpbd", "iterations": )" +
                 std::to_string(sweeps) +
                 R"(}, "bodies": [{"block": [2, 8, 2], "size": [0.1, 0.4, 0.1], "density": 1000,
            "material": {"young": 4e4, "poisson": 0, "damping": 0.002, "energy": "corotated"},
            "pins": [{"box": {"min": [-1, 0.199, -1], "max": [1, 1, 1]}}]}])");
    SolverRig rig(fixture.device(), scene, step);
    const reference::MassSpringSystem end = exact_after(rig, scene, static_cast<int>(2.5 / step));
    double lowest = 0;
    for (const Vec3d& x : end.position) lowest = std::max(lowest, -0.2 - x.y);
    // Cells of 50 mm: nodes inside weigh ρ a³, V S is 1/(3 ρ a²) there, and up to four times that at an edge.
    const double softer = (step * step + step * 0.002) * kYoung / (3 * 1000 * 0.05 * 0.05);
    const double more = lowest / law - 1;
    MESSAGE("steps of " << 1e3 * step << " ms, " << sweeps << " sweeps: longer than its law by " << more
                        << " of it; one sweep by " << softer << " to " << 4 * softer);
    CHECK(more > -0.01);  // stretched by 10 % on the mean, a corotated bar is as long as a spring
    CHECK(more < 0.01 + 4 * softer / sweeps);
    CHECK(more < before);
    before = more;
  }
  CHECK(before < 0.02);
}

TEST_CASE("many iterations of projective dynamics end where many sweeps of xpbd do") {
  GpuFixture fixture;
  for (const double step : {5e-4, 4e-3, 1.0 / 60}) {
    const std::string block = R"("block": [3, 2, 3], "size": [0.3, 0.2, 0.3],
                                 "pins": [{"box": {"min": [-1, 0.099, -1], "max": [1, 1, 1]}}])";
    const auto scene = scene_of(R"("bodies": [)" + body("corotated", block, 0) + "]");
    SolverRig rig(fixture.device(), scene, step);
    rig.perturb(3, 0.02, 1);
    reference::MassSpringSystem swept = rig.reference(), relaxed = swept;
    const std::vector<Vec3d> start = swept.position;
    reference::ProjectionStepper(rig.model().host, 160, Multipliers::Kept).advance({swept, start, step});
    reference::ProjectiveDynamicsStepper(rig.model().host, step, 1000).advance({relaxed, start, step});
    double off = 0, way = 0;
    for (std::size_t n = 0; n < start.size(); ++n) {
      off = std::max(off, length(swept.position[n] - relaxed.position[n]));
      way = std::max(way, length(swept.position[n] - start[n]));
    }
    MESSAGE(step << " s: " << off << " m apart, of a way of " << way << " m");
    CHECK(off < 1e-6 * way);
  }
}

TEST_CASE("projective dynamics refuses neo-Hookean bodies, and says which methods take them") {
  const auto scene = scene_of(R"("solver": {"kind": "projective_dynamics"}, "bodies": [)" +
                              body("neo_hookean", R"("block": [1, 1, 1], "size": [0.1, 0.1, 0.1])") + "]");
  auto model = build_model(scene, std::vector<mesh::TriangleMesh>(1));
  REQUIRE_OK(model);
  const auto choice = choose_method(scene, *model);
  REQUIRE_FALSE(choice);
  const std::string& said = choice.error().message;
  CHECK_MESSAGE(said.find("bodies[0].material.energy is \"neo_hookean\", which solver.kind "
                          "\"projective_dynamics\" does not take; ") != std::string::npos,
                said);
  CHECK(said.find("\"vbd\"") != std::string::npos);
}

TEST_CASE("no sweep of vertex block descent over a neo-Hookean body brings up what its substep minimises") {
  GpuFixture fixture;
  const auto scene = scene_of(R"("gravity": [0, 0, 0], "bodies": [)" +
                              body("neo_hookean", R"("block": [3, 2, 3], "size": [0.3, 0.2, 0.3])", 0) + "]");
  SolverRig rig(fixture.device(), scene, 1.0 / 60);
  const Model& model = rig.model().host;
  reference::MassSpringSystem system = rig.reference();
  system.inverse_mass[0] = 0;  // a body that goes free moves as a whole after its sweeps: equation 8
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    for (std::size_t n = 0; n < system.position.size(); ++n)
      for (int axis = 0; axis < 3; ++axis) {
        system.position[n][axis] = model.rest_position[n][axis] + random.uniform(-0.2, 0.2);
        system.velocity[n][axis] = n == 0 ? 0 : random.uniform(-20, 20);
      }
    const std::vector<Vec3d> start = system.position, velocity = system.velocity;
    const auto objective = [&](const std::vector<Vec3d>& x) {
      double sum = system.solids[0].energy(x);
      for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3d off = x[n] - start[n] - rig.dt() * velocity[n];
        sum += dot(off, off) * model.mass[n] / (2 * rig.dt() * rig.dt());
      }
      return sum;
    };
    double before = 0;
    for (const std::uint32_t sweeps : {1U, 2U, 3U, 6U, 12U}) {
      reference::MassSpringSystem moved = system;
      reference::VbdStepper stepper(model, sweeps);
      stepper.advance({moved, start, rig.dt()});
      const double after = objective(moved.position);
      if (sweeps > 1) CHECK(after <= before * (1 + 1e-12));
      before = after;
    }
  }
}

TEST_CASE("no two nodes of a colour are of one tetrahedron") {
  const auto scene = scene_of(R"("bodies": [)" +
                              body("neo_hookean", R"("block": [5, 4, 3], "size": [0.5, 0.4, 0.3])") + "]");
  auto model = build_model(scene, std::vector<mesh::TriangleMesh>(1));
  REQUIRE_OK(model);
  const Body& solid = model->bodies[0];
  const NodeColors colors = color_nodes(*model, solid);
  std::vector<std::uint32_t> color_of(solid.vertex_count, ~0U);
  for (std::uint32_t color = 0; color < colors.count(); ++color)
    for (std::uint32_t at = colors.starts[color]; at < colors.starts[color + 1]; ++at)
      color_of[colors.nodes[at]] = color;
  CHECK(std::count(color_of.begin(), color_of.end(), ~0U) == 0);
  MESSAGE(colors.count() << " colours");
  for (const mesh::Tet& t : solid.tets)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) CHECK(color_of[t[a]] != color_of[t[b]]);
}
