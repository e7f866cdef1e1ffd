// What a search lists beyond places: where vertices may go until the next search, that nothing unlisted comes near
// meanwhile, and that neighbours are left out only where they hold no pair.
#include "contact/record_checks.hpp"
#include "mesh/primitives.hpp"

using namespace weft;

namespace {

MotionSet random_set(Random& random, double range, double size) {
  MotionSet made{range * Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}};
  made.slack = random.below(4) == 0 ? 0 : size * random.uniform(0, 0.3);
  if (random.below(3) != 0) made.ahead = size * random.uniform(0, 1.5) * random_direction(random);
  return made;
}

/// A feature of this many vertices about a point, which often all go the same way.
std::vector<MotionSet> random_feature(std::size_t count, const Vec3d& middle, Random& random) {
  const double size = std::pow(10, random.uniform(-2, 0));
  const MotionSet common = random_set(random, 0, size);
  const bool together = random.below(2) == 0;
  std::vector<MotionSet> made;
  for (std::size_t v = 0; v < count; ++v) {
    made.push_back(random_set(random, 0.5, size));
    made.back().place += middle;
    if (together) made.back().ahead = common.ahead;
  }
  if (random.below(8) == 0 && count > 1)
    made[1].place = made[0].place + 1e-3 * (made[1].place - made[0].place);
  if (random.below(8) == 0 && count > 2)
    made[2].place = made[0].place + random.uniform(-1, 2) * (made[1].place - made[0].place);
  return made;
}

MovingPair random_pair(Random& random) {
  using reference::PairKind;
  MovingPair made;
  made.kind =
      std::array{PairKind::VertexTriangle, PairKind::EdgeEdge,      PairKind::ObjectVertexTriangle,
                 PairKind::EdgeObjectEdge, PairKind::VertexCapsule, PairKind::VertexPlane}[random.below(6)];
  const Vec3d away = random.uniform(0, 1.5) * random_direction(random);
  const bool edges = made.kind == PairKind::EdgeEdge || made.kind == PairKind::EdgeObjectEdge;
  const bool plane = made.kind == PairKind::VertexPlane, capsule = made.kind == PairKind::VertexCapsule;
  made.a = random_feature(edges ? 2 : 1, away, random);
  made.b = random_feature(edges || capsule ? 2 : plane ? 1 : 3, {}, random);
  if (plane) made.normal = random_direction(random);
  const bool shape =
      made.kind == PairKind::ObjectVertexTriangle || made.kind == PairKind::EdgeObjectEdge || capsule;
  if (shape && random.below(2) == 0) made.radius = random.uniform(0, 0.3);  // sphere, capsule
  if (shape)  // scripted: no way ahead, one slack
    for (MotionSet& set : made.kind == PairKind::ObjectVertexTriangle ? made.a : made.b) set.ahead = {};
  return made;
}

