#include "weft/world.hpp"

#include "api/running_world.hpp"
#include "api/scene_content.hpp"
#include "picture/png.hpp"
#include "session/describe.hpp"
#include "view/world_inputs.hpp"
#include "weft/native.hpp"

namespace weft {

Result<std::vector<AdapterInfo>> adapters() { return gpu::Device::adapters(); }

World::World(std::unique_ptr<RunningWorld> running) : running_(std::move(running)) {}
World::World(World&& other) noexcept = default;
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

Result<World> World::create(const Scene& scene, const WorldOptions& options) {
  const auto read = [&](const SceneText& source) { return scene.content_->read(source); };
  WEFT_TRY(running, RunningWorld::create({.adapter = options.adapter}, scene.content_->source, read));
  return World(std::move(running));
}

Result<World> World::create_on(const NativeDevice& device, const Scene& scene) {
  const gpu::DeviceHandles given{reinterpret_cast<gpu::Id>(device.adapter),
                                 reinterpret_cast<gpu::Id>(device.device)};
  const auto read = [&](const SceneText& source) { return scene.content_->read(source); };
  WEFT_TRY(running, RunningWorld::create({.given = given}, scene.content_->source, read));
  return World(std::move(running));
}

Result<void> World::advance(std::uint32_t frames) {
  for (std::uint32_t frame = 0; frame < frames; ++frame) WEFT_CHECK(running_->advance());
  return {};
}
Result<void> World::finish() { return running_->world().finish(); }
Result<void> World::reset() { return running_->reset(); }

std::uint32_t World::frame() const { return running_->world().frame(); }
double World::time() const { return running_->world().time(); }

Result<void> World::change(const std::string& key, const std::string& value) {
  return running_->session.set(key, value);
}

Result<void> World::grab(std::uint32_t node, const Vec3d& target) {
  return running_->world().grab(node, target);
}
Result<void> World::drag(std::uint32_t node, const Vec3d& target) {
  return running_->world().drag(node, target);
}
Result<void> World::release(std::uint32_t node) { return running_->world().release(node); }

Result<void> World::set_positions(std::span<const Vec3f> positions) {
  return running_->world().set_positions(positions);
}
Result<void> World::set_velocities(std::span<const Vec3f> velocities) {
  return running_->world().set_velocities(velocities);
}
Result<void> World::push(std::span<const Vec3f> impulses) { return running_->world().push(impulses); }

Result<void> World::move(std::span<const std::uint32_t> nodes, std::span<const Vec3f> places) {
  return running_->world().move(nodes, places);
}
std::vector<std::uint32_t> World::given_nodes() const { return running_->world().given_nodes(); }
Result<void> World::set_collider(std::size_t collider, const Placement& placement) {
  return running_->world().set_collider(collider, placement);
}
std::vector<std::size_t> World::given_colliders() const { return running_->world().given_colliders(); }

Buffer World::position() const { return {running_.get(), Buffer::Quantity::Position}; }
Buffer World::velocity() const { return {running_.get(), Buffer::Quantity::Velocity}; }
Buffer World::normal() const { return {running_.get(), Buffer::Quantity::Normal}; }
Buffer World::stretch() const { return {running_.get(), Buffer::Quantity::Stretch}; }
std::span<const Triangle> World::triangles() const { return running_->world().model().host.triangles; }

Result<std::string> World::state_hash() {
  WEFT_CHECK(running_->settle());
  WEFT_CHECK(running_->session.take_snapshot());
  return running_->session.snapshot().hash();
}

Result<std::vector<std::byte>> World::mesh_file(const std::string& format) {
  WEFT_CHECK(running_->settle());
  WEFT_CHECK(running_->session.export_mesh(format));
  return running_->session.exported();
}

Result<std::vector<std::byte>> World::save_state() { return running_->save_state(); }
Result<bool> World::open_state(std::span<const std::byte> bytes) {
  WEFT_TRY(other, running_->open_state(bytes));
  return other.empty();
}

Description World::describe() const { return weft::describe(running_->world()); }
const Totals& World::totals() const { return running_->world().totals(); }
const AdapterInfo& World::adapter() const { return running_->session.device().adapter(); }
std::uint64_t World::gpu_bytes() const { return running_->session.device().allocated_bytes(); }

Result<Image> World::draw(const PictureOptions& options) {
  WEFT_TRY(settings, running_->settings(options));
  WEFT_CHECK(running_->settle());
  sim::World& world = running_->world();
  std::optional<RunningWorld::Drawing>& drawing = running_->drawing;
  if (!drawing || drawing->width != settings.width || drawing->height != settings.height ||
      drawing->view != settings.view || drawing->legend != options.legend) {
    drawing.reset();
    WEFT_TRY(made,
             picture::Offscreen::create(world.device(), settings, view::inputs_of(world), options.legend));
    drawing.emplace(RunningWorld::Drawing{settings.width, settings.height, settings.view, options.legend,
                                          std::move(made)});
    WEFT_CHECK(running_->count_contacts());
  }
  drawing->offscreen.set_camera(options.camera.value_or(render::camera_of(settings)));
  drawing->offscreen.set_time(world.time());
  return drawing->offscreen.draw(world.parity());
}

Result<void> write_png(const std::string& path, const Image& image) {
  return picture::write_png(path, image);
}

}  // namespace weft
