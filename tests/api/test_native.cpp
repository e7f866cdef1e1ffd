#include <algorithm>
#include <span>

#include "api/callers_device.hpp"
#include "api/scenes.hpp"

using namespace weft;

namespace {

constexpr WGPUTextureFormat kFormats[] = {WGPUTextureFormat_RGBA8Unorm, WGPUTextureFormat_RGBA8UnormSrgb,
                                          WGPUTextureFormat_BGRA8Unorm, WGPUTextureFormat_BGRA8UnormSrgb};

/// A sheet that falls onto a ball, with pairs in contact.
constexpr const char* kDrape = R"({ "format": "weft-scene/1", "solver": {"kind": "mass_spring"},
  "cloths": [{ "grid": [12, 12], "size": [1, 1], "plane": "xz", "density": 0.2,
    "stiffness": { "structural": 8, "shear": 2, "bend": 0.1 } }],
  "colliders": [{ "kind": "sphere", "center": [0, -0.31, 0], "radius": 0.3 }] })";

World world_on(const CallersDevice& device, const Scene& scene) {
  auto world = World::create_on(device.native(), scene);
  REQUIRE_OK(world);
  return std::move(*world);
}

Image image_of(World& world, std::uint32_t width, std::uint32_t height, const ViewOptions& options = {}) {
  PictureOptions picture;
  picture.width = width;
  picture.height = height;
  picture.view = options.view;
  picture.camera = options.camera;
  picture.legend = false;
  auto image = world.draw(picture);
  REQUIRE_OK(image);
  return std::move(*image);
}

/// What draw_into leaves in a texture of its own.
std::vector<std::uint8_t> drawn(World& world, WGPUTextureFormat format, std::uint32_t width,
                                std::uint32_t height, const ViewOptions& options = {}) {
  const WGPUDevice device = world.native_device().device;
  const CallersTexture texture(device, CallersTexture::drawable(format, width, height));
  REQUIRE_OK(world.draw_into(texture.target(), options));
  return pixels_of(device, texture.target());
}

/// The numbers of a native buffer, without the padding of each element.
std::vector<float> floats_of(World& world, const Buffer& buffer) {
  const NativeBuffer native = buffer.native();
  const std::vector<std::byte> bytes = bytes_of(world.native_device().device, native);
  std::vector<float> values(buffer.count() * buffer.width());
  for (std::size_t element = 0; element < buffer.count(); ++element)
    std::memcpy(&values[element * buffer.width()], &bytes[element * native.stride],
                buffer.width() * sizeof(float));
  return values;
}

std::vector<float> read_floats(const Buffer& buffer) {
  std::vector<float> values(buffer.count() * buffer.width());
  REQUIRE_OK(buffer.read(values));
  return values;
}

}  // namespace

TEST_CASE("a world on the caller's device ends in the bits of one on its own, and leaves the device well") {
  World own = world_of(scene_of(kDrape));
  const CallersDevice device;
  {
    World world = world_on(device, scene_of(kDrape));
    CHECK(world.adapter().name == own.adapter().name);
    CHECK(world.native_device().device == device.device());
    CHECK(hash_after(world, 4) == hash_after(own, 4));
    World beside = world_on(device, scene_of(kSheet));  // two on one device
    CHECK(hash_after(world, 2) == hash_after(own, 2));
    CHECK(beside.frame() == 0);
  }
  const std::vector<std::byte> zeros = copied(device.device(), 16, [](WGPUCommandEncoder, WGPUBuffer) {});
  CHECK(std::all_of(zeros.begin(), zeros.end(), [](std::byte value) { return value == std::byte{0}; }));
  CHECK(device.errors() == 0);
}

TEST_CASE("the limits that are asked of a device are enough for both solvers, contact and a picture") {
  WGPULimits limits = WGPU_LIMITS_INIT;  // what is not set is WebGPU's default
  limits.maxStorageBuffersPerShaderStage = 8;
  limits.maxComputeInvocationsPerWorkgroup = 256;
  limits.maxComputeWorkgroupSizeX = 256;
  limits.maxComputeWorkgroupsPerDimension = 65535;
  limits.maxComputeWorkgroupStorageSize = 16384;
  limits.maxUniformBufferBindingSize = 65536;
  limits.maxBindingsPerBindGroup = 16;
  const CallersDevice device(limits);
  for (const char* solver : {"mass_spring", "multigrid"}) {
    Scene scene = scene_of(kDrape);
    REQUIRE_OK(scene.set("solver", std::string(R"({ "kind": ")") + solver + R"(" })"));
    World world = world_on(device, scene), own = world_of(scene);
    CHECK(hash_after(world, 4) == hash_after(own, 4));
    CHECK(image_of(world, 64, 48).rgba == image_of(own, 64, 48).rgba);
  }
  CHECK(device.errors() == 0);
}

TEST_CASE("a device with less than weft's shaders need is refused by the limit's name, and so is no device") {
  WGPULimits limits = WGPU_LIMITS_INIT;
  limits.maxStorageBuffersPerShaderStage = 4;
  const CallersDevice device(limits);
  const auto refused = World::create_on(device.native(), scene_of(kSheet));
  REQUIRE(!refused);
  CHECK(refused.error().kind == ErrorKind::Limit);
  CHECK(refused.error().message ==
        "The device's maxStorageBuffersPerShaderStage is 4, and weft's shaders need 8.");
  const auto none = World::create_on({device.native().adapter, nullptr}, scene_of(kSheet));
  REQUIRE(!none);
  CHECK(none.error().kind == ErrorKind::Input);
  CHECK(none.error().message == "The handle of the device is null.");
}

TEST_CASE("a sheet that no buffer of a given device holds is refused by the limit and both numbers") {
  const CallersDevice device;  // with WebGPU's default limits
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("cloths.0.grid", "[4000, 4000]"));
  const auto world = World::create_on(device.native(), scene);
  REQUIRE(!world);
  CHECK(world.error().kind == ErrorKind::Limit);
  CHECK(world.error().message ==
        "The positions of 16000000 nodes need 256000000 bytes, more than this adapter's "
        "maxStorageBufferBindingSize of 134217728.");
}

