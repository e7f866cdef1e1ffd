// The kernels of the multigrid solver for meshes against the reference, on random states of meshes of any
// kind.
#include "gpu/gpu_fixture.hpp"
#include "mesh/irregular_meshes.hpp"
#include "multigrid_rig.hpp"

using namespace weft;
using reference::Field;
using reference::MeshOperator;
using reference::Sym3;

namespace {

using namespace weft::multigrid;

std::string cloth(const std::string& more) {
  return R"("drag": 0.4, "cloths": [{"mesh": "a.obj", )" + more + "}]";
}
const std::string kPlain = R"("density": 0.2, "pins": [{"nodes": [0, 3]}])";  // with the default stiffness
const std::string kSoft =
    R"("density": 0.1, "damping": 0, "stiffness": {"structural": 800, "shear": 100, "bend": 0},
       "pins": [{"nodes": [1]}])";
const std::string kFree =
    R"("node_mass": 0.002, "damping": 2, "stiffness": {"structural": 900, "shear": 0, "bend": 300})";

const std::string kWoven =
    R"("density": 0.2, "pins": [{"nodes": [0, 3]}], "fabric": {"warp": 900, "weft": 300, "shear": 60, "poisson": 0.25,
       "bending_warp": 4e-4, "bending_weft": 1e-4, "damping": 0.002})";
const std::string kGreen =
    R"("density": 0.2, "pins": [{"nodes": [1]}], "fabric": {"warp": 700, "weft": 900, "shear": 200, "poisson": 0.3,
       "bending_warp": 4e-3, "damping": 0, "energy": "green"})";
const std::string kRubber =
    R"("density": 0.3, "fabric": {"energy": "neo_hookean", "warp": 500, "shear": 200, "poisson": 0.25,
       "bending_warp": 3e-4, "damping": 0.0005})";

/// The same beyond a strain limit where nodes are moved far enough.
std::string limited(const std::string& fabric, const std::string& limit) {
  return fabric + R"(, "strain_limit": )" + limit;
}

struct Case {
  const char* name;
  mesh::TriangleMesh mesh;
  std::string cloth;
  double amount, speed, ratio;  // [m], [m/s]
  std::string world = "";
};

/// Gusts that are felt, by cloth of these tests.
const std::string kAirPushes = R"("wind": {"velocity": [3, 4, -6], "gusts": 0.7}, "air": {}, )";

std::vector<Case> cases() {
  return {
      {"sheet", jittered_sheet(40, 31, 2, 1.5), kPlain, 0.01, 1, 1},
      {"sheet numbered at random", shuffled(jittered_sheet(33, 34, 2, 2, 0.45)), kFree, 0.05, 5, 0.25},
      {"tube", tube(40, 21, 0.3, 1), kSoft, 0.01, 1, 2},
      {"sphere", sphere_skin(9, 0.5), kPlain, 0.1, 20, 0},
      {"two pieces", both(jittered_sheet(12, 9, 1, 1), tube(12, 7, 0.2, 0.5), {1, 0, 0}), kSoft, 0.02, 1, 1},
      {"800 triangles apart", triangles_apart(800), kPlain, 0.02, 1, 1},
      {"woven sheet", jittered_sheet(40, 31, 2, 1.5), kWoven, 0.01, 1, 1},
      {"woven tube of fast nodes", tube(40, 21, 0.3, 1), kGreen, 0.01, 20, 0.25},
      {"rubber in two pieces", both(jittered_sheet(12, 9, 1, 1), tube(12, 7, 0.2, 0.5), {1, 0, 0}), kRubber,
       0.02, 1, 0},
      {"limited woven sheet", jittered_sheet(40, 31, 2, 1.5), limited(kWoven, "0.02"), 0.01, 1, 1},
      {"limited woven tube of fast nodes", tube(40, 21, 0.3, 1), limited(kGreen, "0.1"), 0.01, 20, 0.25},
      {"woven triangles apart", triangles_apart(30), kWoven, 0.02, 1, 1},
      {"a triangle", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, kFree, 0.1, 3, 1},
      {"sheet in wind", jittered_sheet(40, 31, 2, 1.5), kPlain, 0.01, 1, 1, kAirPushes},
      {"two pieces in wind", both(jittered_sheet(12, 9, 1, 1), tube(12, 7, 0.2, 0.5), {1, 0, 0}), kSoft, 0.02,
       9, 2, kAirPushes},
      {"woven sheet in wind", jittered_sheet(40, 31, 2, 1.5), kWoven, 0.01, 1, 1, kAirPushes}};
}

