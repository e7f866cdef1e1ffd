#include "model/seams.hpp"

#include <algorithm>
#include <array>
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

/// The nodes of a row, in the order of the rim; of one that goes all the way round the first comes again at the end.
using Row = std::vector<std::uint32_t>;

bool is_closed(const Row& row) { return row.size() > 1 && row.front() == row.back(); }

/// Errors  Input: they are no single run of the rim.
Result<Row> row_of(const Cut& cut, const scene::SeamRow& row, const std::string& where) {
  const auto [first, count] = cut.range(row.panel);
  const std::optional<scene::GridShape>& grid =
      cut.cloth.panels.empty() ? cut.cloth.grid : cut.cloth.panels[row.panel].grid;
  const scene::Selection selection{cut.positions.subspan(first, count), grid ? grid->nx : 0,
                                   grid ? grid->ny : 0};
  WEFT_TRY(selected, scene::select_nodes(row.nodes, selection));
  std::vector<bool> in_row(cut.positions.size()), at_rim(cut.positions.size()), follows(cut.positions.size());
  for (const std::uint32_t node : selected) in_row[first + node] = true;
  const std::vector<std::uint32_t> next = followers(cut, in_row, at_rim);
  Row begins, all;
  for (const std::uint32_t node : selected) {
    if (at_rim[first + node]) all.push_back(first + node);
    if (next[first + node] != first + node) follows[next[first + node]] = true;
  }
  for (const std::uint32_t node : all)
    if (!follows[node]) begins.push_back(node);
  if (all.empty())
    return input_error("%s selects %zu nodes, none of which is at the rim of its panel.", where.c_str(),
                       selected.size());
  if (begins.size() > 1)
    return input_error("%s selects %zu runs of the rim, which begin at nodes %u and %u; a row is one run.",
                       where.c_str(), begins.size(), begins[0] - first, begins[1] - first);
  const bool closed = begins.empty();
  Row nodes{closed ? all[0] : begins[0]};
  do nodes.push_back(next[nodes.back()]);
  while (nodes.back() != nodes.front() && next[nodes.back()] != nodes.back() && nodes.size() <= all.size());
  if (nodes.size() == 2 && nodes[0] == nodes[1]) nodes.pop_back();  // one node
  if (nodes.size() != all.size() + (closed ? 1 : 0))
    return input_error(
        "%s selects a run of the rim and, apart from it, one that goes all the way round; a row is one run.",
        where.c_str());
  return nodes;
}

double length_of(const Cut& cut, const Row& row) {
  double sum = 0;
  for (std::size_t k = 1; k < row.size(); ++k)
    sum += length(cut.positions[row[k]] - cut.positions[row[k - 1]]);
  return sum;
}

/// How far the nodes of a row are from the places of another one that are as far along it, in the mean [m].
double gap_by_length(const Cut& cut, const Row& a, const Row& b) {
  const double scale = length_of(cut, b) / length_of(cut, a);
  double along = 0, passed = 0, sum = 0;  // of b: the place that is looked for, and where its edge begins
  std::size_t edge = 1;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (k > 0) along += scale * length(cut.positions[a[k]] - cut.positions[a[k - 1]]);
    const auto side = [&] { return cut.positions[b[edge]] - cut.positions[b[edge - 1]]; };
    for (; edge + 1 < b.size() && passed + length(side()) < along; ++edge) passed += length(side());
    const double part = along < passed + length(side()) ? (along - passed) / length(side()) : 1;
    sum += length(cut.positions[b[edge - 1]] + part * side() - cut.positions[a[k]]);
  }
  return sum / static_cast<double>(a.size());
}

/// Of the nodes that meet, or of the ends where one row has more, how far they are apart.
double gaps_of(const Cut& cut, const Row& a, const Row& b) {
  const auto gap = [&](std::uint32_t one, std::uint32_t other) {
    return length(cut.positions[one] - cut.positions[other]);
  };
  if (a.size() != b.size() && is_closed(a)) return gap_by_length(cut, a, b);
  if (a.size() != b.size()) return gap(a.front(), b.front()) + gap(a.back(), b.back());
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += gap(a[k], b[k]);
  return sum;
}

/// A closed row from that of its nodes on from which it is nearest to another one.
Row begun_nearest(const Cut& cut, const Row& closed, const Row& other) {
  Row best = closed, begun = closed;
  double least = gaps_of(cut, begun, other);
  for (std::size_t k = 2; k < closed.size(); ++k) {
    begun.erase(begun.begin());
    begun.push_back(begun.front());
    if (const double gaps = gaps_of(cut, begun, other); gaps < least) least = gaps, best = begun;
  }
  return best;
}

/// The nodes of both rows, in the order in which they meet.
struct Rows {
  Row first, second;
};
Result<Rows> rows_of(const Cut& cut, const scene::Seam& seam) {
  Rows rows;
  WEFT_SET(rows.first, row_of(cut, seam.first, seam.where + ".first"));
  WEFT_SET(rows.second, row_of(cut, seam.second, seam.where + ".second"));
  Rows turned{rows.first, {rows.second.rbegin(), rows.second.rend()}};
  for (Rows* way : {&rows, &turned}) {
    if (is_closed(way->first))
      way->first = begun_nearest(cut, way->first, way->second);
    else if (is_closed(way->second))
      way->second = begun_nearest(cut, way->second, way->first);
  }
  const auto gaps = [&](const Rows& way) {
    return is_closed(way.first) ? gaps_of(cut, way.first, way.second) : gaps_of(cut, way.second, way.first);
  };
  if ((gaps(turned) < gaps(rows)) != seam.reversed) return turned;
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
    if (const std::array pair = {rows.first[k], rows.second[k]};
        pair[0] != pair[1] && (k == 0 || made.pairs.empty() || pair != made.pairs.front()))
      made.pairs.push_back(pair);
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
