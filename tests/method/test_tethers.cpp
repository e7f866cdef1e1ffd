// Tethers on the GPU: the kernel beside the same substep in double, bits, and who refuses them.
#include <algorithm>
#include <cmath>

#include "fabric_rig.hpp"

using namespace weft;

namespace {

const std::string kSprings = R"("grid": [17, 12], "size": [0.32, 0.22], "density": 0.2, "damping": 0.02,
    "stiffness": {"structural": 50, "shear": 20, "bend": 2})";
const std::string kTethers = R"(, "pins": ["top_left", "bottom"], "tethers": {"slack": 0.002})";

scene::Scene tethered(const std::string& method, const std::string& cloths) {
  return scene_of(R"("solver": {"kind": ")" + method + R"(", "iterations": 3}, "cloths": [)" + cloths + "]");
}

}  // namespace

TEST_CASE("tethered substeps equal those in double, of springs and fabric, by xpbd and pbd") {
  GpuFixture fixture;
  const std::pair<std::string, double> cases[] = {
      {"xpbd", 2e-3}, {"pbd", 2e-3}, {"xpbd", 0.03}, {"pbd", 0.03}};
  for (const auto& [method, scatter] : cases) {
    CAPTURE(method);
    CAPTURE(scatter);  // [m], of held nodes too: by the larger one they are farther apart than tethers reach
    // The first cloth has none, so that rows are found behind it.
    const scene::Scene scene = tethered(method, "{" + kSprings + "}, {" + kSprings + kTethers + "}, " +
                                                    fabric_cloth(kMesh, kWoven + "0.001",
                                                                 R"(, "pins": [{"nodes": [0, 1, 14]}],
                                                                    "tethers": {"slack": 0.01})"));
    SolverRig rig(fixture.device(), scene, 4e-3, {{}, {}, curved_sheet()});
    rig.perturb(5, scatter, 2.0);
    scene::Scene without = scene;
    for (scene::Cloth& cloth : without.cloths) cloth.tethers.reset();
    SolverRig loose(fixture.device(), without, 4e-3, {{}, {}, curved_sheet()});
    loose.perturb(5, scatter, 2.0);
    const reference::MassSpringSystem free = exact_after(loose, without), exact = exact_after(rig, scene);
    rig.advance(1);
    const std::vector<Vec4f> found = rig.positions();
    double off = 0, pulled = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
      off = std::max(off, length(found[n].xyz().to<double>() - exact.position[n]));
      pulled = std::max(pulled, length(exact.position[n] - free.position[n]));
    }
    MESSAGE(method << ": off by " << off << " m, tethers pull by " << pulled);
    CHECK(pulled > 1e-3);
    CHECK(off < 1e-3 * pulled);
  }
}

TEST_CASE("tethered cloth has the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  for (const std::string method : {"xpbd", "pbd"})
    check_bits(fixture.device(), tethered(method, "{" + kSprings + kTethers + "}"), {});
}

TEST_CASE("methods without tethers refuse them and say which have them") {
  for (const std::string method : {"mass_spring", "multigrid", "vbd", "projective_dynamics", "fem"}) {
    const scene::Scene scene =
        scene_of(R"("solver": {"kind": ")" + method + R"("}, "cloths": [{)" + kSprings + kTethers + "}]");
    auto model = build_model(scene, {{}});
    REQUIRE_OK(model);
    const auto choice = choose_method(scene, *model);
    REQUIRE(!choice);
    CHECK(choice.error().kind == ErrorKind::Input);
    CHECK(choice.error().message == "test.json: cloths[0].tethers has a slack of 0.002, and solver.kind \"" +
                                        method + "\" keeps no tethers; \"xpbd\" or \"pbd\" does.");
  }
}
