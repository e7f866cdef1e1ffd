// How cloth looks, by name: weaves, colours of yarns and how they take light. The whole table is here; scenes and their
// schema read it. The numbers are by eye, not measured.
#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "scene/scene.hpp"

namespace weft::scene {

struct NamedLook {
  const char* name;
  Weave weave;
  Pattern pattern;
  double threads_per_cm;            // 0: 150 over the sheet, coarser than real cloth, so that they are seen
  std::optional<Vec3d> warp, weft;  // sRGB; none: the renderer's, and as the warp
  double sheen, gloss, translucency;
};

inline constexpr NamedLook kLooks[] = {
    {"woven", Weave::Plain, Pattern::Check, 0, {}, {}, 0.35, 0.25, 0.12},
    {"cotton", Weave::Plain, Pattern::Plain, 28, Vec3d{0.86, 0.84, 0.80}, {}, 0.35, 0.2, 0.15},
    {"canvas", Weave::Plain, Pattern::Plain, 11, Vec3d{0.82, 0.77, 0.66}, {}, 0.25, 0.15, 0.08},
    {"linen", Weave::Plain, Pattern::Plain, 16, Vec3d{0.80, 0.74, 0.63}, Vec3d{0.74, 0.68, 0.57}, 0.25, 0.3,
     0.18},
    {"denim", Weave::Twill, Pattern::Plain, 24, Vec3d{0.13, 0.19, 0.36}, Vec3d{0.56, 0.58, 0.61}, 0.3, 0.1,
     0.03},
    {"gabardine", Weave::Twill, Pattern::Plain, 32, Vec3d{0.42, 0.40, 0.36}, {}, 0.3, 0.3, 0.05},
    {"silk", Weave::Satin, Pattern::Plain, 60, Vec3d{0.72, 0.15, 0.20}, {}, 0.15, 1, 0.10},
    {"taffeta", Weave::Plain, Pattern::Plain, 45, Vec3d{0.22, 0.38, 0.46}, Vec3d{0.30, 0.30, 0.52}, 0.1, 0.8,
     0.06},
    {"chiffon", Weave::Plain, Pattern::Plain, 40, Vec3d{0.90, 0.78, 0.74}, {}, 0.2, 0.3, 0.55},
    {"wool", Weave::Twill, Pattern::Plain, 14, Vec3d{0.46, 0.36, 0.30}, Vec3d{0.40, 0.31, 0.26}, 0.9, 0.05,
     0.04},
    {"velvet", Weave::None, Pattern::Plain, 30, Vec3d{0.30, 0.06, 0.14}, {}, 1, 0, 0},
    {"jersey", Weave::Knit, Pattern::Plain, 14, Vec3d{0.36, 0.48, 0.60}, {}, 0.5, 0.1, 0.10},
    {"sweater", Weave::Knit, Pattern::Plain, 4, Vec3d{0.72, 0.46, 0.32}, {}, 0.8, 0.05, 0.05},
    {"paper", Weave::None, Pattern::Plain, 30, Vec3d{0.95, 0.94, 0.90}, {}, 0, 0.1, 0.15},
    {"rubber", Weave::None, Pattern::Plain, 30, {}, {}, 0, 0.7, 0.05},
};

/// Their names, in the same order.
inline constexpr auto kLookNames = [] {
  std::array<const char*, std::size(kLooks)> names{};
  for (std::size_t k = 0; k < names.size(); ++k) names[k] = kLooks[k].name;
  return names;
}();

/// The look of this name, which the table must have.
Look look_of(std::string_view name);
/// What a cloth of a fabric of this name looks like by default; "woven" where there is no such fabric.
const char* look_of_fabric(std::string_view fabric);

}  // namespace weft::scene