/// Cloth of loose triangles that fly about, of which some are held, among all kinds of obstacles that move.
SearchCase flying_soup(std::uint64_t seed) {
  Random random(seed);
  SearchCase made;
  const auto soup = [&](std::uint32_t count, double range) {
    mesh::TriangleMesh mesh;
    for (std::uint32_t t = 0; t < count; ++t) {
      const Vec3d middle = range * Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      const double thin = t % 3 == 0 ? 0.02 : 1;
      const Vec3d along = 0.15 * random_direction(random), beside = 0.1 * thin * random_direction(random);
      for (const Vec3d& p : {middle, middle + along, middle + 0.4 * along + beside})
        mesh.positions.push_back(p.to<float>());
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
  };
  made.cloth = soup(40, 0.35);
  made.objects = {soup(8, 0.4), soup(8, 0.4)};
  made.deforming = {false, true};
  made.shapes = {scene::ColliderSphere{{0.2, -0.1, 0.3}, 0.1},
                 scene::ColliderPlane{{0, -0.4, 0}, {0, 0.8, 0.6}},
                 scene::ColliderCapsule{{-0.3, 0, 0.2}, {-0.2, 0.3, 0.1}, 0.05}};
  for (std::size_t t = 0; t < made.cloth.triangles.size(); ++t) {
    const Vec3d common = std::array{0.0, 0.002, 0.01, 0.05}[random.below(4)] * random_direction(random);
    for (int k = 0; k < 3; ++k) {
      const double own = random.below(3) == 0 ? 0.01 : 0;
      made.velocities.push_back((common + own * random_direction(random)).to<float>());
      made.held.push_back(random.below(20) == 0);
    }
  }
  made.thickness = 0.03F;
  made.self_thickness = 0.02F;
  made.reach = 0.005F;
  made.collider_travel = 0.002F;
  return made;
}

/// Nothing that the search does not list comes nearer than its thickness on motions within the sets.
void check_unlisted(const SearchFound& found, const SearchRun& run, std::uint32_t motions,
                    std::uint64_t seed) {
  std::map<FeatureKey, std::size_t> listed;
  for (const ListedPair& pair : found.pairs)
    if (!is_crossing(pair)) ++listed[key_of(pair.ids)];
  Random random(seed);
  std::size_t unlisted = 0, near = 0, wrong = 0;
  const double band = 1e-5 * run.setup().self_radius();
  for (const PossiblePair& pair : possible_pairs(found, run, band)) {
    const bool is_listed = listed.count(pair.key) != 0;
    unlisted += is_listed ? 0 : 1;
    const double least = least_gap_on_motions(pair.moving, motions, random);
    near += is_listed && least < pair.thickness ? 1 : 0;
    if (!is_listed && least < pair.thickness - 4 * pair.doubt) ++wrong;
  }
  std::printf("%zu pairs that are not listed, %zu listed ones that come near\n", unlisted, near);
  CHECK(wrong == 0);
  CHECK(unlisted > 100);
}

std::vector<Vec3f> turned(const std::vector<Vec3f>& list) {  // about the axis (1, 1, 1), and not by a third
  const Vec3d axis = Vec3d{1, 1, 1} / std::sqrt(3.0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  std::vector<Vec3f> made;
  for (const Vec3f& f : list) {
    const Vec3d p = f.to<double>();
    made.push_back((c * p + s * cross(axis, p) + (1 - c) * dot(axis, p) * axis).to<float>());
  }
  return made;
}

/// A sheet with the lengths that the law gives it (contact_law.hpp), in substeps of 1/480 s.
SearchCase lawful_sheet(std::uint32_t triangle_count) {
  SearchCase made = sheet_of(triangle_count);
  const float cell = made.cloth.positions[1].x - made.cloth.positions[0].x, altitude = cell / std::sqrt(2.0F);
  made.thickness = 0.006F;
  made.self_thickness = std::min(made.thickness, 0.5F * altitude);
  made.most_reach = 0.5F * (0.95F * altitude - made.self_thickness);
  made.reach = std::min(0.5F * made.thickness, made.most_reach);
  made.substep = 1.0F / 480;
  made.room = {20000, 20000, 2200000};
  return made;
}

/// Pairs of triangles that share an edge, of all shapes and folds: edges of 0.03 to 1 m, slivers, tips beside the edge,
/// folds from flat to shut. At rest all lie flat.
SearchCase hinges(std::uint32_t count, std::uint64_t seed, std::vector<Vec3f>& folded) {
  Random random(seed);
  SearchCase made;
  for (std::uint32_t h = 0; h < count; ++h) {
    const Vec3d origin = 4.0 * Vec3d{double(h % 8), double(h / 8 % 8), double(h / 64)};
    const double size = std::pow(10, random.uniform(-1.5, 0)), half_turn = std::acos(-1.0);
    double angle = random.uniform(0, half_turn);
    if (h % 4 == 0) angle = 0;
    if (h % 16 == 1) angle = half_turn;
    const auto tip = [&](double turn, double side, double along, double high) {
      return origin + Vec3d{along, side * high * std::cos(turn), high * std::sin(turn)};
    };
    const double along_x = size * random.uniform(-1, 2), along_y = size * random.uniform(-1, 2);
    const double high_x = std::pow(10, random.uniform(-1.5, 0)),
                 high_y = std::pow(10, random.uniform(-1.5, 0));
    const std::uint32_t first = 4 * h;
    for (const bool at_rest : {true, false}) {
      auto& list = at_rest ? made.cloth.positions : folded;
      list.push_back(origin.to<float>());
      list.push_back((origin + Vec3d{size, 0, 0}).to<float>());
      list.push_back(tip(0, 1, along_x, high_x).to<float>());
      list.push_back(tip(at_rest ? 0 : angle, -1, along_y, high_y).to<float>());
    }
    made.cloth.triangles.push_back({first, first + 1, first + 2});
    made.cloth.triangles.push_back({first + 1, first, first + 3});
  }
  made.thickness = made.self_thickness = 0.05F;
  made.reach = 0.01F;
  return made;
}

}  // namespace

TEST_CASE("a slow vertex may leave its place by its slack, a fast one goes ahead until the next search") {
  // For the search's interval of four substeps, and a fourth of that for safety: five substeps. A vertex that leaves
  // its slack in five goes on for ten, but no further than four slacks, nor less than five.
  GpuFixture fixture;
  SearchCase setup = sheet_of(40);
  setup.reach = 0.01F;
  setup.most_reach = 0.03F;
  setup.collider_travel = 0.004F;
  const Vec3d along = Vec3d{1, 2, -2} / 3.0;
  struct Expected {
    double way, slack, steps;
  };
  const Expected expected[] = {{0, 0.03, 0},      {0.0005, 0.03, 0}, {0.002, 0.03, 0}, {0.0059, 0.03, 0},
                               {0.008, 0.03, 10}, {0.02, 0.03, 6},   {0.5, 0.03, 5}};
  const std::size_t vertices = setup.cloth.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) {
    setup.velocities.push_back((expected[v % 7].way * along).to<float>());
    setup.held.push_back(v % 11 == 0);
  }
  SearchRun run(fixture.device(), setup);
  const SearchFound found = run.run();
  CHECK(found.statistics.reach ==
        doctest::Approx(0.03).epsilon(1e-6).scale(0));  // as ten substeps of its travel, at most that
  for (std::size_t v = 0; v < vertices; ++v) {
    CAPTURE(v);
    Expected of = expected[v % 7];
    if (v % 11 == 0) of = {0, 0.03, 0};  // held: wherever the scene may take it
    CHECK(found.places[v].xyz() == setup.cloth.positions[v]);
    CHECK(found.places[v].w == doctest::Approx(of.slack).epsilon(1e-6).scale(0));
    const double rounding =
        1.2e-7 * (length(setup.cloth.positions[v].to<double>()) + of.way);  // of where it comes
    CHECK(length(found.aheads[v].to<double>() - of.steps * of.way * along) <=
          1e-6 * of.way + of.steps * rounding);
  }
}

