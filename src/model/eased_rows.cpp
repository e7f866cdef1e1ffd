#include "model/eased_rows.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/sides.hpp"

namespace weft {
namespace {

using Row = std::vector<std::uint32_t>;

/// Of each node how far along the row it is, from 0 to 1.
std::vector<double> places_along(const LooseCloth& cloth, const Row& row) {
  std::vector<double> places{0};
  for (std::size_t k = 1; k < row.size(); ++k)
    places.push_back(places.back() + length(cloth.rest[row[k]] - cloth.rest[row[k - 1]]));
  const double all = places.back();
  for (double& place : places) place /= all;
  return places;
}

/// For each of few rising places, which one of many it meets: the nearest that leaves the others theirs.
std::vector<std::size_t> partners(const std::vector<double>& few, const std::vector<double>& many) {
  std::vector<std::size_t> met;
  for (std::size_t k = 0; k < few.size(); ++k) {
    const auto after =
        static_cast<std::size_t>(std::lower_bound(many.begin(), many.end(), few[k]) - many.begin());
    std::size_t at = std::min(after, many.size() - 1);
    if (at > 0 && few[k] - many[at - 1] < many[at] - few[k]) --at;
    const std::size_t least = met.empty() ? 0 : met.back() + 1;
    at = std::clamp(at, least, many.size() - (few.size() - k));
    if (k == 0) at = 0;
    if (k + 1 == few.size()) at = many.size() - 1;
    met.push_back(at);
  }
  return met;
}

template <class Value>
Value between(const Value& a, const Value& b, double part) {
  return (1 - part) * a + part * b;
}

std::uint32_t add_node(LooseCloth& cloth, std::uint32_t a, std::uint32_t b, double part) {
  cloth.rest.push_back(between(cloth.rest[a], cloth.rest[b], part));
  cloth.start.push_back(between(cloth.start[a], cloth.start[b], part));
  const auto near = static_cast<float>(1 - part), far = static_cast<float>(part);
  cloth.uv.push_back(
      {near * cloth.uv[a][0] + far * cloth.uv[b][0], near * cloth.uv[a][1] + far * cloth.uv[b][1]});
  cloth.mass.push_back(0);
  cloth.motion.push_back(0);
  return static_cast<std::uint32_t>(cloth.rest.size() - 1);
}

double area_of(const LooseCloth& cloth, const mesh::Triangle& t) {
  return length(cross(cloth.rest[t[1]] - cloth.rest[t[0]], cloth.rest[t[2]] - cloth.rest[t[0]])) / 2;
}

/// The triangle at a rim, and its corner there that is first.
struct RimEdge {
  std::size_t triangle = 0, corner = 0;
  bool found = false;
};
RimEdge rim_edge(const LooseCloth& cloth, std::uint32_t a, std::uint32_t b) {
  RimEdge edge;
  std::size_t sides = 0;
  for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = cloth.triangles[t][k], to = cloth.triangles[t][(k + 1) % 3];
      if (std::minmax({from, to}) != std::minmax({a, b})) continue;
      edge = {t, k, true};
      ++sides;
    }
  edge.found = sides == 1;
  return edge;
}

/// Parts the triangle at an edge by these nodes on it, from a to b. `density` by its area [kg/m²].
bool part(LooseCloth& cloth, std::uint32_t a, std::uint32_t b, Row nodes, double density) {
  const RimEdge edge = rim_edge(cloth, a, b);
  if (!edge.found) return false;
  const mesh::Triangle whole = cloth.triangles[edge.triangle];
  const std::uint32_t tip = whole[(edge.corner + 2) % 3];
  const auto weigh = [&](const mesh::Triangle& t, double sign) {
    for (const std::uint32_t node : t) cloth.mass[node] += sign * density * area_of(cloth, t) / 3;
  };
  weigh(whole, -1);
  nodes.insert(nodes.begin(), a);
  nodes.push_back(b);
  if (whole[edge.corner] != a) std::reverse(nodes.begin(), nodes.end());
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const mesh::Triangle piece{nodes[k - 1], nodes[k], tip};
    weigh(piece, 1);
    if (k == 1) {
      cloth.triangles[edge.triangle] = piece;
      continue;
    }
    cloth.triangles.push_back(piece);
    if (!cloth.warps.empty()) cloth.warps.push_back(Vec3d(cloth.warps[edge.triangle]));
  }
  return true;
}

