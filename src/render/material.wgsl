// What obstacles are made of, and how it takes light: plaster, marble with veins, brushed metal. The includer declares
// `frame` and `light`.
#include "render/scramble.wgsl"
struct Stone {
  albedo : vec3f,
  mirror : vec3f,     // reflectance seen straight on
  roughness : f32,    // GGX's alpha
}
const kVeins = 1.6;  // size of a vein's wave, in the reach of occlusion
const kPlaster = vec3f(0.360, 0.335, 0.305);
const kMarble = 1u;  // scene::Material
const kMetal = 2u;

fn hash3(cell : vec3i) -> f32 {
  return scrambled((bitcast<u32>(cell.x) * 0x9e3779b9u) ^ (bitcast<u32>(cell.y) * 0x85ebca6bu) ^
                   (bitcast<u32>(cell.z) * 0xc2b2ae35u + 0x27d4eb2fu));
}
fn noise3(at : vec3f) -> f32 {
  let c = vec3i(floor(at));
  let f = fract(at);
  let s = f * f * (3.0 - 2.0 * f);
  let low = mix(mix(hash3(c), hash3(c + vec3i(1, 0, 0)), s.x),
                mix(hash3(c + vec3i(0, 1, 0)), hash3(c + vec3i(1, 1, 0)), s.x), s.y);
  let high = mix(mix(hash3(c + vec3i(0, 0, 1)), hash3(c + vec3i(1, 0, 1)), s.x),
                 mix(hash3(c + vec3i(0, 1, 1)), hash3(c + vec3i(1, 1, 1)), s.x), s.y);
  return mix(low, high, s.z);
}

// Reads  at: a place on the obstacle, which moves with it, in sizes of the veins; width: of a pixel there.
fn stone(material : u32, at : vec3f, width : f32) -> Stone {
  if (material == kMetal) { return Stone(vec3f(0.0), vec3f(0.78, 0.76, 0.73), 0.24); }
  // A loop, since software adapters go through both sides of an `if`, but not through a loop that no lane needs.
  var cloudy = 0.0;
  var scale = 1.0;
  for (var i = 0u; i < select(0u, 4u, material == kMarble); i++) {
    cloudy += noise3(at * scale + f32(i) * 11.3) / scale * (1.0 - smoothstep(0.25, 0.5, width * scale));
    scale *= 2.1;
  }
  if (material != kMarble) { return Stone(kPlaster, vec3f(0.02), 0.5); }
  let wave = abs(fract(0.8 * at.x + 0.6 * at.y + 0.45 * at.z + 1.9 * cloudy) - 0.5);
  let vein = saturate(1.0 - wave / 0.11) * (1.0 - smoothstep(0.1, 0.4, width));
  let ground = mix(vec3f(0.62, 0.61, 0.59), vec3f(0.48, 0.48, 0.49), saturate(0.5 + 1.2 * cloudy));
  return Stone(mix(ground, vec3f(0.16, 0.17, 0.20), 0.75 * vein * vein), vec3f(0.04), 0.14);
}

// What a mirror of this roughness sends back of even light, by the cosine: Karis, "Physically based shading on mobile"
// (2014).
fn mirror_taken(mirror : vec3f, roughness : f32, cosine : f32) -> vec3f {
  let rough = sqrt(roughness);
  let r = rough * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
  let a = min(r.x * r.x, exp2(-9.28 * cosine)) * r.x + r.y;
  let ab = vec2f(-1.04, 1.04) * a + r.zw;
  return mirror * ab.x + ab.y;
}

fn stone_light(stuff : Stone, n : vec3f, to_eye : vec3f, here : Arriving) -> vec3f {
  let v = clamp(dot(n, to_eye), 0.02, 1.0);
  let l = saturate(dot(n, frame.to_light.xyz));
  let half_way = normalize(to_eye + frame.to_light.xyz);
  let h = saturate(dot(n, half_way));
  let slant = 1.0 - saturate(dot(to_eye, half_way));
  let square = slant * slant;
  let fresnel = stuff.mirror + (1.0 - stuff.mirror) * (square * square * slant);
  let lobe = thread_lobe(vec2f(stuff.roughness), vec3f(sqrt(1.0 - l * l), 0.0, l), vec3f(sqrt(1.0 - v * v), 0.0, v),
                         vec3f(sqrt(1.0 - h * h), 0.0, h));
  let taken = mirror_taken(stuff.mirror, stuff.roughness, v);
  let sun = here.sun * l * light.sun.rgb * (stuff.albedo * (1.0 - taken) + 3.14159265 * lobe * fresnel);
  let mirrored = here.sky * surroundings(reflect(-to_eye, n), stuff.roughness);
  return sun + lit_by(here.sky, stuff.albedo) * irradiance(n) * stuff.albedo * (1.0 - taken) + taken * mirrored;
}
