// Inputs that must not mislead the search for pairs: shapes that break formulas, meshes that are no surfaces,
// lengths far from a metre, and coordinates that are no numbers.
#include <doctest/doctest.h>

#include "contact/record_checks.hpp"
#include "mesh/primitives.hpp"

using namespace weft;

namespace {

/// Cloth that is crumpled around a ball, and that ball.
SearchCase crumpled_on_ball(std::uint32_t triangle_count = 128) {
  SearchCase made = sheet_of(triangle_count);
  for (const Vec3f& p : made.cloth.positions) made.uv.push_back({p.x, p.z});
  made.cloth.positions = shaped(made.cloth.positions, Shape::Crumpled, 3);
  made.objects = {mesh::make_sphere(8, 6)};
  for (Vec3f& p : made.objects[0].positions) p = 0.25F * p;
  return made;
}

/// Free triangles at random places, none of which shares a vertex with another.
mesh::TriangleMesh loose_triangles(std::uint32_t count, double range, double size, std::uint64_t seed) {
  Random random(seed);
  const auto point = [&](double half) {
    return Vec3d{random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)};
  };
  mesh::TriangleMesh made;
  for (std::uint32_t t = 0; t < count; ++t) {
    const Vec3d centre = point(range);
    for (int k = 0; k < 3; ++k) made.positions.push_back((centre + point(size)).to<float>());
    made.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return made;
}

std::vector<FeatureKey> keys_of(const SearchFound& found) {
  std::vector<FeatureKey> keys;
  for (const ListedPair& pair : found.pairs)
    if (!is_crossing(pair)) keys.push_back(key_of(pair.ids));
  std::sort(keys.begin(), keys.end());
  return keys;
}

SearchCase small_case(mesh::TriangleMesh cloth, float thickness) {
  SearchCase made;
  made.cloth = std::move(cloth);
  made.thickness = made.self_thickness = thickness;
  made.reach = 0.25F * thickness;
  return made;
}

}  // namespace

TEST_CASE("triangles that share an edge or a vertex list only features that share no vertex") {
  GpuFixture fixture;
  // Two triangles folded shut on their common edge, and a third at one end of it:
  //
  //      2       3 lies 0.01 above 2; 4 and 5 lie 0.01 above 0's other neighbours
  //     / \.
  //    0---1
  SearchCase setup =
      small_case({{{0, 0, 0}, {1, 0, 0}, {0.5F, 0, 1}, {0.5F, 0.01F, 1}, {1, 0.02F, 0.1F}, {0.4F, 0.02F, 1}},
                  {{0, 1, 2}, {1, 0, 3}, {0, 4, 5}}},
                 0.125F);
  SearchRun run(fixture.device(), setup);
  CHECK(check_all(run).pairs > 0);
  const SearchFound found = run.run();
  for (const FeatureKey& key : keys_of(found)) {
    if (key[0] == 0) {
      CHECK((key[1] != key[2] && key[1] != key[3] && key[1] != key[4]));
    } else {
      CHECK((key[1] != key[3] && key[1] != key[4] && key[2] != key[3] && key[2] != key[4]));
    }
  }
  // The fold: each tip is near the other triangle.
  const std::vector<FeatureKey> keys = keys_of(found);
  CHECK(std::binary_search(keys.begin(), keys.end(), corner_key(3, {0, 1, 2})));
  CHECK(std::binary_search(keys.begin(), keys.end(), corner_key(2, {0, 1, 3})));
}

TEST_CASE("cloth triangles without area, and slivers down to a ten-thousandth, are listed as in double") {
  GpuFixture fixture;
  SearchCase setup = small_case(loose_triangles(120, 0.4, 0.1, 5), 0.03125F);
  setup.objects = {loose_triangles(40, 0.4, 0.1, 6)};
  setup.deforming = {true};
  Random random(7);
  SearchRun run(fixture.device(), setup);
  std::vector<Vec3f> cloth = setup.cloth.positions, object = setup.objects[0].positions;
  for (std::vector<Vec3f>* mesh : {&cloth, &object})
    for (std::size_t t = 0; 3 * t < mesh->size(); ++t) {
      Vec3f* p = mesh->data() + 3 * t;
      const Vec3d a = p[0].to<double>(), b = p[1].to<double>(), c = p[2].to<double>();
      const double part = random.uniform(0, 1), width = std::pow(0.1, 1 + static_cast<int>(t % 4));
      if (t % 5 == 0) p[2] = p[1];                              // a segment
      if (t % 5 == 1) p[1] = p[2] = p[0];                       // a point
      if (t % 5 == 2) p[2] = (a + part * (b - a)).to<float>();  // three points of a line, but for rounding
      if (t % 5 == 3) p[2] = (a + part * (b - a) + width * (c - a)).to<float>();
    }
  run.place(cloth);
  run.place_object(0, object);
  CHECK(check_all(run, 1e-4 * setup.self_radius()).pairs > 300);
}

