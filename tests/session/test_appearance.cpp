// Looks, materials and light of a running scene, by pictures: the oracle is a scene that had them from the beginning.
#include <doctest/doctest.h>

#include "gpu/texture.hpp"
#include "picture/image_ring.hpp"
#include "read_inputs.hpp"
#include "session/session.hpp"

using namespace weft;

namespace {

constexpr std::uint32_t kWidth = 160, kHeight = 90, kFrames = 3;

const std::string kScene = R"({ "format": "weft-scene/1", "solver": {"kind": "mass_spring"},
  "time": { "substeps": 8 }, "contact": { "method": "proximity" },
  "cloths": [{ "grid": [9, 9], "size": [1, 1], "plane": "xz", "density": 0.2, "pins": ["top"],
    "color": [0.2, 0.4, 0.6], "look": { "name": "cotton", "pattern": "stripes" } }],
  "colliders": [
    { "kind": "plane", "point": [0, -0.6, 0], "normal": [0, 1, 0] },
    { "kind": "sphere", "center": [-0.8, -0.3, 0], "radius": 0.25 },
    { "kind": "box", "center": [0.8, -0.4, 0], "size": [0.3, 0.3, 0.3],
      "motion": { "kind": "line", "direction": [0, 1, 0], "speed": 2 } } ],
  "camera": { "eye": [0.4, 0.7, 2.6], "target": [0, -0.2, 0] } })";

using Changes = std::vector<scene::Override>;

class Shown {
 public:
  /// A scene with changes from the beginning, after some frames.
  explicit Shown(const Changes& changes) {
    REQUIRE(session_.open({}));
    const gpu::TextureInfo info = {kWidth, kHeight, 1, gpu::TextureFormat::Rgba8Unorm,
                                   gpu::kRenderTarget | gpu::kSampled | gpu::kTextureCopySource};
    auto canvas = gpu::Texture::create(session_.device(), info, "canvas");
    REQUIRE(canvas);
    canvas_ = std::move(*canvas);
    auto ring = picture::ImageRing::create(session_.device(), kWidth, kHeight);
    REQUIRE(ring);
    ring_ = std::move(*ring);
    session_.set_canvas({canvas_.view(), info.format, kWidth, kHeight});
    const auto loaded = session_.load({kScene, "scene", changes}, read_inputs);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    for (std::uint32_t frame = 0; frame < kFrames; ++frame) REQUIRE(session_.advance(true));
    REQUIRE(session_.world()->finish());
  }
  ~Shown() { CHECK(session_.device().status()); }

  std::vector<std::uint8_t> picture() {
    REQUIRE(session_.draw());
    gpu::CommandList list;
    ring_.record(list, canvas_);
    REQUIRE(session_.device().submit(list));
    ring_.start();
    const auto image = ring_.take();
    REQUIRE(image);
    return image->rgba;
  }
  std::string hash() {
    REQUIRE(session_.take_snapshot());
    return session_.snapshot().hash();
  }
  Session& session() { return session_; }

 private:
  Session session_;
  gpu::Texture canvas_;
  picture::ImageRing ring_;
};

}  // namespace

TEST_CASE("a running scene looks, bit for bit, as one that began with the same looks, materials and light") {
  Shown changed({});
  const auto first = changed.picture();
  const std::string hash = changed.hash();
  for (const Changes& changes :
       {Changes{{"cloths.0.look", "silk"}}, Changes{{"cloths.0.look", "denim"}, {"cloths.0.color", "null"}},
        Changes{{"cloths.0.color", "[0.9, 0.2, 0.1]"}}, Changes{{"colliders.0.material", "marble"}},
        Changes{{"colliders.1.material", "metal"}}, Changes{{"colliders.2.material", "metal"}},
        Changes{{"render.light.environment", "sky"}, {"render.light.degrees", "12"}},
        Changes{{"render.light.direction", "[1, 1, 0.2]"}}}) {
    CAPTURE(changes[0].key);
    for (const auto& [key, value] : changes) REQUIRE(changed.session().set(key, value));
    const auto now = changed.picture();
    CHECK(now != first);
    Shown fresh(changes);
    CHECK(now == fresh.picture());
    CHECK(changed.hash() == hash);
    CHECK(fresh.hash() == hash);
    for (const auto& [key, value] : changes) REQUIRE(changed.session().set(key, "null"));
    for (const char* own :
         {R"(cloths.0.color=[0.2, 0.4, 0.6])", R"(cloths.0.look={"name": "cotton", "pattern": "stripes"})"}) {
      const auto back = scene::parse_override(own);
      REQUIRE(changed.session().set(back->key, back->value));
    }
    CHECK(changed.picture() == first);
  }
}
