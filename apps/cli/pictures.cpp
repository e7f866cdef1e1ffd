#include "pictures.hpp"

#include <cstdio>

#include "view/world_inputs.hpp"

namespace weft::cli {
namespace {

std::string frame_name(std::uint32_t frame) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%05u.png", frame);
  return name;
}

}  // namespace

Result<std::unique_ptr<Pictures>> Pictures::create(sim::World& world) {
  auto made = std::make_unique<Pictures>();
  made->render_ = world.scene().render;
  made->frame_s_ = world.scene().time.frame;
  WEFT_CHECK(made->start_drawing(world));
  return made;
}

Result<void> Pictures::start_drawing(sim::World& world) {
  device_ = &world.device();
  WEFT_TRY(offscreen,
           picture::Offscreen::create(world.device(), view::settings_of(world), view::inputs_of(world)));
  offscreen_ = std::move(offscreen);
  return world.count_contacts(render_.view == scene::View::Contacts);
}

Result<void> Pictures::begin(const std::string& folder, std::uint32_t frame) {
  folder_ = folder;
  first_ = next_ = stored_ = frame;
  WEFT_SET(video_,
           picture::VideoWriter::create(folder + "/run.mp4", render_.width, render_.height, 1 / frame_s_));
  return {};
}

Result<void> Pictures::go_on(sim::World& world) {
  next_ = world.frame();
  return start_drawing(world);
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
  WEFT_TRY(arrived, offscreen_->try_take());
  if (arrived) WEFT_CHECK(store(std::move(*arrived)));
  return {};
}

Result<void> Pictures::store(picture::Image image) {
  const std::uint32_t frame = next_++;
  if (frame < stored_) return {};
  stored_ = frame + 1;
  if (video_) WEFT_CHECK(video_->add(image));
  return png_.push(folder_ + "/" + frame_name(frame), std::move(image));
}

Result<void> Pictures::settle() {
  while (offscreen_->pending() > 0) {
    WEFT_TRY(image, offscreen_->read());
    WEFT_CHECK(store(std::move(image)));
  }
  return png_.finish();
}

Result<void> Pictures::finish() {
  WEFT_CHECK(settle());
  return has_video() ? video_->finish() : Result<void>();
}

}  // namespace weft::cli
