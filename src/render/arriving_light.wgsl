// How much of the sky and of the sun arrives at each surface that is seen, at half the picture's size: 9 samples of
// both are spread over 3 x 3 texels, which smooth_light.wgsl gathers.
// Sky: Jimenez, Wu, Pesce, Jarabo, "Practical real-time strategies for accurate indirect occlusion" (2016): along each
// slice through the eye's ray the horizons on both sides, and the cosine-weighted part between them in closed form.
// Sun: Fernando, "Percentage-closer soft shadows" (2005), with the sun's own cone: of what lies in it between a surface
// and the sun the mean distance says how wide the penumbra is.
#include "render/frame.wgsl"
#include "render/depth_metres.wgsl"
#include "render/surroundings.wgsl"
//                                                                                 elements
@group(0) @binding(0) var<uniform>       frame          : Frame;                // 1
@group(0) @binding(1) var<uniform>       light          : Light;                // 1
@group(0) @binding(2) var                depth_map      : texture_depth_2d;     // as the eye sees it
@group(0) @binding(3) var                shadow_map     : texture_depth_2d;
@group(0) @binding(4) var                shadow_sampler : sampler_comparison;
#include "render/half_size.wgsl"
const kPi = 3.14159265;
const kSlices = 2u;
const kSteps = 3u;             // on each side of a slice
const kMostTexels = 96.0;      // of this map that a step of a slice goes
const kFullWithin = 0.6;       // of the reach, in which what keeps the sky away does so wholly
const kSearchTaps = 8u;
const kTaps = 8u;
const kCone = 2.0;             // of the sun's cone, in which a blocker says how wide the penumbra is
const kGoldenAngle = 2.39996323;
const kNormalOffset = 2.0;     // texel of the shadow map, as in lighting.wgsl
const kSteepest = 5.0;         // slope of a surface against the sun's ray up to which taps follow it
const kPenumbraTexels = 8.0;   // of this map, that 1 of the third channel stands for

fn place(texel : vec2f, depth : f32) -> vec3f {
  let at = (texel + 0.5) / vec2f(textureDimensions(depth_map));
  let ray = frame.forward.xyz + (2.0 * at.x - 1.0) * frame.right.xyz + (1.0 - 2.0 * at.y) * frame.up.xyz;
  return frame.eye.xyz + distance_of(depth) * ray;
}

// The cosine of the horizon along a side of a slice, from that of the surface's own, `lowest`.
fn horizon(texel : vec2i, p : vec3f, to_eye : vec3f, step : vec2f, jitter : f32, lowest : f32) -> f32 {
  var highest = lowest;
  for (var i = 0u; i < kSteps; i++) {
    let part = (f32(i) + jitter) / f32(kSteps);
    let away = vec2i(round(step * part * part + 1.2 * normalize(step)));
    let other = texel + away;
    let inside = all(other >= vec2i(0)) && all(other <= last_texel());
    let span = place(vec2f(other), depth_at(other)) - p;
    let size = max(length(span), 1e-6);
    let share = saturate((1.0 - size / frame.forward.w) / (1.0 - kFullWithin));
    highest = max(highest, mix(lowest, dot(span, to_eye) / size, select(0.0, share, inside)));
  }
  return highest;
}

// The cosine-weighted part of the half space around n that is open, 0 to 1.
fn open_sky(texel : vec2i, p : vec3f, n : vec3f, turn : f32, jitter : f32, slices : u32) -> f32 {
  let away = frame.eye.xyz - p;
  let to_eye = normalize(away);
  let rows = f32(textureDimensions(depth_map).y);
  let reach = clamp(frame.forward.w / footprint(dot(-away, frame.forward.xyz), rows), 2.0, kMostTexels);
  let right = normalize(frame.right.xyz);
  let up = normalize(frame.up.xyz);
  var open = 0.0;
  for (var k = 0u; k < slices; k++) {
    let angle = (f32(k) + turn) * (kPi / f32(kSlices));
    let side = vec2f(cos(angle), sin(angle));
    let along = side.x * right + side.y * up;
    let across = along - to_eye * dot(along, to_eye);
    let axis = normalize(cross(across, to_eye));
    let in_slice = n - axis * dot(n, axis);
    let size = max(length(in_slice), 1e-4);
    let cosine = clamp(dot(in_slice, to_eye) / size, -1.0, 1.0);
    let tilt = select(-1.0, 1.0, dot(across, in_slice) >= 0.0) * acos(cosine);
    let step = reach * vec2f(side.x, -side.y);
    let first = horizon(texel, p, to_eye, step, jitter, cos(tilt + 0.5 * kPi));
    let second = horizon(texel, p, to_eye, -step, jitter, cos(tilt - 0.5 * kPi));
    let high = acos(clamp(first, -1.0, 1.0));
    let low = -acos(clamp(second, -1.0, 1.0));
    open += 0.25 * size * (2.0 * cosine + 2.0 * (low + high) * sin(tilt) - cos(2.0 * low - tilt) -
                           cos(2.0 * high - tilt));
  }
  return saturate(open / f32(kSlices));
}

