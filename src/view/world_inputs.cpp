#include "view/world_inputs.hpp"

#include "contact/proximity/rigid_bodies.hpp"
#include "render/scene_inputs.hpp"

namespace weft::view {

render::Settings settings_of(const sim::World& world) {
  const scene::Render& wanted = world.scene().render;
  render::Settings settings;
  settings.width = wanted.width;
  settings.height = wanted.height;
  settings.view = wanted.view;
  settings.camera = world.scene().camera;
  settings.subdivide = wanted.subdivide;
  settings.to_light = wanted.light.direction;
  settings.lighting = {wanted.light.environment, wanted.light.degrees};
  settings.bounds = render::scene_bounds(world.model().host, world.scene(), world.assets().objects);
  return settings;
}

/// Where the words of its rigid bodies have the rows by which they are drawn.
static render::RigidRows rigid_rows(const sim::World& world) {
  if (world.rigid() == nullptr) return {};
  return {&world.rigid()->words(), sizeof(std::uint32_t) * contact::kRigidRows,
          sizeof(std::uint32_t) * contact::kRigidWords};
}

render::Inputs inputs_of(const sim::World& world) {
  return render::inputs_of(
      world.model(), world.state(),
      {world.surface().normal(), world.surface().stretch(), world.contact_counts(), rigid_rows(world)},
      world.scene(), world.assets().objects, world.assets().deformations);
}

}  // namespace weft::view
