#include "sim/probe.hpp"

#include <algorithm>

#include "model/cloth_size.hpp"
#include "model/tension.hpp"

namespace weft::sim {
namespace {

bool has(const Body& body, std::uint32_t node) {
  return node - body.first_vertex < body.vertex_count;  // of one below the first it is more
}

/// Of the springs at a node, half of what they bear, times their lengths at rest [N·m].
Mat3 borne_by_springs(const Springs& springs, std::span<const Vec3d> position, std::uint32_t node) {
  Mat3 sum{};
  for (const Spring& spring : springs) {
    if (spring.node_a != node && spring.node_b != node) continue;
    const Vec3d span = position[spring.node_b] - position[spring.node_a];
    const double now = length(span);
    if (!(now > 0)) continue;
    const double force = spring.stiffness * (now - spring.rest_length);
    sum += force * spring.rest_length / (2 * now * now) * Mat3::outer(span, span);
  }
  return sum;
}

}  // namespace

Result<Probe> probe(const Model& model, const NodeState& state, std::uint32_t node) {
  if (node >= model.vertex_count())
    return Error{ErrorKind::Input, "There is no node " + std::to_string(node) + "; there are " +
                                       std::to_string(model.vertex_count()) + ", from 0."};
  std::vector<Vec3d> position;
  for (const Vec4f& one : state.position) position.push_back({one.x, one.y, one.z});
  const Vec4f& velocity = state.velocity[node];
  Probe found{
      position[node], model.rest_position[node], {velocity.x, velocity.y, velocity.z}, model.mass[node]};
  const Body& body = *std::find_if(model.bodies.begin(), model.bodies.end(),
                                   [&](const Body& one) { return has(one, node); });
  double stretch = 0;
  for (std::uint32_t k = body.first_triangle; k < body.first_triangle + body.triangle_count; ++k) {
    const mesh::Triangle& t = model.triangles[k];
    if (std::find(t.begin(), t.end(), node) == t.end()) continue;
    const std::array<Vec3d, 3> rest = rest_corners(model, body, k - body.first_triangle);
    for (std::size_t side = 0; side < 3; ++side) {
      const std::size_t next = (side + 1) % 3;
      if (t[side] != node && t[next] != node) continue;
      const double at_rest = length(rest[next] - rest[side]);
      if (at_rest > 0) stretch = std::max(stretch, length(position[t[next]] - position[t[side]]) / at_rest);
    }
  }
  if (stretch > 0) found.stretch = stretch;  // else it is in no triangle
  if (body.solid) return found;
  if (body.grid && !body.fabric) {
    const double area = area_of(model, body) * found.mass / mass_of(model, body);
    found.tension = largest_principal(1 / area * borne_by_springs(model.springs(body), position, node)).value;
  } else {
    found.tension = largest_principal(tensions(model, body, position)[node - body.first_vertex]).value;
  }
  return found;
}

}  // namespace weft::sim
