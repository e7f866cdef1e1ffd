// What the way of a vertex has lost in this substep, m: kLostWord. The including kernel binds `vertex_contacts` as
// array<u32>.
#include "state/contact.wgsl"
fn lost_way(vertex : u32) -> vec3f {
  let word = kVertexWords * vertex + kLostWord;
  return vec3f(bitcast<f32>(vertex_contacts[word]), bitcast<f32>(vertex_contacts[word + 1u]),
               bitcast<f32>(vertex_contacts[word + 2u]));
}
fn set_lost_way(vertex : u32, lost : vec3f) {
  let word = kVertexWords * vertex + kLostWord;
  for (var k = 0u; k < 3u; k++) { vertex_contacts[word + k] = bitcast<u32>(lost[k]); }
}
