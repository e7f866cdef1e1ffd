#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>

namespace weft::render {
namespace {

constexpr double kFloorReach = 6;   // radii of what is drawn
constexpr double kSkyReach = 0.15;  // how far things keep the sky from each other, in these radii

Vec3d middle_of(const mesh::Bounds& bounds) {
  return 0.5 * (bounds.low.to<double>() + bounds.high.to<double>());
}
double radius_of(const mesh::Bounds& bounds) {
  return std::max(0.5 * length(bounds.high.to<double>() - bounds.low.to<double>()), 1e-3);
}

std::uint64_t vertex_count(const ClothDraw& cloth) { return cloth.position[0]->bytes() / sizeof(Vec4f); }

Result<void> check_size(const ClothDraw& cloth, const char* name, const gpu::RawBuffer& buffer,
                        std::uint64_t size) {
  if (buffer.bytes() == vertex_count(cloth) * size) return {};
  return shape_error("Buffer %s (%llu vertices) and buffer position (%llu) disagree.", name,
                     static_cast<unsigned long long>(buffer.bytes() / size),
                     static_cast<unsigned long long>(vertex_count(cloth)));
}

Result<void> check_cloth(const ClothDraw& cloth) {
  const gpu::RawBuffer* const needed[] = {cloth.position[0], cloth.position[1], cloth.normal, cloth.uv,
                                          cloth.triangles};
  static constexpr const char* kNames[] = {"position[0]", "position[1]", "normal", "uv", "triangles"};
  for (std::size_t i = 0; i < std::size(needed); ++i)
    if (needed[i] == nullptr) return shape_error("A picture needs buffer %s.", kNames[i]);
  const std::uint64_t triangles = cloth.triangles->bytes() / sizeof(mesh::Triangle);
  for (const ClothRange& range : cloth.ranges)
    if (const std::uint64_t end = std::uint64_t{range.first_triangle} + range.triangle_count; end > triangles)
      return shape_error("A cloth's triangles end at %llu, past the %llu of buffer triangles.",
                         static_cast<unsigned long long>(end), static_cast<unsigned long long>(triangles));
  WEFT_CHECK(check_size(cloth, "position[1]", *cloth.position[1], sizeof(Vec4f)));
  WEFT_CHECK(check_size(cloth, "normal", *cloth.normal, sizeof(Vec4f)));
  return check_size(cloth, "uv", *cloth.uv, 2 * sizeof(float));
}

Result<void> check_view(const ClothDraw& cloth, View view) {
  switch (view) {
    case View::Textured:
    case View::Wireframe:
    case View::Normals:
      return {};
    case View::Stretch:
      if (cloth.stretch == nullptr) return shape_error("View stretch needs buffer stretch.");
      return check_size(cloth, "stretch", *cloth.stretch, sizeof(float));
    case View::Velocity:
      for (const gpu::RawBuffer* velocity : cloth.velocity) {
        if (velocity == nullptr) return shape_error("View velocity needs buffer velocity.");
        WEFT_CHECK(check_size(cloth, "velocity", *velocity, sizeof(Vec4f)));
      }
      return {};
    case View::Contacts:
      if (cloth.contacts == nullptr)
        return input_error(
            "View contacts shows the pairs of contact method proximity, and this scene has none.");
      return check_size(cloth, "contacts", *cloth.contacts, sizeof(float));
  }
  return {};
}

/// The scene's planes, or the ground that takes shadows only.
std::vector<PlaneParams> planes_of(const Inputs& inputs, const Settings& settings) {
  const Vec3d middle = middle_of(settings.bounds);
  const double reach = kFloorReach * radius_of(settings.bounds);
  std::vector<PlaneParams> planes;
  for (const scene::ColliderPlane& plane : inputs.planes)
    planes.push_back(plane_params(plane, middle, reach, false));
  if (planes.empty() && settings.ground_shadow)
    planes.push_back(
        plane_params({{middle.x, settings.bounds.low.y, middle.z}, {0, 1, 0}}, middle, reach, true));
  return planes;
}

}  // namespace

Camera camera_of(const Settings& settings) {
  if (settings.camera) return *settings.camera;
  return frame_camera(settings.bounds, static_cast<double>(settings.width) / settings.height);
}

Result<Renderer> Renderer::create(gpu::Device& device, const Settings& settings, const Inputs& inputs) {
  WEFT_CHECK(check_cloth(inputs.cloth));
  Renderer made;
  made.device_ = &device;
  made.settings_ = settings;
  made.settings_.camera = camera_of(settings);
  made.first_camera_ = *made.settings_.camera;
  if (!settings.to_light) made.settings_.to_light = default_light(made.first_camera_);
  WEFT_CHECK(made.create_scene(inputs));
  WEFT_CHECK(made.resize(settings.width, settings.height));
  WEFT_CHECK(made.set_view(settings.view));
  return made;
}

Result<void> Renderer::create_scene(const Inputs& inputs) {
  given_ = inputs.cloth;
  scene_.cloth = given_;
  if (settings_.subdivide > 0) {
    WEFT_TRY(fine, FineCloth::create(*device_, given_, settings_.subdivide));
    fine_ = std::move(fine);
    scene_.cloth = fine_->draw();
  }
  WEFT_TRY(frame, gpu::Buffer<FrameParams>::create(*device_, 1, "frame", gpu::kUniform | gpu::kCopyTarget));
  scene_.frame = std::move(frame);
  WEFT_SET(scene_.light, gpu::create_uniform(*device_, light(), "light"));
  WEFT_SET(scene_.fabrics, create_fabrics(*device_, scene_.cloth.ranges));
  const std::vector<PlaneParams> squares = planes_of(inputs, settings_);
  WEFT_TRY(planes, create_planes(*device_, squares));
  scene_.planes = std::move(planes);
  take_planes(inputs, squares);
  ObjectMesh mesh = join_objects(inputs);
  WEFT_TRY(objects, ObjectBuffers::create(*device_, mesh));
  scene_.objects = std::move(objects);
  rigid_ = inputs.rigid;
  for (std::size_t k = 0; k < mesh.moving.size(); ++k)
    if (const auto& body = mesh.moving[k].draw.rigid) rigid_objects_.push_back({k, *body});
  colliders_ = inputs.colliders;
  moving_objects_ = MovingObjects(std::move(mesh.moving), colliders_);
  set_time(0);
  WEFT_TRY(shadow_map, ShadowMap::create(*device_, scene_.frame, scene_.cloth, scene_.objects));
  scene_.shadow_map = std::move(shadow_map);
  WEFT_SET(scene_.soft_light,
           SoftLight::create(*device_, scene_.frame, scene_.cloth, scene_.objects, scene_.planes));
  return {};
}

void Renderer::take_planes(const Inputs& inputs, const std::vector<PlaneParams>& squares) {
  moving_planes_.clear();
  for (std::size_t p = 0; p < inputs.planes.size(); ++p)
    if (const auto& motion = inputs.planes[p].motion) {
      MovingPlane moving{p, squares[p], *motion};
      if (inputs.colliders != nullptr && std::holds_alternative<scene::MotionCarried>(*motion))
        moving.given = inputs.plane_colliders[p];
      moving_planes_.push_back(std::move(moving));
    }
}

LightParams Renderer::light() const {
  return light_params(settings_.lighting, first_camera_, *settings_.to_light / length(*settings_.to_light));
}

void Renderer::set_looks(const Inputs& inputs) {
  for (std::size_t k = 0; k < scene_.fabrics.size(); ++k) {
    const FabricParams params = fabric_of(inputs.cloth.ranges[k], k);
    scene_.fabrics[k].write(*device_, {&params, 1});
  }
}

void Renderer::set_materials(const Inputs& inputs) {
  const std::vector<PlaneParams> squares = planes_of(inputs, settings_);
  for (std::size_t p = 0; p < squares.size(); ++p) scene_.planes[p].write(*device_, {&squares[p], 1});
  take_planes(inputs, squares);
  ObjectMesh mesh = join_objects(inputs);
  scene_.objects.position.write(*device_, mesh.positions);
  scene_.objects.normal.write(*device_, mesh.normals);
  moving_objects_ = MovingObjects(std::move(mesh.moving), colliders_);
}

void Renderer::set_light(const Lighting& lighting, const std::optional<Vec3d>& to_light) {
  settings_.lighting = lighting;
  settings_.to_light = to_light ? *to_light : default_light(first_camera_);
  const LightParams params = light();
  scene_.light.write(*device_, {&params, 1});
  write_frame();
}

Result<void> Renderer::resize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return input_error("A picture of %u x %u pixels is empty.", width, height);
  WEFT_TRY(color, gpu::Texture::create(*device_,
                                       {width, height, kSamples, settings_.color_format, gpu::kRenderTarget},
                                       "picture samples"));
  WEFT_TRY(depth, gpu::Texture::create(*device_, {width, height, kSamples, kDepthFormat, gpu::kRenderTarget},
                                       "picture depth"));
  WEFT_CHECK(
      scene_.soft_light.resize(*device_, width, height, scene_.frame, scene_.light, scene_.shadow_map));
  if (auto& textured = passes_[static_cast<std::size_t>(View::Textured)]) WEFT_CHECK(textured->bind(scene_));
  color_ = std::move(color);
  depth_ = std::move(depth);
  settings_.width = width;
  settings_.height = height;
  write_frame();
  return {};
}

