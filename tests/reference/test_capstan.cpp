// A strip over a capsule, in double.
#include "capstan.hpp"

#include "contact/reference/proximity/proximity.hpp"
#include "contact/rules/contact_law.hpp"
#include "sheets.hpp"

using namespace weft;

namespace {

/// In substeps as reference::Simulation takes them, but of a strip that starts draped.
CapstanWatch seen_in_double(const Capstan& capstan) {
  const scene::Scene scene = capstan.scene();
  Sheet strip(scene);
  reference::MassSpringSystem& now = strip.system;
  const StripOverCapsule begun = capstan.strip();
  for (Vec3d& x : now.position) x = begun.draped(x);
  const Assets assets = capstan.assets(scene);
  reference::Proximity contact(scene, strip.model, assets.objects, assets.deformations, 1.0 / 480,
                               {.balances = true});
  CapstanWatch watch(capstan, now);
  const double dt = 1.0 / 480;
  for (int step = 0; step < 8 * static_cast<int>(capstan.frames); ++step) {
    const std::vector<Vec3d> before = now.position, velocity_before = now.velocity;
    strip.stepper.advance({now, before, dt, 1, [&](std::span<const Vec3d> velocity) -> reference::Pressed {
                             return {{}, contact.presses(before, velocity, step * dt, dt)};
                           }});
    const std::vector<Vec3d> position = now.position, velocity = now.velocity;
    contact.answer(
        {before, velocity_before, now.inverse_mass, now.position, now.velocity, strip.stepper.held()},
        step * dt, dt);
    for (std::size_t node = 0; node < position.size(); ++node)
      if (now.position[node] != position[node] || now.velocity[node] != velocity[node])
        strip.stepper.forget(node);
    if (step % 8 == 7) watch.see(now.position, now.velocity);
  }
  return watch;
}

}  // namespace

TEST_CASE(
    "a strip over a capsule rests where friction holds it and slides where not, in double, and gains no "
    "energy") {
  check_capstan(seen_in_double);
}

TEST_CASE("a strip slides over a capsule as a rope does, on any cells, rail and friction, in double") {
  check_sliding(seen_in_double);
}
