#include "scene/looks.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace weft::scene {
namespace {

constexpr std::pair<std::string_view, const char*> kOfFabrics[] = {
    {"denim_11oz", "denim"},
    {"ponte_roma", "jersey"},
    {"interlock", "jersey"},
    {"rib_knit", "jersey"},
    {"sweater_knit", "sweater"},
    {"blanket", "wool"},
    {"trousers", "gabardine"},
    {"jacket", "taffeta"},
    {"tablecloth", "cotton"},
    {"swimsuit", "jersey"},
    {"cotton_broad", "cotton"},
    {"wool_tropical", "wool"},
    {"polyester_tropical", "gabardine"},
    {"polyester_faille", "taffeta"},
};

}  // namespace

Look look_of(std::string_view name) {
  const NamedLook* found = std::find_if(std::begin(kLooks), std::end(kLooks),
                                        [&](const NamedLook& look) { return look.name == name; });
  assert(found != std::end(kLooks));
  return {found->name, found->weave, found->pattern, found->threads_per_cm, found->warp,
          found->weft, std::nullopt, found->sheen,   found->gloss,          found->translucency};
}

const char* look_of_fabric(std::string_view fabric) {
  for (const auto& [name, look] : kOfFabrics)
    if (name == fabric) return look;
  return kLooks[0].name;
}

}  // namespace weft::scene
