// The numbers of proximity contact that follow from a scene: one rule for the GPU and for the reference.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/model.hpp"
#include "scene/scene.hpp"

namespace weft {

/// β: the part of a missing gap that a substep restores, by a push that is in no velocity.
inline constexpr double kPushPart = 0.7;
/// Of a gap that lacks less than this part of the thickness a smaller part is restored, in proportion to what it lacks:
/// pushes of a few roundings would keep contacts chattering, and what chatters creeps.
inline constexpr double kSoftLack = 0.02;
/// The fastest push [m/s].
inline constexpr double kPushSpeed = 0.5;
/// A pair of one cloth that a solver's matrix holds is pushed no farther in a substep than it would go in this many
/// pull_time(): a push stretches what hangs on the pair, and the stiffer it is the more energy that lends.
inline constexpr double kOwnPushPulls = 10;
/// A pair begins a substep with the force of the one before. What parts faster than by this many substeps of the
/// load's acceleration begins with less: a blow that goes through layers would else throw them back. Eight layers
/// that fall from 0.5 m rebounded with 30 % of their energy without this, with 4 % with it.
inline constexpr double kPartingSteps = 2;
/// How fast features may part, or must close, to be more than moved by their load [m/s].
inline double speed_of_load(double dt, const Vec3d& load) { return kPartingSteps * dt * length(load); }
/// Between two iterations the normal part of an impulse goes ahead by this part of its last change.
inline constexpr double kImpulseAhead = 0.5;
/// The same of all of an impulse, where heavy cloth may lie on light cloth.
inline constexpr double kHeavyAhead = 0.9;
/// Cloth is pressed where, of its acting pairs with cloth, more than one in so many keeps less than this part of its
/// thickness.
inline constexpr int kPressedOften = 8;
inline constexpr double kPressedGap = 0.9;
/// A feature no further away than this many thicknesses is in contact, despite the rounding of its place.
inline constexpr double kContactTouching = 1.001;
/// The cosine by which a direction may lie outside of a feature's Voronoi cone: what lies right over an edge of a
/// flat floor is in the cone of neither triangle by the rounding of f32, some 1e-4 of a gap that is a few thousand
/// steps of f32 wide. A floor pushes sideways by no more than this part of what it bears.
inline constexpr double kConeSlack = 1e-3;
/// Features that are nearer to each other than this part of their farthest coordinate are in each other: a direction
/// apart would be the rounding of f32.
inline constexpr double kNoDistance = 0x1p-21;
/// The bit in a cloth's number, as contact has it, of what has an inside: a body, or cloth about a gas.
inline constexpr std::uint32_t kHasInside = 0x80000000U;
/// The same of a body that a solver's matrix has together with others: pairs of two of them are as those of one cloth.
inline constexpr std::uint32_t kIsJoined = 0x40000000U;
/// `joins`: whether a solver's matrix has pairs, and all bodies with volume.
inline std::uint32_t contact_number(const Model& model, std::size_t cloth, bool joins) {
  const Body& body = model.bodies[cloth];
  return static_cast<std::uint32_t>(cloth) | (body.solid || body.gas ? kHasInside : 0) |
         (joins && body.solid ? kIsJoined : 0);
}
inline bool are_of_one_system(std::uint32_t a, std::uint32_t b) { return a == b || (a & b & kIsJoined) != 0; }
/// The part of a missing gap that a hold of the implicit solver restores in a substep, and how fast at most [m/s]; of a
/// node that it has borne before, no more than so much a second [1/s], and as much slower. The node does not keep that
/// speed. Faster, the edges of a strip that bends over a capsule are moved about, and stretched three times as much.
inline constexpr double kHoldPart = 0.15, kHoldRate = 10, kHoldSpeed = 0.05;
/// Of the normals of a vertex's pairs: with less agreement there is no one direction to hold it along, and from kAlike
/// on its pairs are the hold's.
inline constexpr double kAgree = 0.3, kAlike = 0.9;
/// Of a pair, the part that presses a vertex whose hold bounds where it may go: its own pair, but for rounding.
inline constexpr double kWholeWeight = 0.999;
/// What a hold has answered is pushed only where it lacks more than this part of the thickness: so deep the pushes of
/// layers bring it, which are faster than the hold, while those of edges that bend over a body make it creep.
inline constexpr double kHeldLack = 0.2;
/// What an obstacle strikes after an implicit solve, and what would end nearer than this part of the thickness, goes
/// along with its impulse, without its neighbours: the next substep might find it in the obstacle.
inline constexpr double kStruckNear = 0.5;
/// The cosine between a node's own direction from a round obstacle and the pair's, from which on a press is along the
/// pair's alone, and how much more of it until it is along the node's own.
inline constexpr double kRoundCosine = 0.8, kRoundFade = 0.1;
/// No less of a surface's radius than this part is left at a distance from its hollow side.
inline constexpr double kLeastSpread = 0.5;
/// The part of the thickness by which the inside of a triangle or an edge of cloth may come nearer to a round obstacle
/// than its ends, which have pairs of their own: docs/contact.md, Pairs of features.
inline constexpr double kMostSpare = 0.5;
/// A press says no more than this of how far a node has to go, in thicknesses, so that sums of integers hold:
/// docs/solvers/multigrid.md, Contact.
inline constexpr double kMostLack = 16;
/// How near to the plane between two features a vertex may come, as a part of their distance.
inline constexpr double kContactMargin = 0.05;
/// The same as a part of the thickness, at least: where features are nearer, f32 does not know the plane well
/// enough along a whole edge.
inline constexpr double kContactFloor = 0.1;
/// Two sides that go less than this part of their distance come to no plane between them.
inline constexpr double kTurningWay = 0.4;
/// In so many rounds a way's end is taken out of the planes that it is beyond, the deepest first, and what is then
/// farther beyond one than this part of the thickness ends before it.
inline constexpr std::uint32_t kPlaneRounds = 4;
inline constexpr double kBeyondPlane = 1e-5;
/// A way is stopped by planes that take more than this part of it; what they take less of goes on along them.
inline constexpr double kStoppedPart = 0.5;

/// The most of a frame's time that cloth may lose where a substep ends before its time, so that nothing passes through
/// cloth: docs/contact.md, equation (6h).
inline constexpr double kMostDelay = 0.5;
/// Or so much of the time of one substep, where that is more: a frame of one substep has no other to go on in.
inline constexpr double kMostDelayOfSubstep = 63.0 / 64;
/// What a frame of such substeps may lose [µs], of both lengths in seconds.
constexpr std::uint32_t most_delay(double frame, double step) {
  return static_cast<std::uint32_t>(1e6 * std::max(kMostDelay * frame, kMostDelayOfSubstep * step));
}

/// The speed at which crossings come apart: this part of the thickness in a substep, and no more
/// than this many thicknesses per second.
inline constexpr double kUntanglePart = 0.125, kUntangleRate = 120;
/// The part of that speed with which a sheet is drawn to its nearer rim, and from what turn of the contour on
/// its shortening has all of it, and below which slope a way is no longer for being oblique: docs/contact.md.
inline constexpr double kRimPart = 0.5, kContourGain = 4, kLeastSlope = 0.1;
/// Of cloth in a body: from which cosine between their normals on the cloth's own says where outside is, and
/// how much the body's adds to it.
inline constexpr double kLeastOutward = 0.25, kOutwardPart = 0.25;
/// A vertex nearer to a body than this part of the thickness has no side of its own, and goes outward: equation (1c).
inline constexpr double kTouch = 0.01;

/// s of docs/contact.md: a pair's share of its vertices' masses, in whole numbers from 1 to 256. By the gap
/// that it would have after the substep [m].
std::uint32_t contact_urgency(double gap, double thickness);

/// Iterations of impulses in a substep of this length [s], and rounds of separation. Forces are kept from substep to
/// substep, so short ones need one; with six in 1/960 s fifty layers that drop end at 236 of 250 mm.
std::uint32_t contact_iterations(double step);

/// How the impulses of a substep are iterated.
struct ImpulseRule {
  std::uint32_t iterations = 1;
  std::uint32_t pressed = 1;  // iterations where cloth is pressed, kPressedOften; no fewer
  bool heavy = false;         // all of an impulse goes ahead, by kHeavyAhead

