#include "contact/pushes/convex_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/convex_hull.hpp"

namespace weft::contact {
namespace {

/// An edge as a face goes along it.
struct Way {
  std::uint32_t from = 0, to = 0, face = 0;
};

Result<void> add_body(ConvexBodies& all, const mesh::TriangleMesh& hull, std::size_t number) {
  if (hull.positions.size() > mesh::kMostHullVertices)
    return make_error(ErrorKind::Limit, "Convex hull %zu has %zu corners, more than %zu.", number,
                      hull.positions.size(), mesh::kMostHullVertices);
  const mesh::Bounds box = mesh::bounds(hull);
  ConvexBody body{Vec4f::from(box.low, 0), Vec4f::from(box.high, 0)};
  body.first_point = static_cast<std::uint32_t>(all.places.size());
  body.points = static_cast<std::uint32_t>(hull.positions.size());
  for (const Vec3f& p : hull.positions) all.places.push_back(Vec4f::from(p, 0));
  body.first_face = static_cast<std::uint32_t>(all.places.size());
  body.faces = static_cast<std::uint32_t>(hull.triangles.size());
  std::vector<Way> ways;
  for (std::uint32_t f = 0; f < body.faces; ++f) {
    const mesh::Triangle& t = hull.triangles[f];
    const Vec3d a = hull.positions[t[0]].to<double>();
    const Vec3d area = cross(hull.positions[t[1]].to<double>() - a, hull.positions[t[2]].to<double>() - a);
    const double size = length(area);
    if (!(size > 0) || !std::isfinite(size))
      return input_error("Triangle %u of convex hull %zu has no area, or one that is not finite.", f, number);
    all.places.push_back(Vec4f::from((area / size).to<float>(), static_cast<float>(t[0])));
    for (std::size_t k = 0; k < 3; ++k) ways.push_back({t[k], t[(k + 1) % 3], f});
  }
  std::sort(ways.begin(), ways.end(),
            [](const Way& a, const Way& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  body.first_edge = static_cast<std::uint32_t>(all.words.size());
  body.edges = static_cast<std::uint32_t>(ways.size() / 2);
  for (const Way& way : ways) {
    const auto back = std::lower_bound(ways.begin(), ways.end(), way, [](const Way& a, const Way& b) {
      return a.from != b.to ? a.from < b.to : a.to < b.from;
    });
    if (back == ways.end() || back->from != way.to || back->to != way.from)
      return input_error("Convex hull %zu is not closed between its points %u and %u.", number, way.from,
                         way.to);
    if (way.from < way.to)
      for (const std::uint32_t word : {way.from, way.to, way.face, back->face}) all.words.push_back(word);
  }
  body.first_corner = static_cast<std::uint32_t>(all.words.size());
  for (const mesh::Triangle& t : hull.triangles) all.words.insert(all.words.end(), t.begin(), t.end());
  body.first_ring = static_cast<std::uint32_t>(all.words.size());
  std::size_t at = 0;
  for (std::uint32_t p = 0; p <= body.points; ++p) {
    while (at < ways.size() && ways[at].from < p) ++at;
    all.words.push_back(body.points + 1 + static_cast<std::uint32_t>(at));
  }
  for (const Way& way : ways) all.words.push_back(way.to);
  all.bodies.push_back(body);
  return {};
}

}  // namespace

Result<ConvexBodies> convex_bodies(std::span<const mesh::TriangleMesh> hulls) {
  ConvexBodies all;
  for (std::size_t number = 0; number < hulls.size(); ++number)
    WEFT_CHECK(add_body(all, hulls[number], number));
  return all;
}

}  // namespace weft::contact