TEST_CASE(
    "no pair that the law leaves out comes within the thickness, whatever its vertices do in their sets") {
  Random random(11);
  std::size_t unlisted = 0, near = 0, blind = 0, wrong = 0;
  for (int n = 0; n < 10000; ++n) {
    const MovingPair pair = random_pair(random);
    const double thickness = std::pow(10, random.uniform(-2.5, -0.7));
    const double least = least_gap_on_motions(pair, 50, random);
    if (may_come(pair, thickness) && boxes_meet(pair, thickness)) {
      near += least < thickness ? 1 : 0;
      const reference::Gap gap = gap_at(pair, start_of(pair));
      blind += least < thickness && gap.distance >= thickness + nearing(pair, gap.direction).slack ? 1 : 0;
    } else {
      ++unlisted;
      wrong += least < thickness - 1e-9 ? 1 : 0;
    }
  }
  std::printf("%zu unlisted; of the listed %zu come near, %zu of them ahead of their slacks\n", unlisted,
              near, blind);
  CHECK(wrong == 0);
  CHECK(unlisted > 3000);
  CHECK(near > 1000);  // the motions find what there is
  CHECK(blind > 100);  // and a law without the ways ahead would miss these
}

TEST_CASE(
    "a search lists what the law lists in soups that fly among moving obstacles, and nothing else comes "
    "near") {
  GpuFixture fixture;
  SearchRun run(fixture.device(), flying_soup(1));
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    CAPTURE(seed);
    const SearchCase other = flying_soup(seed);
    run.move(other.cloth.positions, other.velocities);
    CHECK(check_all(run).pairs > 200);
    check_unlisted(run.run(), run, 20, seed);
  }
}

