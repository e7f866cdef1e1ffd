#include <algorithm>

#include "picture/image_ring.hpp"
#include "render/picture.hpp"
#include "render/sheet.hpp"

using namespace weft;
using namespace weft::render;
using picture::Image;

namespace {

Vec3d waves(double u, double v) { return {2 * u - 1, 0.3 * std::sin(7 * u + 2 * v), 1 - 2 * v}; }

/// A cloth over a sphere and a floor, so that every kind of pass has pixels.
struct Drawn {
  GpuFixture fixture;
  Sheet sheet{fixture.device(), 30, waves, 2};

  Inputs inputs() const {
    Inputs inputs;
    inputs.cloth = sheet.draw();
    inputs.spheres = {{{0, -0.6, 0}, 0.4}};
    inputs.planes = {{{0, -1, 0}, {0, 1, 0}}};
    return inputs;
  }
  Renderer renderer(const Settings& settings) {
    return value_of(Renderer::create(fixture.device(), settings, inputs()));
  }
  /// Draws into a texture of the test's own and brings its bytes to the host.
  Image draw(const Renderer& renderer, const Settings& settings) {
    const gpu::TextureInfo info = {settings.width, settings.height, 1, settings.color_format,
                                   gpu::kRenderTarget | gpu::kTextureCopySource};
    const auto target = value_of(gpu::Texture::create(fixture.device(), info, "target"));
    auto ring = value_of(picture::ImageRing::create(fixture.device(), settings.width, settings.height));
    gpu::CommandList list;
    renderer.record(list, 0, target.view());
    ring.record(list, target);
    REQUIRE(fixture.device().submit(list));
    ring.start();
    return value_of(ring.take());
  }
};

Settings small() {
  Settings settings;
  settings.width = 150;
  settings.height = 101;
  settings.bounds = {{-1, -1, -1}, {1, 0.5F, 1}};
  return settings;
}

}  // namespace

TEST_CASE("a texture of blue, green and red gets the same picture with two channels exchanged") {
  Drawn drawn;
  Settings settings = small();
  const Image expected = drawn.draw(drawn.renderer(settings), settings);
  settings.color_format = gpu::TextureFormat::Bgra8UnormSrgb;
  Image image = drawn.draw(drawn.renderer(settings), settings);
  CHECK(difference(image, expected) > 1000);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) std::swap(image.rgba[i], image.rgba[i + 2]);
  CHECK(image.rgba == expected.rgba);
}

TEST_CASE("a renderer of another size draws what one made at that size draws") {
  Drawn drawn;
  Settings settings = small();
  auto renderer = drawn.renderer(settings);
  settings.camera = renderer.camera();  // a new one would frame the bounds for its own aspect
  for (const auto& [width, height] : {std::pair{301U, 80U}, {64U, 200U}, {150U, 101U}}) {
    settings.width = width;
    settings.height = height;
    REQUIRE(renderer.resize(width, height));
    const Image image = drawn.draw(renderer, settings);
    CAPTURE(width);
    CHECK(color_count(image) > 200);
    CHECK(image.rgba == drawn.draw(drawn.renderer(settings), settings).rgba);
  }
}

TEST_CASE("a size that cannot be is refused, and the one before it stays") {
  Drawn drawn;
  auto renderer = drawn.renderer(small());
  const Image before = drawn.draw(renderer, small());
  CHECK(renderer.resize(0, 10).error().kind == ErrorKind::Input);
  CHECK(renderer.resize(10, 1000000).error().kind == ErrorKind::Limit);
  CHECK(drawn.draw(renderer, small()).rgba == before.rgba);
}

TEST_CASE("a view that is changed shows what a renderer of that view draws, and back the same as before") {
  Drawn drawn;
  auto renderer = drawn.renderer(small());
  const std::uint64_t bytes = drawn.fixture.device().allocated_bytes();
  for (const View view : {View::Wireframe, View::Textured, View::Stretch, View::Velocity, View::Normals,
                          View::Wireframe, View::Textured}) {
    Settings settings = small();
    settings.view = view;
    REQUIRE(renderer.set_view(view));
    CAPTURE(scene::name_of(view));
    CHECK(renderer.view() == view);
    CHECK(drawn.fixture.device().allocated_bytes() == bytes);  // no view has buffers of its own
    CHECK(drawn.draw(renderer, settings).rgba == drawn.draw(drawn.renderer(settings), settings).rgba);
  }
}

TEST_CASE("a view of a subdivided cloth that is chosen later draws what it draws from the start") {
  Drawn drawn;
  Settings settings = small();
  settings.subdivide = 2;
  auto renderer = drawn.renderer(settings);
  for (const View view :
       {View::Wireframe, View::Stretch, View::Velocity, View::Contacts, View::Stretch, View::Textured}) {
    settings.view = view;
    REQUIRE(renderer.set_view(view));
    CAPTURE(scene::name_of(view));
    const Image image = drawn.draw(renderer, settings);
    CHECK(image.rgba == drawn.draw(drawn.renderer(settings), settings).rgba);
    Settings coarse = settings;
    coarse.subdivide = 0;
    CHECK(difference(image, drawn.draw(drawn.renderer(coarse), coarse)) > 100);
  }
}

TEST_CASE("the shadow map is drawn where something takes shadows, and only there") {
  Drawn drawn;
  const auto passes = [&](const Inputs& inputs, View view) {
    Settings settings = small();
    settings.view = view;
    const auto renderer = value_of(Renderer::create(drawn.fixture.device(), settings, inputs));
    gpu::CommandList list;
    renderer.record(list, 0, 1);
    return std::count_if(list.commands().begin(), list.commands().end(), [](const gpu::Command& command) {
      return command.kind == gpu::CommandKind::BeginRender;
    });
  };
  Inputs alone, over_floor;
  alone.cloth = over_floor.cloth = drawn.inputs().cloth;
  over_floor.planes = drawn.inputs().planes;
  REQUIRE(!over_floor.planes.empty());
  CHECK(passes(drawn.inputs(), View::Stretch) == 2);  // over a sphere too
  CHECK(passes(over_floor, View::Normals) == 2);
  CHECK(passes(alone, View::Textured) == 5);  // and the depth seen, what light arrives, and that smoothed
  for (const View view : {View::Wireframe, View::Normals, View::Stretch, View::Velocity}) {
    CAPTURE(scene::name_of(view));
    CHECK(passes(alone, view) == 1);
  }
}

TEST_CASE("a view that lacks its buffer is refused, and the one before it stays") {
  Drawn drawn;
  Inputs inputs = drawn.inputs();
  inputs.cloth.stretch = nullptr;
  auto renderer = value_of(Renderer::create(drawn.fixture.device(), small(), inputs));
  CHECK(renderer.set_view(View::Stretch).error().message == "View stretch needs buffer stretch.");
  CHECK(renderer.view() == View::Textured);
  CHECK(drawn.draw(renderer, small()).rgba == drawn.draw(drawn.renderer(small()), small()).rgba);
}

TEST_CASE("a camera that is moved changes the next picture, and back gives the first again") {
  Drawn drawn;
  auto renderer = drawn.renderer(small());
  const Camera before = renderer.camera();
  const Image first = drawn.draw(renderer, small());
  Camera nearer = before;
  nearer.eye = 0.5 * (before.eye + before.target);
  renderer.set_camera(nearer);
  CHECK(difference(drawn.draw(renderer, small()), first) > 1000);
  renderer.set_camera(before);
  CHECK(drawn.draw(renderer, small()).rgba == first.rgba);
}
