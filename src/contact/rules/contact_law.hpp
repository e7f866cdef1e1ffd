// The numbers of proximity contact that follow from a scene: one rule for the GPU and for the reference.
#pragma once

#include <cstdint>

#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// β: the part of a missing gap that the contact spring restores in a substep.
inline constexpr double kContactSpring = 0.25;
/// The wall behind the spring, as a part of the thickness.
inline constexpr double kContactWall = 0.25;
/// A feature no further away than this many thicknesses is in contact, despite the rounding of its place.
inline constexpr double kContactTouching = 1.001;
/// A press says no more than this of how far a node has to go, in thicknesses, so that sums of integers hold:
/// docs/solvers/multigrid.md, Contact.
inline constexpr double kMostLack = 16;
/// How near to the plane between two features a vertex may come, as a part of their distance.
inline constexpr double kContactMargin = 0.05;
/// The same as a part of the thickness, at least: where features are nearer, f32 does not know the plane well
/// enough along a whole edge.
inline constexpr double kContactFloor = 0.1;

/// The speed at which crossings come apart: this part of the thickness in a substep, and no more
/// than this many thicknesses per second.
inline constexpr double kUntanglePart = 0.125, kUntangleRate = 120;
/// The part of that speed with which a sheet is drawn to its nearer rim, and from what turn of the contour on
/// its shortening has all of it, and below which slope a way is no longer for being oblique: docs/contact.md.
inline constexpr double kRimPart = 0.5, kContourGain = 4, kLeastSlope = 0.1;
/// Of cloth in a body: from which cosine between their normals on the cloth's own says where outside is, and
/// how much the body's adds to it.
inline constexpr double kLeastOutward = 0.25, kOutwardPart = 0.25;
/// A vertex nearer to a body than this part of the thickness has no known side, and is sent outward.
inline constexpr double kTouch = 0.01;

/// s of docs/contact.md: a pair's share of its vertices' masses, in whole numbers from 1 to 256. By the gap
/// that it would have after the substep [m].
std::uint32_t contact_urgency(double gap, double thickness);

/// ζ = 2 ξ √β of a contact with this restitution e, 0 to 1, where ξ = -ln e / √(π² + ln² e) is the damping
/// ratio of an oscillator that returns e of its speed after half a swing; 1 for e = 0. With a logarithm of
/// its own: the same bits on every machine.
double contact_damping(double restitution);

/// The shortest altitude of any cloth triangle at rest [m]; infinite without triangles.
double shortest_altitude(const Model& model);
/// h_s: the thickness between cloth and cloth [m]. No more than half the shortest altitude, since a vertex lies no
/// nearer to a triangle of its own sheet.
double self_thickness(const Model& model, double thickness);

/// b₁: with no more reach than this, flat cloth lists no pairs with itself [m]. It is what a fast
/// vertex may go until the next search, unless it needs more: up to kFastest times as much.
double flat_reach(const Model& model, const scene::Contact& contact);
inline constexpr double kFastest = 4;
/// Factor by which an approaching feature may speed up until then.
inline constexpr double kReachMargin = 1.25;

}  // namespace weft
