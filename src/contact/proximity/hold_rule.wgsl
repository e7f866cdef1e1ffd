// How what obstacles press is held. Mirror: contact/rules/contact_law.hpp.
const kWholeWeight = 0.999;  // of a pair, from which it presses a vertex whose hold bounds where it may go
const kAgree = 0.3;       // of the normals of a vertex's pairs: with less there is no one direction to hold it along
const kAlike = 0.9;       // with no less its pairs are the hold's: contact/proximity/evaluate.wgsl
const kHoldPart = 0.15;   // of a missing gap, the part that is restored in a substep, if that is not too fast
const kHoldRate = 10.0;   // 1/s: of what has borne before, no more than so much a second
const kHoldSpeed = 0.05;  // m/s: and no faster
