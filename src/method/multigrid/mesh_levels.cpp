#include "method/multigrid/mesh_levels.hpp"

#include <algorithm>
#include <tuple>

namespace weft {
namespace {

mesh::Network network_of(const Model& model, const multigrid::SystemBodies& bodies,
                         std::span<const mesh::Edge> pairs) {
  mesh::Network network;
  const std::uint32_t first = bodies.first_vertex();
  const auto nodes = std::span(model.rest_position).subspan(first, bodies.vertex_count());
  network.positions.assign(nodes.begin(), nodes.end());
  for (const Body& body : bodies.bodies) {
    const std::uint32_t own = body.first_vertex - first;
    for (const auto& [a, b, c] : own_triangles(model, body))
      network.triangles.push_back({own + a, own + b, own + c});
    for (const auto& [a, b, c, d] : body.tets) network.tets.push_back({own + a, own + b, own + c, own + d});
  }
  if (!bodies.first().solid)
    network.edges = mesh::mesh_edges(network.triangles);
  else
    network.edges.assign(pairs.begin(), pairs.end());
  return network;
}

/// The rows of a matrix whose blocks beside the diagonal are those of these pairs.
void set_rows(MeshLevel& level, std::span<const mesh::Edge> pairs) {
  level.block_count = level.node_count + static_cast<std::uint32_t>(pairs.size());
  std::vector<std::uint32_t>& starts = level.rows.starts;
  starts.assign(level.node_count + 1, 0);
  for (const mesh::Edge& pair : pairs)
    for (const std::uint32_t node : pair) ++starts[node + 1];
  for (std::size_t node = 0; node < level.node_count; ++node) starts[node + 1] += starts[node];
  level.rows.items.resize(2 * pairs.size());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (std::uint32_t p = 0; p < pairs.size(); ++p)
    for (const std::size_t k : {0, 1})
      level.rows.items[next[pairs[p][k]]++] = {pairs[p][1 - k], {level.node_count + p, k == 1}};
}

void set_sources(MeshLevel& level) {
  std::vector<std::vector<Share>> sources(level.node_count);
  for (std::uint32_t node = 0; node < level.taps.size(); ++node)
    for (const Share& tap : level.taps[node])
      if (tap.weight != 0) sources[tap.index].push_back({node, tap.weight});
  for (const std::vector<Share>& list : sources) {
    level.sources.items.insert(level.sources.items.end(), list.begin(), list.end());
    level.sources.close();
  }
}

/// A part of Pᵀ A P in the row of one coarse node.
struct Product {
  std::uint32_t column;
  BlockPlace at;
  double weight;
};

/// What row `node` of Pᵀ A P is made of, in columns from `node` on: the matrix is symmetric.
std::vector<Product> products_of(const MeshLevel& fine, const MeshLevel& coarse, std::uint32_t node,
                                 Blocks blocks) {
  std::vector<Product> row;
  for (const Share& source : coarse.sources.of(node)) {
    const auto add = [&](std::uint32_t other, BlockPlace at) {
      if (blocks == Blocks::Symmetric) at.transposed = false;
      for (const Share& tap : coarse.taps[other])
        if (tap.weight != 0 && tap.index >= node)
          row.push_back(
              {tap.index, at, static_cast<double>(source.weight) * static_cast<double>(tap.weight)});
    };
    add(source.index, {source.index});
    for (const Coupling& coupling : fine.rows.of(source.index)) add(coupling.node, coupling.at);
  }
  std::stable_sort(row.begin(), row.end(), [](const Product& a, const Product& b) {
    return std::tie(a.column, a.at.block, a.at.transposed) < std::tie(b.column, b.at.block, b.at.transposed);
  });
  return row;
}

/// The pattern of Pᵀ A P, and of which blocks it is made.
void set_products(const MeshLevel& fine, MeshLevel& coarse, Blocks blocks) {
  Lists<BlockShare> diagonal, beside;
  std::vector<mesh::Edge> pairs;
  for (std::uint32_t node = 0; node < coarse.node_count; ++node) {
    const std::vector<Product> row = products_of(fine, coarse, node, blocks);
    for (std::size_t k = 0; k < row.size();) {
      const std::uint32_t column = row[k].column;
      Lists<BlockShare>& lists = column == node ? diagonal : beside;
      while (k < row.size() && row[k].column == column) {
        const BlockPlace at = row[k].at;
        double weight = 0;
        for (; k < row.size() && row[k].column == column && row[k].at == at; ++k) weight += row[k].weight;
        lists.items.push_back({at, static_cast<float>(weight)});
      }
      lists.close();
      if (column != node) pairs.push_back({node, column});
    }
  }
  const auto first = static_cast<std::uint32_t>(diagonal.items.size());
  coarse.products = std::move(diagonal);
  for (std::size_t k = 1; k < beside.starts.size(); ++k)
    coarse.products.starts.push_back(first + beside.starts[k]);
  coarse.products.items.insert(coarse.products.items.end(), beside.items.begin(), beside.items.end());
  set_rows(coarse, pairs);
}

}  // namespace

std::vector<MeshLevel> mesh_levels(const Model& model, const Body& body, const Springs& springs) {
  std::vector<mesh::Edge> pairs;
  for (const Spring spring : springs)
    pairs.push_back({spring.node_a - body.first_vertex, spring.node_b - body.first_vertex});
  return mesh_levels(model, {{&body, 1}}, pairs, Blocks::Symmetric);
}

std::vector<MeshLevel> mesh_levels(const Model& model, const multigrid::SystemBodies& bodies,
                                   std::span<const mesh::Edge> pairs, Blocks blocks) {
  mesh::Network network = network_of(model, bodies, pairs);
  std::vector<MeshLevel> levels(1);
  levels[0].node_count = bodies.vertex_count();
  set_rows(levels[0], pairs);
  while (network.positions.size() > kLeastNodes) {
    mesh::CoarseMesh coarse = mesh::coarsened(network);
    if (coarse.of.size() == network.positions.size()) break;  // nothing is joined any more
    MeshLevel level;
    level.node_count = static_cast<std::uint32_t>(coarse.of.size());
    level.taps = std::move(coarse.taps);
    set_sources(level);
    set_products(levels.back(), level, blocks);
    levels.push_back(std::move(level));
    network = std::move(coarse.network);
  }
  return levels;
}

}  // namespace weft
