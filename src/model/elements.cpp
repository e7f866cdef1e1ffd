#include "model/elements.hpp"

#include <cassert>

#include "element/triple/triple.hpp"
#include "model/host_model.hpp"

namespace weft {
namespace {

ElementTable build(const HostModel& model, ElementKind kind, const ClothModel& cloth) {
  const std::uint32_t first = cloth.first_vertex;
  if (kind == ElementKind::Spring)
    return cloth.grid ? build_springs(*cloth.grid, cloth.material(), first)
                      : build_springs(cloth_mesh(model, cloth), cloth.material(), first);
  if (kind == ElementKind::Triple && cloth.grid)
    return build_triples(*cloth.grid, cloth.stiffness.bending, cloth.weights, first);
  return {kind, {}, {}, {}};
}

}  // namespace

std::size_t HostModel::number_of(const ClothModel& cloth) const {
  const auto number = static_cast<std::size_t>(&cloth - cloths.data());
  assert(number < cloths.size());  // a cloth of this model, not a copy of one
  return number;
}

std::uint64_t HostModel::count(ElementKind kind, const ClothModel& cloth) const {
  if (kind == ElementKind::Spring && cloth.grid) return mesh::grid_spring_count(*cloth.grid);
  if (kind == ElementKind::Triple && cloth.grid) return triple_count(*cloth.grid, cloth.stiffness.bending);
  return elements(kind, cloth).size();
}

std::uint64_t HostModel::count(ElementKind kind) const {
  std::uint64_t sum = 0;
  for (const ClothModel& cloth : cloths) sum += count(kind, cloth);
  return sum;
}

const ElementTable& HostModel::elements(ElementKind kind, const ClothModel& cloth) const {
  auto& tables = store_.of(kind).bodies;
  tables.resize(cloths.size());
  auto& table = tables[number_of(cloth)];
  if (!table) table = std::make_unique<const ElementTable>(build(*this, kind, cloth));
  return *table;
}

const ElementTable& HostModel::elements(ElementKind kind) const {
  if (cloths.size() == 1) return elements(kind, cloths[0]);
  auto& joined = store_.of(kind).joined;
  if (joined) return *joined;
  ElementTable all{kind, {}, {}, {}};
  for (const ClothModel& cloth : cloths) {
    const ElementTable& part = elements(kind, cloth);
    all.nodes.insert(all.nodes.end(), part.nodes.begin(), part.nodes.end());
    all.rest.insert(all.rest.end(), part.rest.begin(), part.rest.end());
    all.material.insert(all.material.end(), part.material.begin(), part.material.end());
  }
  joined = std::make_unique<const ElementTable>(std::move(all));
  return *joined;
}

const mesh::Adjacency& HostModel::incidence(ElementKind kind, const ClothModel& cloth) const {
  auto& made = store_.of(kind).incidence;
  made.resize(cloths.size());
  auto& rows = made[number_of(cloth)];
  if (!rows)
    rows = std::make_unique<const mesh::Adjacency>(
        weft::incidence(elements(kind, cloth), cloth.first_vertex, cloth.vertex_count));
  return *rows;
}

const Colors& HostModel::colors(ElementKind kind) const {
  auto& made = store_.of(kind).colors;
  if (!made) made = std::make_unique<const Colors>(color_elements(elements(kind), vertex_count()));
  return *made;
}

}  // namespace weft