Result<void> Renderer::can_show(View view) const { return check_view(given_, view); }

Result<void> Renderer::set_view(View view) {
  auto& passes = passes_[static_cast<std::size_t>(view)];
  if (!passes) {
    WEFT_CHECK(check_view(given_, view));
    if (fine_) {
      WEFT_CHECK(fine_->add_field(*device_, view));
      scene_.cloth = fine_->draw();
    }
    WEFT_TRY(made, ViewPasses::create(*device_, {view, settings_.color_format}, scene_));
    passes = std::move(made);
  }
  settings_.view = view;
  write_frame();
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
  const std::optional<Field> field = field_of(settings_.view);
  const Range range = settings_.range ? *settings_.range : field ? field->range : Range{};
  const auto low = static_cast<float>(range.lowest), high = static_cast<float>(range.highest);
  params.field_range = {low, high, 1 / std::max(high - low, 1e-6F), 0};
  for (std::size_t i = 0; i < kColorMapSize; ++i)
    params.color_map[i] = Vec4f::from(srgb_to_linear(kColorMap[i]), 1);
  const Basis basis = basis_of(camera);
  const double half = half_height(camera);
  const auto wide = [](const Vec3d& v, double w) {
    return Vec4f::from(v.to<float>(), static_cast<float>(w));
  };
  params.right = wide(half * static_cast<double>(width) / height * basis.right, near);
  params.up = wide(half * basis.up, far);
  params.forward = wide(-1 * basis.back, kSkyReach * radius);
  params.shadow_span = {static_cast<float>(light.span.x), static_cast<float>(light.span.y),
                        static_cast<float>(light.span.z), 0};
  scene_.frame.write(*device_, {&params, 1});
}

