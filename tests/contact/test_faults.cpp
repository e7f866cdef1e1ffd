// Inputs that must not break contact: empty and tiny objects, values that are not finite, sums at their bound, a short
// stack.
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/file.hpp"
#include "contact/push_fixture.hpp"
#include "mesh/primitives.hpp"
#include "source_path.hpp"
#include "temporary_folder.hpp"

using namespace weft;
using contact::PushSetup;
using scene::ContactMethod;

namespace {

constexpr ContactMethod kMethods[] = {ContactMethod::Paper, ContactMethod::Bvh};

PushSetup sphere_setup(ContactMethod method) {
  PushSetup setup;
  setup.method = method;
  setup.objects = {mesh::make_sphere(20, 20)};
  return setup;
}

Pose sphere_pose() { return sheet_over(mesh::bounds(mesh::make_sphere(20, 20)), 21, 0.7, 0.02, 9); }

}  // namespace

TEST_CASE("an empty list of colliders records nothing") {
  GpuFixture fixture;
  for (const ContactMethod method : kMethods) {
    PushSetup empty;
    empty.method = method;
    const Found found = find_contacts(fixture.device(), sphere_pose(), empty);
    CHECK(found.dispatches == 0);
    CHECK(found.push_scale == 1);
  }
}

TEST_CASE("objects of a few triangles are found alike by both methods") {
  GpuFixture fixture;
  for (const std::uint32_t count : {1U, 2U, 3U, 4U, 5U, 17U}) {
    PushSetup setup = sphere_setup(ContactMethod::Paper);
    std::vector<mesh::Triangle>& triangles = setup.objects[0].triangles;
    triangles.erase(triangles.begin() + 200 + count, triangles.end());
    triangles.erase(triangles.begin(), triangles.begin() + 200);
    mesh::TriangleMesh used;  // a box around them alone
    for (const mesh::Triangle& t : triangles)
      for (const std::uint32_t vertex : t) used.positions.push_back(setup.objects[0].positions[vertex]);
    const Pose pose = sheet_over(mesh::bounds(used), 30, 0.5, 0.2, count);
    const Found paper = find_contacts(fixture.device(), pose, setup);
    setup.method = ContactMethod::Bvh;
    CHECK(find_contacts(fixture.device(), pose, setup).same_as(paper));
    CHECK(paper.statistics.contacts > 0);
  }
}

TEST_CASE("nodes that are not finite end in no contact, and the others keep theirs") {
  GpuFixture fixture;
  const Pose clean = sphere_pose();
  constexpr float kInf = std::numeric_limits<float>::infinity(),
                  kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kLargest = std::numeric_limits<float>::max(),
                  kLeast = std::numeric_limits<float>::denorm_min();
  for (const ContactMethod method : kMethods) {
    PushRun run(fixture.device(), clean, sphere_setup(method));
    const Found expected = run.run();
    REQUIRE(expected.statistics.contacts > 50);
    for (const float bad : {kInf, -kInf, kNan, -kNan}) {
      Pose pose = clean;
      pose.predicted[0].x = bad;  // a corner of the sheet, which touches nothing
      pose.predicted[20].y = bad;
      pose.predicted[440].z = bad;
      run.place(pose);
      CHECK(run.run().same_as(expected));
      for (Vec4f& p : pose.predicted) p = {bad, bad, bad, 1};
      run.place(pose);
      CHECK(run.run().statistics.contacts == 0);
      pose = clean;
      for (Vec4f& p : pose.previous) p = {bad, bad, bad, 1};
      run.place(pose);
      const Found blind = run.run();
      CHECK(blind.statistics.contacts == expected.statistics.contacts);
      for (std::size_t i = 0; i < blind.pushes.size(); ++i)
        if (i % 4 != 3) REQUIRE(blind.pushes[i] == 0);  // no direction, no push
    }
    for (const float extreme : {kLargest, kLeast, 0.0F}) {  // must end, whatever they find
      Pose pose = clean;
      for (std::size_t i = 0; i < pose.predicted.size(); i += 3)
        pose.predicted[i] = {extreme, -extreme, extreme, 1};
      run.place(pose);
      CHECK(run.run().statistics.contact_overflow == 0);
    }
  }
}

TEST_CASE("all nodes at one point have no contacts, even on the surface, and end") {
  GpuFixture fixture;
  for (const ContactMethod method : kMethods) {
    PushRun run(fixture.device(), sphere_pose(), sphere_setup(method));
    for (const Vec3f& point : {Vec3f{0, 0, 0}, mesh::make_sphere(20, 20).positions[100]}) {
      Pose pose = sphere_pose();
      for (Vec4f& p : pose.predicted) p = Vec4f::from(point, 1);
      run.place(pose);
      const Found found = run.run();
      CHECK(found.statistics.contacts == 0);
      CHECK(found.statistics.contact_overflow == 0);
    }
  }
}

