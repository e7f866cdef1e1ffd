// How far along its way to the start an element is taken, by the square of how far it turns or is stretched there. At
// the end of that way what turns is followed to second order; where a substep turns wrinkles far, that gives energy.
// Source: docs/solvers/multigrid.md, equation 5b.
const kFarTurn = 1.0 / 16.0;  // mirror: src/method/multigrid/lead.hpp
override kLeads : bool = false;

fn lead_of(turn : f32) -> f32 {
  let far = turn / kFarTurn;
  return select(0.0, max(0.0, 1.0 - far * far), kLeads);
}
// Of damping, which acts along elements as they will be where they are not taken ahead.
fn damping_lead(lead : f32) -> f32 { return select(1.0, lead, kLeads); }
