#include "model/elements.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "element/membrane/build.hpp"
#include "element/triple/triple.hpp"
#include "model/fabric.hpp"
#include "model/model.hpp"
#include "model/solid.hpp"

namespace weft {
namespace {

void append_threads(ElementTable& springs, const Body& body) {
  for (const Thread& thread : body.pattern->threads)
    append(springs, Spring{body.first_vertex + thread.a, body.first_vertex + thread.b, 0,
                           static_cast<float>(thread.stiffness), static_cast<float>(thread.damping)});
}

/// The springs of what is sewn, and the threads that pull at what is not yet.
ElementTable sewn_springs(const Model& model, const Body& body) {
  mesh::TriangleMesh pattern{{}, body.pattern->triangles};
  for (const Vec3d& place : body.pattern->position) pattern.positions.push_back(place.to<float>());
  ElementTable table =
      build_sewn_springs(pattern, own_triangles(model, body), body.material(), body.first_vertex);
  append_threads(table, body);
  return table;
}

ElementTable build(const Model& model, ElementKind kind, const Body& body) {
  const std::uint32_t first = body.first_vertex;
  if (body.solid) {
    if (kind == ElementKind::Tet) return tet::build_tets(body_tets(model, body), first);
    return {kind, {}, {}, {}};
  }
  if (body.fabric) {
    if (kind == ElementKind::Membrane)
      return membrane::build_membranes(fabric_sheet(model, body).rest(), membrane_law(*body.fabric), first);
    if (kind == ElementKind::Hinge) return hinge_table(model.plate(body), first);
    ElementTable table{kind, {}, {}, {}};
    if (kind == ElementKind::Spring && body.pattern) append_threads(table, body);
    return table;
  }
  if (kind == ElementKind::Spring && body.pattern) return sewn_springs(model, body);
  if (kind == ElementKind::Spring && !body.whole.empty()) {
    mesh::TriangleMesh mesh = cloth_mesh(model, body);
    const std::vector<mesh::Triangle> torn = std::exchange(mesh.triangles, body.whole);
    return build_springs(mesh, torn, body.material(), first);
  }
  if (kind == ElementKind::Spring)
    return body.grid ? build_springs(*body.grid, body.material(), first)
                     : build_springs(cloth_mesh(model, body), body.material(), first);
  if (kind == ElementKind::Triple && body.grid)
    return build_triples(*body.grid, body.stiffness.bending, body.weights, first);
  return {kind, {}, {}, {}};
}

}  // namespace

std::size_t Model::number_of(const Body& body) const {
  const auto number = static_cast<std::size_t>(&body - bodies.data());
  assert(number < bodies.size());  // a body of this model, not a copy of one
  return number;
}

std::uint64_t Model::count(ElementKind kind, const Body& body) const {
  if (body.solid) return kind == ElementKind::Tet ? body.tets.size() : 0;
  if (body.fabric) return elements(kind, body).size();
  if (kind == ElementKind::Spring && body.grid) return mesh::grid_spring_count(*body.grid);
  if (kind == ElementKind::Triple && body.grid) return triple_count(*body.grid, body.stiffness.bending);
  return elements(kind, body).size();
}

std::uint64_t Model::count(ElementKind kind) const {
  std::uint64_t sum = 0;
  for (const Body& body : bodies) sum += count(kind, body);
  return sum;
}

const ElementTable& Model::elements(ElementKind kind, const Body& body) const {
  auto& tables = store_.of(kind).bodies;
  tables.resize(bodies.size());
  auto& table = tables[number_of(body)];
  if (!table) table = std::make_unique<const ElementTable>(build(*this, kind, body));
  return *table;
}

const ElementTable& Model::elements(ElementKind kind) const {
  if (bodies.size() == 1) return elements(kind, bodies[0]);
  auto& joined = store_.of(kind).joined;
  if (joined) return *joined;
  ElementTable all{kind, {}, {}, {}};
  for (const Body& body : bodies) {
    const ElementTable& part = elements(kind, body);
    all.nodes.insert(all.nodes.end(), part.nodes.begin(), part.nodes.end());
    all.rest.insert(all.rest.end(), part.rest.begin(), part.rest.end());
    all.material.insert(all.material.end(), part.material.begin(), part.material.end());
  }
  joined = std::make_unique<const ElementTable>(std::move(all));
  return *joined;
}

const hinge::Plate& Model::plate(const Body& body) const {
  auto& plates = store_.plates();
  plates.resize(bodies.size());
  auto& made = plates[number_of(body)];
  if (!made) {
    hinge::Plate plate = hinge::build_plate(fabric_sheet(*this, body).rest(), bending_law(*body.fabric));
    if (body.fabric->rest_angles == scene::RestAngles::Flat)
      for (hinge::Hinge& hinge : plate.hinges) hinge.rest_angle = 0;
    made = std::make_unique<const hinge::Plate>(std::move(plate));
  }
  return *made;
}

std::uint64_t Model::sliver_count() const {
  std::uint64_t sum = 0;
  for (const Body& body : bodies) {
    if (!body.fabric) continue;
    const std::vector<hinge::Facet>& facets = plate(body).facets;
    sum += static_cast<std::uint64_t>(
        std::count_if(facets.begin(), facets.end(), [](const hinge::Facet& facet) { return facet.sliver; }));
  }
  return sum;
}

const mesh::Adjacency& Model::incidence(ElementKind kind, const Body& body) const {
  auto& made = store_.of(kind).incidence;
  made.resize(bodies.size());
  auto& rows = made[number_of(body)];
  if (!rows)
    rows = std::make_unique<const mesh::Adjacency>(
        weft::incidence(elements(kind, body), body.first_vertex, body.vertex_count));
  return *rows;
}

const Colors& Model::colors(ElementKind kind) const {
  auto& made = store_.of(kind).colors;
  if (!made) made = std::make_unique<const Colors>(color_elements(elements(kind), vertex_count()));
  return *made;
}

}  // namespace weft
