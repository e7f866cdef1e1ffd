// How cloth gives light back. No more than arrives: what sheen and gloss take, what is below them does not get; a test
// integrates both.
//   sheen   fibres that stand up, in a half of their colour's logarithm, as light goes through them too: Estevez and
//           Kulla, "Production friendly microfacet sheen BRDF" (2017); Neubelt and Pettineo's visibility (2013)
//   gloss   threads: GGX, smoother along than across (Heitz 2014), once for the warp and once for the weft
//   body    Lambert's, on both sides: what is translucent sends a part of it through
const kInvPi = 0.318309886;
const kSheenRoughness = 0.4;
const kGlossStraight = 0.08;  // reflectance of threads seen straight on, at gloss 1

struct Yarn {
  albedo : vec3f,
  sheen : f32,
  gloss : f32,
  grazing : f32,        // of gloss, at a slant: see gloss_taken
  translucency : f32,
  warp : f32,           // the part of the surface where the warp is above
  roughness : vec2f,    // along and across a thread
}

// A surface and its threads, all unit and at right angles.
struct Sheet {
  normal : vec3f,
  warp : vec3f,
  weft : vec3f,
}

// What sheen sends back of even light, by the cosine: at most 0.008 above the integral of `sheen_lobe`.
fn sheen_taken(cosine : f32) -> f32 {
  let x = 1.0 - cosine;
  return 0.0791 + x * (0.1161 + x * (1.1758 + x * (-2.0049 + x * 1.4018)));
}
// What gloss sends back of even light: a bound on the integral of the lobes.
fn gloss_taken(yarn : Yarn, cosine : f32) -> f32 {
  let x = 1.0 - cosine;
  return yarn.gloss * (0.92 * kGlossStraight + yarn.grazing * x * x * sqrt(x));
}

fn sheen_lobe(to_half : f32, to_light : f32, to_eye : f32) -> f32 {
  let sine = sqrt(max(1.0 - to_half * to_half, 1e-6));
  let spread = (2.0 + 1.0 / kSheenRoughness) * pow(sine, 1.0 / kSheenRoughness) * (0.5 * kInvPi);
  return spread / (4.0 * (to_light + to_eye - to_light * to_eye));
}

// Of threads along `thread`; light, eye and half: in the axes (thread, across, normal).
fn thread_lobe(roughness : vec2f, light : vec3f, eye : vec3f, half_way : vec3f) -> f32 {
  let h = vec3f(half_way.xy / roughness, half_way.z);
  let d = dot(h, h);
  let spread = kInvPi / (roughness.x * roughness.y * d * d);
  let hidden = light.z * length(vec3f(roughness * eye.xy, eye.z)) +
      eye.z * length(vec3f(roughness * light.xy, light.z));
  return spread * 0.5 / hidden;
}

// Radiance by the irradiance that arrives square to `to_light`, times that angle's cosine.
fn reflected(yarn : Yarn, sheet : Sheet, to_light : vec3f, to_eye : vec3f) -> vec3f {
  let facing = dot(sheet.normal, to_light);
  let l = saturate(facing);
  let v = max(dot(sheet.normal, to_eye), 0.02);
  let half_way = normalize(to_light + to_eye);
  let h = saturate(dot(sheet.normal, half_way));
  let slope = min(abs(facing), 1.0);
  let sheen_left = 1.0 - yarn.sheen * max(sheen_taken(v), sheen_taken(slope));
  let gloss_left = 1.0 - max(gloss_taken(yarn, v), gloss_taken(yarn, slope));
  let body = kInvPi * yarn.albedo * (sheen_left * gloss_left) *
      ((1.0 - yarn.translucency) * l + yarn.translucency * saturate(-facing));
  if (facing <= 0.0) { return body; }
  let light_in = vec3f(dot(sheet.warp, to_light), dot(sheet.weft, to_light), l);
  let eye_in = vec3f(dot(sheet.warp, to_eye), dot(sheet.weft, to_eye), v);
  let half_in = vec3f(dot(sheet.warp, half_way), dot(sheet.weft, half_way), h);
  let warp = thread_lobe(yarn.roughness, light_in, eye_in, half_in);
  let weft = thread_lobe(yarn.roughness, light_in.yxz, eye_in.yxz, half_in.yxz);
  let slant = 1.0 - saturate(dot(to_eye, half_way));
  let square = slant * slant;
  let fresnel = kGlossStraight + (1.0 - kGlossStraight) * square * square * slant;
  let gloss = yarn.gloss * fresnel * mix(weft, warp, yarn.warp);
  return body + l * (yarn.sheen * sqrt(yarn.albedo) * sheen_lobe(h, l, v) + sheen_left * gloss);
}

// The same of surroundings: `before` arrives from the normal's side, `behind` from the other (irradiance over pi),
// `mirrored` from where gloss mirrors.
fn reflected_around(yarn : Yarn, cosine : f32, before : vec3f, behind : vec3f, mirrored : vec3f) -> vec3f {
  let v = max(cosine, 0.02);
  let sheen = yarn.sheen * sheen_taken(v);
  let gloss = gloss_taken(yarn, v);
  let body = yarn.albedo * ((1.0 - yarn.translucency) * before + yarn.translucency * behind);
  return sheen * sqrt(yarn.albedo) * before + (1.0 - sheen) * (gloss * mirrored + (1.0 - gloss) * body);
}
