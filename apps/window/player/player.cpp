#include "player/player.hpp"

#include <limits>

#include "base/file.hpp"
#include "player/camera_fit.hpp"
#include "player/json_values.hpp"
#include "player/lists.hpp"
#include "scene/load.hpp"
#include "session/describe.hpp"

namespace weft::window {
namespace {

constexpr std::uint64_t kMostStateBytes = 512000000;  // as on the page

/// Errors  Input: a change is not JSON.
Result<SceneText> changed_text(const Wanted& wanted) {
  SceneText text = wanted.scene;
  WEFT_TRY(values, SceneValues::read(wanted.scene, wanted.set));
  for (const std::string& key : values.cleared()) text.changes.push_back({key, "null"});
  for (const auto& [key, value] : wanted.set) text.changes.push_back({key, value});
  return text;
}

}  // namespace

// What is shown

Result<void> Player::begin(const gpu::DeviceOptions& options, std::uint32_t width, std::uint32_t height,
                           scene::View view) {
  session_.on_world([this](sim::World& made) {
    made.on_report([this, &made](std::uint32_t frame) {
      const std::uint64_t truncated = made.totals().truncated;
      altered_.add(made, frame, truncated - truncated_);
      truncated_ = truncated;
    });
  });
  WEFT_CHECK(session_.open(options));
  WEFT_CHECK(session_.set_view(view));
  return make_canvas(width, height);
}

Result<void> Player::make_canvas(std::uint32_t width, std::uint32_t height) {
  const gpu::TextureInfo info = {width, height, 1, gpu::TextureFormat::Rgba8Unorm,
                                 gpu::kRenderTarget | gpu::kSampled | gpu::kTextureCopySource};
  WEFT_SET(canvas_, gpu::Texture::create(session_.device(), info, "canvas"));
  session_.set_canvas({canvas_.view(), info.format, width, height});
  return {};
}

Result<void> Player::resize(std::uint32_t width, std::uint32_t height) {
  gpu::Texture before = std::move(canvas_);  // the recorded lists name it until the new ones are recorded
  WEFT_CHECK(make_canvas(width, height));
  WEFT_CHECK(session_.resize(width, height));
  stale_ = true;
  if (!has_world()) return {};
  look().set_target(canvas_.view());
  const render::Camera camera = look().camera();
  const bool at_home =
      camera.eye == home_.eye && camera.target == home_.target && camera.fov_degrees == home_.fov_degrees;
  find_home();
  if (!at_home) look().set_camera(camera);
  return {};
}

void Player::find_home() {
  look().reset_camera();
  fit_camera(look(), world().model().host.start_position);
  home_ = look().camera();
}

Result<void> Player::load(const Wanted& wanted) {
  WEFT_TRY(source, changed_text(wanted));
  const OwnMesh* mesh = wanted.mesh.get();
  WEFT_CHECK(session_.load(std::move(source), [&](const SceneText& text) { return read_(text, mesh); }));
  WEFT_SET(values_, SceneValues::read(wanted.scene, wanted.set));
  facts_ = describe(world());
  count_anew();
  find_home();
  return {};
}

void Player::count_anew() {
  pins_.forget();
  altered_ = {};
  truncated_ = 0;
  pace_ = {};
  stale_ = true;
}

Result<void> Player::open(Wanted wanted) {
  // Most of what is refused is so here, while the cloth before still moves.
  WEFT_TRY(text, changed_text(wanted));
  if (const auto scene = scene::parse_scene(text.text, text.file, text.changes); !scene) return scene.error();
  std::string recorded;
  if (recording_) WEFT_SET(recorded, stop_recording());
  const std::optional<Wanted> before = std::move(loaded_);
  const std::optional<render::Camera> camera =
      before && has_world() ? std::optional(look().camera()) : std::nullopt;
  const bool same = before && before->name == wanted.name;  // with other values: seen from where it was
  loaded_.reset();
  notice.clear();
  const Result<void> opened = load(wanted);
  if (!opened && (!before || opened.error().kind == ErrorKind::DeviceLost)) return opened;
  if (!opened) WEFT_CHECK(load(*before));
  loaded_ = opened ? std::move(wanted) : *before;
  if (camera && (same || !opened)) set_camera(*camera);
  if (opened && !facts_.unstable_step.empty()) notice.say(facts_.unstable_step, Tone::Warning);
  if (!recorded.empty()) notice.say(recorded, Tone::Plain);
  return opened;
}

Result<void> Player::open_state(const std::string& path) {
  WEFT_TRY(bytes, read_file(path, kMostStateBytes));
  WEFT_TRY(other, session_.open_state(bytes, build_));
  notice.clear_error();
  if (!other.empty())
    notice.say("The state was written " + other + ": bits may differ from those of a run that goes on there.",
               Tone::Warning);
  count_anew();
  pins_.take(world().grabbed());
  truncated_ = world().totals().truncated;
  return {};
}

std::vector<std::string> Player::remarks() {
  return has_world() ? altered_.sentences(world()) : std::vector<std::string>();
}

// Time

Result<void> Player::change_mesh() {
  if (!session_.changes_mesh()) return {};
  WEFT_TRY(change, session_.change_mesh(build_));
  for (const std::string& news : change.news) notice.say(news, Tone::Plain);
  if (!change.changed) return {};
  facts_ = describe(world());
  pins_.take(world().grabbed());
  return recording_ ? recording_->go_on(world()) : Result<void>();
}

Result<void> Player::simulate_and_draw() {
  WEFT_CHECK(change_mesh());
  WEFT_CHECK(session_.advance(true));
  stale_ = false;
  return recording_ ? recording_->add(world(), look().camera()) : Result<void>();
}

Result<void> Player::tick(double seconds, bool counted) {
  if (!has_world()) return {};
  return stopped([&]() -> Result<void> {
    WEFT_CHECK(world().poll());
    const double frame = facts_.frame_seconds;
    if (playing_ && !counted) pace_.pass(seconds, frame);
    const bool due = playing_ && (counted || pace_.due(frame));
    if (due && counted && !world().has_room()) WEFT_CHECK(world().finish());
    if (due && world().has_room()) {
      if (!counted) pace_.take(frame);
      return simulate_and_draw();
    }
    if (!stale_) return {};
    stale_ = false;
    return session_.draw();
  }());
}

double Player::until_due() const {
  return playing_ ? pace_.until_due(facts_.frame_seconds) : std::numeric_limits<double>::infinity();
}

void Player::play(bool on) {
  if (on) notice.clear_error();
  playing_ = on;
  pace_.begin();
}

Result<void> Player::step() {
  if (!has_world()) return {};
  play(false);
  return stopped([&]() -> Result<void> {
    WEFT_CHECK(world().finish());
    WEFT_CHECK(simulate_and_draw());
    return world().finish();
  }());
}

Result<void> Player::reset() {
  if (!has_world()) return {};
  count_anew();
  const Result<void> done = session_.reset();
  if (done) facts_ = describe(world());
  return stopped(done);
}

Result<std::string> Player::state_hash() {
  WEFT_CHECK(world().finish());
  WEFT_TRY(snapshot, world().snapshot());
  return snapshot.hash();
}

Result<void> Player::said(const Result<void>& done) {
  if (done || done.error().kind == ErrorKind::DeviceLost || !has_world()) return done;
  notice.say(done.error().message, Tone::Error);
  return {};
}

Result<void> Player::stopped(const Result<void>& done) {
  if (!done) playing_ = false;
  return said(done);
}

// Look

Result<void> Player::set_view(scene::View view) {
  if (const std::string why = refusal(view); !why.empty()) {
    notice.say(why, Tone::Plain);
    return {};
  }
  stale_ = true;
  if (view != scene::View::Wireframe) before_wireframe_ = view;
  return stopped(session_.set_view(view));
}

std::string Player::refusal(scene::View view) {
  if (!has_world()) return "No scene is shown.";
  const Result<void> can = look().can_show(view);
  return can ? "" : can.error().message;
}

void Player::set_camera(const render::Camera& camera) {
  look().set_camera(camera);
  stale_ = true;
}

// Change

Result<void> Player::change(const Edits& edits) {
  if (!loaded_) return {};
  Wanted wanted = *loaded_;
  for (const auto& [key, value] : edits) {
    wanted.set.erase(key);
    if (value) wanted.set[key] = *value;
  }
  return said(open(std::move(wanted)));
}

Result<void> Player::change_live(const Edits& edits) {
  if (!loaded_) return {};
  for (const auto& [key, value] : edits) {
    const auto found = loaded_->set.find(key);
    const auto before = found != loaded_->set.end() ? std::optional(found->second) : std::nullopt;
    WEFT_CHECK(values_.set(key, value));
    if (const Result<void> done = tell(key); !done) {
      WEFT_CHECK(values_.set(key, before));
      return said(done);
    }
    loaded_->set.erase(key);
    if (value) loaded_->set[key] = *value;
    stale_ = true;
  }
  return {};
}

Result<void> Player::tell(const std::string& key) {
  std::vector<std::string> keys = cleared_by(key);
  keys.insert(keys.begin(), key);
  for (const std::string& each : keys) {
    const Json* now = values_.now(each);
    WEFT_CHECK(session_.set(each, now != nullptr ? text_of(*now) : "null"));
  }
  return {};
}

// Recording

Result<void> Player::record(const std::string& folder) {
  WEFT_SET(recording_, Recording::begin(world(), session_.shown(), folder));
  return {};
}

Result<std::string> Player::stop_recording() {
  Recording ended = std::move(*recording_);
  recording_.reset();
  return ended.end();
}

Result<void> Player::pin_within(const render::PickArea& area) {
  WEFT_TRY(refused, pins_.toggle_within(area));
  if (!refused.empty()) notice.say(refused, Tone::Plain);
  return {};
}

}  // namespace weft::window