TEST_CASE("a texture of each format gets the bytes of the picture, in every size, view and camera") {
  const CallersDevice device;
  World callers = world_on(device, scene_of(kDrape)), own = world_of(scene_of(kDrape));
  ViewOptions normals, above;
  normals.view = View::Normals;
  above.camera = Camera{{0, 3, 0.1}, {0, 0, 0}, 25};
  for (World* world : {&callers, &own}) {
    REQUIRE_OK(world->advance(4));
    const Image image = image_of(*world, 150, 90), from_above = image_of(*world, 64, 100, above),
                with_normals = image_of(*world, 64, 100, normals);
    CHECK(*std::min_element(image.rgba.begin(), image.rgba.end()) <
          *std::max_element(image.rgba.begin(), image.rgba.end()));
    for (const WGPUTextureFormat format : kFormats) {
      CAPTURE(static_cast<int>(format));
      CHECK(drawn(*world, format, 150, 90) == image.rgba);
      CHECK(drawn(*world, format, 64, 100, above) == from_above.rgba);
      CHECK(drawn(*world, format, 64, 100, normals) == with_normals.rgba);
      CHECK(drawn(*world, format, 150, 90) == image.rgba);
    }
  }
  CHECK(device.errors() == 0);
}

TEST_CASE("a texture shows the state at the end of the frames before, without waiting for it") {
  World world = world_of(scene_of(kSheet));
  const auto rest = drawn(world, WGPUTextureFormat_RGBA8Unorm, 96, 64);
  REQUIRE_OK(world.advance(2));
  const auto later = drawn(world, WGPUTextureFormat_RGBA8Unorm, 96, 64);
  CHECK(later != rest);
  CHECK(later == image_of(world, 96, 64).rgba);
}

TEST_CASE("contacts are counted for as long as the texture or the picture shows them") {
  Scene scene = scene_of(kDrape);
  World world = world_of(scene), plain = world_of(scene);
  ViewOptions contacts;
  contacts.view = View::Contacts;
  REQUIRE_OK(world.advance(6));
  drawn(world, WGPUTextureFormat_RGBA8Unorm, 96, 64, contacts);
  const Image textured = image_of(world, 96, 64);  // does not end the counting
  REQUIRE_OK(world.advance(2));
  const auto shown = drawn(world, WGPUTextureFormat_RGBA8Unorm, 96, 64, contacts);
  CHECK(shown == image_of(world, 96, 64, contacts).rgba);
  CHECK(shown != textured.rgba);
  REQUIRE_OK(plain.advance(8));
  CHECK(shown == image_of(plain, 96, 64, contacts).rgba);
}

