#include "model/host_model.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/lumped.hpp"
#include "scene/select.hpp"

namespace weft {
namespace {

/// A cloth before it is appended to the model.
struct PlacedCloth {
  std::vector<Vec3d> positions, starts;  // [m]
  std::vector<mesh::Triangle> triangles;
  std::vector<std::array<float, 2>> uv;  // [m]
  std::vector<double> areas;             // [m²]
};

PlacedCloth place_grid(const scene::Cloth& cloth, const mesh::Grid& grid) {
  PlacedCloth placed;
  placed.positions = scene::grid_positions(*cloth.grid, cloth.transform);
  placed.starts = scene::grid_start_positions(*cloth.grid, cloth.transform);
  placed.triangles = mesh::grid_triangles(grid);
  placed.areas = mesh::vertex_areas(grid);
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const mesh::RestPoint point = mesh::rest_point(grid, i, j);
      placed.uv.push_back({static_cast<float>(point.x), static_cast<float>(point.y)});
    }
  return placed;
}

/// A mesh has no sheet coordinates: the two axes along which it is largest serve.
PlacedCloth place_mesh(const mesh::TriangleMesh& mesh) {
  PlacedCloth placed;
  placed.triangles = mesh.triangles;
  placed.areas = mesh::vertex_areas(mesh);
  const mesh::Bounds box = mesh::bounds(mesh);
  const Vec3f size = box.high - box.low;
  const int thin = size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2);
  for (const Vec3f& p : mesh.positions) {
    placed.positions.push_back(p.to<double>());
    placed.uv.push_back({p[thin == 0 ? 1 : 0] - box.low[thin == 0 ? 1 : 0],
                         p[thin == 2 ? 1 : 2] - box.low[thin == 2 ? 1 : 2]});
  }
  placed.starts = placed.positions;
  return placed;
}

void append(HostModel& model, const scene::Cloth& cloth, const PlacedCloth& placed, ClothModel part) {
  part.first_vertex = static_cast<std::uint32_t>(model.vertex_count());
  part.vertex_count = static_cast<std::uint32_t>(placed.positions.size());
  part.first_triangle = static_cast<std::uint32_t>(model.triangles.size());
  part.triangle_count = static_cast<std::uint32_t>(placed.triangles.size());
  part.weights = cloth.node_mass ? mesh::BoundaryWeights::Uniform : mesh::BoundaryWeights::Area;
  part.stiffness = cloth.stiffness;
  part.damping = cloth.damping;
  part.color = cloth.color;
  model.rest_position.insert(model.rest_position.end(), placed.positions.begin(), placed.positions.end());
  model.start_position.insert(model.start_position.end(), placed.starts.begin(), placed.starts.end());
  model.uv.insert(model.uv.end(), placed.uv.begin(), placed.uv.end());
  model.motion.resize(model.vertex_count(), 0);
  for (const double area : placed.areas)
    model.mass.push_back(cloth.node_mass ? *cloth.node_mass : *cloth.density * area);
  for (mesh::Triangle triangle : placed.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += part.first_vertex;
    model.triangles.push_back(triangle);
  }
  model.cloths.push_back(part);
}

/// Finds the one free node of each of the cloth's grabs.
Result<void> append_grabs(HostModel& model, const scene::Cloth& cloth, const scene::Selection& selection,
                          std::uint32_t first) {
  for (const scene::Grab& grab : cloth.grabs) {
    WEFT_TRY(nodes, scene::select_nodes(grab.node, selection));
    if (nodes.size() != 1)
      return input_error("%s selects %zu nodes; a grab holds exactly one.", grab.node.where.c_str(),
                         nodes.size());
    const std::uint32_t node = first + nodes[0];
    if (model.kinematic(node))
      return input_error("%s selects node %u, which is %s; a grab holds a free node.",
                         grab.node.where.c_str(), nodes[0], model.motion[node] == 1 ? "pinned" : "moved");
    for (const NodeGrab& other : model.grabs)
      if (other.node == node && scene::overlap(other.grab, grab))
        return input_error("%s holds node %u, which %s holds at the same time.", grab.where.c_str(), nodes[0],
                           other.grab.where.c_str());
    model.grabs.push_back({node, grab});
  }
  return {};
}

}  // namespace

