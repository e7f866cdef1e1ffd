// Worlds that are sewn: what threads keep, where seams close, from saved bytes, for every workgroup size.
#include "contact_rig.hpp"
#include "method/method.hpp"
#include "model/node_groups.hpp"
#include "scene/names.hpp"
#include "sim/sewn_state.hpp"

using namespace weft;

namespace {

constexpr double kSpeed = 0.5;  // of threads, at most [m/s]

const std::string kSprings =
    R"("stiffness": {"structural": 200, "shear": 80, "bend": 5}, "damping": 0.02, "density": 0.2)";
const std::string kFabric =
    R"("density": 0.2, "fabric": {"warp": 200, "weft": 150, "shear": 60, "poisson": 0.1,
    "bending_warp": 1e-5, "damping": 0.001})";

/// Two panels beside nothing, 40 mm and more apart and not in line, one of which is turned.
scene::Scene two_panels(const std::string& solver, const std::string& contact,
                        const std::string& material = kSprings) {
  return contact_scene(R"("gravity": [0, 0, 0], "solver": {"kind": ")" + solver +
                       (solver == "multigrid" || solver == "fem" ? R"(", "residual": 1e-4},)" : R"("},)") +
                       R"(
      "contact": {"method": ")" +
                       contact + R"(", "thickness": 0.004},
      "cloths": [{"panels": [
          {"grid": [7, 6], "size": [0.12, 0.1], "transform": {"translate": [-0.08, 0, 0]}},
          {"grid": [6, 6], "size": [0.1, 0.1], "transform":
             {"translate": [0.08, 0.02, 0.03], "rotate": [0, 0.0998334, 0, 0.9950042]}}],
        "seams": [{"first": {"panel": 0, "nodes": "right"}, "second": {"panel": 1, "nodes": "left"}}], )" +
                       material + "}]");
}

/// A method and what it sews.
struct Sewed {
  std::string solver, material;
};
std::vector<Sewed> all_sewed() {
  std::vector<Sewed> all;
  for (const Method& method : methods()) {
    all.push_back({scene::name_of(method.kind), kSprings});
    if (method.sews_fabric) all.push_back({scene::name_of(method.kind), kFabric});
  }
  return all;
}

/// Goes on by so many frames, and sews before each. The last world of the run.
template <class Each>
std::unique_ptr<sim::World> sewn_on(gpu::Device& device, std::unique_ptr<sim::World> world, int frames,
                                    const Each& each) {
  for (int frame = 0; frame < frames; ++frame) {
    auto sewn = sim::sewn_state(*world, "test");
    REQUIRE_OK(sewn);
    if (sewn->state) {
      sim::WorldOptions options;
      options.sewing = sewn->state->sewing;
      auto next = sim::World::create(device, world->scene(), world->assets(), options);
      REQUIRE_OK(next);
      REQUIRE_OK((*next)->open(*sewn->state));
      world = std::move(*next);
    }
    each(*world);
    advance(*world, 1);
  }
  return world;
}
std::unique_ptr<sim::World> sewn_on(gpu::Device& device, std::unique_ptr<sim::World> world, int frames) {
  return sewn_on(device, std::move(world), frames, [](sim::World&) {});
}

/// The triangles that pass through each other, but for neighbours: those with a common node, or with nodes that a seam
/// joins.
std::size_t crossings_of(sim::World& world) {
  const Moment now(world);
  const Model& model = world.model().host;
  const CutPattern& pattern = *model.bodies[0].pattern;
  NodeGroups groups(model.vertex_count());
  for (const CutSeam& seam : pattern.seams)
    for (const auto& [a, b] : seam.pairs) groups.join(pattern.node[a], pattern.node[b]);
  const auto beside = [&](const reference::Crossing& crossing) {
    for (const std::uint32_t a : model.triangles[crossing.a])
      for (const std::uint32_t b : model.triangles[crossing.b])
        if (groups.of(a) == groups.of(b)) return true;
    return false;
  };
  const auto found = reference::self_crossings({now.position, model.triangles});
  return found.size() - static_cast<std::size_t>(std::count_if(found.begin(), found.end(), beside));
}

}  // namespace