TEST_CASE("vertices that stand at one place are features of their own, at distance zero") {
  GpuFixture fixture;
  mesh::TriangleMesh cloth = loose_triangles(30, 0.3, 0.2, 8);
  const std::size_t half = cloth.positions.size();
  for (std::size_t v = 0; v < half; ++v) cloth.positions.push_back(Vec3f(cloth.positions[v]));
  for (std::uint32_t t = 0; t < 30; ++t)
    cloth.triangles.push_back({90 + 3 * t, 91 + 3 * t, 92 + 3 * t});  // the same triangle of other vertices
  SearchCase setup = small_case(cloth, 0.03125F);
  setup.objects = {loose_triangles(10, 0.3, 0.2, 9)};
  setup.objects[0].triangles.push_back(setup.objects[0].triangles[0]);  // named twice
  SearchRun run(fixture.device(), setup);
  const SearchFound found = run.run();
  CHECK(check_pairs(found, run, 1e-5 * setup.radius()).pairs > 300);
  check_records(found, run, 1e-5 * setup.radius());
  const std::vector<FeatureKey> keys = keys_of(found);
  for (std::uint32_t v = 0; v < 90; ++v)
    CHECK(std::binary_search(keys.begin(), keys.end(),
                             corner_key(v, {90 + v / 3 * 3, 91 + v / 3 * 3, 92 + v / 3 * 3})));
}

TEST_CASE("which way the triangles of cloth or object face changes no pair") {
  GpuFixture fixture;
  const SearchCase setup = crumpled_on_ball();
  SearchCase all = setup, half = setup;
  for (auto& t : all.objects[0].triangles) std::swap(t[0], t[1]);
  for (std::size_t t = 0; t < half.objects[0].triangles.size(); t += 2)
    std::swap(half.objects[0].triangles[t][1], half.objects[0].triangles[t][2]);
  for (std::size_t t = 0; t < half.cloth.triangles.size(); t += 3)
    std::swap(half.cloth.triangles[t][0], half.cloth.triangles[t][2]);
  SearchRun run(fixture.device(), setup);
  const std::vector<FeatureKey> expected = keys_of(run.run());
  CHECK(expected.size() > 1000);
  for (const SearchCase& turned : {all, half}) {
    SearchRun other(fixture.device(), turned);
    check_all(other);
    CHECK(keys_of(other.run()) == expected);
  }
}

TEST_CASE("objects with a fin, a bow-tie and a boundary are found whole, rigid or deforming") {
  GpuFixture fixture;
  mesh::TriangleMesh fin = mesh::make_box({0.5, 0.5, 0.5});  // a third triangle on an edge of the box
  fin.positions.push_back({0.4F, 0.45F, 0.1F});
  fin.triangles.push_back({fin.triangles[0][0], fin.triangles[0][1], 8});
  mesh::TriangleMesh bow_tie{
      {{0, 0, 0}, {0.3F, 0.05F, 0.1F}, {0.3F, -0.1F, 0.2F}, {-0.3F, 0, 0.1F}, {-0.3F, 0.1F, -0.2F}},
      {{0, 1, 2}, {0, 3, 4}}};
  mesh::TriangleMesh open = mesh::make_sphere(9, 7);
  open.triangles.resize(open.triangles.size() / 2);
  for (Vec3f& p : open.positions) p = 0.25F * p;
  SearchCase setup = crumpled_on_ball();
  setup.objects = {fin, bow_tie, open};
  for (const bool deforming : {false, true}) {
    setup.deforming.assign(3, deforming);
    SearchRun run(fixture.device(), setup);
    CHECK(check_all(run).pairs > 1000);
  }
}

TEST_CASE("all lengths ten thousand times smaller or larger give the same pairs") {
  GpuFixture fixture;
  const SearchCase metre = crumpled_on_ball();
  for (const float scale : {1e-4F, 1.0F, 1e4F}) {
    CAPTURE(scale);
    SearchCase setup = metre;
    for (Vec3f& p : setup.cloth.positions) p = scale * p;
    for (Vec3f& p : setup.objects[0].positions) p = scale * p;
    setup.thickness *= scale, setup.self_thickness *= scale, setup.reach *= scale;
    SearchRun run(fixture.device(), setup);
    CHECK(check_pairs(run.run(), run, 1e-5 * setup.self_radius()).pairs > 1000);
    const SearchFound found = run.run();
    check_object_candidates(found, named(found, run), run, 0);
    check_records(found, run, 1e-5 * setup.self_radius());
  }
}

TEST_CASE("with all vertices at one point every pair that shares no vertex is listed once") {
  GpuFixture fixture;
  SearchCase setup = sheet_of(33);
  setup.room = {60000, 60000, 2000};
  setup.objects = {loose_triangles(1, 0.01, 0.01, 2)};
  const std::size_t count = setup.cloth.positions.size();
  SearchRun run(fixture.device(), setup);
  run.place(std::vector<Vec3f>(count, {0.015625F, 0.015625F, 0.015625F}));
  const SearchFound found = run.run();
  check_pairs(found, run, 1e-5 * setup.self_radius());
  check_records(found, run, 1e-5 * setup.self_radius());
  CHECK(found.statistics.candidates == 33 * 32 / 2 + 33);  // nothing lies flat where nothing has a direction
}

