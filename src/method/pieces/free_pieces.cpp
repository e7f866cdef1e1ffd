#include "method/pieces/free_pieces.hpp"

#include <algorithm>

#include "model/node_groups.hpp"

namespace weft {
namespace {

void join_by_elements(const Model& model, const Body& body, NodeGroups& groups) {
  for (std::size_t kind = 0; kind < kElementKinds; ++kind) {
    if (model.count(static_cast<ElementKind>(kind), body) == 0) continue;
    const ElementTable& elements = model.elements(static_cast<ElementKind>(kind), body);
    for (std::uint32_t at = 0; at < elements.size(); ++at)
      for (const std::uint32_t node : elements.nodes_of(at)) groups.join(elements.nodes_of(at)[0], node);
  }
}

void join_all(const Body& body, NodeGroups& groups) {
  for (std::uint32_t node = 1; node < body.vertex_count; ++node)
    groups.join(body.first_vertex, body.first_vertex + node);
}

bool has_several_solids(const Model& model) {
  return std::count_if(model.bodies.begin(), model.bodies.end(),
                       [](const Body& body) { return body.solid.has_value(); }) > 1;
}

}  // namespace

FreePieces free_pieces(const Model& model, PiecesOf of) {
  if (of == PiecesOf::Solids && !has_several_solids(model)) return {{}, {0}};
  const auto count = static_cast<std::uint32_t>(model.vertex_count());
  NodeGroups groups(count);
  const Body* joined = nullptr;
  std::vector<bool> is_held(count);
  for (const Body& body : model.bodies) {
    of == PiecesOf::Elements ? join_by_elements(model, body, groups) : join_all(body, groups);
    if (of != PiecesOf::Solids) continue;
    if (!body.solid) {
      is_held[groups.of(body.first_vertex)] = true;
    } else {
      if (joined != nullptr) groups.join(joined->first_vertex, body.first_vertex);
      joined = &body;
    }
  }
  std::vector<std::uint32_t> size(count);
  for (std::uint32_t node = 0; node < count; ++node) {
    ++size[groups.of(node)];
    if (model.kinematic(node)) is_held[groups.of(node)] = true;
  }
  FreePieces pieces{{}, {0}};
  std::vector<std::uint32_t> next(count);  // where in `nodes` the next of a piece goes
  for (std::uint32_t node = 0; node < count; ++node) {
    if (groups.of(node) != node || is_held[node]) continue;
    next[node] = pieces.starts.back();
    pieces.starts.push_back(pieces.starts.back() + size[node]);
  }
  pieces.nodes.resize(pieces.starts.back());
  for (std::uint32_t node = 0; node < count; ++node)
    if (const std::uint32_t piece = groups.of(node); !is_held[piece]) pieces.nodes[next[piece]++] = node;
  return pieces;
}

}  // namespace weft
