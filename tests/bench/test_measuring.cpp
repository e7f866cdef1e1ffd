// The measurements of `weft bench`, on small sizes: counts and sizes, never times.
#include <doctest/doctest.h>

#include <cmath>

#include "base/file.hpp"
#include "bench/copy.hpp"
#include "bench/crossing_count.hpp"
#include "bench/drawn_frames.hpp"
#include "bench/largest.hpp"
#include "bench/pull.hpp"
#include "bench/row.hpp"
#include "gpu/gpu_fixture.hpp"
#include "method/method.hpp"
#include "scene/load.hpp"
#include "source_path.hpp"
#include "temporary_folder.hpp"

using namespace weft;

namespace {

/// Lowers what a binding may hold.
void limit_bindings(gpu::Device& device, std::uint64_t bytes) {
  gpu::Limits limits = device.limits();
  limits.max_storage_binding_size = bytes;
  device.lower_limits(limits);
}

bool makes_world(gpu::Device& device, std::uint32_t side, bench::Formulation formulation) {
  auto sheet = bench::make_hanging_sheet(side, formulation);
  REQUIRE(sheet);
  return static_cast<bool>(sim::World::create(device, sheet->scene, sheet->assets));
}

}  // namespace

TEST_CASE("the largest sheet within a limit runs, and the next larger one is refused by that limit") {
  for (const bench::Formulation formulation : bench::kFormulations) {
    GpuFixture fixture{OwnDevice{}};
    limit_bindings(fixture.device(), 500000);
    const auto row = bench::measure_largest(fixture.device(), formulation, "adapter", {1ULL << 30U, 60});
    REQUIRE_MESSAGE(row, (row ? "" : row.error().message));
    CAPTURE(row->variant);
    CAPTURE(row->side);
    CHECK(row->skipped.empty());
    CHECK(row->step.median > 0);
    CHECK(row->nodes == static_cast<std::uint64_t>(row->side) * row->side);
    CHECK(row->gpu_bytes > 4 * sizeof(Vec4f) * row->nodes);
    CHECK(row->limited_by.find("maxStorageBufferBindingSize of 500000") != std::string::npos);
    CHECK(makes_world(fixture.device(), row->side, formulation));
    CHECK(!makes_world(fixture.device(), row->side + 1, formulation));
  }
}

TEST_CASE(
    "the largest sheet is worked out, not run, where memory or time do not suffice, and both numbers say "
    "so") {
  GpuFixture fixture;
  const auto full =
      bench::measure_largest(fixture.device(), bench::Formulation::Grid, "adapter", {20ULL << 20U, 60});
  REQUIRE(full);
  CHECK(full->skipped.find("GiB of memory, more than the 0.02 allowed") != std::string::npos);
  CHECK(full->step.samples == 0);
  CHECK(full->nodes * sizeof(Vec4f) <= fixture.device().limits().max_storage_binding_size);
  CHECK(full->nodes * 48 > fixture.device().limits().max_storage_binding_size);
  const auto slow =
      bench::measure_largest(fixture.device(), bench::Formulation::Grid, "adapter", {1ULL << 40U, 0.0001});
  REQUIRE(slow);
  CHECK(slow->skipped.find("s to build, more than the 0.0001 allowed") != std::string::npos);
}

TEST_CASE(
    "what a frame does once is not in the dispatches of its steps, whatever the solver and the cloths") {
  GpuFixture fixture;
  const std::string cloth = R"({"grid": [6, 6], "size": [1, 1], "density": 0.2})";
  const auto dispatches = [&](const std::string& solver, const std::string& cloths, int substeps) {
    const auto scene =
        scene::parse_scene(R"({"format": "weft-scene/1", "time": {"substeps": )" + std::to_string(substeps) +
                               R"(}, "solver": {"kind": ")" + solver + R"("}, "cloths": [)" + cloths + "]}",
                           "a.json");
    REQUIRE(scene);
    const auto assets = load_assets(*scene, std::string());
    REQUIRE(assets);
    auto world = sim::World::create(fixture.device(), *scene, *assets);
    REQUIRE(world);
    return bench::dispatches_per_step(**world);
  };
  for (const Method& method : methods()) {
    const std::string solver = scene::name_of(method.kind);
    CAPTURE(solver);
    const double one = dispatches(solver, cloth, 56);  // both below the step from which on contact iterates
    CHECK(dispatches(solver, cloth, 40) == one);
    // A dispatch may take two steps; one step in search_interval may search.
    const double whole = one * method.search_interval;
    CHECK(whole == std::floor(whole));
    const double two = dispatches(solver, cloth + ", " + cloth, 56);
    CHECK(dispatches(solver, cloth + ", " + cloth, 40) == two);
    CHECK(two >= one);  // a method may take all cloths in one dispatch
  }
}

TEST_CASE("copies and dispatches in order are measured in a buffer that the adapter allows") {
  GpuFixture fixture{OwnDevice{}};
  gpu::Limits limits = fixture.device().limits();
  limits.max_buffer_size = 1000003;
  fixture.device().lower_limits(limits);
  std::vector<bench::CopyRow> rows;
  REQUIRE(bench::run_copy(fixture.device(), true, [&](const bench::CopyRow& row) {
    rows.push_back(row);
    return Result<void>();
  }));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].what == "copy");
  CHECK(rows[0].bytes == 1000000);
  CHECK(rows[1].what == "dispatch");
  for (const bench::CopyRow& row : rows) CHECK(row.time.median > 0);
}

