#include "model/model.hpp"

#include <algorithm>

#include "element/triple/triple.hpp"
#include "mesh/lumped.hpp"
#include "model/enclosed.hpp"
#include "scene/select.hpp"

namespace weft {
namespace {

/// A body before it is appended to the model. Where its mass comes from is its own matter: that of a cloth from its
/// triangles, so that each of its vertices needs one; that of a body with volume from its tetrahedra.
struct PlacedBody {
  std::vector<Vec3d> positions, starts;  // [m]
  std::vector<mesh::Triangle> triangles;
  std::vector<std::array<float, 2>> uv;  // [m]
  std::vector<double> mass;              // [kg]
};

/// Errors  Input: a vertex has no area.
Result<std::vector<double>> cloth_masses(const scene::Cloth& cloth, const std::vector<double>& areas) {
  if (auto checked = mesh::check_vertex_areas(areas); !checked)
    return checked.error().while_doing("building " + cloth.where);
  std::vector<double> masses;
  masses.reserve(areas.size());
  for (const double area : areas)
    masses.push_back(cloth.node_mass ? *cloth.node_mass : *cloth.density * area);
  return masses;
}

/// A membrane has strains of its triangle at rest. Errors  Input: a triangle's corners lie on a line.
Result<void> check_membranes(const scene::Cloth& cloth, const PlacedBody& placed) {
  for (std::size_t t = 0; t < placed.triangles.size(); ++t) {
    const auto& [a, b, c] = placed.triangles[t];
    const std::vector<Vec3d>& x = placed.positions;
    if (length(cross(x[b] - x[a], x[c] - x[a])) > 0) continue;
    return input_error("%s.fabric: triangle %zu of the mesh has no area, so it has no strain.",
                       cloth.where.c_str(), t);
  }
  return {};
}

PlacedBody place_grid(const scene::Cloth& cloth, const mesh::Grid& grid) {
  PlacedBody placed;
  placed.positions = scene::grid_positions(*cloth.grid, cloth.transform);
  placed.starts = scene::grid_start_positions(*cloth.grid, cloth.transform);
  placed.triangles = mesh::grid_triangles(grid);
  for (std::uint32_t j = 0; j < grid.ny; ++j)
    for (std::uint32_t i = 0; i < grid.nx; ++i) {
      const mesh::RestPoint point = mesh::rest_point(grid, i, j);
      placed.uv.push_back({static_cast<float>(point.x), static_cast<float>(point.y)});
    }
  return placed;
}

/// A mesh has no sheet coordinates: the two axes along which it is largest serve.
PlacedBody place_mesh(const mesh::TriangleMesh& mesh) {
  PlacedBody placed;
  placed.triangles = mesh.triangles;
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

/// Its nodes are rounded to f32 once they are placed, so that on the GPU a body begins at rest.
/// Errors  Input: a tetrahedron has no volume.
Result<PlacedBody> place_solid(const scene::Cloth& cloth, const mesh::TetMesh& mesh) {
  const auto& [scale, rotate, translate] = cloth.transform;
  mesh::TriangleMesh surface{mesh.positions, mesh::boundary(mesh.tets)};
  PlacedBody placed = place_mesh(mesh::transformed(surface, scale, rotate, translate));
  placed.mass.assign(placed.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    const std::vector<Vec3d>& x = placed.positions;
    const double volume = mesh::six_volumes({x[a], x[b], x[c], x[d]}) / 6;
    if (!(volume > 0))
      return input_error("%s: tetrahedron %zu has a volume of %g m³ where it is placed; it has no strain.",
                         cloth.where.c_str(), t, volume);
    for (const std::uint32_t node : mesh.tets[t]) placed.mass[node] += *cloth.density * volume / 4;
  }
  return placed;
}

void append(Model& model, const scene::Cloth& cloth, const PlacedBody& placed, Body body) {
  body.first_vertex = static_cast<std::uint32_t>(model.vertex_count());
  body.vertex_count = static_cast<std::uint32_t>(placed.positions.size());
  body.first_triangle = static_cast<std::uint32_t>(model.triangles.size());
  body.triangle_count = static_cast<std::uint32_t>(placed.triangles.size());
  body.weights = cloth.node_mass ? mesh::BoundaryWeights::Uniform : mesh::BoundaryWeights::Area;
  body.stiffness = cloth.stiffness;
  body.damping = cloth.damping;
  body.strain_limit = cloth.strain_limit;
  if (cloth.tethers) body.slack = cloth.tethers->slack;
  body.fabric = cloth.fabric;
  body.strength = cloth.strength;
  body.solid = cloth.solid;
  if (cloth.fabric)
    body.warp = cloth.grid ? placed.positions[1] - placed.positions[0]
                           : scene::transformed(cloth.transform, cloth.fabric->warp_direction) -
                                 scene::transformed(cloth.transform, {});
  body.color = cloth.color;
  body.look = cloth.look;
  model.rest_position.insert(model.rest_position.end(), placed.positions.begin(), placed.positions.end());
  model.start_position.insert(model.start_position.end(), placed.starts.begin(), placed.starts.end());
  model.uv.insert(model.uv.end(), placed.uv.begin(), placed.uv.end());
  model.motion.resize(model.vertex_count(), 0);
  model.mass.insert(model.mass.end(), placed.mass.begin(), placed.mass.end());
  for (mesh::Triangle triangle : placed.triangles) {
    for (std::uint32_t& vertex : triangle) vertex += body.first_vertex;
    model.triangles.push_back(triangle);
  }
  model.bodies.push_back(std::move(body));
}

/// A motion of its own for each node that a program moves.
Result<void> append_given(Model& model, const scene::Motion& motion, std::span<const std::uint32_t> nodes,
                          std::uint32_t first) {
  std::size_t given = nodes.size();
  for (const scene::Motion& other : model.motions)
    given += std::holds_alternative<scene::MotionGiven>(other.shape) ? 1 : 0;
  if (given > kMostGivenNodes)
    return make_error(ErrorKind::Limit, "%s: a program may move %zu nodes of a scene, not %zu.",
                      motion.where.c_str(), kMostGivenNodes, given);
  for (const std::uint32_t node : nodes) {
    model.motions.push_back({motion.where, {}, motion.shape});
    model.motion[first + node] = 1 + static_cast<std::uint32_t>(model.motions.size());
  }
  return {};
}

/// Finds the one free node of each of the cloth's grabs.
Result<void> append_grabs(Model& model, const scene::Cloth& cloth, const scene::Selection& selection,
                          std::uint32_t first) {
  const auto own = static_cast<std::ptrdiff_t>(model.grabs.size());
  for (const scene::Grab& grab : cloth.grabs) {
    WEFT_TRY(nodes, scene::select_nodes(grab.node, selection));
    if (nodes.size() != 1)
      return input_error("%s selects %zu nodes; a grab holds exactly one.", grab.node.where.c_str(),
                         nodes.size());
    const std::uint32_t node = first + nodes[0];
    if (model.kinematic(node))
      return input_error("%s selects node %u, which is %s; a grab holds a free node.",
                         grab.node.where.c_str(), nodes[0], model.motion[node] == 1 ? "pinned" : "moved");
    const auto other = std::find_if(model.grabs.begin() + own, model.grabs.end(), [&](const NodeGrab& one) {
      return one.node == node && scene::overlap(one.grab, grab);
    });
    if (other != model.grabs.end())
      return input_error("%s holds node %u, which %s holds at the same time.", grab.where.c_str(), nodes[0],
                         other->grab.where.c_str());
    model.grabs.push_back({node, grab});
  }
  return {};
}

}  // namespace

Result<Model> build_model(const scene::Scene& scene, const std::vector<mesh::TriangleMesh>& cloth_meshes,
                          std::span<const mesh::TetMesh> solids) {
  Model model;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    Body body;
    PlacedBody placed;
    mesh::Grid grid;
    scene::Selection selection;
    if (cloth.solid) {
      mesh::TetMesh block;
      if (cloth.solid->block) block = mesh::block(cloth.solid->block->cells, cloth.solid->block->size);
      const mesh::TetMesh& mesh = cloth.solid->block ? block : solids[c];
      WEFT_SET(placed, place_solid(cloth, mesh));
      body.tets = mesh.tets;
    } else if (cloth.grid) {
      const double scale = cloth.transform.scale;
      grid =
          mesh::Grid{cloth.grid->nx, cloth.grid->ny, cloth.grid->width * scale, cloth.grid->height * scale};
      if (!cloth.strength && cloth.seams.empty())
        body.grid = grid;  // what tears or is sewn is a mesh from the first frame on: no law changes then
      placed = place_grid(cloth, grid);
      selection.nx = grid.nx;
      selection.ny = grid.ny;
    } else {
      placed = place_mesh(cloth_meshes[c]);
    }
    if (!cloth.solid)
      WEFT_SET(placed.mass, cloth_masses(cloth, cloth.grid ? mesh::vertex_areas(grid)
                                                           : mesh::vertex_areas(cloth_meshes[c])));
    if (cloth.fabric) WEFT_CHECK(check_membranes(cloth, placed));
    if (cloth.pressure) WEFT_SET(body.gas, enclosed_gas(cloth, placed.triangles, placed.positions));
    selection.positions = placed.positions;
    WEFT_TRY(kinematic, scene::kinematic_nodes(cloth, selection));
    append(model, cloth, placed, body);
    const std::uint32_t first = model.bodies.back().first_vertex;
    for (const std::uint32_t node : kinematic.pins) model.motion[first + node] = 1;
    for (std::size_t m = 0; m < kinematic.motions.size(); ++m) {
      if (std::holds_alternative<scene::MotionGiven>(cloth.motions[m].shape)) {
        WEFT_CHECK(append_given(model, cloth.motions[m], kinematic.motions[m], first));
        continue;
      }
      model.motions.push_back(cloth.motions[m]);
      for (const std::uint32_t node : kinematic.motions[m])
        model.motion[first + node] = 1 + static_cast<std::uint32_t>(model.motions.size());
    }
    WEFT_CHECK(append_grabs(model, cloth, selection, first));
  }
  for (std::size_t node = 0; node < model.vertex_count();
       ++node)  // kinematic nodes stay in the sheet's plane
    if (model.kinematic(node)) model.start_position[node] = model.rest_position[node];
  return model;
}

std::array<Vec3d, 3> rest_corners(const Model& model, const Body& body, std::uint32_t triangle) {
  std::array<Vec3d, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = body.pattern ? body.pattern->position[body.pattern->triangles[triangle][k]]
                              : model.rest_position[model.triangles[body.first_triangle + triangle][k]];
  return corners;
}

std::vector<mesh::Triangle> own_triangles(const Model& model, const Body& body) {
  const auto first = model.triangles.begin() + body.first_triangle;
  std::vector<mesh::Triangle> triangles(first, first + body.triangle_count);
  for (mesh::Triangle& triangle : triangles)
    for (std::uint32_t& vertex : triangle) vertex -= body.first_vertex;
  return triangles;
}

mesh::TriangleMesh cloth_mesh(const Model& model, const Body& body) {
  mesh::TriangleMesh mesh;
  for (std::uint32_t v = 0; v < body.vertex_count; ++v)
    mesh.positions.push_back(model.rest_position[body.first_vertex + v].to<float>());
  mesh.triangles = own_triangles(model, body);
  return mesh;
}

std::array<double, 2> bending_stiffness(const Body& body) {
  if (!body.grid) return {};
  return triple_stiffness(*body.grid, body.stiffness.bending);
}

}  // namespace weft