/// Products of blocks' symmetric parts and random vectors.
Field each_times(const std::vector<Sym3>& blocks, const Field& x) {
  Field made(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) made[b] = blocks[b] * x[b];
  return made;
}

/// A level's blocks equal the reference's, in the rows of both of their nodes.
void check_blocks(MeshRig& rig, const reference::MeshHierarchy& hierarchy, std::size_t l) {
  const MeshLists lists = mesh_lists(hierarchy.levels()[0].levels);
  const std::vector<std::array<float, 2>> all = rig.download(rig.cycle().blocks());
  const std::vector<Sym3>& expected = hierarchy.levels()[l].blocks;
  const std::vector<Vec3d>& skews = hierarchy.levels()[l].skews;
  const std::size_t words = skews.empty() ? 3 : 5;
  const Field some = random_field(expected.size(), l);
  const double size = largest(each_times(expected, some));
  for (const std::size_t row : {0, 1}) {
    std::vector<Sym3> blocks;
    for (std::size_t block = 0; block < expected.size(); ++block) {
      const auto* at = &all[words * lists.entries_of[l][block][row]];
      blocks.push_back(sym3({at[0][0], at[0][1], at[1][0], at[1][1]}, at[2][0], at[2][1]));
      if (skews.empty()) continue;
      const Vec3d skew = Vec3f{at[3][0], at[3][1], at[4][0]}.to<double>();
      CHECK(length(skew - (row == 0 ? 1.0 : -1.0) * skews[block]) < 1e-5 * size);
    }
    CHECK(difference(each_times(blocks, some), each_times(expected, some)) < 1e-5);
  }
}

Field inverses_times(MeshRig& rig, std::size_t l, const Field& x) {
  const std::vector<Vec4f> a = rig.vector(l, kInverse), b = rig.vector(l, kInverse + 1);
  Field made;
  for (std::size_t n = 0; n < a.size(); ++n) made.push_back(sym3(a[n], b[n].x, b[n].y) * x[n]);
  return made;
}

}  // namespace

TEST_CASE("a mesh's residual, matrices and diagonals equal the reference's") {
  GpuFixture fixture;
  for (const Case& c : cases()) {
    CAPTURE(std::string(c.name));
    MeshRig rig(fixture.device(), c.world + cloth(c.cloth), 1.0 / 480, 64, false, {c.mesh});
    rig.perturb(c.mesh.positions.size(), c.amount, c.speed);
    rig.set_ratio(c.ratio);
    if (c.mesh.positions.size() > 9) rig.hold(9, {0.1, 0.2, 0.3});
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
    });
    const reference::MeshStep expected = rig.linearise();
    CHECK(difference(field(rig.vector(0, kResidual)), expected.residual) < 2e-5);
    const reference::MeshHierarchy hierarchy(expected.matrix, rig.cycle().bottom(), rig.cycle().finest());
    REQUIRE(hierarchy.levels().size() == rig.cycle().shapes().size());
    for (std::size_t l = 0; l < hierarchy.levels().size(); ++l) {
      CAPTURE(l);
      const MeshOperator& level = hierarchy.levels()[l];
      const Field some = random_field(level.blocks.size(), l);
      check_blocks(rig, hierarchy, l);
      CHECK(difference(inverses_times(rig, l, some), each_times(level.inverse_diagonal(), some)) < 2e-3);
    }
  }
}

