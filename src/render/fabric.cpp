#include "render/fabric.hpp"

#include <algorithm>
#include <cmath>

#include "render/color_map.hpp"

namespace weft::render {
namespace {

using scene::Pattern, scene::Weave;

constexpr double kPeriodsPerSheet = 5;
constexpr double kThreadsPerSheet =
    150;                            // where a look says none: coarser than real cloth, so that some are seen
constexpr double kMostHem = 0.012;  // [m]
constexpr double kHemPart = 0.03;   // of the shorter side

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

struct Crossings {
  std::uint32_t period = 2, shift = 1;
  double along = 0.32, across = 0.55;  // roughness of the threads
};
Crossings crossings_of(Weave weave) {
  switch (weave) {
    case Weave::Plain:
      return {};
    case Weave::Twill:
      return {4, 1, 0.30, 0.55};
    case Weave::Satin:
      return {5, 2, 0.16, 0.42};
    case Weave::Knit:
      return {2, 1, 0.55, 0.60};
    case Weave::None:
      break;
  }
  return {2, 1, 0.35, 0.35};
}

}  // namespace

FabricParams fabric_of(const ClothRange& range, std::size_t index) {
  const scene::Look& look = range.look;
  const auto linear = [](const Vec3f& color, double w) {
    return Vec4f::from(srgb_to_linear(color), static_cast<float>(w));
  };
  const bool own = range.color || look.warp;
  const Dye dye = own ? dye_of((range.color ? *range.color : *look.warp).to<float>())
                      : kPalette[index % std::size(kPalette)];
  const Weave weave = range.woven ? look.weave : Weave::None;
  const Pattern pattern = range.woven ? look.pattern : Pattern::Plain;
  const Crossings crossings = crossings_of(weave);
  const double pitch =
      look.threads_per_cm > 0 ? 0.01 / look.threads_per_cm : range.sheet_size / kThreadsPerSheet;
  const Vec3f weft = look.weft ? look.weft->to<float>() : dye.base;
  const bool two_sided = pattern == Pattern::Check && !look.weft;
  const bool hemmed = range.rim && weave != Weave::None;
  const std::array<double, 2> rim = range.rim.value_or(std::array<double, 2>{});
  const double hem = hemmed ? std::min(kMostHem, kHemPart * std::min(rim[0], rim[1])) : 0;
  // Of even light, what gloss sends back at a slant; its bound over roughness is by quadrature (reflection.wgsl).
  const double grazing = 0.3 * std::pow(0.26 / std::sqrt(crossings.along * crossings.across), 1.3);
  const bool spun = weave != Weave::None && look.threads_per_cm > 0;

  FabricParams params;
  params.tint = linear((range.color ? dye : kPalette[index % std::size(kPalette)]).base, look.gloss);
  params.warp = linear(dye.base, pitch);
  params.weft = linear(weft, range.sheet_size / kPeriodsPerSheet);
  params.stripe = linear(look.stripe ? look.stripe->to<float>() : dye.dark, look.sheen);
  params.accent = linear(dye.accent, look.translucency);
  params.back = linear(dye.back, two_sided ? 0.68 : 0);
  params.rim = {static_cast<float>(rim[0]), static_cast<float>(rim[1]), static_cast<float>(hem),
                look.threads_per_cm > 0 ? 0.8F : 0.45F};
  params.gloss = {static_cast<float>(crossings.along), static_cast<float>(crossings.across),
                  static_cast<float>(grazing), spun ? static_cast<float>(0.16 * (1 - look.gloss)) : 0.0F};
  params.weave = static_cast<std::uint32_t>(weave);
  params.pattern = static_cast<std::uint32_t>(pattern);
  params.period = crossings.period;
  params.shift = crossings.shift;
  return params;
}

Vec3f color_of(const scene::Look& look, std::size_t index) {
  return look.warp ? look.warp->to<float>() : kPalette[index % std::size(kPalette)].base;
}

Result<std::vector<gpu::Buffer<FabricParams>>> create_fabrics(gpu::Device& device,
                                                              const std::vector<ClothRange>& ranges) {
  std::vector<gpu::Buffer<FabricParams>> fabrics;
  for (const ClothRange& range : ranges) {
    WEFT_TRY(fabric, gpu::create_uniform(device, fabric_of(range, fabrics.size()), "fabric"));
    fabrics.push_back(std::move(fabric));
  }
  return fabrics;
}

}  // namespace weft::render
