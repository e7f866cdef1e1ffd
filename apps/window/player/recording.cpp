#include "player/recording.hpp"

#include "base/file.hpp"
#include "base/words.hpp"

namespace weft::window {

Result<Recording> Recording::begin(sim::World& world, scene::View view, const std::string& folder) {
  WEFT_CHECK(make_folder(folder));
  WEFT_CHECK(world.finish());
  scene::Scene shown = world.scene();
  shown.render.view = view;
  WEFT_CHECK(world.change(shown));
  Recording made;
  WEFT_SET(made.pictures_, cli::Pictures::create(world));
  WEFT_CHECK(made.pictures_->begin(folder, world.frame()));
  made.folder_ = folder;
  WEFT_CHECK(world.count_contacts(view == scene::View::Contacts));
  return made;
}

Result<void> Recording::add(sim::World& world, const render::Camera& camera) {
  WEFT_CHECK(world.finish());
  pictures_->set_camera(camera);
  return pictures_->draw(world);
}

Result<std::string> Recording::end() {
  WEFT_CHECK(pictures_->finish());
  const std::uint32_t count = pictures_->count();
  return counted(count, "picture", "pictures") + (pictures_->has_video() ? " and run.mp4" : "") +
         (count == 1 && !pictures_->has_video() ? " is" : " are") + " in " + folder_ + ".";
}

}  // namespace weft::window
