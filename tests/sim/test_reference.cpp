// Whole frames of the GPU's world against the same scene in double.
//
// Tolerance. Every substep rounds a position once, by at most half a step of f32: 6e-8 m below 2 m. The
// forces feel that rounding too, and give back at most omega² h² < 2 times as much (h is 0.7 of the limit 2 /
// omega). While nothing is amplified, n substeps are thus within 3 n * 6e-8 m; roundings differ in sign, so a
// tenth of it is seen.
#include <algorithm>
#include <cmath>

#include "contact_rig.hpp"
#include "reference/simulation.hpp"

using namespace weft;

namespace {

constexpr double kRounding = 3 * 6e-8;  // of a substep [m]

/// The same scene twice.
class Twins {
 public:
  Twins(gpu::Device& device, const std::string& name, const std::string& grid,
        const std::string& contact = "\"bvh\"")
      : Twins(device, shipped_scene(name, {{"cloths.0.grid", grid}, {"contact.method", contact}})) {}
  Twins(gpu::Device& device, const scene::Scene& scene) : scene_(scene), world_(world_of(device, scene_)) {
    auto made = reference::Simulation::create(scene_, world_->assets());
    REQUIRE_OK(made);
    exact_.emplace(std::move(*made));
    CHECK(exact_->substeps() == world_->substeps());
    CHECK(exact_->element_count(ElementKind::Spring) == world_->element_count(ElementKind::Spring));
    // Both find the limit by the same code; 0: there is none.
    const double limit = world_->plan().limit().largest_step;
    CHECK(std::abs(exact_->plan().limit().largest_step - limit) <= 1e-4 * limit);
  }

  /// The largest distance of a node from its twin after this many more frames [m].
  double advance(std::uint32_t frames) {
    weft::advance(*world_, frames);
    for (std::uint32_t frame = 0; frame < frames; ++frame) REQUIRE(exact_->advance_frame());
    const auto snapshot = world_->snapshot();
    REQUIRE_OK(snapshot);
    REQUIRE(snapshot->position.size() == exact_->positions().size());
    double largest = 0;
    for (std::size_t node = 0; node < exact_->positions().size(); ++node)
      largest =
          std::max(largest, length(snapshot->position[node].xyz().to<double>() - exact_->positions()[node]));
    MESSAGE(scene_.title, ": ", exact_->frame(), " frames of ", exact_->substeps(),
            " substeps, largest difference ", largest, " m, contacts ", world_->totals().contacts, " and ",
            exact_->contacts());
    return largest;
  }

  double rounding() const { return kRounding * exact_->frame() * exact_->substeps(); }  // of all substeps [m]
  std::uint64_t contacts() const { return world_->totals().contacts; }
  std::uint64_t exact_contacts() const { return exact_->contacts(); }

 private:
  scene::Scene scene_;
  std::unique_ptr<sim::World> world_;
  std::optional<reference::Simulation> exact_;
};

}  // namespace

TEST_CASE("a frame of a hanging sheet is the reference's within the rounding of its substeps") {
  GpuFixture fixture;
  Twins twins(fixture.device(), "hanging", "[24,24]");
  const double away = twins.advance(1);  // 0.3 µm was seen
  CHECK(away < twins.rounding());
}

TEST_CASE("ten frames of the breeze are the reference's within the rounding of their substeps") {
  GpuFixture fixture;
  Twins twins(fixture.device(), "breeze", "[24,16]");
  const double away = twins.advance(10);  // 0.3 µm was seen
  CHECK(away < twins.rounding());
}

TEST_CASE("a corner that the scene draws up is the reference's within the rounding of its substeps") {
  GpuFixture fixture;
  Twins twins(fixture.device(), "drag", "[16,16]");
  // It is taken after 30 frames. A grabbed node rounds as others do, and its distance from the target shrinks in
  // every substep, an error with it.
  const double away = twins.advance(45);  // 3.5 µm was seen
  CHECK(away < twins.rounding());
}

TEST_CASE("the pull over the sphere has the reference's contacts, and its shape while contacts are few") {
  GpuFixture fixture;
  Twins twins(fixture.device(), "pull-sphere", "[20,20]");
  // A push adds its own rounding, below 1 µm; 0.45 µm was seen in all.
  const double early = twins.advance(10);
  CHECK(early < twins.rounding());
  CHECK(twins.contacts() == twins.exact_contacts());
  CHECK(twins.contacts() > 300);
  // From about the twelfth frame on, with several contacts a substep that each turn a node back, any
  // difference grows by a factor of two to five a frame: 1 µm, 6 µm, 32 µm, 0.5 mm after 13, 15, 17, 19
  // frames, and 0.7 mm at the end, where the contacts are still the same 1616. A twentieth of the 105 mm
  // between nodes is allowed.
  const double late = twins.advance(10);
  CHECK(late < 0.005);
  CHECK(static_cast<double>(twins.contacts()) ==
        doctest::Approx(static_cast<double>(twins.exact_contacts())).epsilon(0.01).scale(0));
}

