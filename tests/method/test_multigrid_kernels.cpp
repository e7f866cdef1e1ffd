// The kernels of the multigrid solver against the reference, on random states of any size.
#include <algorithm>

#include "gpu/gpu_fixture.hpp"
#include "multigrid_rig.hpp"

using namespace weft;
using reference::Field;
using reference::GridOperator;
using reference::Sym3;

namespace {

using namespace weft::multigrid;

/// Gusts that are felt, by cloth of these tests.
const std::string kAirPushes = R"("wind": {"velocity": [3, 4, -6], "gusts": 0.7}, "air": {}, )";

std::string cloth(std::uint32_t nx, std::uint32_t ny, const std::string& more) {
  return R"("drag": 0.4, "cloths": [{"grid": [)" + std::to_string(nx) + ", " + std::to_string(ny) +
         R"(], "size": [2, 1.5], "plane": "xz", )" + more + "}]";
}
const std::string kPlain =
    R"("density": 0.2, "pins": ["top_left", {"nodes": [3]}])";  // with the default stiffness
const std::string kBending =
    R"("density": 0.1, "damping": 0, "pins": ["left"],
       "stiffness": {"structural": 800, "shear": 100, "bend": 0, "bending": 0.01})";
const std::string kPinnedInside =
    R"("density": 0.1, "damping": 0.01, "pins": [{"nodes": [24, 60, 61]}],
       "stiffness": {"structural": 800, "shear": 100, "bend": 20, "bending": 0.01})";
const std::string kNodeMass =
    R"("node_mass": 0.002, "damping": 2, "stiffness": {"structural": 0, "shear": 900, "bend": 300, "bending": 1e-3})";

/// The product of a level's matrix and a random vector, block by block as kernels have stored it.
Field stored_product(MultigridRig& rig, std::size_t l, const Field& x) {
  const GridLevelParams& level = rig.cycle().shapes()[l];
  const std::vector<BlockPart> all = rig.download(rig.cycle().operators());
  GridOperator stored;
  stored.nx = level.nx;
  stored.ny = level.ny;
  stored.rows.resize(node_count(level));
  stored.fixed.assign(node_count(level), false);
  const auto part = [&](std::uint32_t p, std::uint32_t n) {
    return all[level.first_operator + p * node_count(level) + n];
  };
  for (std::uint32_t n = 0; n < node_count(level); ++n)
    for (std::uint32_t b = 0; b < kBlocks; ++b) {
      const auto xx_yy = part(kBlockParts * b, n), zz_yz = part(kBlockParts * b + 1, n),
                 xz_xy = part(kBlockParts * b + 2, n);
      stored.rows[n][b] = sym3({xx_yy[0], xx_yy[1], zz_yz[0], zz_yz[1]}, xz_xy[0], xz_xy[1]);
    }
  return stored.apply(x);
}

/// Of a matrix that is made of poses: a spring's stretch is kept to 2⁻¹¹ of itself, and is half of the block at most.
constexpr double kKept = 1.0 / 4096;

}  // namespace

