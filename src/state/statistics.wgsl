// Made by scripts/make_statistics.py from src/state/statistics.txt.
// The words of a frame's report. Kernels bind it as array<atomic<u32>>.
// Narrow-phase hits, summed over substeps.
const kStatContacts = 0u;
// Wrapping sum of hash_pair over all hits: the same for every method that finds the same.
const kStatContactHash = 1u;
// The largest length of a triangle's edge over its rest length, at the end of a frame, as the bits of a positive f32.
const kStatMaxStretch = 2u;
// Contacts that a list had no room for; anything but 0 means that contact is incomplete.
const kStatContactOverflow = 3u;
// Searches for pairs of features (proximity).
const kStatDetections = 4u;
// Edges through triangles that they do not touch at rest, the most of a search (proximity).
const kStatCrossings = 5u;
// Vertices truncated by contact, summed over substeps (proximity).
const kStatTruncated = 6u;
// Of these, vertices that an obstacle has passed since cloth behind them did not give way.
const kStatDriven = 7u;
// Substeps that ended before their time for all cloth, so that nothing passes through cloth (proximity).
const kStatSlowed = 8u;
// The time that these were short of.
const kStatDelayUs = 9u;
// Pairs of features that are listed at the end of a frame (proximity).
const kStatPairs = 10u;
// Pairs of triangles that the last search of a frame has listed (proximity).
const kStatCandidates = 11u;
// Of the pairs, those near enough to have a record, at the end of a frame (proximity).
const kStatNear = 12u;
// Iterations that the linear systems of a substep took, the most (implicit solver).
const kStatIterations = 13u;
// Iterations of the last linear system of a substep, the most (implicit solver).
const kStatCorrections = 14u;
// The largest part of its residual that a linear system kept (implicit solver), as the bits of a positive f32.
const kStatResidual = 15u;
// Linear systems that were left with a larger residual than wanted (implicit solver).
const kStatUnsolved = 16u;
// 1: in a substep cloth was pressed, and impulses took all their iterations (proximity).
const kStatPressing = 17u;
// Tetrahedra with less than a twentieth of their volume, or inside out, at a frame's end.
const kStatFlattened = 18u;
// Nodes that are not finite; 0 but where a run diverged.
const kStatNonfinite = 19u;
// 1 once the state is frozen at the last good frame.
const kStatFrozen = 20u;
// 1 once a list was too short: the state is as before the frame until the list is longer.
const kStatRolledBack = 21u;
// 1: a vertex is about to leave its reach.
const kStatDetect = 22u;
// 1: a search is under way.
const kStatDue = 23u;
// Edges through triangles that they do not touch at rest, of the last search (proximity).
const kStatCrossingsLeft = 24u;
// Near pairs before the search that is under way.
const kStatNearBefore = 25u;
// 1: some vertex goes farther than to the obstacles that have records (proximity).
const kStatFarWays = 26u;
// The last round of a substep in which cloth could meet other cloth on its way; 0: none.
const kStatMeeting = 27u;
// That time in the frame's substeps before this one, in microseconds.
const kStatDelayBefore = 28u;
// The bits, inverted, of the part that all cloth may go of its ways; 0: all.
const kStatSlowPart = 29u;
// Of a substep, kPressedOften times the pairs of cloth that are pressed less those that act, as i32.
const kStatPressed = 30u;
// How far a collider may go until the next search [m], as the bits of a positive f32.
const kStatReach = 31u;
// How far one may have gone since this search [m], as the bits of a positive f32.
const kStatTravel = 32u;
// How far a rigid body may go in this substep [m], as the bits of a positive f32.
const kStatBodyTravel = 33u;
