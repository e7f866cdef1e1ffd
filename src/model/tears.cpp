#include "model/tears.hpp"

#include <algorithm>

#include "model/cloth_size.hpp"

namespace weft {
namespace {

/// The whole cloth's node that a node is a part of.
std::uint32_t origin_of(const Tears::OfCloth& tears, const Body& body, std::uint32_t node) {
  return node < body.vertex_count ? node : tears.origin[node - body.vertex_count];
}

Result<void> check_tears(const Model& whole, const Body& body, std::size_t number,
                         const Tears::OfCloth& tears) {
  const auto other = [&] {
    return input_error("The tears of cloth %zu are not those of its %u nodes and %u triangles.", number,
                       body.vertex_count, body.triangle_count);
  };
  if (tears.triangles.empty()) return tears.origin.empty() ? Result<void>() : other();
  if (!body.strength || tears.triangles.size() != body.triangle_count ||
      tears.origin.size() > 3 * std::size_t{body.triangle_count})
    return other();
  for (const std::uint32_t origin : tears.origin)
    if (origin >= body.vertex_count) return other();
  const std::vector<mesh::Triangle> triangles = own_triangles(whole, body);
  const std::size_t nodes = body.vertex_count + tears.origin.size();
  std::vector<bool> used(nodes);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t node = tears.triangles[t][corner];
      if (node >= nodes || origin_of(tears, body, node) != triangles[t][corner]) return other();
      used[node] = true;
    }
  for (std::size_t node = body.vertex_count; node < nodes; ++node)
    if (!used[node]) return other();
  return {};
}

/// The masses of a torn cloth's nodes [kg]. A node that is whole keeps its own, to the bit.
std::vector<double> masses_of(const Model& whole, const Body& body, const Tears::OfCloth& tears) {
  const std::size_t nodes = body.vertex_count + tears.origin.size();
  std::vector<double> area(nodes), area_whole(body.vertex_count);
  for (std::size_t t = 0; t < tears.triangles.size(); ++t) {
    const double size = area_of(whole, whole.triangles[body.first_triangle + t]);
    for (const std::uint32_t node : tears.triangles[t]) {
      area[node] += size;
      area_whole[origin_of(tears, body, node)] += size;
    }
  }
  std::vector<bool> parted(body.vertex_count);
  for (const std::uint32_t origin : tears.origin) parted[origin] = true;
  std::vector<double> masses;
  for (std::uint32_t node = 0; node < nodes; ++node) {
    const std::uint32_t origin = origin_of(tears, body, node);
    const double mass = whole.mass[body.first_vertex + origin];
    masses.push_back(parted[origin] ? mass * area[node] / area_whole[origin] : mass);
  }
  return masses;
}

}  // namespace

std::size_t Tears::splits() const {
  std::size_t sum = 0;
  for (const OfCloth& cloth : cloths) sum += cloth.origin.size();
  return sum;
}

Result<Model> torn_model(const Model& whole, const Tears& tears) {
  if (tears.cloths.empty()) return whole;
  if (tears.cloths.size() != whole.bodies.size())
    return input_error("There are tears of %zu cloths and bodies; the scene has %zu.", tears.cloths.size(),
                       whole.bodies.size());
  Model torn;
  torn.motions = whole.motions;
  for (std::size_t c = 0; c < whole.bodies.size(); ++c) {
    const Body& old = whole.bodies[c];
    const Tears::OfCloth& own = tears.cloths[c];
    WEFT_CHECK(check_tears(whole, old, c, own));
    Body body = old;
    body.first_vertex = static_cast<std::uint32_t>(torn.rest_position.size());
    const std::vector<mesh::Triangle> triangles = own_triangles(whole, old);
    if (!own.triangles.empty()) {
      body.vertex_count += static_cast<std::uint32_t>(own.origin.size());
      body.whole = triangles;
    }
    const std::vector<double> masses =
        own.triangles.empty() ? std::vector<double>() : masses_of(whole, old, own);
    for (std::uint32_t node = 0; node < body.vertex_count; ++node) {
      const std::size_t from = old.first_vertex + origin_of(own, old, node);
      torn.rest_position.push_back(whole.rest_position[from]);
      torn.start_position.push_back(whole.start_position[from]);
      torn.uv.push_back(whole.uv[from]);
      torn.motion.push_back(whole.motion[from]);
      torn.mass.push_back(masses.empty() ? whole.mass[from] : masses[node]);
    }
    for (mesh::Triangle t : own.triangles.empty() ? triangles : own.triangles) {
      for (std::uint32_t& node : t) node += body.first_vertex;
      torn.triangles.push_back(t);
    }
    for (NodeGrab grab : whole.grabs)
      if (grab.node >= old.first_vertex && grab.node < old.first_vertex + old.vertex_count) {
        grab.node += body.first_vertex - old.first_vertex;
        torn.grabs.push_back(std::move(grab));
      }
    torn.bodies.push_back(std::move(body));
  }
  return torn;
}

bool can_tear(const scene::Scene& scene) {
  return std::any_of(scene.cloths.begin(), scene.cloths.end(),
                     [](const scene::Cloth& cloth) { return cloth.strength.has_value(); });
}

Result<void> check_whole(const scene::Scene& scene) {
  for (const scene::Cloth& cloth : scene.cloths)
    if (cloth.strength)
      return input_error(
          "%s.strength is %g N/m, and cloth tears on a GPU only, not in the reference on the processor.",
          cloth.where.c_str(), *cloth.strength);
  return {};
}

}  // namespace weft
