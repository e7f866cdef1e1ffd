#include "scene/fabrics.hpp"

#include <algorithm>

namespace weft::scene {

const NamedFabric* find_fabric(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kFabrics), std::end(kFabrics),
                                         [&](const NamedFabric& fabric) { return fabric.name == name; });
  return found == std::end(kFabrics) ? nullptr : found;
}

Fabric moduli_of(const NamedFabric& fabric) {
  Fabric made;
  made.name = fabric.name;
  made.warp = fabric.warp.value;
  made.weft = fabric.weft.value;
  made.shear = fabric.shear.value;
  made.poisson = fabric.poisson.value;
  made.bending_warp = fabric.bending_warp.value;
  made.bending_weft = fabric.bending_weft.value;
  made.bending_twist = fabric.bending_twist.value;
  return made;
}

}  // namespace weft::scene
