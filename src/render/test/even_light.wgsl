// What cloth sends back of a radiance of 1 from everywhere, for tests: of a sun in each direction, and of surroundings.
// One invocation per sample.
#include "gpu/index.wgsl"
#include "render/reflection.wgsl"
//                                                                         elements
@group(0) @binding(0) var<storage, read>       samples : array<vec4f>;  // 2 each: see below
@group(0) @binding(1) var<storage, read_write> sent    : array<vec2f>;  // 1 each
const kParts = 160u;  // along the sphere's axis; twice as many around it

@compute @workgroup_size(kWorkgroupSize)
fn even_light(@builtin(global_invocation_id) id : vec3u) {
  let index = flat_index(id);
  if (index >= arrayLength(&sent)) { return; }
  let a = samples[2u * index];       // sheen, gloss, grazing, translucency
  let b = samples[2u * index + 1u];  // roughness along and across, cosine and azimuth of the eye
  let yarn = Yarn(vec3f(1.0), a.x, a.y, a.z, a.w, 0.7, b.xy);
  let sheet = Sheet(vec3f(0.0, 0.0, 1.0), vec3f(1.0, 0.0, 0.0), vec3f(0.0, 1.0, 0.0));
  let flat = sqrt(1.0 - b.z * b.z);
  let eye = vec3f(flat * cos(b.w), flat * sin(b.w), b.z);
  var sum = 0.0;
  for (var i = 0u; i < kParts; i++) {
    let z = (2.0 * f32(i) + 1.0) / f32(kParts) - 1.0;
    let r = sqrt(1.0 - z * z);
    for (var j = 0u; j < 2u * kParts; j++) {
      let turn = 3.14159265 * (f32(j) + 0.5) / f32(kParts);
      sum += reflected(yarn, sheet, vec3f(r * cos(turn), r * sin(turn), z), eye).x;
    }
  }
  let part = 4.0 * 3.14159265 / f32(2u * kParts * kParts);
  sent[index] = vec2f(part * sum, reflected_around(yarn, b.z, vec3f(1.0), vec3f(1.0), vec3f(1.0)).x);
}