template <class Value>
void exchange(std::vector<Value>& all, std::size_t first, std::size_t count, const std::vector<Value>& made) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  all.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(first), made.begin(), made.end());
}

}  // namespace

LooseCloth::LooseCloth(const Model& model, const Body& body) {
  const auto own = [&](const auto& all) {
    const auto first = all.begin() + body.first_vertex;
    return std::vector(first, first + body.vertex_count);
  };
  rest = own(model.rest_position);
  start = own(model.start_position);
  uv = own(model.uv);
  mass = own(model.mass);
  motion = own(model.motion);
  triangles = own_triangles(model, body);
  warps = body.warps;
}

void LooseCloth::put_back(Model& model, std::size_t number) const {
  Body& body = model.bodies[number];
  const std::uint32_t first = body.first_vertex, end = first + body.vertex_count;
  const auto more_nodes = static_cast<std::uint32_t>(rest.size()) - body.vertex_count;
  const auto more_triangles = static_cast<std::uint32_t>(triangles.size()) - body.triangle_count;
  for (mesh::Triangle& t : model.triangles)
    for (std::uint32_t& node : t) node += node >= end ? more_nodes : 0;
  for (NodeGrab& grab : model.grabs) grab.node += grab.node >= end ? more_nodes : 0;
  exchange(model.rest_position, first, body.vertex_count, rest);
  exchange(model.start_position, first, body.vertex_count, start);
  exchange(model.uv, first, body.vertex_count, uv);
  exchange(model.mass, first, body.vertex_count, mass);
  exchange(model.motion, first, body.vertex_count, motion);
  std::vector<mesh::Triangle> numbered = triangles;
  for (mesh::Triangle& t : numbered)
    for (std::uint32_t& node : t) node += first;
  exchange(model.triangles, body.first_triangle, body.triangle_count, numbered);
  body.warps = warps;
  body.vertex_count += more_nodes;
  body.triangle_count += more_triangles;
  for (std::size_t later = number + 1; later < model.bodies.size(); ++later) {
    model.bodies[later].first_vertex += more_nodes;
    model.bodies[later].first_triangle += more_triangles;
  }
}

bool ease(LooseCloth& cloth, Row& first, Row& second) {
  if (first.size() == second.size()) return true;
  Row& few = first.size() < second.size() ? first : second;
  const Row& many = first.size() < second.size() ? second : first;
  if (few.size() < 2) return false;
  const std::vector<double> along = places_along(cloth, many);
  const std::vector<std::size_t> met = partners(places_along(cloth, few), along);
  double all = 0, area = 0;
  for (const double one : cloth.mass) all += one;
  for (const mesh::Triangle& t : cloth.triangles) area += area_of(cloth, t);
  Row made{few[0]};
  for (std::size_t k = 1; k < few.size(); ++k) {
    const double from = along[met[k - 1]], way = along[met[k]] - from;
    Row nodes;
    for (std::size_t at = met[k - 1] + 1; at < met[k]; ++at)
      nodes.push_back(add_node(cloth, few[k - 1], few[k], (along[at] - from) / way));
    if (!nodes.empty() && !part(cloth, few[k - 1], few[k], nodes, all / area)) return false;
    made.insert(made.end(), nodes.begin(), nodes.end());
    made.push_back(few[k]);
  }
  few = std::move(made);
  return true;
}

}  // namespace weft
