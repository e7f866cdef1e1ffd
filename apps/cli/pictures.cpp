#include "pictures.hpp"

#include <cstdio>

#include "render/scene_inputs.hpp"

namespace weft::cli {
namespace {

std::string frame_name(std::uint32_t frame) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%05u.png", frame);
  return name;
}

}  // namespace

Result<std::unique_ptr<Pictures>> Pictures::create(sim::World& world, const std::string& folder) {
  auto made = std::make_unique<Pictures>();
  made->device_ = &world.device();
  const scene::Render& wanted = world.scene().render;
  const std::vector<mesh::TriangleMesh>& objects = world.assets().objects;
  render::Settings settings;
  settings.width = wanted.width;
  settings.height = wanted.height;
  settings.view = wanted.view;
  settings.camera = world.scene().camera;
  settings.subdivide = wanted.subdivide;
  settings.bounds = render::scene_bounds(world.model().host, world.scene(), objects);
  const render::Inputs inputs =
      render::inputs_of(world.model(), world.state(),
                        {world.surface().normal(), world.surface().stretch(), world.contact_counts()},
                        world.scene(), objects, world.assets().keyframes);
  WEFT_TRY(offscreen, picture::Offscreen::create(world.device(), settings, inputs));
  made->offscreen_ = std::move(offscreen);
  WEFT_TRY(taken, OutFolder::take(folder));  // only now: what is refused leaves no folder behind
  made->folder_.emplace(std::move(taken));
  WEFT_CHECK(world.count_contacts(wanted.view == scene::View::Contacts));
  WEFT_TRY(video, picture::VideoWriter::create(folder + "/run.mp4", wanted.width, wanted.height,
                                               1 / world.scene().time.frame));
  made->video_ = std::move(video);
  return made;
}

Result<void> Pictures::draw(const sim::World& world) {
  while (offscreen_->full()) {
    WEFT_TRY(image, offscreen_->read());
    WEFT_CHECK(store(std::move(image)));
  }
  list_.reset();
  offscreen_->record(list_, world.parity());
  offscreen_->set_time(world.time());
  WEFT_CHECK(device_->submit(list_));
  offscreen_->start();
  ++drawn_;
  WEFT_TRY(arrived, offscreen_->try_take());
  if (arrived) WEFT_CHECK(store(std::move(*arrived)));
  return {};
}

Result<void> Pictures::store(picture::Image image) {
  if (video_) WEFT_CHECK(video_->add(image));
  return png_.push(folder_->path() + "/" + frame_name(stored_++), std::move(image));
}

Result<void> Pictures::finish() {
  while (offscreen_->pending() > 0) {
    WEFT_TRY(image, offscreen_->read());
    WEFT_CHECK(store(std::move(image)));
  }
  WEFT_CHECK(png_.finish());
  return has_video() ? video_->finish() : Result<void>();
}

}  // namespace weft::cli