TEST_CASE("the residual and the diagonal equal the reference's") {
  GpuFixture fixture;
  struct Case {
    std::uint32_t nx, ny;
    std::string cloth;
    double amount, speed, ratio;
    std::string world = "";
  };
  for (const Case& c : {Case{17, 23, kPlain, 0.02, 1, 1},
                        {9, 2, kPlain, 0.5, 20, 0.25},
                        {2, 2, kBending, 0.01, 1, 1},
                        {3, 31, kBending, 0.2, 5, 2},
                        {40, 13, kNodeMass, 0.01, 1, 1},
                        {12, 7, kNodeMass, 1, 100, 0},
                        {17, 23, kPlain, 0.02, 3, 1, kAirPushes},
                        {12, 7, kNodeMass, 1, 100, 0.25, kAirPushes},
                        {2, 9, kBending, 0.05, 9, 2, kAirPushes}}) {
    CAPTURE(c.nx);
    CAPTURE(c.cloth);
    MultigridRig rig(fixture.device(), c.world + cloth(c.nx, c.ny, c.cloth));
    rig.perturb(c.nx, c.amount, c.speed);
    rig.set_ratio(c.ratio);
    if (c.nx > 9) rig.hold(10, {0.1, 0.2, 0.3});
    rig.run([&](gpu::ComputePass& pass) { rig.cycle().record_system(pass); });
    const reference::LinearStep expected = rig.linearise();
    // f32 rounds a span, and once more where it is taken ahead.
    CHECK(difference(field(rig.vector(0, kResidual)), expected.residual) < 4e-5);
    // By what D⁻¹ does to a vector with D in it: both may be far apart where a block is nearly singular.
    const std::vector<Sym3> inverse = expected.matrix.inverse_diagonal();
    const std::vector<Vec4f> a = rig.vector(0, kInverse), b = rig.vector(0, kInverse + 1);
    Field found, wanted;
    const Field some = random_field(inverse.size(), 5);
    for (std::size_t n = 0; n < inverse.size(); ++n) {
      found.push_back(sym3(a[n], b[n].x, b[n].y) * some[n]);
      wanted.push_back(inverse[n] * some[n]);
    }
    CHECK(difference(found, wanted) < 2e-3);
  }
}

TEST_CASE("the matrices of coarse levels equal the reference's") {
  GpuFixture fixture;
  struct Case {
    std::uint32_t nx, ny;
    std::string cloth, world = "";
  };
  for (const Case& c : {Case{34, 21, kPlain},
                        {34, 21, kPlain, kAirPushes},
                        {22, 18, kPinnedInside, kAirPushes},
                        {7, 50, kBending},
                        {22, 18, kPinnedInside},
                        {100, 80, kNodeMass},
                        {128, 3, kPlain}}) {
    CAPTURE(c.nx);
    CAPTURE(c.cloth);
    MultigridRig rig(fixture.device(), c.world + cloth(c.nx, c.ny, c.cloth));
    rig.perturb(c.ny, 0.01, 1);
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
    });
    const reference::LinearStep step = rig.linearise();
    const reference::Hierarchy hierarchy(step.matrix, step.source, rig.cycle().bottom(),
                                         rig.cycle().finest());
    REQUIRE(hierarchy.levels().size() == rig.cycle().shapes().size());
    for (std::size_t l = 1; l < hierarchy.levels().size(); ++l) {
      CAPTURE(l);
      GridOperator plain = hierarchy.levels()[l];
      const Field x = random_field(plain.size(), l);
      const std::vector<Sym3> inverse = plain.inverse_diagonal();
      plain.bending = {};
      CHECK(difference(stored_product(rig, l, x), plain.apply(x)) < kKept);
      const std::vector<Vec4f> a = rig.vector(l, kInverse), b = rig.vector(l, kInverse + 1);
      Field found, wanted;
      for (std::size_t n = 0; n < inverse.size(); ++n) {
        found.push_back(sym3(a[n], b[n].x, b[n].y) * x[n]);
        wanted.push_back(inverse[n] * x[n]);
      }
      CHECK(difference(found, wanted) < 2e-3);
    }
  }
}

