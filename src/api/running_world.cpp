#include "api/running_world.hpp"

#include "view/world_inputs.hpp"

namespace weft {
namespace {

constexpr const char* kBuild = WEFT_VERSION ", the library";

}  // namespace

Result<std::unique_ptr<RunningWorld>> RunningWorld::create(gpu::DeviceOptions device, const SceneText& source,
                                                           const ReadInputs& read) {
  auto running = std::make_unique<RunningWorld>();
  WEFT_CHECK(running->session.open(std::move(device)));
  WEFT_CHECK(running->session.load(source, read));
  return running;
}

void RunningWorld::let_go() {
  drawing.reset();
  texture_view.reset();
}

Result<void> RunningWorld::advance() {
  if (session.changes_mesh()) {
    WEFT_TRY(change, session.change_mesh(kBuild));
    if (change.changed) let_go();
  }
  return world().advance_frame();
}

Result<void> RunningWorld::reset() {
  if (session.changes_mesh()) let_go();
  return session.reset();
}

Result<std::string> RunningWorld::open_state(std::span<const std::byte> bytes) {
  if (session.changes_mesh()) let_go();
  return session.open_state(bytes, kBuild);
}

Result<std::vector<std::byte>> RunningWorld::save_state() { return session.save_state(kBuild); }

Result<void> RunningWorld::settle() {
  const Result<void> finished = world().finish();
  if (!finished && finished.error().kind != ErrorKind::Diverged) return finished;
  return {};
}

Result<render::Settings> RunningWorld::settings(const PictureOptions& options) {
  render::Settings settings = view::settings_of(world());
  settings.width = options.width.value_or(settings.width);
  settings.height = options.height.value_or(settings.height);
  settings.view = options.view.value_or(settings.view);
  if (settings.width == 0 || settings.height == 0)
    return input_error("A picture of %u x %u pixels is empty.", settings.width, settings.height);
  return settings;
}

Result<void> RunningWorld::count_contacts() {
  return world().count_contacts((drawing && drawing->view == View::Contacts) ||
                                (texture_view && texture_view->view() == View::Contacts));
}

const gpu::RawBuffer& RunningWorld::buffer(Buffer::Quantity quantity) {
  sim::World& of = world();
  switch (quantity) {
    case Buffer::Quantity::Position:
      return of.state().position[of.parity()];
    case Buffer::Quantity::Velocity:
      return of.state().velocity[of.parity()];
    case Buffer::Quantity::Normal:
      return of.surface().normal();
    case Buffer::Quantity::Stretch:
      break;
  }
  return of.surface().stretch();
}

}  // namespace weft
