// The light of a picture: a sun of some size, and surroundings that shine from everywhere, given in closed form.
// The includer declares `light`.
struct Light {  // mirror: LightParams in src/render/light.hpp
  sun : vec4f,                           // irradiance over pi; w: tangent of half the sun's angle
  irradiance : array<vec4f, 9>,          // over pi, of the surroundings: factors of 1, x, y, z, xy, yz, zx, xx, yy
  level : vec4f,                         // radiance at the horizon
  slope : vec4f,                         // its change by the direction's y
  curve : vec4f,                         // by the square of that
  area_direction : array<vec4f, 3>,      // unit; w: cosine of half the angle that the area covers
  area_radiance : array<vec4f, 3>,       // beside that behind it; w: 1 - that cosine
  backdrop_horizon : vec4f,              // linear, after the tone curve; w: 1 where a sky is seen, 0 for the studio's
  backdrop_zenith : vec4f,
}
const kAreas = 3u;

// What arrives over the half space around a unit `n`, over pi: spherical harmonics of the second order, as Ramamoorthi
// and Hanrahan have them ("An efficient representation for irradiance environment maps", 2001), as a polynomial.
fn irradiance(n : vec3f) -> vec3f {
  let e = light.irradiance[0].rgb + n.x * light.irradiance[1].rgb + n.y * light.irradiance[2].rgb +
      n.z * light.irradiance[3].rgb + n.x * n.y * light.irradiance[4].rgb + n.y * n.z * light.irradiance[5].rgb +
      n.z * n.x * light.irradiance[6].rgb + n.x * n.x * light.irradiance[7].rgb + n.y * n.y * light.irradiance[8].rgb;
  return max(e, vec3f(0.0));
}

// The radiance around a unit direction, blurred as a surface of this roughness (GGX's alpha) mirrors it.
fn surroundings(direction : vec3f, roughness : f32) -> vec3f {
  var sum = light.level.rgb + direction.y * (light.slope.rgb + direction.y * light.curve.rgb);
  let lobe = roughness * roughness;
  for (var i = 0u; i < kAreas; i++) {
    let edge = 0.03 + 0.6 * roughness;
    let at = dot(direction, light.area_direction[i].xyz) - light.area_direction[i].w;
    let share = light.area_radiance[i].w / (light.area_radiance[i].w + lobe);  // of the lobe that the area fills
    sum += share * smoothstep(-edge, edge, at) * light.area_radiance[i].rgb;
  }
  return sum;
}