TEST_CASE("a texture that cannot be drawn into is refused by what is wrong with it") {
  const CallersDevice device;
  World world = world_on(device, scene_of(kSheet));
  const auto refusal = [&](const WGPUTextureDescriptor& descriptor) {
    const CallersTexture texture(device.device(), descriptor);
    const auto drawn_into = world.draw_into(texture.target());
    REQUIRE(!drawn_into);
    CHECK(drawn_into.error().kind == ErrorKind::Input);
    return drawn_into.error().message;
  };
  WGPUTextureDescriptor descriptor = CallersTexture::drawable(WGPUTextureFormat_RGBA16Float, 32, 32);
  CHECK(
      refusal(descriptor) ==
      "A texture to draw into is RGBA8Unorm, RGBA8UnormSrgb, BGRA8Unorm or BGRA8UnormSrgb, and this one has "
      "WGPUTextureFormat 0x00000028.");
  static_assert(WGPUTextureFormat_RGBA16Float == 0x28);
  descriptor.format = WGPUTextureFormat_RGBA8Unorm;
  descriptor.usage = WGPUTextureUsage_CopySrc;
  descriptor.dimension = WGPUTextureDimension_3D;
  CHECK(refusal(descriptor) == "A texture to draw into has two dimensions, and this one has not.");
  descriptor.dimension = WGPUTextureDimension_2D;
  CHECK(refusal(descriptor) ==
        "A texture to draw into has the usage RenderAttachment, and this one has not.");
  descriptor.usage = WGPUTextureUsage_RenderAttachment;
  descriptor.sampleCount = 4;
  CHECK(refusal(descriptor) == "A texture to draw into has one sample a pixel, and this one has 4.");
  descriptor.sampleCount = 1;
  descriptor.mipLevelCount = 2;
  CHECK(refusal(descriptor) == "A texture to draw into has one mip level, and this one has 2.");
  descriptor.mipLevelCount = 1;
  descriptor.size.depthOrArrayLayers = 3;
  CHECK(refusal(descriptor) == "A texture to draw into has one layer, and this one has 3.");
  const auto none = world.draw_into({});
  REQUIRE(!none);
  CHECK(none.error().message == "The handle of the texture to draw into is null.");

  const CallersDevice other;
  const CallersTexture foreign(other.device(),
                               CallersTexture::drawable(WGPUTextureFormat_RGBA8Unorm, 32, 32));
  const auto elsewhere = world.draw_into(foreign.target());
  REQUIRE(!elsewhere);
  CHECK(elsewhere.error().kind == ErrorKind::Shader);
  CHECK(drawn(world, WGPUTextureFormat_RGBA8Unorm, 32, 32) == image_of(world, 32, 32).rgba);
  CHECK(device.errors() == 0);  // weft's errors are weft's
}

TEST_CASE("the native buffers hold what is read, in either buffer of a state") {
  Scene scene = scene_of(kSheet);
  REQUIRE_OK(scene.set("time.substeps", "101"));  // odd, so that position changes its buffer in each frame
  const CallersDevice device;
  World world = world_on(device, scene);
  WGPUBuffer last = nullptr;
  for (int frame = 0; frame < 3; ++frame) {
    CHECK(world.position().native().buffer != last);
    last = world.position().native().buffer;
    for (const Buffer& buffer : {world.position(), world.velocity(), world.normal(), world.stretch()}) {
      CHECK(buffer.native().count == buffer.count());
      CHECK(floats_of(world, buffer) == read_floats(buffer));
    }
    REQUIRE_OK(world.advance());
    REQUIRE_OK(world.finish());
  }
  const NativeBuffer triangles = world.native_triangles();
  REQUIRE(triangles.count == world.triangles().size());
  CHECK(triangles.stride == 12);
  const std::vector<std::byte> bytes = bytes_of(device.device(), triangles);
  CHECK(std::ranges::equal(bytes, std::as_bytes(world.triangles())));
  // Pinned nodes have the inverse mass 0; of the 0.2 kg a node has no more than one of the 361 cells.
  const std::vector<std::byte> state = bytes_of(device.device(), world.position().native());
  std::vector<Vec4f> position(400);
  std::memcpy(position.data(), state.data(), state.size());
  CHECK(position[0].w == 0);
  double mass = 0;
  for (const Vec4f& node : position)
    if (node.w > 0) mass += 1 / static_cast<double>(node.w);
  CHECK(mass < 0.2);
  CHECK(mass > 0.2 * (1 - 2.0 / 361));
  CHECK(device.errors() == 0);
}

TEST_CASE("an error of the caller's own calls is the caller's, and the world goes on") {
  const CallersDevice device;
  World world = world_on(device, scene_of(kSheet)), own = world_of(scene_of(kSheet));
  REQUIRE_OK(world.advance(2));
  WGPUBufferDescriptor wrong = WGPU_BUFFER_DESCRIPTOR_INIT;
  wrong.size = 16;
  wrong.usage = WGPUBufferUsage_MapRead | WGPUBufferUsage_Storage;  // not allowed together
  wgpuBufferRelease(wgpuDeviceCreateBuffer(device.device(), &wrong));
  CHECK(device.errors() == 1);
  CHECK(hash_after(world, 2) == hash_after(own, 4));
}

TEST_CASE("after the caller has given the device up every call says that it is lost") {
  const CallersDevice device;
  World world = world_on(device, scene_of(kSheet));
  REQUIRE_OK(world.advance(2));
  REQUIRE_OK(world.finish());
  wgpuDeviceDestroy(device.device());
  CHECK(world.advance().error().kind == ErrorKind::DeviceLost);
  CHECK(world.finish().error().kind == ErrorKind::DeviceLost);
  CHECK(world.reset().error().kind == ErrorKind::DeviceLost);
  CHECK(world.state_hash().error().kind == ErrorKind::DeviceLost);
  CHECK(world.mesh_file("ply").error().kind == ErrorKind::DeviceLost);
  CHECK(world.draw().error().kind == ErrorKind::DeviceLost);
  CHECK(world.pick(Ray{{0, 1, 0}, {0, -1, 0}}).error().kind == ErrorKind::DeviceLost);
  std::vector<float> values(400);
  CHECK(world.stretch().read(values).error().kind == ErrorKind::DeviceLost);
  CHECK(World::create_on(device.native(), scene_of(kSheet)).error().kind == ErrorKind::DeviceLost);
}
