#include "model/sewn.hpp"

#include <algorithm>
#include <cmath>

#include "model/node_groups.hpp"
#include "model/seams.hpp"

namespace weft {
namespace {

Result<void> check_sewing(const Body& body, std::size_t number, const Sewing::OfCloth& sewing) {
  const std::size_t pairs = body.pattern ? pair_count(*body.pattern) : 0;
  if (sewing.pairs.size() != pairs)
    return input_error("The sewing of cloth %zu has %zu pairs of nodes; the scene has %zu.", number,
                       sewing.pairs.size(), pairs);
  for (const std::int32_t pair : sewing.pairs)
    if (pair != Sewing::kLoose && pair != Sewing::kSewn && std::abs(pair) > Sewing::kMostExponent)
      return input_error("The sewing of cloth %zu has a thread of 2^%d N/m.", number, pair);
  return {};
}

/// Which nodes of a cloth are which once it is sewn: numbers from 0, in the order of each group's lowest node.
std::vector<std::uint32_t> sewn_nodes(const CutPattern& pattern, const Sewing::OfCloth& sewing) {
  NodeGroups groups(pattern.position.size());
  std::size_t pair = 0;
  for (const CutSeam& seam : pattern.seams)
    for (const auto& [a, b] : seam.pairs)
      if (sewing.pairs[pair++] == Sewing::kSewn) groups.join(a, b);
  std::vector<std::uint32_t> nodes(pattern.position.size());
  std::uint32_t count = 0;
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    nodes[node] = groups.of(node) == node ? count++ : nodes[groups.of(node)];
  return nodes;
}

/// Those that pull; of two between the same nodes the first.
std::vector<Thread> threads_of(const CutPattern& pattern, const Sewing::OfCloth& sewing) {
  std::vector<Thread> threads;
  std::size_t pair = 0;
  for (const CutSeam& seam : pattern.seams)
    for (const auto& [first, second] : seam.pairs) {
      const std::int32_t exponent = sewing.pairs[pair++];
      if (exponent == Sewing::kLoose || exponent == Sewing::kSewn) continue;
      const auto [a, b] = std::minmax({pattern.node[first], pattern.node[second]});
      const auto same = [a = a, b = b](const Thread& other) { return other.a == a && other.b == b; };
      if (a == b || std::any_of(threads.begin(), threads.end(), same)) continue;
      threads.push_back({a, b, std::ldexp(1.0, exponent), seam.damping});
    }
  return threads;
}

void append_node(Model& sewn, const Model& whole, std::size_t from) {
  sewn.rest_position.push_back(whole.rest_position[from]);
  sewn.start_position.push_back(whole.start_position[from]);
  sewn.uv.push_back(whole.uv[from]);
  sewn.motion.push_back(whole.motion[from]);
  sewn.mass.push_back(whole.mass[from]);
}

}  // namespace

std::size_t Sewing::sewn() const {
  std::size_t sum = 0;
  for (const OfCloth& cloth : cloths)
    sum += static_cast<std::size_t>(std::count(cloth.pairs.begin(), cloth.pairs.end(), kSewn));
  return sum;
}

Result<Model> sewn_model(const Model& whole, const Sewing& sewing) {
  if (sewing.cloths.empty()) return whole;
  if (sewing.cloths.size() != whole.bodies.size())
    return input_error("There is sewing of %zu cloths and bodies; the scene has %zu.", sewing.cloths.size(),
                       whole.bodies.size());
  Model sewn;
  sewn.motions = whole.motions;
  std::vector<std::uint32_t> now;  // of each node of the whole model
  for (std::size_t c = 0; c < whole.bodies.size(); ++c) {
    const Body& old = whole.bodies[c];
    WEFT_CHECK(check_sewing(old, c, sewing.cloths[c]));
    Body body = old;
    body.first_vertex = static_cast<std::uint32_t>(sewn.vertex_count());
    if (body.pattern) {
      body.pattern->node = sewn_nodes(*body.pattern, sewing.cloths[c]);
      body.pattern->threads = threads_of(*body.pattern, sewing.cloths[c]);
    }
    for (std::uint32_t node = 0; node < old.vertex_count; ++node) {
      const std::size_t from = old.first_vertex + node;
      const std::size_t at = body.first_vertex + (body.pattern ? body.pattern->node[node] : node);
      now.push_back(static_cast<std::uint32_t>(at));
      if (at == sewn.vertex_count()) {
        append_node(sewn, whole, from);
        continue;
      }
      sewn.mass[at] += whole.mass[from];
      sewn.motion[at] = std::max(sewn.motion[at], whole.motion[from]);  // one of them at most is held
    }
    body.vertex_count = static_cast<std::uint32_t>(sewn.vertex_count()) - body.first_vertex;
    sewn.bodies.push_back(std::move(body));
  }
  for (mesh::Triangle triangle : whole.triangles) {
    for (std::uint32_t& node : triangle) node = now[node];
    sewn.triangles.push_back(triangle);
  }
  sewn.grabs = whole.grabs;
  for (NodeGrab& grab : sewn.grabs) grab.node = now[grab.node];
  return sewn;
}

std::vector<std::vector<std::uint32_t>> sewn_from(const Model& model, const Model& then) {
  std::vector<std::vector<std::uint32_t>> from(then.vertex_count());
  for (std::size_t c = 0; c < model.bodies.size(); ++c) {
    const Body &old = model.bodies[c], &body = then.bodies[c];
    if (!old.pattern) {
      for (std::uint32_t k = 0; k < old.vertex_count; ++k)
        from[body.first_vertex + k].push_back(old.first_vertex + k);
      continue;
    }
    for (std::size_t k = 0; k < old.pattern->node.size(); ++k) {
      std::vector<std::uint32_t>& nodes = from[body.first_vertex + body.pattern->node[k]];
      const std::uint32_t node = old.first_vertex + old.pattern->node[k];
      if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
    }
  }
  return from;
}

bool is_sewn(const scene::Scene& scene) {
  return std::any_of(scene.cloths.begin(), scene.cloths.end(),
                     [](const scene::Cloth& cloth) { return !cloth.seams.empty(); });
}

Result<void> check_unsewn(const scene::Scene& scene) {
  for (const scene::Cloth& cloth : scene.cloths)
    if (!cloth.seams.empty())
      return input_error(
          "%s.seams are %zu, and cloth is sewn on a GPU only, not in the reference on the processor.",
          cloth.where.c_str(), cloth.seams.size());
  return {};
}

}  // namespace weft