  bool operator==(const ImpulseRule&) const = default;
};
/// Of substeps of this length [s]. One iteration carries some layers' weight, and not more: the middle of a rope
/// that was wrung by half a turn at either end sank to a thirtieth of its thickness, and passed through itself;
/// with six it passes nowhere. So where cloth is pressed, substeps that have one have six. An iteration takes out
/// of the speed of heavy cloth what light cloth under it weighs: a sheet on one of a hundredth of its density sank
/// by 4 mm into it in six iterations a substep, and crept on a slope. So long substeps have four times the square
/// root of Σ (the greatest density over a cloth's), over all cloths of a tenth of it or less, where that is more,
/// up to 64.
ImpulseRule impulse_rule(const Model& model, const scene::Contact& contact, double step);

/// ℓ: of each cloth the median of its triangles' shortest altitudes at rest, of all cloths the least [m]; infinite
/// without triangles. The median, since a sliver says nothing of its cloth.
double typical_altitude(const Model& model);
/// h_s: the thickness between cloth and cloth [m]: no more than half of ℓ, since a vertex of flat cloth lies no
/// nearer to a triangle of its own sheet. A pair of one cloth may have less: pair_thickness.
double self_thickness(const Model& model, double thickness);
/// Features of one cloth that are no further apart at rest than this part of h_s do not meet: they have no side.
inline constexpr double kTouchingAtRest = 0.02;
/// The thickness of a pair of features of one cloth that are this far apart at rest [m]; 0: they do not meet.
inline double pair_thickness(double self_thickness, double rest_distance) {
  if (rest_distance <= kTouchingAtRest * self_thickness) return 0;
  return rest_distance < 2 * self_thickness ? 0.5 * rest_distance : self_thickness;
}

/// b₁: with no more slack than this, flat cloth lists no pairs with itself [m].
double flat_reach(const Model& model, const scene::Contact& contact);
/// The same of each vertex, from the shortest altitude of the triangles around it; at least a quarter of b₁, so that a
/// sliver lists pairs and is not held back [m].
std::vector<double> most_slacks(const Model& model, double most_reach, double self_thickness);
/// Factor by which an approaching feature may speed up until then.
inline constexpr double kReachMargin = 1.25;

}  // namespace weft
