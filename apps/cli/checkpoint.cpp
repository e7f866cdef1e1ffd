#include "checkpoint.hpp"

#include <cstdio>

#include "base/file.hpp"
#include "version.hpp"

namespace weft::cli {

std::string build_name() { return version_text(); }

Result<sim::SavedState> read_checkpoint(const std::string& path, sim::World& world) {
  const auto read = [&]() -> Result<sim::SavedState> {
    WEFT_TRY(bytes, read_file(path, sim::most_saved_bytes(world.model().vertex_count(),
                                                          world.state().creases.size())));
    WEFT_TRY(state, sim::read_saved_state(bytes));
    WEFT_CHECK(world.open(state));
    return state;
  }();
  if (!read) return read.error().while_doing("resuming from " + path);
  return read;
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