TEST_CASE(
    "free panels that sew themselves together keep their momentum, and gain no more than threads give") {
  GpuFixture fixture;
  for (const auto& [solver, material] : all_sewed()) {
    CAPTURE(solver);
    CAPTURE(material);
    auto world = world_of(fixture.device(), two_panels(solver, "none", material));
    const double mass = [&] {
      double sum = 0;
      for (const double one : Moment(*world).mass) sum += one;
      return sum;
    }();
    const Moment before(*world);
    double highest = 0, livest = 0;
    world = sewn_on(fixture.device(), std::move(world), 60, [&](sim::World& now) {
      const Moment at(now);
      highest = std::max(highest, energy_of(now, at) - now.sewing().work);
      livest = std::max(livest, reference::energies(system_of(now, at)).kinetic);
    });
    CHECK(world->sewing().sewn() == 6);
    CHECK(world->model().vertex_count() == before.mass.size() - 6);
    const Moment after(*world);
    const double momentum = length(after.momentum(0, after.mass.size())), spin = length(after.spin());
    // Threads keep both. What a method loses of springs that turn in long steps, it loses here too.
    const bool keeps_spin = solver == "mass_spring" || solver == "vbd" || solver == "projective_dynamics";
    CHECK(momentum < 1e-3 * mass * kSpeed);
    CHECK(spin < (keeps_spin ? 1e-3 : 0.05) * mass * kSpeed * 0.1);
    CHECK(highest < 1e-6 + 0.01 * world->sewing().work);
    CHECK(livest < mass * kSpeed * kSpeed / 2);
  }
}

TEST_CASE("while threads pull, and once seams are closed, kernels go where the steps in double go") {
  GpuFixture fixture;
  for (const auto& [solver, material] : all_sewed()) {
    CAPTURE(solver);
    CAPTURE(material);
    for (const std::int32_t pair : {5, Sewing::kSewn}) {
      CAPTURE(pair);
      scene::Scene scene = two_panels(solver, "none", material);
      if (pair == Sewing::kSewn) scene.gravity = {0, -9.81, 0};
      scene.time.frame = 1.0 / 240;
      sim::WorldOptions options;
      options.sewing.cloths = {{std::vector<std::int32_t>(6, pair)}};
      auto made = sim::World::create(fixture.device(), scene, Assets{*load_assets(scene, "models")}, options);
      REQUIRE_OK(made);
      sim::World& world = **made;
      const Model& model = world.model().host;
      reference::MassSpringSystem system = reference::elements_of(model);
      system.acceleration = scene.gravity;
      system.velocity.assign(model.vertex_count(), {});
      system.position = Moment(world).position;
      const std::vector<Vec3d> before = system.position;
      const auto stepper = reference::make_stepper(world.scene().solver, model, world.plan().step());
      stepper->forget();
      for (std::uint32_t step = 0; step < 2 * world.plan().substeps(); ++step) {
        const std::vector<Vec3d> places = system.position;
        stepper->advance({system, places, world.plan().step()});
      }
      advance(world, 2);
      const Moment after(world);
      double way = 0, off = 0;
      for (std::size_t node = 0; node < before.size(); ++node) {
        way = std::max(way, length(system.position[node] - before[node]));
        off = std::max(off, length(after.position[node] - system.position[node]));
      }
      CHECK(way > 1e-4);
      CHECK(off < 1e-3 * way);
    }
  }
}

TEST_CASE("two grabbed nodes that a seam makes one are one grabbed node, which stays where both were held") {
  GpuFixture fixture;
  auto world = world_of(fixture.device(), two_panels("mass_spring", "none"));
  const CutPattern& pattern = *world->model().host.bodies[0].pattern;
  const auto& pair = pattern.seams[0].pairs[2];
  const std::array<std::uint32_t, 2> nodes{pattern.node[pair[0]], pattern.node[pair[1]]};
  const Vec3d target{0, 0.01, 0.02};
  for (const std::uint32_t node : nodes) REQUIRE_OK(world->grab(node, target));
  world = sewn_on(fixture.device(), std::move(world), 60);
  CHECK(world->sewing().sewn() > 0);
  REQUIRE(world->grabbed().size() == 1);
  CHECK(length(Moment(*world).position[world->grabbed()[0].node] - target) < 1e-3);
}

