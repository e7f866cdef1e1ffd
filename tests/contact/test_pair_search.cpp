// The search for pairs of features: its broad phase against boxes in f32, which it must equal exactly; its
// narrow phase against double; its lists against themselves.
#include "contact/record_checks.hpp"
#include "mesh/primitives.hpp"

using namespace weft;

namespace {

/// A sphere and a box in the way of the sheet, one that keeps its shape and one that does not.
SearchCase sheet_with_objects(std::uint32_t triangle_count) {
  SearchCase made = sheet_of(triangle_count);
  mesh::TriangleMesh ball = mesh::make_sphere(10, 8), box = mesh::make_box({0.5, 0.1, 0.3});
  for (Vec3f& p : ball.positions) p = (0.2 * p.to<double>() + Vec3d{0.3, -0.15, 0.4}).to<float>();
  for (Vec3f& p : box.positions) p += Vec3f{0.1F, 0.07F, 0.2F};
  made.objects = {ball, box};
  made.deforming = {false, true};
  return made;
}

/// Cloths and deforming objects of these numbers of triangles, from x = 0 on and elsewhere.
void check_tails(std::initializer_list<std::uint32_t> counts) {
  GpuFixture fixture;
  for (const std::uint32_t count : counts) {
    CAPTURE(count);
    SearchCase setup = sheet_of(count), other = sheet_of(count);
    for (Vec3f& p : other.cloth.positions) p = {p.x, 0.25F * p.z, -p.y};
    setup.objects = {other.cloth};
    setup.deforming = {true};
    const std::vector<Vec3f> flat = setup.cloth.positions;
    SearchRun run(fixture.device(), setup);
    for (const Shape shape : {Shape::Wavy, Shape::Crumpled})
      for (const Vec3f& shift :
           {Vec3f{}, Vec3f{0, 0.125F, 0}, Vec3f{0.5F, 0.01F, 0}, Vec3f{-0.75F, -0.5F, -0.25F}}) {
        CAPTURE(static_cast<int>(shape));
        std::vector<Vec3f> placed = shaped(flat, shape);
        for (Vec3f& p : placed) p += shift;
        run.place(placed);
        check_all(run);
      }
  }
}

}  // namespace

TEST_CASE(
    "candidates and pairs of cloth with itself and with objects are those of brute force in every pose") {
  GpuFixture fixture;
  SearchCase setup = sheet_with_objects(257);
  const std::vector<Vec3f> flat = setup.cloth.positions;
  for (const Vec3f& p : flat) setup.uv.push_back({p.x, p.z});
  SearchRun run(fixture.device(), setup);
  for (const Shape shape : kShapes) {
    CAPTURE(static_cast<int>(shape));
    run.place(shaped(flat, shape));
    const SearchFound found = run.run();
    const NamedCandidates names = named(found, run);
    const CandidateCount self = check_self_candidates(found, names, run);
    const std::size_t ball = check_object_candidates(found, names, run, 0),
                      box = check_object_candidates(found, names, run, 1);
    const double rounding = 1e-5 * setup.self_radius();
    const ListCheck listed = check_pairs(found, run, rounding);
    check_records(found, run, rounding);
    std::printf("pose %d: candidates %zu + %zu + %zu, flat %zu, pairs %zu, doubtful %zu\n",
                static_cast<int>(shape), self.expected, ball, box, self.flat, listed.pairs, listed.doubtful);
    CHECK(ball > 50);
    CHECK(box > 50);
    if (shape != Shape::Flat) CHECK(listed.pairs > 500);
    if (shape == Shape::Flat) CHECK(self.flat > 300);
  }
}

TEST_CASE("trees of one triangle and of a leaf's four, one less and one more, hold every triangle") {
  check_tails({1, 3, 4, 5});
}

TEST_CASE("trees of 4 * 8 triangles, one less and one more, hold every triangle") {
  check_tails({31, 32, 33});
}

TEST_CASE("trees of 4 * 64 triangles, one less and one more, hold every triangle") {
  check_tails({255, 256, 257});
}

TEST_CASE("rigid trees of one triangle and of few triangles hold every triangle") {
  GpuFixture fixture;
  for (const std::uint32_t count : {1U, 4U, 5U, 17U}) {
    CAPTURE(count);
    SearchCase setup = sheet_of(40);
    setup.objects = {mesh::make_sphere(6, 5)};
    setup.objects[0].triangles.resize(count);
    for (Vec3f& p : setup.objects[0].positions) p = 0.25F * p;
    SearchRun run(fixture.device(), setup);
    run.place(shaped(setup.cloth.positions, Shape::Crumpled));
    CHECK(check_all(run).pairs > 0);
  }
}