TEST_CASE("vertices of a sheet with objects that fly each its own way are listed by the law in every pose") {
  GpuFixture fixture;
  SearchCase setup = sheet_of(257);
  mesh::TriangleMesh ball = mesh::make_sphere(10, 8), box = mesh::make_box({0.5, 0.1, 0.3});
  for (Vec3f& p : ball.positions) p = (0.2 * p.to<double>() + Vec3d{0.3, -0.15, 0.4}).to<float>();
  for (Vec3f& p : box.positions) p += Vec3f{0.1F, 0.07F, 0.2F};
  setup.objects = {ball, box};
  setup.deforming = {false, true};
  setup.room = {1000000, 1000000, 200000};
  Random random(5);
  for (std::size_t v = 0; v < setup.cloth.positions.size(); ++v)
    setup.velocities.push_back(
        (std::array{0.0, 0.001, 0.0015, 0.01, 0.02}[random.below(5)] * random_direction(random)).to<float>());
  SearchRun run(fixture.device(), setup);
  const std::vector<Vec3f> flat = setup.cloth.positions;
  for (const Shape shape : kShapes) {
    CAPTURE(static_cast<int>(shape));
    run.place(shaped(flat, shape));
    CHECK(check_all(run).pairs > 500);
  }
}

TEST_CASE("a flat sheet lists nothing of itself at rest, slow, or falling at 10 m/s across its plane") {
  // Features that share no vertex are an altitude apart, 0.05 of it more than what both may go beside their ways; their
  // ways ahead are across n, which lies in the sheet.
  GpuFixture fixture;
  for (const std::uint32_t triangles : {200U, 2048U}) {
    SearchCase setup = lawful_sheet(triangles);
    const std::vector<Vec3f> flat = setup.cloth.positions;
    const Vec3f down = turned({{0, -1, 0}})[0];
    SearchRun run(fixture.device(), setup);
    for (const float speed : {0.0F, 0.1F, 1.0F, 10.0F, 100.0F}) {
      CAPTURE(speed);
      run.move(turned(flat), std::vector<Vec3f>(flat.size(), speed * down));
      const SearchFound found = run.run();
      if (speed == 10.0F) CHECK(length(found.aheads[0].to<double>()) >= 5 * 10.0 / 480 - 1e-6);
      CHECK(found.statistics.pairs == 0);
    }
  }
}

TEST_CASE("a flat sheet that flies in its plane, or is blown apart, lists all that may come near") {
  GpuFixture fixture;
  SearchCase setup = lawful_sheet(72);
  const std::vector<Vec3f> flat = setup.cloth.positions;
  std::vector<Vec3f> along(flat.size(), Vec3f{6, 0, 3}), blown;
  Random random(3);
  for (std::size_t v = 0; v < flat.size(); ++v)
    blown.push_back((10.0 * random_direction(random)).to<float>());
  SearchRun run(fixture.device(), setup);
  for (const auto& velocities : {along, blown}) {
    run.move(flat, velocities);
    CHECK(check_all(run).pairs > 100);
    check_unlisted(run.run(), run, 20, 4);
  }
}

TEST_CASE(
    "neighbours that are left out hold no pair that the law lists, however they are folded and shaped") {
  GpuFixture fixture;
  std::vector<Vec3f> folded;
  SearchCase setup = hinges(384, 21, folded);
  SearchRun run(fixture.device(), setup);
  Random random(9);
  std::vector<Vec3f> still(folded.size()), flying;
  for (std::size_t v = 0; v < folded.size(); ++v)
    flying.push_back(
        (std::array{0.0, 0.0, 0.0, 0.003, 0.02}[random.below(5)] * random_direction(random)).to<float>());
  for (const auto& velocities : {still, flying}) {
    run.move(folded, velocities);
    const SearchFound found = run.run();
    // Coordinates of 28 m are good for 28 * 2^-24 = 1.7e-6 m.
    const CandidateCount count = check_self_candidates(found, named(found, run), run);
    const ListCheck listed = check_pairs(found, run, 1e-5);
    std::printf("hinges: %zu flat, %zu candidates, %zu pairs\n", count.flat, count.expected, listed.pairs);
    CHECK(count.flat > 20);
    CHECK(listed.pairs > 100);
  }
}

