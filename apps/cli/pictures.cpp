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
  made->device_ = &world.device();
  made->render_ = world.scene().render;
  made->frame_s_ = world.scene().time.frame;
  WEFT_TRY(offscreen,
           picture::Offscreen::create(world.device(), view::settings_of(world), view::inputs_of(world)));
  made->offscreen_ = std::move(offscreen);
  WEFT_CHECK(world.count_contacts(made->render_.view == scene::View::Contacts));
  return made;
}

Result<void> Pictures::begin(const std::string& folder) {
  folder_ = folder;
  WEFT_SET(video_,
           picture::VideoWriter::create(folder + "/run.mp4", render_.width, render_.height, 1 / frame_s_));
  return {};
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
  return png_.push(folder_ + "/" + frame_name(stored_++), std::move(image));
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