TEST_CASE("smoothing, restriction and the cycle of the coarsest levels equal the reference's") {
  GpuFixture fixture;
  for (const auto& [nx, ny, material] : {std::tuple{100U, 81U, kPlain},
                                         {40U, 23U, kBending},
                                         {128U, 67U, kNodeMass},
                                         {151U, 130U, kBending},
                                         {2000U, 3U, kPlain}}) {
    CAPTURE(nx);
    MultigridRig rig(fixture.device(), cloth(nx, ny, material));
    rig.perturb(nx, 0.005, 1);
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
      rig.cycle().record_guess(pass);
      rig.cycle().record_down(pass);
    });
    const reference::LinearStep step = rig.linearise();
    const reference::Hierarchy hierarchy(step.matrix, step.source, rig.cycle().bottom(),
                                         rig.cycle().finest());
    const std::size_t tail = rig.cycle().tail();
    for (std::size_t l = 0; l < tail; ++l) {  // each from the task that the kernels gave it
      CAPTURE(l);
      const GridOperator& matrix = hierarchy.levels()[l];
      const Field r = field(rig.vector(l, kResidual));
      Field x(r.size());
      reference::smooth(matrix, matrix.inverse_diagonal(), r, x,
                        l == 0 ? rig.cycle().finest() : multigrid::Smoothing{});
      const Field smoothed = field(rig.vector(l, l == 0 ? kFirst : kSecond));
      CHECK(difference(smoothed, x) < 1e-3);
      Field left = matrix.apply(smoothed);
      for (std::size_t n = 0; n < left.size(); ++n) left[n] = r[n] - left[n];
      CHECK(difference(field(rig.vector(l + 1, kResidual)), restricted(left, matrix)) < 1e-3);
    }
    const Field below = hierarchy.cycle_from(tail, field(rig.vector(tail, kResidual)));
    CHECK(difference(field(rig.vector(tail, kFirst)), below) < 1e-3);
  }
}

TEST_CASE("a whole implicit substep equals the reference's, on sheets flat and crumpled") {
  GpuFixture fixture;
  struct Case {
    std::uint32_t nx, ny;
    std::string cloth;
    double amount, speed;
    std::string world = "";
  };
  for (const Case& c : {Case{64, 64, kPlain, 1e-3, 1},
                        {64, 63, kPlain, 1e-3, 1, kAirPushes},
                        {33, 20, kNodeMass, 0.05, 5, kAirPushes},
                        {100, 80, kBending, 0.01, 1},
                        {5, 4, kPlain, 0.1, 3},
                        {2, 2, kNodeMass, 0.1, 3},
                        {33, 2, kPlain, 0.05, 3},
                        {129, 70, kNodeMass, 0.05, 5}}) {
    CAPTURE(c.nx);
    CAPTURE(c.cloth);
    MultigridRig rig(fixture.device(), c.world + cloth(c.nx, c.ny, c.cloth));
    rig.perturb(c.nx, c.amount, c.speed);
    if (c.nx > 9) rig.hold(c.nx + 5, {0.1, 0.2, 0.3});
    check_substep(rig);
  }
}

TEST_CASE("what obstacles hold is in the matrix, and a pressed node begins anew, as in the reference") {
  GpuFixture fixture;
  struct Case {
    std::uint32_t nx, ny, every;
    std::string cloth, world = "";
  };
  for (const Case& c : {Case{34, 21, 3, kPlain},
                        {64, 64, 1, kBending},
                        {100, 80, 7, kNodeMass},
                        {34, 22, 3, kPlain, kAirPushes}}) {
    CAPTURE(c.nx);
    MultigridRig rig(fixture.device(), c.world + cloth(c.nx, c.ny, c.cloth), 1.0 / 480, 64, true);
    rig.perturb(c.nx, 1e-3, 1);
    rig.press(c.ny, c.every);
    const reference::LinearStep step = rig.linearise();
    const auto pressed = std::count_if(step.holds.begin(), step.holds.end(),
                                       [](const auto& hold) { return hold.has_value(); });
    CHECK(pressed > step.holds.size() / (4 * c.every));
    CHECK(pressed < step.holds.size() / c.every);  // some are not, or agree on nothing
    rig.run([&](gpu::ComputePass& pass) {
      rig.cycle().record_system(pass);
      rig.cycle().record_matrices(pass);
    });
    CHECK(difference(field(rig.vector(0, kResidual)), step.residual) < 2e-5);
    const reference::Hierarchy hierarchy(step.matrix, step.source, rig.cycle().bottom(),
                                         rig.cycle().finest());
    GridOperator coarse = hierarchy.levels()[1];
    const Field x = random_field(coarse.size(), 3);
    coarse.bending = {};
    CHECK(difference(stored_product(rig, 1, x), coarse.apply(x)) < kKept);
    const std::vector<std::int32_t> left = rig.download(rig.press_sums());
    CHECK(std::all_of(left.begin() + kHoldWords * rig.model().vertex_count(), left.end(),
                      [](std::int32_t word) { return word == 0; }));

    rig.press(c.ny, c.every);
    rig.run_first();
    rig.let_go_after_first();
    rig.set_history_of_pressed(1);
    rig.run([&](gpu::ComputePass& pass) { rig.cycle().record_system_again(pass); });
    const auto second = rig.linearise(field(rig.vector(0, kWay)));
    // Of the first system's residual, most of which is gone: what f32 rounds in the parts that cancel stays.
    const double gone = std::max(1.0, largest(step.residual) / largest(second.residual));
    CHECK(difference(field(rig.vector(0, kResidual)), second.residual) < 2e-5 * gone);

    rig.press(c.ny, c.every);
    check_substep(rig, true);
  }
}

