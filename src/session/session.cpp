#include "session/session.hpp"

#include <algorithm>

#include "model/mesh_file.hpp"
#include "scene/load.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kTimedFrames = 9;  // the median of so many

}  // namespace

Result<void> Session::open(gpu::DeviceOptions options) {
  close();
  options.timestamps = true;
  WEFT_TRY(device, gpu::Device::create(options));
  device_ = std::move(device);
  return {};
}

void Session::close() {
  view_.reset();
  world_.reset();
  canvas_ = {};
  device_.reset();
}

Result<void> Session::load(SceneText source, const ReadInputs& read) {
  if (!device_) return make_error(ErrorKind::DeviceLost, "There is no GPU device; open one first.");
  auto built = build(std::move(source), read);
  if (built) return built;
  view_.reset();
  world_.reset();
  // What was made before the failure may be faulty too; the next load shall not answer for it.
  if (auto rest = device_->wait(); !rest && rest.error().kind == ErrorKind::DeviceLost) return rest;
  return built;
}

Result<void> Session::build(SceneText source, const ReadInputs& read) {
  view_.reset();
  world_.reset();
  snapshot_ = {};
  exported_ = {};
  source_ = std::move(source);
  WEFT_TRY(inputs, read(source_));
  WEFT_CHECK(device_->status());
  WEFT_TRY(world, sim::World::create(*device_, std::move(inputs.scene), inputs.assets));
  world_ = std::move(world);
  WEFT_CHECK(show_world());
  return device_->wait();  // now it is known whether all of it could be made
}

Result<void> Session::show_world() {
  if (made_) made_(*world_);
  if (canvas_.target == 0) return {};
  if (shown_ == scene::View::Contacts && world_->contact_counts() == nullptr) shown_ = scene::View::Textured;
  WEFT_TRY(view, view::CanvasView::create(*world_, canvas_, shown_));
  view_.emplace(std::move(view));
  return world_->count_contacts(shown_ == scene::View::Contacts);
}

Result<void> Session::follow(const Result<bool>& anew) {
  if (anew && !*anew) return {};
  if (!anew && world_) return anew.error();
  std::optional<render::Camera> camera;
  if (view_) camera = view_->camera();
  view_.reset();
  if (!anew) return anew.error();
  WEFT_CHECK(show_world());
  if (view_ && camera) view_->set_camera(*camera);
  return device_->wait();
}

Result<sim::MeshChange> Session::change_mesh(const std::string& build) {
  Result<sim::MeshChange> made = sim::change_mesh(world_, build);
  WEFT_CHECK(follow(made ? Result<bool>(made->changed) : Result<bool>(made.error())));
  return made;
}

Result<void> Session::reset() { return follow(sim::reset_whole(world_)); }

Result<void> Session::set(const std::string& key, const std::string& value) {
  std::vector<scene::Override>& changes = source_.changes;
  std::vector<scene::Override> before = changes;
  changes.push_back({key, value});
  const auto changed = [&]() -> Result<void> {
    WEFT_TRY(scene, scene::parse_scene(source_.text, source_.file, changes));
    return world_->change(scene);
  }();
  if (changed && view_) view_->set_appearance(*world_);
  if (!changed) {
    changes = std::move(before);  // the world stays as it is
    return changed;
  }
  const auto last = changes.end() - 1;  // a slider sets one key a thousand times
  changes.erase(std::remove_if(changes.begin(), last, [&](const auto& change) { return change.key == key; }),
                last);
  return {};
}

Result<void> Session::resize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return input_error("A picture of %u x %u pixels is empty.", width, height);
  if (view_) WEFT_CHECK(view_->resize(width, height));
  canvas_.width = width;
  canvas_.height = height;
  return view_ ? device_->wait() : Result<void>();
}

Result<void> Session::set_view(scene::View view) {
  if (view_) WEFT_CHECK(view_->set_view(view));
  if (world_) WEFT_CHECK(world_->count_contacts(view == scene::View::Contacts));
  shown_ = view;
  return view_ ? device_->wait() : Result<void>();
}

Result<void> Session::advance(bool draw) {
  // Natively advance_frame would wait here; in a browser nothing arrives while it does.
  if (!world_->has_room()) return make_error(ErrorKind::Failure, "Three frames are under way already.");
  if (!draw || !view_) return world_->advance_frame();
  view_->set_time(world_->time() + world_->scene().time.frame);
  return world_->advance_frame(&view_->list(world_->parity_after()));
}

Result<void> Session::draw() {
  if (!view_) return {};
  view_->set_time(world_->time());
  return device_->submit(view_->list(world_->parity()));
}

Result<void> Session::pick(double x, double y) {
  picked_.reset();
  if (!view_) return make_error(ErrorKind::Failure, "Nothing can be picked without a canvas.");
  WEFT_CHECK(take_snapshot());
  picked_ = render::pick_node(view_->ray(x, y), snapshot_.position, world_->model().host.triangles);
  return {};
}

Result<void> Session::pick_within(const render::PickArea& area) {
  picked_within_.clear();
  if (!view_) return make_error(ErrorKind::Failure, "Nothing can be picked without a canvas.");
  WEFT_CHECK(take_snapshot());
  picked_within_ = view_->nodes_within(area, snapshot_.position);
  return {};
}

Result<void> Session::take_snapshot() {
  WEFT_TRY(snapshot, world_->snapshot());
  snapshot_ = std::move(snapshot);
  return {};
}

Result<std::vector<std::byte>> Session::save_state(const std::string& build) {
  WEFT_TRY(state, world_->save(build));
  return sim::write_saved_state(state);
}

Result<std::string> Session::open_state(std::span<const std::byte> bytes, const std::string& build) {
  WEFT_TRY(state, sim::read_saved_state(bytes));
  WEFT_CHECK(follow(sim::open_in(world_, state)));
  return sim::other_origin(state, build, device_->adapter().name);
}

Result<void> Session::export_mesh(const std::string& format) {
  WEFT_CHECK(take_snapshot());
  const DrawnMesh drawn =
      drawn_mesh(world_->model().host, snapshot_.position, world_->scene().render.subdivide);
  WEFT_SET(exported_, mesh_file(drawn, format));
  return {};
}

Result<std::vector<sim::KernelTime>> Session::time_passes() {
  WEFT_CHECK(world_->finish());
  if (world_->frame() == 0)
    return make_error(ErrorKind::Failure, "Nothing has been simulated yet: passes are timed after a frame.");
  if (world_->substeps() < 2)
    return make_error(ErrorKind::Failure, "A frame of this scene has 1 step; passes are timed over 2.");
  WEFT_TRY(before, world_->snapshot());
  WEFT_TRY(kernels, sim::time_kernels(*world_, kTimedFrames));
  WEFT_CHECK(world_->restore(before));
  return kernels;
}

}  // namespace weft
