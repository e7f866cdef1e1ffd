#include "render/cloth_surface.hpp"

namespace weft::render {
namespace {

constexpr double kSettsPerSheet = 5;
constexpr double kThreadsPerSett = 30;  // far fewer than in real cloth, so that some are seen

struct Dye {
  Vec3f base, dark, accent, back;  // sRGB
};
constexpr Dye kPalette[] = {
    {{0.20F, 0.43F, 0.50F}, {0.10F, 0.20F, 0.31F}, {0.94F, 0.87F, 0.71F}, {0.78F, 0.50F, 0.40F}},  // sea
    {{0.74F, 0.28F, 0.20F}, {0.30F, 0.09F, 0.12F}, {0.97F, 0.90F, 0.74F}, {0.36F, 0.47F, 0.56F}},  // brick
    {{0.82F, 0.62F, 0.20F}, {0.42F, 0.27F, 0.10F}, {0.99F, 0.95F, 0.84F}, {0.36F, 0.42F, 0.36F}},  // straw
    {{0.33F, 0.49F, 0.30F}, {0.12F, 0.22F, 0.16F}, {0.95F, 0.89F, 0.70F}, {0.66F, 0.42F, 0.48F}},  // moss
    {{0.48F, 0.36F, 0.60F}, {0.20F, 0.13F, 0.30F}, {0.95F, 0.88F, 0.82F}, {0.72F, 0.60F, 0.34F}},  // plum
};

/// A check from one colour: its dark stripe, a pale line, and a back turned towards the complement.
Dye dye_of(const Vec3f& color) {
  const Vec3f white{1, 0.97F, 0.88F};
  const Vec3f complement = Vec3f{1, 1, 1} - color;
  return {color, 0.40F * color, 0.22F * color + 0.78F * white,
          0.35F * color + 0.4F * complement + 0.25F * white};
}

const char* entry_of(scene::View view) {
  switch (view) {
    case scene::View::Textured:
    case scene::View::Wireframe:
      break;  // has a class of its own
    case scene::View::Normals:
      return "fragment_normals";
    case scene::View::Stretch:
    case scene::View::Velocity:
    case scene::View::Contacts:
      return "fragment_field";
  }
  return "fragment_textured";
}

/// The view's value at each vertex; arbitrary where it shows no field.
const gpu::RawBuffer& field_buffer(const ClothDraw& cloth, scene::View view, std::size_t parity) {
  switch (view) {
    case scene::View::Stretch:
      return *cloth.stretch;
    case scene::View::Velocity:
      return *cloth.velocity[parity];
    case scene::View::Contacts:
      return *cloth.contacts;
    default:
      return *cloth.uv;
  }
}

}  // namespace

WeaveParams weave_of(const ClothRange& range, std::size_t index) {
  const Dye dye = range.color ? dye_of(range.color->to<float>()) : kPalette[index % std::size(kPalette)];
  if (!range.woven) {  // threads far below a pixel: nothing but their mean is seen
    const Vec3f color = srgb_to_linear(dye.base);
    return {Vec4f::from(color, 1e-6F), Vec4f::from(color, 1), Vec4f::from(color, 0), Vec4f::from(color, 0)};
  }
  const double sett = range.sheet_size / kSettsPerSheet;
  return {Vec4f::from(srgb_to_linear(dye.base), static_cast<float>(sett / kThreadsPerSett)),
          Vec4f::from(srgb_to_linear(dye.dark), static_cast<float>(sett)),
          Vec4f::from(srgb_to_linear(dye.accent), 0), Vec4f::from(srgb_to_linear(dye.back), 0.68F)};
}

Result<std::vector<gpu::Buffer<WeaveParams>>> create_weaves(gpu::Device& device,
                                                            const std::vector<ClothRange>& ranges) {
  std::vector<gpu::Buffer<WeaveParams>> weaves;
  for (const ClothRange& range : ranges) {
    const WeaveParams params = weave_of(range, weaves.size());
    WEFT_TRY(weave, gpu::create_uniform(device, params, "weave"));
    weaves.push_back(std::move(weave));
  }
  return weaves;
}

Result<ClothSurface> ClothSurface::create(gpu::Device& device, const Look& look,
                                          const gpu::Buffer<FrameParams>& frame, const ShadowMap& shadow,
                                          std::span<const gpu::Buffer<WeaveParams>> weaves,
                                          const ClothDraw& cloth) {
  ClothSurface made;
  gpu::RenderPipelineInfo info = picture_pipeline(look);
  info.fragment_entry = entry_of(look.view);
  WEFT_TRY(pipeline, gpu::RenderPipeline::create(device, "render/cloth.wgsl", info));
  made.pipeline_ = std::move(pipeline);
  made.index_buffer_ = cloth.triangles->id();
  for (const ClothRange& range : cloth.ranges) {
    const gpu::Buffer<WeaveParams>& weave = weaves[made.parts_.size()];
    Part part;
    for (std::size_t parity = 0; parity < 2; ++parity) {
      WEFT_TRY(group,
               made.pipeline_.bind({frame, shadow.texture(), shadow.sampler(), weave, *cloth.position[parity],
                                    *cloth.normal, *cloth.uv, field_buffer(cloth, look.view, parity)}));
      part.groups[parity] = std::move(group);
    }
    part.first_index = 3 * range.first_triangle;
    part.index_count = 3 * range.triangle_count;
    made.parts_.push_back(std::move(part));
  }
  return made;
}

void ClothSurface::record(gpu::RenderPass& pass, std::uint32_t parity) const {
  for (const Part& part : parts_)
    pass.draw_indexed(pipeline_.id(), part.groups[parity].id(), index_buffer_, part.index_count,
                      part.first_index);
}

}  // namespace weft::render
