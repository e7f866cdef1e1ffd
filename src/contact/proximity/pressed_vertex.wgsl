// What obstacles ask of a vertex: the sums of `press`. The including kernel binds `step`, and `presses` as array<i32>.
#include "contact/proximity/hold_rule.wgsl"
#include "contact/proximity/press_sums.wgsl"
#include "state/step.wgsl"

struct PressedVertex {
  weight : f32,     // of its pairs; 0: there is none, and nothing else is set
  normal : vec3f,   // the sum of their directions, by weight
  lack : f32,       // how much further along it the vertex has to go than its velocity takes it, m
  gap : f32,        // the part of it by which it is too near, m
  surface : vec3f,  // the obstacle's velocity, m/s
  friction : f32,
}

fn clear_presses(vertex : u32) {
  for (var word = 0u; word < kPressWords; word++) { presses[press_words(vertex) + word] = 0; }
}

fn press_sum(word : u32) -> f32 {
  return f32(presses[word + kPressWraps]) * 0x1p32 + f32(presses[word]);
}
fn press_vector(word : u32) -> vec3f {
  return vec3f(press_sum(word), press_sum(word + 1u), press_sum(word + 2u)) / kPressUnits;
}

fn pressed_vertex(vertex : u32) -> PressedVertex {
  var found : PressedVertex;
  let word = press_words(vertex);
  found.weight = press_sum(word + kPressWeight) / kPressUnits;
  if (found.weight == 0.0) { return found; }
  found.normal = press_vector(word + kPressNormal);
  found.lack = press_sum(word + kPressLack) / (kLackUnits * found.weight) * step.contact.thickness;
  found.surface = press_vector(word + kPressSurface) / found.weight;
  found.friction = press_sum(word + kPressFriction) / (kPressUnits * found.weight);
  found.gap = press_sum(word + kPressRestored) / (kLackUnits * found.weight) * step.contact.thickness;
  return found;
}
