// A vector across a normal, and no longer than what friction allows.
fn part_across(v : vec3f, n : vec3f) -> vec3f { return v - dot(v, n) * n; }
fn no_longer(v : vec3f, most : f32) -> vec3f {
  let size = length(v);
  return select(1.0, most / size, size > most) * v;
}
