// VBD over fabric: kernels beside the same substep in double, and both beside laws that neither was written from.
#include <algorithm>
#include <cmath>

#include "fabric_rig.hpp"
#include "hanging_strips.hpp"
#include "method/vbd/node_colors.hpp"
#include "method/vbd/reference/fabric_descent.hpp"

using namespace weft;
using reference::FabricCloth;

namespace {

scene::Scene vbd_scene(const std::string& cloths, int iterations = 10,
                       const std::string& world = R"("gravity": [0, 0, 0])") {
  return scene_of(world + R"(, "solver": {"kind": "vbd", "iterations": )" + std::to_string(iterations) +
                  R"(}, "cloths": [)" + cloths + "]");
}

constexpr double kDiagonalMargin = 4e-6;  // mirror: src/method/symmetric.wgsl

/// Of the matrices (4) of all nodes as a substep begins.
double largest_trace(SolverRig& rig) {
  const reference::MassSpringSystem system = rig.reference();
  const Model& model = rig.model().host;
  const FabricCloth& cloth = system.fabrics[0];
  reference::Ways ways{system.position, system.velocity, system.inverse_mass};
  for (Vec3d& way : ways.way) way = rig.dt() * way;
  reference::FabricDescent descent(model, model.bodies[0]);
  descent.begin_sweep(ways, cloth, rig.dt());
  double most = 0;
  for (std::uint32_t node = 0; node < cloth.count; ++node) {
    const double mobility = rig.dt() * rig.dt() * system.inverse_mass[node];
    most = std::max(most, 3 + mobility * descent.pull(ways, cloth, node, rig.dt()).hessian.trace());
  }
  return most;
}

/// Puts damping by how much strains have changed in a step in place of that by their rates at its end.
void damp_by_change(const reference::MassSpringSystem& end, const std::vector<Vec3d>& start, double h,
                    std::vector<Vec3d>& force) {
  const membrane::Membranes& membranes = end.fabrics[0].membranes;
  const membrane::Law& law = membranes.law;
  std::vector<Vec3d> by_rates(force.size());
  membranes.add_damping_forces(end.position, end.velocity, by_rates);
  for (std::size_t n = 0; n < force.size(); ++n) force[n] -= by_rates[n];
  for (std::size_t t = 0; t < membranes.triangles.size(); ++t) {
    const membrane::Strain now = membrane::strain_of(law.energy, membranes.deformation(t, end.position));
    const membrane::Triple before = membrane::strain_of(law.energy, membranes.deformation(t, start)).value;
    const double warp = law.delay / h * (now.value.warp - before.warp),
                 weft = law.delay / h * (now.value.weft - before.weft),
                 shear = law.delay / h * (now.value.shear - before.shear);
    const Stiffness& c = law.stiffness;
    const double s1 = c.warp * warp + c.coupled * weft, s2 = c.coupled * warp + c.weft * weft,
                 s3 = c.shear * shear;
    const membrane::Corners forces = membrane::forces(
        membranes.rests[t],
        {s1 * now.warp.warp + s3 * now.shear.warp, s2 * now.weft.weft + s3 * now.shear.weft});
    for (std::size_t i = 0; i < 3; ++i) force[membranes.triangles[t][i]] += forces[i];
  }
}

}  // namespace

TEST_CASE("no two nodes of a colour are of one triangle or hinge") {
  for (const bool is_mesh : {false, true}) {
    Exact cloth(vbd_scene(fabric_cloth(is_mesh ? kMesh : kGrid, kWoven + "0")),
                {is_mesh ? curved_sheet() : mesh::TriangleMesh{}});
    const Body& body = cloth.model().bodies[0];
    const NodeColors colors = color_nodes(cloth.model(), body);
    std::vector<std::uint32_t> color_of(body.vertex_count, ~0U);
    for (std::uint32_t color = 0; color < colors.count(); ++color)
      for (std::uint32_t at = colors.starts[color]; at < colors.starts[color + 1]; ++at)
        color_of[colors.nodes[at]] = color;
    CHECK(std::count(color_of.begin(), color_of.end(), ~0U) == 0);
    CHECK(colors.nodes.size() == body.vertex_count);
    MESSAGE(colors.count() << " colours");
    for (const ElementKind kind : {ElementKind::Membrane, ElementKind::Hinge}) {
      const ElementTable& table = cloth.model().elements(kind, body);
      REQUIRE(table.size() > 0);
      std::size_t shared = 0;
      for (std::size_t e = 0; e < table.size(); ++e)
        for (const std::uint32_t a : table.nodes_of(e))
          for (const std::uint32_t b : table.nodes_of(e))
            if (a != b && color_of[a] == color_of[b]) ++shared;
      CHECK(shared == 0);
    }
  }
}

TEST_CASE("a vbd substep of fabric equals the reference, on grids and meshes, with one sweep or three") {
  GpuFixture fixture;
  // f32 inverts a matrix whose diagonal is larger by a part of its trace, of which no eigenvalue is below 1.
  check_substeps(
      fixture.device(), [](const std::string& cloth, int sweeps) { return vbd_scene(cloth, sweeps); },
      [](SolverRig& rig, int sweeps) { return sweeps * kDiagonalMargin * largest_trace(rig); });
}

TEST_CASE("fabric by vbd has the same bits for every workgroup, beside springs, and on every run") {
  GpuFixture fixture;
  check_bits(fixture.device(),
             vbd_scene(fabric_cloth(kGrid, kWoven + "0.001") +
                           R"(, {"grid": [9, 7], "size": [0.2, 0.15], "density": 0.2}, )" +
                           fabric_cloth(kMesh, kIsotropic + "0.001"),
                       2),
             {{}, {}, curved_sheet()});
}

