#include "api/running_world.hpp"

#include "view/world_inputs.hpp"

namespace weft {

Result<std::unique_ptr<RunningWorld>> RunningWorld::create(gpu::DeviceOptions device, const SceneText& source,
                                                           const ReadInputs& read) {
  auto running = std::make_unique<RunningWorld>();
  WEFT_CHECK(running->session.open(std::move(device)));
  WEFT_CHECK(running->session.load(source, read));
  return running;
}

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