// The part of the sun that arrives, and the radius of the penumbra, m.
fn sun_seen(p : vec3f, normal : vec3f, turn : f32, taken : bool) -> vec2f {
  let to_sun = frame.to_light.xyz;
  let n = select(-normal, normal, dot(normal, to_sun) > 0.0);
  let facing = max(dot(n, to_sun), 1e-3);
  let slope = sqrt(saturate(1.0 - facing * facing));
  let texel = frame.to_light.w;
  let lifted = p + n * (kNormalOffset * texel * (0.35 + 0.65 * slope));
  let clip = frame.light_projection * vec4f(lifted, 1.0);  // orthographic: w is 1
  let at = vec2f(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y);
  let span = frame.shadow_span.xyz;
  let depth = min(clip.z, 1.0);
  let inside = taken && all(at >= vec2f(0.0)) && all(at <= vec2f(1.0));
  // Taps follow the surface's own plane: its rise towards the sun by a metre along the map's axes.
  let axes = transpose(mat3x3f(frame.light_projection[0].xyz, frame.light_projection[1].xyz,
                               frame.light_projection[2].xyz));
  let rise = clamp(vec2f(dot(axes[0], n) * span.x, -dot(axes[1], n) * span.y) * (0.5 / facing), vec2f(-kSteepest),
                   vec2f(kSteepest));
  let widest = min(light.sun.w * depth * span.z, 0.2 * min(span.x, span.y));
  let size = vec2f(textureDimensions(shadow_map));
  let bias = 1.5 * texel;
  var blockers = 0.0;
  var distances = 0.0;
  for (var i = 0u; i < select(0u, kSearchTaps, inside); i++) {
    let part = f32(i) / f32(kSearchTaps - 1u);
    let angle = f32(i) * kGoldenAngle + turn * 2.0 * kPi;
    let offset = widest * part * part * vec2f(cos(angle), sin(angle));
    let there = vec2i(clamp((at + offset / span.xy) * size, vec2f(0.0), size - 1.0));
    let between = (depth - textureLoad(shadow_map, there, 0)) * span.z;
    let blocks = between + dot(rise, offset) > bias && length(offset) <= kCone * between * light.sun.w + texel;
    blockers += select(0.0, 1.0, blocks);
    distances += select(0.0, between, blocks);
  }
  let radius = max(light.sun.w * distances / max(blockers, 1.0), texel);
  var seen = 0.0;
  for (var i = 0u; i < select(0u, kTaps, blockers > 0.0); i++) {
    let angle = f32(i) * kGoldenAngle + turn * 2.0 * kPi;
    let offset = radius * sqrt((f32(i) + 0.5) / f32(kTaps)) * vec2f(cos(angle), sin(angle));
    seen += textureSampleCompareLevel(shadow_map, shadow_sampler, at + offset / span.xy,
                                      depth + (dot(rise, offset) - 0.2 * bias) / span.z);
  }
  return select(vec2f(1.0, 0.0), vec2f(seen / f32(kTaps), radius), blockers > 0.0);
}

@fragment
fn fragment_main(@builtin(position) at : vec4f) -> @location(0) vec4f {
  let texel = vec2i(at.xy);
  let depth = depth_at(texel);
  let covered = depth < 1.0;
  let slope = depth_slope(texel, depth);
  let p = place(vec2f(texel), depth);
  let along = place(vec2f(texel) + vec2f(1.0, 0.0), depth + slope.x) - p;
  let down = place(vec2f(texel) + vec2f(0.0, 1.0), depth + slope.y) - p;
  let n = unit_or(cross(down, along), -frame.forward.xyz);
  let cell = vec2u(texel) % 3u;
  let number = cell.x + 3u * cell.y;
  let turn = f32(number * 5u % 9u) / 9.0;
  let jitter = (f32(number * 2u % 9u) + 0.5) / 9.0;
  let open = open_sky(texel, p, n, turn, jitter, select(0u, kSlices, covered));
  let sun = sun_seen(p, n, turn, covered);
  let soft = sun.y / footprint(distance_of(depth), f32(textureDimensions(depth_map).y)) / kPenumbraTexels;
  return vec4f(select(1.0, open, covered), sun.x, saturate(soft), 1.0);
}
