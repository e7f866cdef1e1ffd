// Reads and clears what cloth has given a rigid body. The including kernel binds `rigid` as array<u32>.
#include "contact/proximity/rigid_words.wgsl"
#include "state/wide.wgsl"

fn number_at(word : u32) -> f32 { return bitcast<f32>(rigid[word]); }
fn vector_at(word : u32) -> vec3f { return bitcast<vec3f>(vec3u(rigid[word], rigid[word + 1u], rigid[word + 2u])); }
fn quaternion_at(word : u32) -> vec4f { return vec4f(vector_at(word), number_at(word + 3u)); }
fn set_number(word : u32, value : f32) { rigid[word] = bitcast<u32>(value); }
fn set_vector(word : u32, value : vec3f) {
  for (var axis = 0u; axis < 3u; axis++) { rigid[word + axis] = bitcast<u32>(value[axis]); }
}
fn set_quaternion(word : u32, value : vec4f) {
  for (var axis = 0u; axis < 4u; axis++) { rigid[word + axis] = bitcast<u32>(value[axis]); }
}

fn take_three(word : u32) -> vec3f {
  var sum : vec3f;
  for (var axis = 0u; axis < 3u; axis++) {
    sum[axis] = number_of(rigid[word + 2u * axis], rigid[word + 2u * axis + 1u], kRigidUnits);
    rigid[word + 2u * axis] = 0u;
    rigid[word + 2u * axis + 1u] = 0u;
  }
  return sum;
}

struct Given { linear : vec3f, angular : vec3f }
fn take_sums(body : u32, sums : u32) -> Given {
  let mass = number_at(body + kRigidMass);
  let linear = take_three(body + sums);
  let angular = take_three(body + sums + 6u);
  return Given(mass * linear, mass * number_at(body + kRigidExtent) * angular);
}
