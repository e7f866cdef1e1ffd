#include "checkpoint.hpp"

#include <cstdio>

#include "base/file.hpp"
#include "version.hpp"

namespace weft::cli {

std::string build_name() { return version_text(); }

Result<sim::SavedState> read_checkpoint(const std::string& path, const sim::World& world) {
  std::uint64_t tearing = 0;
  for (const Body& body : world.model().host.bodies)
    if (body.strength) tearing += body.triangle_count;
  WEFT_TRY(bytes, read_file(path, sim::most_saved_bytes(world.model().vertex_count(),
                                                        world.state().creases.size(), tearing)));
  return sim::read_saved_state(bytes);
}

std::string other_origin(const sim::SavedState& state, const sim::World& world) {
  const std::string other = sim::other_origin(state, build_name(), world.device().adapter().name);
  if (other.empty()) return other;
  return "The checkpoint was written " + other + ": bits may differ from those of a run that goes on there.";
}

std::string checkpoint_name(std::uint32_t frames) {
  char name[32];
  std::snprintf(name, sizeof name, "checkpoint_%05u.weft", frames);
  return name;
}

}  // namespace weft::cli
