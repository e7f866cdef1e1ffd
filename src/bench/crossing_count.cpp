#include "bench/crossing_count.hpp"

#include "bench/measure.hpp"

namespace weft::bench {

Result<CrossingCount> CrossingCount::create(gpu::Device& device, scene::Scene scene, const Assets& assets) {
  scene.contact.method = scene::ContactMethod::Proximity;
  scene.contact.self = true;
  WEFT_CHECK(fix_step(scene, assets, 1));
  CrossingCount made;
  WEFT_TRY(world, sim::World::create(device, std::move(scene), assets));
  made.world_ = std::move(world);
  return made;
}

Result<std::uint32_t> CrossingCount::of(const sim::Snapshot& state) {
  WEFT_CHECK(world_->restore(state));
  WEFT_CHECK(world_->advance_frame());  // its only step begins with a search, in the state as it is
  WEFT_CHECK(world_->finish());
  return world_->totals().crossings_left;
}

}  // namespace weft::bench
