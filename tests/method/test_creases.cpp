// Cloth that keeps bends on the GPU: kernels beside the same substep in double, bits, and what a fold leaves.
#include <algorithm>
#include <cmath>

#include "fabric_rig.hpp"
#include "model/fabric.hpp"
#include "scene/names.hpp"

using namespace weft;

namespace {

const std::string kPlastic = R"(, "plastic": {"yield_curvature": 4, "hardening": 0.3})";

std::vector<std::string> keeping_methods() {
  std::vector<std::string> words;
  for (const Method& method : methods())
    if (takes_energy(method, scene::FabricEnergy::Yarn) && !method.flat_fabric)
      words.push_back(scene::name_of(method.kind));
  return words;
}

scene::Scene scene_with(const std::string& method, const std::string& cloths) {
  return scene_of(R"("gravity": [0, 0, 0], "solver": {"kind": ")" + method + R"("}, "cloths": [)" + cloths +
                  "]");
}

}  // namespace

TEST_CASE("facets yield and their creases pull as in double, by every method that keeps bends") {
  GpuFixture fixture;
  for (const std::string& method : keeping_methods())
    for (const bool is_mesh : {false, true}) {
      CAPTURE(method);
      CAPTURE(is_mesh);
      const std::string pins = is_mesh ? R"(, "pins": [{"nodes": [0, 1, 14]}])" : R"(, "pins": ["top"])";
      // A cloth that keeps none is first, so that creases are found behind it.
      const scene::Scene scene =
          scene_with(method, fabric_cloth(kGrid, kWoven + "0") + ", " +
                                 fabric_cloth(kGrid, kWoven + "0.001" + kPlastic) + ", " +
                                 fabric_cloth(is_mesh ? kMesh : kGrid, kWoven + "0.002" + kPlastic, pins));
      SolverRig rig(fixture.device(), scene, method == "mass_spring" ? 1e-5 : 1e-3,
                    {{}, {}, is_mesh ? curved_sheet() : mesh::TriangleMesh{}});
      for (const std::uint64_t seed : {5U, 6U}) {  // the second time with creases
        rig.perturb(seed, 2e-3, 0.5);
        const reference::MassSpringSystem before = rig.reference(), exact = exact_after(rig, scene);
        rig.advance(1);
        const reference::MassSpringSystem found = rig.reference();
        double change = 0, most = 0;
        for (std::size_t n = 0; n < found.velocity.size(); ++n) {
          change = std::max(change, length(exact.velocity[n] - before.velocity[n]));
          most = std::max(most, length(found.velocity[n] - exact.velocity[n]));
        }
        double off = 0, kept = 0;
        std::size_t yielded = 0, facets = 0;
        for (std::size_t c = 1; c < 3; ++c)
          for (std::size_t f = 0; f < exact.fabrics[c].creases.size(); ++f) {
            const hinge::Crease &a = exact.fabrics[c].creases[f], &b = found.fabrics[c].creases[f];
            const hinge::Crease& old = before.fabrics[c].creases[f];
            ++facets;
            yielded += a.spent > old.spent ? 1 : 0;
            kept = std::max(kept, length(a.parts));
            off = std::max(
                {off, length(a.parts - b.parts), std::abs(a.spent - b.spent) * 0.02});  // of a cell's size
          }
        MESSAGE(method << ": " << yielded << " of " << facets << " facets yield; creases off by " << off
                       << " of " << kept << " rad, velocities by " << most / change);
        CHECK(yielded > facets / 4);
        CHECK(off <
              1e-5 * kept);  // angles of f32 places that are 1e-8 m off at heights of 1 cm, by their size
        CHECK(most < 1e-4 * change);
      }
    }
}

TEST_CASE("creases have the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  // Of those whose bends have one number, and two.
  for (const std::string method : {"mass_spring", "multigrid", "vbd"}) {
    CAPTURE(method);
    check_bits(fixture.device(), scene_with(method, fabric_cloth(kGrid, kWoven + "0.001" + kPlastic)), {});
  }
}

TEST_CASE("a yield that nothing reaches changes no bit, by every method that keeps bends") {
  GpuFixture fixture;
  const std::string far = R"(, "plastic": {"yield_curvature": 1e6})";
  for (const std::string& method : keeping_methods()) {
    CAPTURE(method);
    std::vector<std::vector<Vec4f>> ends;
    for (const std::string& more : {std::string(), far}) {
      SolverRig rig(fixture.device(), scene_with(method, fabric_cloth(kGrid, kWoven + "0.001" + more)), 1e-4);
      rig.perturb(3, 2e-3, 0.5);
      rig.advance(20);
      ends.push_back(rig.positions());
    }
    CHECK(same_bits(ends[0], ends[1]));
  }
}

TEST_CASE("a method that keeps no bends refuses plastic fabric and says which do") {
  auto model =
      build_model(scene_of(R"("cloths": [)" + fabric_cloth(kGrid, kWoven + "0" + kPlastic) + "]"), {{}});
  REQUIRE_OK(model);
  const scene::Scene scene = scene_with("projective_dynamics", fabric_cloth(kGrid, kWoven + "0" + kPlastic));
  const auto choice = choose_method(scene, *model);
  REQUIRE(!choice);
  CHECK(choice.error().kind == ErrorKind::Input);
  CHECK(choice.error().message ==
        "test.json: cloths[0].fabric.plastic keeps bends, which solver.kind \"projective_dynamics\" does "
        "not: it "
        "takes fabric that stays flat at rest; \"multigrid\", \"mass_spring\", \"xpbd\", \"pbd\", \"vbd\" or "
        "\"fem\" "
        "keeps them.");
}

TEST_CASE("long: crumpled cloth that yields settles, with no more energy than it began with, however stiff") {
  GpuFixture fixture;
  for (const std::string& method : {std::string("multigrid"), std::string("vbd"), std::string("xpbd")})
    for (const int scale : {1, 100}) {
      CAPTURE(method);
      CAPTURE(scale);
      const scene::Scene scene = scene_with(method, fabric_cloth(kMesh, kWoven + "0.001" + kPlastic));
      const Settled energy = settled(fixture.device(), scene, scale, false);
      CHECK(energy.most <= energy.start);
      CHECK(energy.end < 0.5 * energy.start);
    }
}
