// Pieces of cloth that nothing holds, by vertex block descent: each has the momentum that gravity gives it, and keeps
// its spin, however few the sweeps. No number here comes from the method.
#include <cmath>

#include "gpu/gpu_fixture.hpp"
#include "mesh/irregular_meshes.hpp"
#include "method/pieces/free_pieces.hpp"
#include "solver_rig.hpp"

using namespace weft;

namespace {

constexpr double kGravity = 9.81;  // [m/s²]

/// What a piece moves with as a whole, and about its middle.
struct Motion {
  Vec3d momentum, spin;          // [kg·m/s], [kg·m²/s]
  double speeds = 0, turns = 0;  // the sums of what its nodes have of them, whatever their directions
};

template <class System>
Motion motion_of(const System& system, std::span<const std::uint32_t> nodes) {
  Motion sum;
  double mass = 0;
  Vec3d middle;
  for (const std::uint32_t node : nodes) {
    const double m = 1 / system.inverse_mass[node];
    mass += m;
    middle += m * system.position[node];
    sum.momentum += m * system.velocity[node];
    sum.speeds += m * length(system.velocity[node]);
  }
  for (const std::uint32_t node : nodes) {
    const Vec3d arm = system.position[node] - middle / mass;
    const Vec3d turn = cross(arm, system.velocity[node] - sum.momentum / mass) / system.inverse_mass[node];
    sum.spin += turn;
    sum.turns += length(turn);
  }
  return sum;
}

/// Two sheets beside each other in one mesh.
mesh::TriangleMesh two_sheets() {
  mesh::TriangleMesh both = jittered_sheet(9, 7, 0.2, 0.15);
  const mesh::TriangleMesh other = jittered_sheet(6, 11, 0.12, 0.25);
  const auto first = static_cast<std::uint32_t>(both.positions.size());
  for (const Vec3f& p : other.positions) both.positions.push_back(p + Vec3f{0.4F, 0.1F, 0});
  for (const mesh::Triangle& t : other.triangles)
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return both;
}

}  // namespace

TEST_CASE("pieces that elements hold together are found, and those that a pin holds are none of them") {
  const auto scene = scene_of(R"("cloths": [{"grid": [5, 4], "size": [0.4, 0.3], "density": 0.2},
      {"mesh": "m.obj", "density": 0.2}, {"grid": [3, 3], "size": [0.2, 0.2], "density": 0.2, "pins": ["top_left"]}])");
  const auto model = build_model(scene, {{}, two_sheets(), {}});
  REQUIRE_OK(model);
  const FreePieces pieces = free_pieces(*model, PiecesOf::Elements);
  REQUIRE(pieces.count() == 3);
  CHECK(pieces.starts == std::vector<std::uint32_t>{0, 20, 20 + 63, 20 + 63 + 66});
  for (std::uint32_t at = 0; at < pieces.nodes.size(); ++at) CHECK(pieces.nodes[at] == at);
}

TEST_CASE("a piece that nothing holds falls with g and keeps its spin by vbd, however few the sweeps") {
  GpuFixture fixture;
  const std::string fabric =
      R"("density": 0.2, "fabric": {"warp": 900, "weft": 300, "shear": 60, "poisson": 0.25,
      "bending_warp": 4e-4, "bending_weft": 1e-4, "damping": 0.01})";
  const std::string springs = R"("density": 0.2, "damping": 0.02,
      "stiffness": {"structural": 500, "shear": 200, "bend": 20})";
  for (const double dt : {1.0 / 60, 1.0 / 480})
    for (const int sweeps : {1, 10}) {
      CAPTURE(dt);
      CAPTURE(sweeps);
      const auto scene = scene_of(R"("solver": {"kind": "vbd", "iterations": )" + std::to_string(sweeps) +
                                  R"(}, "cloths": [
        {"grid": [13, 9], "size": [0.5, 0.4], )" +
                                  springs + R"(},
        {"grid": [2, 60], "size": [0.005, 0.3], )" +
                                  springs + R"(},
        {"mesh": "m.obj", )" + fabric +
                                  R"(},
        {"grid": [5, 5], "size": [0.2, 0.2], "pins": ["top"], )" +
                                  springs + R"(}],
        "bodies": [{"block": [2, 3, 2], "size": [0.1, 0.15, 0.1], "density": 900,
                    "material": {"young": 20000, "poisson": 0.45}}])");
      SolverRig rig(fixture.device(), scene, dt, {{}, {}, two_sheets(), {}, {}});
      rig.perturb(11, 0.002, 2.0);
      const FreePieces pieces = free_pieces(rig.model().host, PiecesOf::Elements);
      REQUIRE(pieces.count() == 5);
      const auto piece = [&](std::size_t at) {
        return std::span(pieces.nodes).subspan(pieces.starts[at], pieces.starts[at + 1] - pieces.starts[at]);
      };
      std::vector<Motion> begun;
      for (std::size_t at = 0; at < pieces.count(); ++at)
        begun.push_back(motion_of(rig.reference(), piece(at)));
      constexpr int kSteps = 40;
      rig.advance(kSteps);
      const reference::MassSpringSystem now = rig.reference();
      for (std::size_t at = 0; at < pieces.count(); ++at) {
        CAPTURE(at);
        const Motion ended = motion_of(now, piece(at));
        double mass = 0;
        for (const std::uint32_t node : piece(at)) mass += 1 / now.inverse_mass[node];
        const Vec3d exact = begun[at].momentum + Vec3d{0, -kGravity * mass * kSteps * dt, 0};
        const double off = length(ended.momentum - exact) / begun[at].speeds;
        const double turned = length(ended.spin - begun[at].spin) / begun[at].turns;
        MESSAGE("momentum off by ", off, " of its nodes', spin by ", turned);
        // A way of less than a metre is rounded to 2^-24 of it in each step, and so is what all nodes have in common;
        // a narrow piece turns about its length by what 4e-6 of its inertia across leaves.
        CHECK(off < 4 * kSteps / 16777216.0);
        CHECK(turned < 1e-3);
      }
    }
}