TEST_CASE("every triangle of a rigid object that has turned and moved is a candidate where its box is near") {
  GpuFixture fixture;
  SearchCase setup = sheet_with_objects(256);
  setup.most_reach = setup.reach;
  setup.objects.pop_back();
  const mesh::TriangleMesh ball = setup.objects[0];
  SearchRun run(fixture.device(), setup);
  const std::vector<Vec3f> cloth = shaped(setup.cloth.positions, Shape::Wavy);
  run.place(cloth);
  // Two thirds, one third, two thirds: a turn whose rows f32 does not have exactly.
  const float a = 2.0F / 3.0F, b = 1.0F / 3.0F;
  const RigidRows to{{Vec4f{a, -b, a, 0.1F}, Vec4f{a, a, -b, 0.02F}, Vec4f{-b, a, a, 0.3F}}};
  run.move_object(0, to);
  const SearchFound found = run.run();
  const NamedCandidates names = named(found, run);
  // In the object's space, where the kernel tests boxes; the way there is rounded to a few 2^-24 m.
  std::vector<Vec3f> local;
  for (const Vec3f& p : cloth) {
    const Vec3d d = p.to<double>() - to({});
    Vec3d q;
    for (const Vec4f& row : to.rows) q += d[static_cast<int>(&row - to.rows.data())] * row.xyz().to<double>();
    local.push_back(q.to<float>());
  }
  std::size_t sure = 0, missing = 0, stray = 0;
  for (std::uint32_t i = 0; i < setup.cloth.triangles.size(); ++i)
    for (std::uint32_t t = 0; t < ball.triangles.size(); ++t) {
      const BoxF own = box_of(local, setup.cloth.triangles[i]),
                 other = box_of(ball.positions, ball.triangles[t]);
      const bool listed =
          std::binary_search(names.objects[0].begin(), names.objects[0].end(), NumberPair{i, t});
      const bool near = boxes_meet(own, other, setup.radius() - 1e-5F);
      sure += near ? 1 : 0;
      missing += near && !listed ? 1 : 0;
      stray += listed && !boxes_meet(own, other, setup.radius() + 1e-5F) ? 1 : 0;
    }
  CHECK(sure > 200);
  CHECK(missing == 0);
  CHECK(stray == 0);
  CHECK(check_pairs(found, run, 1e-5 * setup.radius()).pairs > 100);
  check_records(found, run, 1e-5 * setup.radius());
}

TEST_CASE("an object that deforms is found exactly where it is now") {
  GpuFixture fixture;
  SearchCase setup = sheet_of(200), other = sheet_of(150);
  setup.objects = {other.cloth};
  setup.deforming = {true};
  SearchRun run(fixture.device(), setup);
  for (const Shape shape : kShapes) {
    CAPTURE(static_cast<int>(shape));
    run.place(shaped(setup.cloth.positions, Shape::Wavy));
    std::vector<Vec3f> placed = shaped(other.cloth.positions, shape, 7);
    for (Vec3f& p : placed) p = {p.z, 0.03F + 0.5F * p.y, p.x};
    run.place_object(0, placed);
    CHECK(check_all(run).pairs > 200);
  }
}

TEST_CASE("spheres, capsules and planes are listed with every feature that is near their surface") {
  GpuFixture fixture;
  SearchCase setup = sheet_of(256);
  setup.shapes = {scene::ColliderSphere{{0.25, -0.125, 0.5}, 0.1875},
                  scene::ColliderPlane{{0, -0.0625, 0}, {0, 1, 0}},
                  scene::ColliderCapsule{{0.625, 0, 0.25}, {0.75, 0.125, 0.875}, 0.0625},
                  scene::ColliderPlane{{0.5, 0.25, 0}, {-0.6, -0.8, 0}}};
  SearchRun run(fixture.device(), setup);
  for (const Shape shape : kShapes) {
    CAPTURE(static_cast<int>(shape));
    run.place(shaped(setup.cloth.positions, shape));
    CHECK(check_all(run).pairs > 50);
  }
}

TEST_CASE("what a search lists does not hang on the size of workgroups") {
  GpuFixture fixture;
  SearchCase setup = sheet_with_objects(257);
  setup.cloth.positions = shaped(setup.cloth.positions, Shape::Accordion);
  std::vector<std::vector<FeatureKey>> lists;
  for (const std::uint32_t size : {64U, 128U, 256U}) {
    SearchRun run(fixture.device(), setup, size);
    lists.emplace_back();
    for (const ListedPair& pair : run.run().pairs)
      if (!is_crossing(pair)) lists.back().push_back(key_of(pair.ids));
    std::sort(lists.back().begin(), lists.back().end());
    CHECK(std::adjacent_find(lists.back().begin(), lists.back().end()) == lists.back().end());
    CHECK(lists.back() == lists.front());
  }
  CHECK(lists.front().size() > 1000);
}

TEST_CASE("a tree of five levels, whose upper boxes have a dispatch of their own, holds every triangle") {
  GpuFixture fixture;
  SearchCase setup = sheet_of(2049);  // 4 * 8^3 + 1: the walk begins at boxes of the fourth level
  const std::vector<Vec3f> flat = setup.cloth.positions;
  SearchRun run(fixture.device(), setup);
  for (const Shape shape : {Shape::Wavy, Shape::Accordion}) {
    run.place(shaped(flat, shape));
    const std::size_t pairs = check_all(run).pairs;
    if (shape == Shape::Accordion) CHECK(pairs > 500);
  }
}