TEST_CASE("many vbd sweeps over fabric are backward Euler") {
  const mesh::TriangleMesh mesh = jittered_sheet(6, 5, 0.1, 0.08);
  for (const std::string damping : {"0", "0.0005"})
    for (const std::string& fabric : fabrics(damping))
      for (const double h : {1e-4, 1e-3}) {
        CAPTURE(fabric);
        CAPTURE(h);
        Exact cloth(vbd_scene(fabric_cloth(kMesh, fabric, R"(, "pins": [{"nodes": [0, 5]}])"), 1000), {mesh});
        cloth.perturb(4, 1e-3, 0.3);
        const double left = left_of_backward_euler(
            cloth, h,
            [&](const auto& end, const auto& start, auto& force) { damp_by_change(end, start, h, force); });
        MESSAGE("h " << h << " s: " << left << " of the forces are left");
        CHECK(left < 1e-6);
      }
}

TEST_CASE("a sheet that turns keeps its shape whatever its damping, by vbd and projective_dynamics") {
  for (const char* solver : {"vbd", "projective_dynamics"})
    for (const double delay : {0.0, 0.003, 0.1}) {
      CAPTURE(solver);
      CAPTURE(delay);
      const scene::Scene scene = scene_of(
          R"("gravity": [0, 0, 0], "solver": {"kind": ")" + std::string(solver) +
          R"(", "iterations": 1000}, "cloths": [)" +
          fabric_cloth(R"("grid": [9, 3], "size": [0.4, 0.1])", kWoven + std::to_string(delay)) + "]");
      Exact cloth(scene, {{}});
      const std::vector<Vec3d> rest = cloth.system.position;
      Vec3d center;
      for (const Vec3d& x : rest) center += 1.0 / static_cast<double>(rest.size()) * x;
      constexpr double kTurn = 30;  // rad/s, about the normal and across
      for (std::size_t v = 0; v < rest.size(); ++v)
        cloth.system.velocity[v] = cross(Vec3d{0, 0.6 * kTurn, 0.8 * kTurn}, rest[v] - center);
      const double before = length(rest[0] - rest[8]);
      double most = 0;
      for (int step = 0; step < 20; ++step) {
        cloth.advance(1.0 / 480, 1);
        most = std::max(most,
                        std::abs(length(cloth.system.position[0] - cloth.system.position[8]) / before - 1));
      }
      MESSAGE(solver << ", delay " << delay << " s: longer or shorter by " << most);
      // ω² ρ L²/12 E of what spins, twice as much where it springs back.
      CHECK(most < 2 * kTurn * kTurn * 0.2 * 0.4 * 0.4 / 12 / 900 * 1.2);
    }
}

TEST_CASE("fabric by vbd stays where Newton's method has it at rest, by as many sweeps as its step needs") {
  const mesh::TriangleMesh mesh = jittered_sheet(8, 7, 0.14, 0.12);
  for (const std::string& fabric : fabrics("0.001"))
    for (const auto& [sweeps, h] :
         {std::pair{1, 1e-4}, {1, 2.5e-4}, {2, 5e-4}, {10, 1e-3}, {30, 2e-3}, {100, 1.0 / 120}}) {
      CAPTURE(fabric);
      CAPTURE(sweeps);
      CAPTURE(h);
      const scene::Scene scene = vbd_scene(fabric_cloth(kMesh, fabric, R"(, "pins": [{"nodes": [0, 7]}])"),
                                           sweeps, R"("gravity": [0, -9.81, 0], "drag": 3)");
      Exact cloth(scene, {mesh});
      const std::vector<Vec3d> rest = rest_of(cloth, scene, mesh, std::array<std::uint32_t, 2>{0, 7});
      cloth.system.position = rest;
      cloth.advance(h, 400);
      const auto [apart, way] = from_rest(cloth, rest);
      MESSAGE(sweeps << " sweeps of " << h << " s: " << apart << " m apart, after a way of " << way << " m");
      CHECK(apart < 1e-4 * way);
    }
}

TEST_CASE("a strip that hangs by vbd stretches by its weight over its modulus, and narrows") {
  GpuFixture fixture;
  for (const HangingStrip& strip : hanging_strips()) {
    CAPTURE(strip.fabric);
    const scene::Scene scene =
        vbd_scene(fabric_cloth(R"("grid": [5, 21], "size": [0.08, 0.4])",
                               strip.fabric + R"(, "bending_warp": 1e-5, "damping": 0.0002)",
                               R"(, "pins": [{"nodes": [2]}])"),
                  10, R"("gravity": [0, -9.81, 0], "drag": 12)");
    SolverRig rig(fixture.device(), scene, 1e-3);
    rig.advance(1500);  // drag takes e⁻⁹ of what swings
    std::vector<Vec3d> end;
    for (const Vec4f& x : rig.positions()) end.push_back(x.xyz().to<double>());
    check_hanging(strip, end);
  }
}

TEST_CASE("fabric by vbd comes to rest in long steps, from a heap or squeezed, at 100 times the stiffness") {
  GpuFixture fixture;
  for (const std::string& fabric : fabrics("0"))
    for (const int scale : {1, 100})
      for (const bool squeezed : {false, true}) {
        CAPTURE(fabric);
        CAPTURE(scale);
        const Settled energy =
            settled(fixture.device(), vbd_scene(fabric_cloth(kMesh, fabric)), scale, squeezed);
        CHECK(energy.most < energy.start);
        CHECK(energy.end < 0.1 * energy.start);  // NaN is not
      }
}