TEST_CASE("smoothing, restriction and the cycle of a mesh's coarsest levels equal the reference's") {
  GpuFixture fixture;
  // Stiff cloth leaves the coarsest level what ten steps do not solve, so that each of them shows.
  const std::string stiff = R"("density": 0.2, "stiffness": {"structural": 5e5, "shear": 2e5, "bend": 5e4})";
  // The last has more pieces than one workgroup shows its invocations at once.
  for (const auto& [mesh, material, levels] : {std::tuple{jittered_sheet(90, 71, 2, 1.5), kPlain, 1U},
                                               {sphere_skin(36, 0.5), stiff, 3U},
                                               {triangles_apart(800), kPlain, 1U}}) {
    MeshRig rig(fixture.device(), cloth(material), 1.0 / 480, 64, false, {mesh});
    rig.perturb(4, 0.005, 1);
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
      rig.cycle().record_guess(pass);
      rig.cycle().record_down(pass);
    });
    const reference::MeshStep step = rig.linearise();
    const reference::MeshHierarchy hierarchy(step.matrix, rig.cycle().bottom(), rig.cycle().finest());
    const std::size_t tail = rig.cycle().tail();
    REQUIRE(tail + levels <= hierarchy.levels().size());
    for (std::size_t l = 0; l < tail; ++l) {  // each from the task that the kernels gave it
      CAPTURE(l);
      const MeshOperator& matrix = hierarchy.levels()[l];
      const Field r = field(rig.vector(l, kResidual));
      Field x(r.size());
      reference::smooth(matrix, matrix.inverse_diagonal(), r, x,
                        l == 0 ? rig.cycle().finest() : multigrid::Smoothing{});
      CHECK(difference(field(rig.vector(l, kFirst)), x) < 1e-3);
      const Field left = residual(matrix, r, field(rig.vector(l, kFirst)));
      CHECK(difference(field(rig.vector(l + 1, kResidual)), restricted(left, matrix)) < 1e-3);
    }
    const Field below = hierarchy.cycle_from(tail, field(rig.vector(tail, kResidual)));
    CHECK(difference(field(rig.vector(tail, kFirst)), below) < 1e-3);
  }
}

TEST_CASE("a whole implicit substep of a mesh equals the reference's") {
  GpuFixture fixture;
  for (const Case& c : cases()) {
    CAPTURE(std::string(c.name));
    MeshRig rig(fixture.device(), c.world + cloth(c.cloth), 1.0 / 480, 64, false, {c.mesh});
    rig.perturb(c.mesh.positions.size(), c.amount, std::min(c.speed, 5.0));
    rig.set_ratio(c.ratio);
    if (c.mesh.positions.size() > 9) rig.hold(9, {0.1, 0.2, 0.3});
    check_substep(rig);
  }
}

TEST_CASE("what obstacles hold is in a mesh's matrix, and a pressed node begins anew, as in the reference") {
  GpuFixture fixture;
  for (const auto& [mesh, material, every] : {std::tuple{jittered_sheet(34, 21, 2, 1.5), kPlain, 3U},
                                              {sphere_skin(12, 0.5), kFree, 1U},
                                              {tube(40, 21, 0.3, 1), kSoft, 7U}}) {
    MeshRig rig(fixture.device(), cloth(material), 1.0 / 480, 64, true, {mesh});
    rig.perturb(every, 1e-3, 1);
    rig.press(every, every);
    const reference::MeshStep step = rig.linearise();
    const auto pressed = static_cast<std::size_t>(std::count_if(
        step.holds.begin(), step.holds.end(), [](const auto& hold) { return hold.has_value(); }));
    CHECK(pressed > step.holds.size() / (4 * every));
    CHECK(pressed < step.holds.size() / every);  // some are not, or agree on nothing
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
    });
    CHECK(difference(field(rig.vector(0, kResidual)), step.residual) < 2e-5);
    const reference::MeshHierarchy hierarchy(step.matrix, rig.cycle().bottom(), rig.cycle().finest());
    for (const std::size_t l : {0U, 1U}) check_blocks(rig, hierarchy, l);
    const std::vector<std::int32_t> left = rig.download(rig.press_sums());
    CHECK(std::all_of(left.begin() + kHoldWords * rig.model().vertex_count(), left.end(),
                      [](std::int32_t word) { return word == 0; }));

    rig.press(every, every);
    rig.run_first();
    rig.let_go_after_first();
    rig.set_history_of_pressed(1);
    rig.run([&](gpu::ComputePass& pass) { rig.cycle().record_system_again(pass); });
    const auto second = rig.linearise(field(rig.vector(0, kWay)));
    // Of the first system's residual, most of which is gone: what f32 rounds in the parts that cancel stays.
    const double gone = std::max(1.0, largest(step.residual) / largest(second.residual));
    CHECK(difference(field(rig.vector(0, kResidual)), second.residual) < 2e-5 * gone);

    rig.press(every, every);
    check_substep(rig, true);
  }
}

TEST_CASE("an implicit substep of a mesh has the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  std::vector<std::vector<Vec4f>> positions;
  for (const std::uint32_t size : {64U, 64U, 128U, 256U}) {
    MeshRig rig(fixture.device(), cloth(kPlain), 1.0 / 480, size, false, {jittered_sheet(51, 40, 2, 2)});
    rig.perturb(4, 0.01, 2);
    rig.run_substep();
    positions.push_back(rig.download(rig.state().position[1]));
    CHECK(same_bits(positions.back(), positions.front()));
  }
}