TEST_CASE("bent strips, sheets of slivers and compressed sheets list all that the law lists") {
  GpuFixture fixture;
  for (const double aspect : {0.1, 1.0, 10.0}) {
    CAPTURE(aspect);
    SearchCase setup = sheet_of(128);
    for (Vec3f& p : setup.cloth.positions) p.z *= static_cast<float>(aspect);
    const float altitude = 0.125F * std::min(1.0F, static_cast<float>(aspect)) / 1.5F;
    setup.self_thickness = 0.4F * altitude;
    setup.reach = 0.1F * altitude;
    const std::vector<Vec3f> flat = setup.cloth.positions;
    SearchRun run(fixture.device(), setup);
    std::size_t left_out = 0;
    for (const double turn :
         {0.2, 0.6, 1.2, 2.0, 2.8, 3.1}) {  // of a zigzag of strips, by which each is bent [rad]
      CAPTURE(turn);
      for (const double part : {1.0, 0.3}) {  // of the length along the strips
        std::vector<Vec3f> bent;
        for (const Vec3f& p : flat) {
          const double strip = std::round(8 * p.x), half = 0.5 * turn;
          bent.push_back(
              Vec3d{0.125 * strip * std::cos(half), std::fmod(strip, 2) * 0.125 * std::sin(half), part * p.z}
                  .to<float>());
        }
        run.place(bent);
        const SearchFound found = run.run();
        left_out += check_self_candidates(found, named(found, run), run).flat;
        check_pairs(found, run, 1e-5 * setup.self_radius());
      }
    }
    CHECK(left_out > 100);
  }
}

TEST_CASE(
    "a pair of one cloth keeps half of its distance at rest where that is less, and one that touches at rest "
    "nothing") {
  GpuFixture fixture;
  // Slivers of a hundred by one: two rows of them, and a seam, vertices of which stand at one place.
  mesh::TriangleMesh cloth;
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i <= 20; ++i) cloth.positions.push_back(Vec3d{0.001 * i, 0, 0.1 * row}.to<float>());
  const auto add_rows = [&](std::uint32_t first) {
    for (std::uint32_t row = 0; row < 2; ++row)
      for (std::uint32_t i = 0; i < 20; ++i) {
        const std::uint32_t a = first + 21 * row + i;
        cloth.triangles.push_back({a, a + 1, a + 21});
        cloth.triangles.push_back({a + 1, a + 22, a + 21});
      }
  };
  add_rows(0);
  const std::size_t vertices = cloth.positions.size();
  for (std::size_t v = 0; v < vertices; ++v) cloth.positions.push_back(Vec3f(cloth.positions[v]));
  add_rows(static_cast<std::uint32_t>(vertices));
  SearchCase setup;
  setup.cloth = cloth;
  setup.thickness = setup.self_thickness = 0.005F;
  setup.reach = 0.0012F;
  setup.room = {400000, 400000, 400000};
  for (const bool two_cloths : {false, true}) {
    CAPTURE(two_cloths);
    if (two_cloths) setup.second_cloth = {static_cast<std::uint32_t>(vertices), 80};
    SearchRun run(fixture.device(), setup);
    const SearchFound found = run.run();
    check_pairs(found, run, 1e-7);
    std::size_t touching = 0, thin = 0, whole = 0;
    for (const ListedPair& pair : found.pairs) {
      if (is_crossing(pair)) continue;
      touching += thickness_of(pair) == 0 ? 1 : 0;
      thin += thickness_of(pair) > 0 && thickness_of(pair) < setup.self_thickness ? 1 : 0;
      whole += thickness_of(pair) == setup.self_thickness ? 1 : 0;
      // Slanted edges of 100 mm, 3 mm apart across them; a vertex that stands at one place with another.
      const FeatureKey key = key_of(pair.ids);
      if (key == edge_key({2, 23}, {5, 26}))
        CHECK(thickness_of(pair) == doctest::Approx(0.0015).epsilon(1e-4).scale(0));
      if (key == corner_key(63, {0, 1, 21}))
        CHECK(thickness_of(pair) == (two_cloths ? setup.self_thickness : 0));
    }
    CHECK(thin > 500);
    if (two_cloths) {
      CHECK(touching == 0);
      CHECK(whole > 500);
    } else {
      CHECK(touching > 200);
    }
  }
}
