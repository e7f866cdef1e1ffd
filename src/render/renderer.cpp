#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>


namespace weft::render {
namespace {

constexpr double kFloorReach = 6;  // radii of what is drawn

Vec3d middle_of(const mesh::Bounds& bounds) {
  return 0.5 * (bounds.low.to<double>() + bounds.high.to<double>());
}
double radius_of(const mesh::Bounds& bounds) {
  return std::max(0.5 * length(bounds.high.to<double>() - bounds.low.to<double>()), 1e-3);
}

Result<void> check_cloth(const ClothDraw& cloth, View view) {
  const gpu::RawBuffer* const needed[] = {cloth.position[0], cloth.position[1], cloth.normal, cloth.uv,
                                          cloth.triangles};
  static constexpr const char* kNames[] = {"position[0]", "position[1]", "normal", "uv", "triangles"};
  for (std::size_t i = 0; i < std::size(needed); ++i)
    if (needed[i] == nullptr) return shape_error("A picture needs buffer %s.", kNames[i]);
  const std::uint64_t vertices = cloth.position[0]->bytes() / sizeof(Vec4f);
  const auto check = [vertices](const char* name, const gpu::RawBuffer& buffer,
                                std::uint64_t size) -> Result<void> {
    if (buffer.bytes() == vertices * size) return {};
    return shape_error("Buffer %s (%llu vertices) and buffer position (%llu) disagree.", name,
                       static_cast<unsigned long long>(buffer.bytes() / size),
                       static_cast<unsigned long long>(vertices));
  };
  const std::uint64_t triangles = cloth.triangles->bytes() / sizeof(mesh::Triangle);
  for (const ClothRange& range : cloth.ranges)
    if (const std::uint64_t end = std::uint64_t{range.first_triangle} + range.triangle_count; end > triangles)
      return shape_error("A cloth's triangles end at %llu, past the %llu of buffer triangles.",
                         static_cast<unsigned long long>(end), static_cast<unsigned long long>(triangles));
  WEFT_CHECK(check("position[1]", *cloth.position[1], sizeof(Vec4f)));
  WEFT_CHECK(check("normal", *cloth.normal, sizeof(Vec4f)));
  WEFT_CHECK(check("uv", *cloth.uv, 2 * sizeof(float)));
  if (view != View::Stretch) return {};
  if (cloth.stretch == nullptr) return shape_error("View stretch needs buffer stretch.");
  return check("stretch", *cloth.stretch, sizeof(float));
}

}  // namespace

Result<Renderer> Renderer::create(gpu::Device& device, const Settings& settings, const Inputs& inputs) {
  WEFT_CHECK(check_cloth(inputs.cloth, settings.view));
  if (settings.width == 0 || settings.height == 0)
    return input_error("A picture of %u x %u pixels is empty.", settings.width, settings.height);
  Renderer made;
  made.device_ = &device;
  made.settings_ = settings;
  const double aspect = static_cast<double>(settings.width) / settings.height;
  if (!settings.camera) made.settings_.camera = frame_camera(settings.bounds, aspect);
  if (!settings.to_light) made.settings_.to_light = default_light(*made.settings_.camera);

  WEFT_TRY(frame, gpu::Buffer<FrameParams>::create(device, 1, "frame", gpu::kUniform | gpu::kCopyTarget));
  made.frame_ = std::move(frame);
  made.write_frame();
  WEFT_CHECK(made.create_targets());
  WEFT_TRY(objects, ObjectBuffers::create(device, join_objects(inputs)));
  made.objects_ = std::move(objects);
  WEFT_TRY(shadow_map, ShadowMap::create(device, made.frame_, inputs.cloth, made.objects_));
  made.shadow_map_ = std::move(shadow_map);
  WEFT_TRY(object_surface,
           ObjectSurface::create(device, settings.view, made.frame_, made.shadow_map_, made.objects_));
  made.object_surface_ = std::move(object_surface);
  if (settings.view == View::Wireframe) {
    WEFT_TRY(cloth, ClothWireframe::create(device, made.frame_, inputs.cloth));
    made.cloth_wireframe_ = std::move(cloth);
  } else {
    WEFT_TRY(cloth, ClothSurface::create(device, settings.view, made.frame_, made.shadow_map_, inputs.cloth));
    made.cloth_surface_ = std::move(cloth);
  }
  std::vector<scene::ColliderPlane> planes = inputs.planes;
  const bool shadows_only = planes.empty();
  const Vec3d middle = middle_of(settings.bounds);
  if (shadows_only && settings.ground_shadow)
    planes.push_back({{middle.x, settings.bounds.low.y, middle.z}, {0, 1, 0}});
  for (const scene::ColliderPlane& plane : planes) {
    const PlaneParams params =
        plane_params(plane, middle, kFloorReach * radius_of(settings.bounds), shadows_only);
    WEFT_TRY(floor, Floor::create(device, settings.view, made.frame_, made.shadow_map_, params));
    made.floors_.push_back(std::move(floor));
  }
  WEFT_TRY(background, Background::create(device, settings.view, made.frame_));
  made.background_ = std::move(background);
  return made;
}

Result<void> Renderer::create_targets() {
  const std::uint32_t width = settings_.width, height = settings_.height;
  WEFT_TRY(color, gpu::Texture::create(*device_, {width, height, kSamples, kColorFormat, gpu::kRenderTarget},
                                       "picture samples"));
  color_ = std::move(color);
  WEFT_TRY(depth, gpu::Texture::create(*device_, {width, height, kSamples, kDepthFormat, gpu::kRenderTarget},
                                       "picture depth"));
  depth_ = std::move(depth);
  return {};
}

void Renderer::write_frame() {
  const Camera& camera = *settings_.camera;
  const auto width = static_cast<float>(settings_.width), height = static_cast<float>(settings_.height);
  const Vec3d middle = middle_of(settings_.bounds);
  const double radius = radius_of(settings_.bounds);
  const double reach = kFloorReach * radius;
  const double distance = length(camera.eye - middle);
  const double near = std::max(distance - 1.5 * radius, 0.01 * radius);
  const double far = distance + 1.5 * reach;
  const Vec3d to_light = *settings_.to_light / length(*settings_.to_light);
  const LightView light = light_view(settings_.bounds, to_light, ShadowMap::kTexels);

  FrameParams params;
  params.view_projection = view_projection(camera, static_cast<double>(width) / height, near, far).to_float();
  params.light_projection = light.projection.to_float();
  params.eye = Vec4f::from(camera.eye.to<float>(), 1);
  params.to_light = Vec4f::from(to_light.to<float>(), static_cast<float>(light.texel));
  params.viewport = {width, height, 1 / width, 1 / height};
  const auto low = static_cast<float>(settings_.lowest_stretch),
             high = static_cast<float>(settings_.highest_stretch);
  params.stretch_range = {low, high, 1 / std::max(high - low, 1e-6F), 0};
  for (std::size_t i = 0; i < kColorMapSize; ++i)
    params.color_map[i] = Vec4f::from(srgb_to_linear(kColorMap[i]), 1);
  frame_.write(*device_, {&params, 1});
}

void Renderer::record(gpu::CommandList& list, std::uint32_t parity, gpu::Id target) const {
  shadow_map_.record(list, parity);
  gpu::RenderPass pass(list, {color_.view(), target, depth_.view(), {0, 0, 0, 1}, false}, "picture");
  cloth_surface_.record(pass, parity);  // of the two, one is empty
  cloth_wireframe_.record(pass, parity);
  object_surface_.record(pass);
  for (const Floor& floor : floors_) floor.record(pass);
  background_.record(pass);
}

void Renderer::set_camera(const Camera& camera) {
  settings_.camera = camera;
  write_frame();
}

}  // namespace weft::render
