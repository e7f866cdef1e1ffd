// Where a feature of a surface is the nearest to a place beside it: its Voronoi cone, in double.
#pragma once

#include <cstdint>

#include "contact/reference/proximity/pairs.hpp"

namespace weft::reference {

/// Whether `way`, from a point of the edge, leads to places of which no triangle at the edge is nearer elsewhere.
/// True where there is no triangle; all of them count where there are more than two. Triangles whose third corner is
/// one of the nodes that it has `met`, or beside one, do not: folded cloth is nearest to itself in its fold.
bool in_cone_of_edge(const Features& of, const mesh::Edge& edge, const Vec3d& way,
                     std::span<const std::uint32_t> met = {});
/// Whether `way`, from the vertex, leads to places to which no edge at the vertex is nearer elsewhere; likewise.
bool in_cone_of_vertex(const Features& of, std::uint32_t vertex, const Vec3d& way,
                       std::span<const std::uint32_t> met = {});

/// Whether the direction of a pair, with its weights, lies in the cones of its features. What has a radius has
/// no cone. The inside of a triangle has only its normal. A vertex of cloth has none before an obstacle
/// and before the inside of a triangle: it keeps the distance that it has.
bool in_cones(const FeaturePair& pair, const Features& cloth, const Features& object);

}  // namespace weft::reference