TEST_CASE("crossings are counted in the state as it is, through an object and through the cloth itself") {
  GpuFixture fixture;
  const auto scene = scene::parse_scene(R"({"format": "weft-scene/1", "solver": {"kind": "mass_spring"},
    "contact": {"method": "bvh", "thickness": 0.003}, "cloths": [{"grid": [9, 9], "size": [1, 1], "plane": "xz",
    "density": 0.3, "damping": 0.01, "stiffness": {"structural": 300, "shear": 40, "bend": 1}}],
    "colliders": [{"kind": "mesh", "mesh": "m", "transform": {"translate": [0, -1, 0]}}]})",
                                        "test");
  REQUIRE_MESSAGE(scene, (scene ? "" : scene.error().message));
  mesh::TriangleMesh spike;  // a thin upright triangle, far below the sheet
  spike.positions = {{-0.03F, -0.3F, 0.02F}, {0.04F, -0.3F, 0.02F}, {0.01F, 0.4F, 0.01F}};
  spike.triangles = {{0, 1, 2}};
  const auto assets =
      load_assets(*scene, [&](const std::string&) { return Result<mesh::TriangleMesh>(spike); });
  REQUIRE_MESSAGE(assets, (assets ? "" : assets.error().message));
  auto count = bench::CrossingCount::create(fixture.device(), *scene, *assets);
  REQUIRE_MESSAGE(count, (count ? "" : count.error().message));
  const auto world = sim::World::create(fixture.device(), *scene, *assets);
  REQUIRE(world);
  auto state = (*world)->snapshot();
  REQUIRE(state);
  CHECK(*count->of(*state) == 0);
  sim::Snapshot pierced = *state;  // lowered onto the spike, two of whose edges then pass through the sheet
  for (Vec4f& node : pierced.position) node.y = -1.0F;
  const auto through = count->of(pierced);
  REQUIRE(through);
  CHECK(*through >= 2);
  sim::Snapshot folded = *state;  // the edge of two nodes at a corner goes through the sheet's middle
  folded.position[0] = {0.02F, -0.2F, 0.03F, folded.position[0].w};
  folded.position[1] = {0.02F, 0.2F, 0.03F, folded.position[1].w};
  CHECK(*count->of(folded) > 0);
  CHECK(*count->of(*state) == 0);
}

TEST_CASE("frames with pictures are counted and leave no buffer behind") {
  GpuFixture fixture;
  auto sheet = bench::make_hanging_sheet(8, bench::Formulation::Grid);
  REQUIRE(sheet);
  REQUIRE(bench::fix_step(sheet->scene, sheet->assets, 4));
  const auto time = bench::time_drawn_frames(fixture.device(), sheet->scene, sheet->assets, nullptr, 0, 3);
  REQUIRE_MESSAGE(time, (time ? "" : time.error().message));
  CHECK(time->samples == 3);
  CHECK(time->least > 0);
  CHECK(fixture.device().allocated_bytes() == 0);
}

TEST_CASE("timed frames stay near their pose, in simulated time too") {
  GpuFixture fixture;
  auto sheet = bench::make_hanging_sheet(8, bench::Formulation::Grid);
  REQUIRE(sheet);
  REQUIRE(bench::fix_step(sheet->scene, sheet->assets, 4));
  const double frame = sheet->scene.time.frame;
  auto world = sim::World::create(fixture.device(), sheet->scene, sheet->assets);
  REQUIRE(world);
  for (int k = 0; k < 3; ++k) REQUIRE((*world)->advance_frame());
  REQUIRE((*world)->finish());
  const auto state = (*world)->snapshot();
  REQUIRE(state);
  const bench::Pose pose{*state, 8.5 * frame};
  const std::uint64_t before = (*world)->totals().frames;
  for (int k = 0; k < 23; ++k) {
    REQUIRE(bench::time_steps(**world, 0, 1, &pose));
    CHECK((*world)->time() > 3.5 * frame);
    CHECK((*world)->time() < 8.5 * frame);
  }
  // Frames 4 to 8; then each round of five begins with one that is not timed, its frame 4.
  CHECK((*world)->totals().frames - before == 23 + 5);
}

TEST_CASE("a pull that meets nothing is no row, but says until when no hit was found") {
  GpuFixture fixture;
  const TemporaryFolder folder;
  const auto file = read_file(source_path("scenes/pull-sphere.json"), 1U << 20U);
  REQUIRE(file);
  std::string scene(reinterpret_cast<const char*>(file->data()), file->size());
  const std::string place = R"("translate": [0, 0, 0])";
  REQUIRE(scene.find(place) != std::string::npos);
  scene.replace(scene.find(place), place.size(), R"("translate": [0, -9, 0])");
  REQUIRE(write_file(folder.path("pull-sphere.json"), scene));
  bench::Selection selection;
  selection.quick = true;
  selection.sides = {4};
  selection.objects = {"sphere"};
  int rows = 0;
  REQUIRE(bench::run_pull(fixture.device(), selection, {folder.path(""), source_path("models")},
                          [&](const bench::Row& row) {
                            ++rows;
                            // Pulled at full speed until 0.25 + 0.5 / 0.6 = 1.083 s, of which 0.1 s are timed.
                            CHECK(row.skipped.find("no 2 steps have a hit from 0.6 s to 1 s") == 0);
                            return Result<void>();
                          }));
  CHECK(rows == 5);
}

TEST_CASE("the noise of times is what 5 and 95 of 100 of them are") {
  std::vector<double> times;
  for (int k = 100; k >= 0; --k) times.push_back(k);
  const bench::Timing timing = bench::timing_of(times);
  CHECK(timing.least == 0);
  CHECK(timing.low == 5);
  CHECK(timing.median == 50);
  CHECK(timing.high == 95);
  CHECK(timing.samples == 101);
  const bench::Timing one = bench::timing_of({3});
  CHECK(one.low == 3);
  CHECK(one.high == 3);
  CHECK(bench::timing_of({}).samples == 0);
}
