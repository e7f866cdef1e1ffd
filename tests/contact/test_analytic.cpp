// Spheres and planes against double.
#include <cmath>

#include "contact/push_fixture.hpp"
#include "contact/reference/pushes/analytic.hpp"
#include "state/hash_pair.hpp"

using namespace weft;
using contact::PushSetup;

namespace {

/// Nodes anywhere around the origin, moved by up to `step`, every seventh kinematic.
Pose scattered_nodes(std::uint32_t count, double range, double step, std::uint64_t seed) {
  Random random(seed);
  Pose pose;
  const auto offset = [&](double size) {
    return Vec3d{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3d before = offset(range);
    const float inverse_mass = i % 7 == 0 ? 0.0F : 2.0F;
    pose.previous.push_back(Vec4f::from(before.to<float>(), inverse_mass));
    pose.predicted.push_back(Vec4f::from((before + offset(step)).to<float>(), inverse_mass));
  }
  pose.triangles = {{0, 1, 2}};
  return pose;
}

std::vector<Vec3d> positions(const std::vector<Vec4f>& list) {
  std::vector<Vec3d> result;
  for (const Vec4f& p : list) result.push_back(p.xyz().to<double>());
  return result;
}

}  // namespace

TEST_CASE("nodes near spheres and planes get the pushes of double, and count once a collider") {
  GpuFixture fixture;
  const Pose pose = scattered_nodes(20000, 2, 0.1, 1);
  PushSetup setup;
  setup.thickness = 0.0625;
  setup.spheres = {{{0.5, 0.25, 0}, 1}, {{-1, 0, 0.5}, 0.5}};
  setup.planes = {{{0, -1, 0}, {0, 1, 0}}, {{0.5, 0, 0}, {0.6, 0, 0.8}}};
  const Found found = find_contacts(fixture.device(), pose, setup);

  const std::vector<Vec3d> previous = positions(pose.previous), predicted = positions(pose.predicted);
  std::vector<double> inverse_mass;
  for (const Vec4f& p : pose.previous) inverse_mass.push_back(p.w);
  const auto expected = reference::analytic_pushes(previous, predicted, inverse_mass, setup.spheres,
                                                   setup.planes, {setup.thickness, found.max_push});
  std::uint32_t hits = 0, hash = 0;
  std::size_t doubtful = 0;
  for (std::uint32_t node = 0; node < expected.size(); ++node) {
    std::uint32_t id = contact::kAnalyticId;
    bool doubt = false;
    const auto count = [&](const auto& collider) {
      const double gap = reference::surface_at(collider, predicted[node]).distance - setup.thickness;
      doubt = doubt || std::abs(gap) < 1e-6;
      if (gap < 0 && inverse_mass[node] > 0) ++hits, hash += hash_pair(node, id);
      ++id;
    };
    for (const auto& sphere : setup.spheres) count(sphere);
    for (const auto& plane : setup.planes) count(plane);
    if (doubt) {
      ++doubtful;
      continue;
    }
    CAPTURE(node);
    REQUIRE(static_cast<std::uint32_t>(found.pushes[4 * node + 3]) == expected[node].count);
    for (int axis = 0; axis < 3; ++axis) {
      const double sum =
          found.pushes[4 * node + static_cast<std::size_t>(axis)] / static_cast<double>(found.push_scale);
      // Half a unit and 1e-6 m a push: roundings of coordinates up to 3 m, and f32's root and quotients (2.5
      // ulp).
      CHECK(std::abs(sum - expected[node].sum[axis]) <=
            expected[node].count * (0.5 / found.push_scale + 1e-6));
    }
  }
  CHECK(doubtful < 20);
  if (doubtful == 0) {
    CHECK(found.statistics.contacts == hits);
    CHECK(found.statistics.contact_hash == hash);
  }
  CHECK(hits > 10000);
}

TEST_CASE("a sphere pushes a node at its centre straight up, and far and tiny ones keep their bits finite") {
  GpuFixture fixture;
  Pose pose = scattered_nodes(64, 1, 0, 2);
  for (std::size_t i = 0; i < 64; ++i) {
    const float far = std::ldexp(1.0F, static_cast<int>(4 * i) - 128);  // 2^-128 to 2^124 m from the centre
    pose.previous[i] = pose.predicted[i] = i == 0 ? Vec4f{0, 0, 0, 1} : Vec4f{far, 0, 0, 1};
  }
  PushSetup setup;
  setup.spheres = {{{0, 0, 0}, 1}};
  setup.thickness = 0.5;
  const Found found = find_contacts(fixture.device(), pose, setup);
  const auto units = [&](double metres) {
    return static_cast<std::int32_t>(std::round(metres * found.push_scale));
  };
  CHECK(found.pushes[1] == units(std::min<double>(1.5, found.max_push)));
  CHECK(found.pushes[0] == 0);
  for (std::size_t i = 1; i < 64; ++i) {
    CAPTURE(i);
    const double distance = std::ldexp(1.0, static_cast<int>(4 * i) - 128) - 1;
    CHECK(found.pushes[4 * i + 3] == (distance < 0.5 ? 1 : 0));
    if (distance < 0.5 && i > 2)  // 2^-120 m and less may be flushed to zero, and then go up
      CHECK(std::abs(found.pushes[4 * i] - units(std::min<double>(0.5 - distance, found.max_push))) <=
            units(1e-6));
  }
}

TEST_CASE("a radius or a normal that is off is refused") {
  GpuFixture fixture;
  const Pose pose = scattered_nodes(8, 1, 0, 3);
  auto model = GpuModel::create(fixture.device(), model_of(pose));
  REQUIRE(model);
  auto state = State::create(fixture.device(), model->host, 1);
  REQUIRE(state);
  auto contacts = Contacts::create_pushes(fixture.device(), model->host);
  REQUIRE(contacts);
  PushSetup setup;
  setup.spheres = {{{0, 0, 0}, 1}, {{0, 0, 0}, 0}};
  const auto flat = contact::Pushes::create(fixture.device(), *model, *state, *contacts, setup);
  REQUIRE_FALSE(flat);
  CHECK(flat.error().message == "Collider sphere 1 has the radius 0 m, which is not positive.");
  setup.spheres.pop_back();
  setup.planes = {{{0, 0, 0}, {0, 2, 0}}};
  const auto tilted = contact::Pushes::create(fixture.device(), *model, *state, *contacts, setup);
  REQUIRE_FALSE(tilted);
  CHECK(tilted.error().message == "Collider plane 0 has a normal of length 2, which is not 1.");
}