TEST_CASE("one giant triangle among many tiny ones finds those near it, and they each other") {
  GpuFixture fixture;
  mesh::TriangleMesh cloth = loose_triangles(255, 0.5, 0.01, 12);
  for (Vec3f& p : cloth.positions) p.y *= 0.05F;
  const auto first = static_cast<std::uint32_t>(cloth.positions.size());
  for (const Vec3f& p : {Vec3f{-100, 0.01F, -100}, Vec3f{100, -0.01F, -90}, Vec3f{0, 0, 100}})
    cloth.positions.push_back(p);
  cloth.triangles.push_back({first, first + 1, first + 2});
  SearchCase setup = small_case(cloth, 0.0078125F);
  setup.objects = {{{{-80, -0.02F, 80}, {80, 0.01F, 80}, {3, 0.01F, -100}}, {{0, 1, 2}}}};
  SearchRun run(fixture.device(), setup);
  // Coordinates of 100 m are good for 100 * 2^-24 = 6e-6 m, and several meet in a distance.
  CHECK(check_all(run, 4e-5).pairs > 300);
}

TEST_CASE("without objects, and with an object of one triangle, only what is there is listed") {
  GpuFixture fixture;
  SearchCase setup = crumpled_on_ball();
  setup.objects.clear();
  SearchRun none(fixture.device(), setup);
  CHECK(check_all(none).pairs > 1000);
  setup.self_thickness = 0;  // nor does cloth meet cloth
  SearchRun nothing(fixture.device(), setup);
  const SearchFound found = nothing.run();
  CHECK(found.statistics.candidates == 0);
  CHECK(found.statistics.pairs == 0);
  CHECK(found.statistics.near == 0);
  setup.objects = {{{{0, 0, 0}, {0.25F, 0, 0}, {0, 0.125F, 0.25F}}, {{0, 1, 2}}}};
  for (const bool deforming : {false, true}) {
    setup.deforming = {deforming};
    SearchRun one(fixture.device(), setup);
    CHECK(check_all(one, 1e-5 * setup.radius()).pairs > 20);
  }
}

TEST_CASE("triangles with a vertex that is no number list nothing, and all others what they did") {
  GpuFixture fixture;
  SearchCase setup = crumpled_on_ball(257);
  mesh::TriangleMesh soft = mesh::make_sphere(6, 5);
  for (Vec3f& p : soft.positions) p = 0.2F * p + Vec3f{0.1F, 0.1F, 0};
  setup.objects.push_back(soft);
  setup.deforming = {false, true};
  setup.room = {60000, 60000, 60000};
  SearchRun run(fixture.device(), setup);
  const std::vector<Vec3f> clean = run.setup().cloth.positions;
  const std::vector<FeatureKey> expected = keys_of(run.run());
  constexpr float kInf = std::numeric_limits<float>::infinity(),
                  kNan = std::numeric_limits<float>::quiet_NaN();
  const std::uint32_t sick[] = {0, 40, 99};
  for (const float bad : {kInf, -kInf, kNan, -kNan}) {
    CAPTURE(bad);
    std::vector<Vec3f> placed = clean;
    for (int k = 0; k < 3; ++k) placed[sick[k]][k] = bad;
    run.place(placed);
    check_all(run);
    const std::vector<FeatureKey> found = keys_of(run.run());
    CHECK(std::includes(expected.begin(), expected.end(), found.begin(), found.end()));
    CHECK(found.size() > expected.size() / 2);
    std::vector<Vec3f> object = soft.positions;
    object[3].y = bad;
    run.place_object(1, object);
    const SearchFound blind = run.run();
    const NamedCandidates names = named(blind, run);
    check_self_candidates(blind, names, run);
    CHECK(check_object_candidates(blind, names, run, 0) > 1000);
    CHECK(check_object_candidates(blind, names, run, 1) > 1000);
    check_records(blind, run, 1e-5 * setup.self_radius());
    run.place_object(1, soft.positions);
  }
  run.place(clean);
  CHECK(keys_of(run.run()) == expected);  // no box remembers
  for (const float bad : {kInf, kNan}) {
    run.place(std::vector<Vec3f>(clean.size(), {bad, bad, bad}));
    const SearchFound found = run.run();
    CHECK(found.statistics.candidates == 0);
    CHECK(found.statistics.pairs == 0);
  }
  for (const float extreme : {std::numeric_limits<float>::max(), -std::numeric_limits<float>::max()}) {
    std::vector<Vec3f> placed = clean;  // far away, and no obstacle to what is here
    placed[40] = {extreme, extreme, extreme};
    run.place(placed);
    const SearchFound found = run.run();
    check_self_candidates(found, named(found, run), run);
    check_records(found, run, 1e-5 * setup.self_radius());
  }
  std::vector<Vec3f> placed = clean;  // a denormal may count as zero
  placed[40] = {std::numeric_limits<float>::denorm_min(), 0, -1e-41F};
  run.place(placed);
  check_all(run);
}