TEST_CASE("an implicit substep has the same bits for every workgroup, and on every run") {
  GpuFixture fixture;
  std::vector<std::vector<Vec4f>> positions;
  for (const std::uint32_t size : {64U, 64U, 128U, 256U}) {
    MultigridRig rig(fixture.device(), cloth(71, 60, kPlain), 1.0 / 480, size);
    rig.perturb(4, 0.01, 2);
    rig.run_substep();
    positions.push_back(rig.download(rig.state().position[1]));
    CHECK(same_bits(positions.back(), positions.front()));
  }
}

TEST_CASE(
    "grids in a row that differ in their places alone are one cycle, as many as a binding has room for") {
  const auto grid = [](const std::string& side, const std::string& more) {
    return R"({"grid": [)" + side + ", 30], \"size\": [1, 1], \"density\": 0.2" + more + "}";
  };
  const std::string plain = grid("40", ""),
                    other_place =
                        grid("40", R"(, "transform": {"translate": [3, 0, 0], "rotate": [0, 0.6, 0, 0.8]})"),
                    pinned = grid("40", R"(, "pins": ["top_left"])"), longer = grid("41", ""),
                    damped = grid("40", R"(, "damping": 0.5)"),
                    stiffer = grid("40", R"(, "stiffness": {"bending": 1})"),
                    wider = grid("40", R"(, "transform": {"scale": 2})");
  gpu::Limits limits;
  limits.max_workgroups_per_dimension = 65535;
  limits.max_storage_binding_size = std::uint64_t{1} << 27U;
  const auto equal_of = [&](const std::vector<std::string>& cloths) {
    std::string list;
    for (const std::string& cloth : cloths) list += (list.empty() ? "" : ",") + cloth;
    const scene::Scene scene = scene_of("\"cloths\": [" + list + "]");
    const auto model = build_model(scene, std::vector<mesh::TriangleMesh>(cloths.size()));
    REQUIRE_OK(model);
    return equal_grids(model->bodies, most_cloths(model->bodies[0], limits));
  };
  CHECK(equal_of({plain}) == 1);
  CHECK(equal_of({plain, other_place, pinned, longer, plain}) == 3);
  for (const std::string& other : {longer, damped, stiffer, wider}) CHECK(equal_of({plain, other}) == 1);
  limits.max_workgroups_per_dimension = 2;
  CHECK(equal_of({plain, plain, plain}) == 2);
  limits.max_workgroups_per_dimension = 65535;
  limits.max_storage_binding_size = std::uint64_t{4} * 40 * 30 * 200;  // bytes: some 193 a node
  CHECK(equal_of({plain, plain, plain, plain, plain}) < 5);
  CHECK(equal_of({plain, plain, plain, plain, plain}) > 1);
  limits.max_storage_binding_size = 1024;  // none fits: its own buffers say so
  CHECK(equal_of({plain, plain}) == 1);
}