TEST_CASE("sheets that meet each other, a ball and a floor do as the reference does while they touch") {
  GpuFixture fixture;
  for (const bool heavy : {false, true}) {  // the upper one
    CAPTURE(heavy);
    Twins twins(
        fixture.device(),
        contact_scene(
            R"("time": {"substeps": 9}, "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
            lying_cloth(9, "[0, 0.22, 0]", ", \"friction\": 0.3") + "," +
            R"({"grid": [8, 8], "size": [0.4, 0.4], "plane": "xz", "density": )" + (heavy ? "30" : "0.3") +
            R"(, "damping": 0.01,
        "stiffness": {"structural": 40, "shear": 10, "bend": 0.3},
        "transform": {"translate": [0.03, 0.28, 0.02], "rotate": [0.05, 0.25, 0.08, 0.9637]}})" +
            R"(], "colliders": [{"kind": "sphere", "center": [0.01, 0.1, 0.02], "radius": 0.1},
                          {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])"));
    const double away = twins.advance(7);
    CHECK(twins.exact_contacts() > 100);
    CHECK(twins.contacts() == twins.exact_contacts());
    CHECK(away < 0.7 * twins.rounding());
    if (heavy) continue;  // each rounding counts a hundred times
    // Pairs share a vertex by whole numbers, so a rounding can shift an impulse by a part: a twentieth of the
    // thickness.
    CHECK(twins.advance(2) < 0.0005);
  }
}

TEST_CASE("sheets that begin exactly in each other part as the reference's do") {
  GpuFixture fixture;
  for (const char* turned : {"[0, 0, 0, 1]", "[1, 0, 0, 0]"}) {
    CAPTURE(turned);
    Twins twins(
        fixture.device(),
        contact_scene(
            R"("gravity": [0, 0, 0], "time": {"substeps": 8}, "contact": {"method": "proximity", "thickness": 0.01},
        "cloths": [)" +
            lying_cloth(6, "[0.25, 0.25, 0.25]") + R"(, {"grid": [7, 7], "size": [0.4, 0.4], "plane": "xz",
        "density": 0.3, "damping": 0.01, "stiffness": {"structural": 40, "shear": 10, "bend": 0.3},
        "transform": {"translate": [0.263, 0.25, 0.271], "rotate": )" +
            turned + "}}]"));
    CHECK(twins.advance(1) < 0.0005);  // as above; they part by 8 mm
    CHECK(twins.exact_contacts() > 100);
    CHECK(twins.contacts() == twins.exact_contacts());
  }
}

TEST_CASE("a sheet that begins exactly in a hull's face comes out as the reference's does") {
  GpuFixture fixture;
  Twins twins(fixture.device(), contact_scene(R"("gravity": [0, 0, 0], "time": {"substeps": 8},
      "contact": {"method": "proximity", "thickness": 0.01}, "cloths": [)" +
                                              lying_cloth(9, "[0.013, 0, 0.021]") + R"(], "colliders": [
      {"kind": "convex", "points": [[-0.13, -0.2, -0.13], [0.13, -0.2, -0.13], [0.13, -0.2, 0.13], [-0.13, -0.2, 0.13],
                                    [-0.13, 0, -0.13], [0.13, 0, -0.13], [0.13, 0, 0.13], [-0.13, 0, 0.13]]}])"));
  CHECK(twins.advance(1) < 0.0005);  // as above
  CHECK(twins.exact_contacts() > 100);
  CHECK(twins.contacts() == twins.exact_contacts());
}

TEST_CASE("what strikes obstacles goes back from them as the reference's does, by methods with sweeps") {
  GpuFixture fixture;
  for (const std::string solver : {"vbd", "xpbd", "pbd", "projective_dynamics"}) {
    CAPTURE(solver);
    Twins twins(
        fixture.device(),
        contact_scene(R"("title": ")" + solver + R"(", "time": {"substeps": 8}, "solver": {"kind": ")" +
                      solver +
                      R"(", "iterations": 4}, "contact": {"method": "proximity", "thickness": 0.01,
        "restitution": 0.7}, "cloths": [)" +
                      lying_cloth(9, "[0, 0.22, 0]", ", \"friction\": 0.3") +
                      R"(], "colliders": [{"kind": "sphere", "center": [0.01, 0.1, 0.02], "radius": 0.1,
        "motion": {"kind": "line", "direction": [0.6, 0.8, 0], "speed": 1}},
                          {"kind": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}])"));
    const double away =
        twins.advance(3);  // later a rounding decides which node is struck a substep before others
    CHECK(twins.exact_contacts() > 10);
    CHECK(away < 1e-5);  // a thousandth of the thickness, of a way of millimetres
  }
}