Result<HostModel> build_model(const scene::Scene& scene,
                              const std::vector<mesh::TriangleMesh>& cloth_meshes) {
  HostModel model;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    ClothModel part;
    PlacedCloth placed;
    scene::Selection selection;
    if (cloth.grid) {
      const double scale = cloth.transform.scale;
      part.grid =
          mesh::Grid{cloth.grid->nx, cloth.grid->ny, cloth.grid->width * scale, cloth.grid->height * scale};
      placed = place_grid(cloth, *part.grid);
      selection.nx = part.grid->nx;
      selection.ny = part.grid->ny;
    } else {
      placed = place_mesh(cloth_meshes[c]);
    }
    if (auto areas = mesh::check_vertex_areas(placed.areas); !areas)
      return areas.error().while_doing("building " + cloth.where);
    selection.positions = placed.positions;
    WEFT_TRY(held, scene::held_nodes(cloth, selection));
    append(model, cloth, placed, part);
    const std::uint32_t first = model.cloths.back().first_vertex;
    for (const std::uint32_t node : held.pins) model.motion[first + node] = 1;
    for (std::size_t m = 0; m < held.motions.size(); ++m) {
      model.motions.push_back(cloth.motions[m]);
      for (const std::uint32_t node : held.motions[m])
        model.motion[first + node] = 1 + static_cast<std::uint32_t>(model.motions.size());
    }
    WEFT_CHECK(append_grabs(model, cloth, selection, first));
  }
  for (std::size_t node = 0; node < model.vertex_count(); ++node)  // what is held stays in the sheet's plane
    if (model.kinematic(node)) model.start_position[node] = model.rest_position[node];
  return model;
}

std::vector<Spring> build_springs(const HostModel& model, const ClothModel& cloth) {
  std::vector<mesh::MeshSpring> springs;
  if (cloth.grid) {
    springs = mesh::grid_springs(*cloth.grid, cloth.weights);
  } else {
    mesh::TriangleMesh mesh;
    for (std::uint32_t v = 0; v < cloth.vertex_count; ++v)
      mesh.positions.push_back(model.rest_position[cloth.first_vertex + v].to<float>());
    for (std::uint32_t t = 0; t < cloth.triangle_count; ++t) {
      mesh::Triangle triangle = model.triangles[cloth.first_triangle + t];
      for (std::uint32_t& vertex : triangle) vertex -= cloth.first_vertex;
      mesh.triangles.push_back(triangle);
    }
    springs = mesh::mesh_springs(mesh, cloth.weights);
  }
  std::vector<Spring> built;
  built.reserve(springs.size());
  for (const mesh::MeshSpring& spring : springs) {
    const double stiffness = spring.kind == mesh::SpringKind::Structural ? cloth.stiffness.structural
                             : spring.kind == mesh::SpringKind::Shear    ? cloth.stiffness.shear
                                                                         : cloth.stiffness.bend;
    built.push_back({cloth.first_vertex + spring.node_a, cloth.first_vertex + spring.node_b,
                     static_cast<float>(spring.rest_length), static_cast<float>(spring.weight * stiffness),
                     static_cast<float>(stiffness > 0 ? spring.weight * cloth.damping : 0)});
  }
  return built;
}

std::array<double, 2> bending_stiffness(const ClothModel& cloth) {
  if (!cloth.grid) return {};
  const double di = cloth.grid->width / (cloth.grid->nx - 1), dj = cloth.grid->height / (cloth.grid->ny - 1);
  const double bending = cloth.stiffness.bending;
  return {bending * dj / (di * di * di), bending * di / (dj * dj * dj)};
}

std::vector<BendTriple> build_bending(const ClothModel& cloth) {
  std::vector<BendTriple> triples;
  const auto [along_i, along_j] = bending_stiffness(cloth);
  if (!(along_i > 0)) return triples;
  const std::uint32_t nx = cloth.grid->nx, ny = cloth.grid->ny, first = cloth.first_vertex;
  const double rim = cloth.weights == mesh::BoundaryWeights::Uniform ? 1 : 0.5;
  for (std::uint32_t j = 0; j < ny; ++j)
    for (std::uint32_t i = 1; i + 1 < nx; ++i) {
      const std::uint32_t node = first + j * nx + i;
      triples.push_back({node - 1, node, node + 1, (j == 0 || j + 1 == ny ? rim : 1) * along_i});
    }
  for (std::uint32_t i = 0; i < nx; ++i)
    for (std::uint32_t j = 1; j + 1 < ny; ++j) {
      const std::uint32_t node = first + j * nx + i;
      triples.push_back({node - nx, node, node + nx, (i == 0 || i + 1 == nx ? rim : 1) * along_j});
    }
  return triples;
}

std::vector<Spring> build_springs(const HostModel& model) {
  std::vector<Spring> all;
  for (const ClothModel& cloth : model.cloths) {
    const std::vector<Spring> springs = build_springs(model, cloth);
    all.insert(all.end(), springs.begin(), springs.end());
  }
  return all;
}

}  // namespace weft
