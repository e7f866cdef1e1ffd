// The search for pairs of features: its broad phase against boxes in f32, which it must equal exactly; its
// narrow phase against double; its lists against themselves.
#include "collision/search_checks.hpp"
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
    const std::size_t self = check_self_candidates(names, run), ball = check_object_candidates(names, run, 0),
                      box = check_object_candidates(names, run, 1);
    const ListCheck listed = check_contacts(found, run, 1e-5 * setup.self_radius());
    check_entries(found);
    std::printf("pose %d: candidates %zu + %zu + %zu, pairs %zu, doubtful %zu, flat %zu\n",
                static_cast<int>(shape), self, ball, box, listed.pairs, listed.doubtful, listed.flat);
    CHECK(ball > 50);
    CHECK(box > 50);
    if (shape != Shape::Flat) CHECK(listed.pairs > 500);
    if (shape != Shape::Crumpled) CHECK(listed.flat == 0);
  }
}