TEST_CASE("panels about a capsule are sewn on: no seam is open, and nothing is passed through") {
  GpuFixture fixture;
  const auto scene = contact_scene(R"("gravity": [0, 0, 0], "solver": {"kind": "multigrid"},
      "contact": {"thickness": 0.004},
      "cloths": [{"panels": [
          {"grid": [11, 6], "size": [0.3, 0.15], "transform": {"translate": [0, 0, 0.1]}},
          {"grid": [11, 6], "size": [0.3, 0.15], "transform": {"translate": [0, 0, -0.1], "rotate": [0, 1, 0, 0]}}],
        "seams": [{"first": {"panel": 0, "nodes": "right"}, "second": {"panel": 1, "nodes": "left"}},
                  {"first": {"panel": 0, "nodes": "left"}, "second": {"panel": 1, "nodes": "right"}}],
        "stiffness": {"structural": 500, "shear": 200, "bend": 5}, "damping": 0.05, "density": 0.2}],
      "colliders": [{"kind": "capsule", "a": [0, -0.2, 0], "b": [0, 0.2, 0], "radius": 0.06}])");
  double deepest = 0;
  std::size_t crossed = 0;
  auto world = sewn_on(fixture.device(), world_of(fixture.device(), scene), 72, [&](sim::World& now) {
    const Moment at(now);
    deepest =
        std::max(deepest, reference::inside_capsule(at.position, {0, -0.2, 0}, {0, 0.2, 0}, 0.06).deepest);
    crossed += crossings_of(now);
  });
  CHECK(world->sewing().sewn() == 12);
  CHECK(crossed == 0);
  CHECK(reference::self_crossings({Moment(*world).position, world->model().host.triangles}).empty());
  CHECK(deepest == 0);
}

TEST_CASE("long: the dress of scenes/sewn-dress.json is sewn at all its seams, and stays on") {
  GpuFixture fixture;
  std::size_t crossed = 0, entered = 0;
  int frame = 0;
  auto world = sewn_on(
      fixture.device(), world_of(fixture.device(), shipped_scene("sewn-dress")), 170, [&](sim::World& now) {
        if (++frame % 10 != 0) return;
        const Moment at(now);
        const mesh::TriangleMesh& person = now.assets().objects[0];
        const std::vector<Vec3d> corners = reference::widened(person.positions);
        crossed += crossings_of(now);
        entered +=
            reference::crossings({at.position, now.model().host.triangles}, {corners, person.triangles})
                .size();
      });
  CHECK(world->sewing().sewn() == 30);
  CHECK(crossed == 0);
  CHECK(entered == 0);
  const Moment end(*world);
  CHECK(std::max_element(end.position.begin(), end.position.end(), [](const Vec3d& a, const Vec3d& b) {
          return a.y < b.y;
        })->y > 1.44);  // the hands have let go at 1.8 s: it hangs on the shoulders
  CHECK(end.largest_speed() < 0.5);
}

TEST_CASE("long: a world that is being sewn goes on from its bytes to the bits of one that never stopped") {
  GpuFixture fixture;
  for (const std::string solver : {"mass_spring", "multigrid"}) {
    CAPTURE(solver);
    for (const int stop : {10, 54}) {
      CAPTURE(stop);
      auto world =
          sewn_on(fixture.device(), world_of(fixture.device(), two_panels(solver, "proximity")), stop);
      CHECK(world->sewing().sewn() == (stop == 10 ? 0 : 6));
      const auto saved = world->save("test");
      REQUIRE_OK(saved);
      const auto read = sim::read_saved_state(sim::write_saved_state(*saved));
      REQUIRE_OK(read);
      CHECK(read->sewing == saved->sewing);
      auto fresh = world_of(fixture.device(), two_panels(solver, "proximity"));
      CHECK_FALSE(fresh->open(*read));
      const sim::WorldOptions options{.workgroup_size = 64, .sewing = read->sewing};
      auto other = sim::World::create(fixture.device(), fresh->scene(), fresh->assets(), options);
      REQUIRE_OK(other);
      REQUIRE_OK((*other)->open(*read));
      const std::string ended = hash_of(*sewn_on(fixture.device(), std::move(world), 7));
      CHECK(hash_of(*sewn_on(fixture.device(), std::move(*other), 7)) == ended);
    }
  }
}
