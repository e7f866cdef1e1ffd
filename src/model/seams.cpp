#include "model/seams.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/sides.hpp"
#include "model/eased_rows.hpp"
#include "model/node_groups.hpp"
#include "scene/select.hpp"

namespace weft {
namespace {

/// What rows are found on.
struct Cut {
  const scene::Cloth& cloth;
  std::span<const Vec3d> positions;           // of the cloth's nodes [m]
  std::span<const mesh::Triangle> triangles;  // of these
  std::vector<std::uint32_t> sizes;           // of its panels, in nodes

  /// The first node of a panel, and how many it has.
  std::array<std::uint32_t, 2> range(std::size_t panel) const {
    const auto first = std::accumulate(sizes.begin(), sizes.begin() + std::ptrdiff_t(panel), 0U);
    return {first, sizes[panel]};
  }
};

/// Of each node that is followed along the rim by another one of the row, which; else itself.
std::vector<std::uint32_t> followers(const Cut& cut, const std::vector<bool>& in_row,
                                     std::vector<bool>& at_rim) {
  std::vector<std::uint32_t> next(cut.positions.size());
  std::iota(next.begin(), next.end(), 0U);
  mesh::for_each_edge(mesh::sorted_sides(cut.triangles), [&](std::span<const mesh::Side> sides) {
    if (sides.size() != 1) return;
    const mesh::Triangle& t = cut.triangles[sides[0].triangle];
    const std::uint32_t from = t[sides[0].start()], to = t[(sides[0].start() + 1) % 3];
    at_rim[from] = at_rim[to] = true;
    if (in_row[from] && in_row[to]) next[from] = to;
  });
  return next;
}

/// The nodes of a row, in the order of the rim. Errors  Input: they are no single run of it.
Result<std::vector<std::uint32_t>> row_of(const Cut& cut, const scene::SeamRow& row,
                                          const std::string& where) {
  const auto [first, count] = cut.range(row.panel);
  const std::optional<scene::GridShape>& grid =
      cut.cloth.panels.empty() ? cut.cloth.grid : cut.cloth.panels[row.panel].grid;
  const scene::Selection selection{cut.positions.subspan(first, count), grid ? grid->nx : 0,
                                   grid ? grid->ny : 0};
  WEFT_TRY(selected, scene::select_nodes(row.nodes, selection));
  std::vector<bool> in_row(cut.positions.size()), at_rim(cut.positions.size()), follows(cut.positions.size());
  for (const std::uint32_t node : selected) in_row[first + node] = true;
  const std::vector<std::uint32_t> next = followers(cut, in_row, at_rim);
  std::vector<std::uint32_t> begins;
  std::size_t size = 0;
  for (const std::uint32_t node : selected) {
    if (at_rim[first + node]) ++size;
    if (next[first + node] != first + node) follows[next[first + node]] = true;
  }
  for (const std::uint32_t node : selected)
    if (at_rim[first + node] && !follows[first + node]) begins.push_back(first + node);
  if (size == 0)
    return input_error("%s selects %zu nodes, none of which is at the rim of its panel.", where.c_str(),
                       selected.size());
  if (begins.empty())
    return input_error("%s goes all the way round a rim of %zu nodes; a row has two ends.", where.c_str(),
                       size);
  if (begins.size() > 1)
    return input_error("%s selects %zu runs of the rim, which begin at nodes %u and %u; a row is one run.",
                       where.c_str(), begins.size(), begins[0] - first, begins[1] - first);
  std::vector<std::uint32_t> nodes{begins[0]};
  while (next[nodes.back()] != nodes.back() && nodes.size() < size) nodes.push_back(next[nodes.back()]);
  if (nodes.size() != size)
    return input_error("%s selects a run of the rim and, apart from it, one that goes all the way round.",
                       where.c_str());
  return nodes;
}

double length_of(const Cut& cut, const std::vector<std::uint32_t>& row) {
  double sum = 0;
  for (std::size_t k = 1; k < row.size(); ++k)
    sum += length(cut.positions[row[k]] - cut.positions[row[k - 1]]);
  return sum;
}

/// Of the nodes that meet, or of the ends where one row has more, how far they are apart.
double gaps_of(const Cut& cut, const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  const auto gap = [&](std::uint32_t one, std::uint32_t other) {
    return length(cut.positions[one] - cut.positions[other]);
  };
  if (a.size() != b.size()) return gap(a.front(), b.front()) + gap(a.back(), b.back());
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += gap(a[k], b[k]);
  return sum;
}

/// The nodes of both rows, in the order in which they meet.
struct Rows {
  std::vector<std::uint32_t> first, second;
};
Result<Rows> rows_of(const Cut& cut, const scene::Seam& seam) {
  Rows rows;
  WEFT_SET(rows.first, row_of(cut, seam.first, seam.where + ".first"));
  WEFT_SET(rows.second, row_of(cut, seam.second, seam.where + ".second"));
  std::vector<std::uint32_t> turned(rows.second.rbegin(), rows.second.rend());
  if ((gaps_of(cut, rows.first, turned) < gaps_of(cut, rows.first, rows.second)) != seam.reversed)
    rows.second.swap(turned);
  return rows;
}

/// Gives the row that has fewer nodes more. Errors  Input: it cannot have them.
Result<void> make_equal(LooseCloth& loose, const scene::Cloth& cloth, const scene::Seam& seam, Rows& rows) {
  const std::size_t first = rows.first.size(), second = rows.second.size();
  if (first == second) return {};
  if (cloth.node_mass)
    return input_error(
        "%s sews a row of %zu nodes to one of %zu; of a cloth with \"node_mass\" both have as many.",
        seam.where.c_str(), first, second);
  if (!ease(loose, rows.first, rows.second))
    return input_error(
        "%s sews a row of %zu nodes to one of %zu, which cannot have more: it is one node, or its edges "
        "have more in another seam.",
        seam.where.c_str(), first, second);
  return {};
}

Result<CutSeam> seam_of(const Cut& cut, const scene::Seam& seam, const Rows& rows) {
  CutSeam made;
  made.where = seam.where;
  for (std::size_t k = 0; k < rows.first.size(); ++k)
    if (rows.first[k] != rows.second[k]) made.pairs.push_back({rows.first[k], rows.second[k]});
  if (made.pairs.empty()) return input_error("%s sews a row to itself.", seam.where.c_str());
  const double size = (length_of(cut, rows.first) + length_of(cut, rows.second)) / 2;
  // A row of one node has no length: its thread is as one of a centimetre.
  made.force = seam.force * (size > 0 ? size / static_cast<double>(rows.first.size() - 1) : 0.01);
  made.damping = std::exp2(std::ceil(std::log2(made.force / seam.speed)));  // springs have few kinds
  made.within = seam.within;
  made.start = seam.start;
  made.last = seam.start + seam.patience;
  return made;
}

Vec3d normal_of(const Cut& cut, std::size_t triangle) {
  const mesh::Triangle& t = cut.triangles[triangle];
  return cross(cut.positions[t[1]] - cut.positions[t[0]], cut.positions[t[2]] - cut.positions[t[0]]);
}

/// One place for all nodes of a group: half way, and off the sheet that all of them are the rim of, so that what is
/// between them there is not taken for a neighbour.
Vec3d common_place(const Cut& cut, const std::vector<std::uint32_t>& nodes, std::span<const Vec3d> normals) {
  Vec3d middle, normal;
  double widest = 0;
  for (const std::uint32_t node : nodes) {
    middle += cut.positions[node] / static_cast<double>(nodes.size());
    if (length(normals[node]) > 0) normal += normals[node] / length(normals[node]);
    widest = std::max(widest, length(cut.positions[node] - cut.positions[nodes[0]]));
  }
  return middle + widest / 2 / static_cast<double>(nodes.size()) * normal;
}

/// Of each node where it meets those that it is sewn to [m].
std::vector<Vec3d> meeting_places(const Model& model, const Body& body, const Cut& cut,
                                  const NodeGroups& groups) {
  std::vector<Vec3d> normals(cut.positions.size());
  for (std::size_t t = 0; t < cut.triangles.size(); ++t)
    for (const std::uint32_t node : cut.triangles[t]) normals[node] += normal_of(cut, t);
  std::vector<std::vector<std::uint32_t>> members(cut.positions.size());
  for (std::uint32_t node = 0; node < members.size(); ++node) members[groups.of(node)].push_back(node);
  std::vector<Vec3d> places(cut.positions.begin(), cut.positions.end());
  for (const std::vector<std::uint32_t>& group : members) {
    if (group.size() < 2) continue;
    Vec3d place = common_place(cut, group, normals);
    for (const std::uint32_t node : group)
      if (model.kinematic(body.first_vertex + node)) place = cut.positions[node];
    for (const std::uint32_t node : group) places[node] = place;
  }
  return places;
}

/// Refuses seams that join two corners of a triangle, or two nodes that are held.
Result<void> check_groups(const Model& model, const Body& body, const scene::Cloth& cloth,
                          const NodeGroups& groups) {
  const CutPattern& pattern = *body.pattern;
  for (std::size_t t = 0; t < pattern.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = pattern.triangles[t][k], b = pattern.triangles[t][(k + 1) % 3];
      if (groups.of(a) == groups.of(b))
        return input_error("%s.seams join nodes %u and %u, two corners of triangle %zu.", cloth.where.c_str(),
                           a, b, t);
    }
  std::vector<std::uint32_t> holder(pattern.position.size(), ~0U);
  for (std::uint32_t node = 0; node < pattern.position.size(); ++node) {
    if (!model.kinematic(body.first_vertex + node)) continue;
    std::uint32_t& other = holder[groups.of(node)];
    if (other != ~0U)
      return input_error("%s.seams join nodes %u and %u, and the scene holds both of them.",
                         cloth.where.c_str(), other, node);
    other = node;
  }
  return {};
}

}  // namespace

std::size_t pair_count(const CutPattern& pattern) {
  std::size_t pairs = 0;
  for (const CutSeam& seam : pattern.seams) pairs += seam.pairs.size();
  return pairs;
}

Result<void> add_seams(Model& model, const scene::Scene& scene, const Assets& assets) {
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const scene::Cloth& cloth = scene.cloths[c];
    if (cloth.seams.empty()) continue;
    Body& body = model.bodies[c];
    LooseCloth loose(model, body);
    const std::vector<Vec3d> positions = loose.rest;
    const std::vector<mesh::Triangle> triangles = loose.triangles;
    Cut whole{cloth, positions, triangles, {body.vertex_count}};
    if (!cloth.panels.empty()) whole.sizes = assets.panels[c];
    std::vector<Rows> rows;
    for (const scene::Seam& seam : cloth.seams) {
      WEFT_TRY(found, rows_of(whole, seam));
      rows.push_back(std::move(found));
    }
    for (std::size_t k = 0; k < rows.size(); ++k)
      WEFT_CHECK(make_equal(loose, cloth, cloth.seams[k], rows[k]));
    loose.put_back(model, c);
    CutPattern pattern;
    pattern.position = loose.rest;
    pattern.triangles = loose.triangles;
    const Cut cut{cloth, pattern.position, pattern.triangles, {}};
    NodeGroups groups(body.vertex_count);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      WEFT_TRY(made, seam_of(cut, cloth.seams[k], rows[k]));
      for (const auto& [a, b] : made.pairs) groups.join(a, b);
      pattern.seams.push_back(std::move(made));
    }
    pattern.node.resize(body.vertex_count);
    std::iota(pattern.node.begin(), pattern.node.end(), 0U);
    const std::vector<Vec3d> places = meeting_places(model, body, cut, groups);
    body.pattern = std::move(pattern);
    WEFT_CHECK(check_groups(model, body, cloth, groups));
    std::copy(places.begin(), places.end(), model.rest_position.begin() + body.first_vertex);
  }
  return {};
}

}  // namespace weft