bool Renderer::shows_sun() const {
  const auto& groups = scene_.objects.groups;
  const bool objects =
      std::any_of(groups.begin(), groups.end(), [](const auto& g) { return g.index_count > 0; });
  return settings_.view == View::Textured || objects || !scene_.planes.empty();
}

void Renderer::record(gpu::CommandList& list, std::uint32_t parity, gpu::Id target) const {
  constexpr std::uint64_t kPlaces = 3 * sizeof(Vec4f);
  for (const auto& [number, collider] : rigid_objects_)
    list.copy(rigid_.words->range(rigid_.first + collider * rigid_.stride, kPlaces),
              scene_.objects.placement.range(kPlaces * number, kPlaces));
  if (fine_) fine_->record(list, parity, settings_.view);
  if (shows_sun()) scene_.shadow_map.record(list, parity);
  if (settings_.view == View::Textured) scene_.soft_light.record(list, parity);
  gpu::RenderPass pass(list, {color_.view(), target, depth_.view(), {0, 0, 0, 1}, false}, "picture");
  passes_[static_cast<std::size_t>(settings_.view)]->record(pass, parity);
}

void Renderer::set_camera(const Camera& camera) {
  settings_.camera = camera;
  write_frame();
}

void Renderer::set_time(double time) {
  moving_objects_.write(*device_, scene_.objects, time);
  for (const MovingPlane& moving : moving_planes_) {
    const scene::ColliderMotion& motion =
        moving.given ? *scene::motion_of((*colliders_)[*moving.given]) : moving.motion;
    const PlaneParams params =
        moved_plane(moving.rest, scene::motion_at(motion, time), middle_of(settings_.bounds));
    scene_.planes[moving.plane].write(*device_, {&params, 1});
  }
}

}  // namespace weft::render