TEST_CASE("a kinematic node is never pushed, and its triangle still counts") {
  GpuFixture fixture;
  for (const ContactMethod method : kMethods) {
    Pose pose = sphere_pose();
    const Found free = find_contacts(fixture.device(), pose, sphere_setup(method));
    for (std::size_t i = 0; i < pose.previous.size(); i += 2) pose.previous[i].w = pose.predicted[i].w = 0;
    const Found found = find_contacts(fixture.device(), pose, sphere_setup(method));
    CHECK(found.statistics.contacts == free.statistics.contacts);
    std::size_t pushed = 0;
    for (std::size_t i = 0; i < found.pushes.size(); ++i) {
      CHECK(found.pushes[i] == ((i / 4) % 2 == 0 ? 0 : free.pushes[i]));
      pushed += i % 4 == 3 && found.pushes[i] > 0 ? 1 : 0;
    }
    CHECK(pushed > 10);
  }
}

TEST_CASE("the sum of pushes that are all equal and as long as can be stays below 2^31") {
  GpuFixture fixture;
  //  A fan of eight triangles around node 0, each through every one of 4000 object triangles that face +x,
  //  and whose previous position lies so deep that each push is cut to the limit.
  Pose pose;
  pose.previous.push_back({-1000, 0, 0, 1});
  pose.predicted.push_back({2, 0, 0, 1});
  for (int i = 0; i < 8; ++i) {
    const auto angle = static_cast<float>(i) * 0.7853982F;
    pose.predicted.push_back({-2, 0.5F * std::cos(angle), 0.5F * std::sin(angle), 1});
    pose.previous.push_back({-1000, 0, 0.001F * static_cast<float>(i + 1), 1});
  }
  for (std::uint32_t i = 0; i < 8; ++i) pose.triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
  constexpr std::uint32_t kObjects = 4000;
  PushSetup setup;
  setup.objects.resize(1);
  for (std::uint32_t i = 0; i < kObjects; ++i) {
    const float x = static_cast<float>(i) / kObjects - 0.5F;
    const Vec3f corners[] = {{x, -9, -9}, {x, 9, -9}, {x, 0, 18}};  // counter-clockwise seen from +x
    for (const Vec3f& p : corners) setup.objects[0].positions.push_back(p);
    setup.objects[0].triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  for (const ContactMethod method : kMethods) {
    setup.method = method;
    const Found found = find_contacts(fixture.device(), pose, setup);
    CHECK(found.pushes[3] == 8 * kObjects);
    const double expected =
        8.0 * kObjects * std::round(static_cast<double>(found.push_scale) * found.max_push);
    CHECK(found.pushes[0] == expected);
    CHECK(expected > 1073741824.0 * 0.99);  // the bound is used: twice the scale would overflow
    CHECK(found.statistics.contacts == 8 * kObjects);
  }
}

TEST_CASE("a stack that is too short is counted, never silent") {
  TemporaryFolder folder;
  std::filesystem::copy(source_path("src"), folder.path("src"), std::filesystem::copy_options::recursive);
  const std::string path = folder.path("src/contact/pushes/bvh.wgsl");
  auto bytes = read_file(path, 1U << 20U);
  REQUIRE(bytes);
  std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  const std::string declared = "const kStackSize = " + std::to_string(contact::kStackSize) + "u;";
  REQUIRE(text.find(declared) != std::string::npos);
  text.replace(text.find(declared), declared.size(), "const kStackSize = 1u;");
  REQUIRE(write_file(path, text));
  GpuFixture fixture;
  const Found whole = find_contacts(fixture.device(), sphere_pose(), sphere_setup(ContactMethod::Bvh));
  const char* set_before = getenv("WEFT_SHADERS");
  const std::string before = set_before == nullptr ? "" : set_before;
  setenv("WEFT_SHADERS", folder.path("src").c_str(), 1);
  const Found cut = find_contacts(fixture.device(), sphere_pose(), sphere_setup(ContactMethod::Bvh));
  before.empty() ? unsetenv("WEFT_SHADERS") : setenv("WEFT_SHADERS", before.c_str(), 1);
  CHECK(whole.statistics.contact_overflow == 0);
  CHECK(cut.statistics.contact_overflow > 0);
  CHECK(cut.statistics.contacts < whole.statistics.contacts);
}
