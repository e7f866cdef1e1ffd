// Threads, as colours and slopes over a sheet. The warp runs along uv's first axis. Stripes are filtered by their own
// slope; threads fade into their mean before they get so thin that they would beat with the pixels.
#include "render/scramble.wgsl"
struct Fabric {  // mirror: FabricParams in src/render/fabric.hpp
  tint : vec4f,    // linear colour of lines; w: gloss
  warp : vec4f,    // linear colour; w: thread pitch, m
  weft : vec4f,    // linear colour; w: period of the pattern, m
  stripe : vec4f,  // linear colour of the broad stripe; w: sheen
  accent : vec4f,  // linear colour of the thin lines; w: translucency
  back : vec4f,    // linear colour that the back is blended with; w: how far
  rim : vec4f,     // width and height of the sheet, m; width of its hem, m, 0: none; contrast of single threads
  gloss : vec4f,   // roughness along and across a thread; reflectance at a slant; how uneven yarns are
  weave : u32,     // scene::Weave
  pattern : u32,   // scene::Pattern
  period : u32,    // of the crossings: threads
  shift : u32,     // of the crossings from a thread to the next
}
const kKnit = 3u;  // scene::Weave
const kNone = 4u;
const kCheck = 1u;  // scene::Pattern
const kStripes = 2u;
const kFadeFrom = 0.25;  // threads a pixel
const kFadeTo = 0.50;
const kCourse = 0.8;     // height of a row of loops, by the width of a column

struct Threads {
  color : vec3f,
  slope : vec2f,       // rise of the surface along uv
  warp : f32,          // the part where the warp is above, 0 to 1
  translucency : f32,
}

fn stripe(x : f32, middle : f32, half_width : f32, blur : f32) -> f32 {
  return saturate((half_width - abs(x - middle)) / blur + 0.5) * saturate(2.0 * half_width / blur);
}

// The colour of the thread at x [period], blurred over `blur` [period].
fn thread_color(fabric : Fabric, yarn : vec3f, x : f32, blur : f32) -> vec3f {
  let at = abs(fract(x) - 0.5);  // mirrored: 0 in the middle of the period, 0.5 at its ends
  if (fabric.pattern == kStripes) { return mix(yarn, fabric.stripe.rgb, stripe(at, 0.0, 0.25, blur)); }
  if (fabric.pattern != kCheck) { return yarn; }
  var color = mix(yarn, fabric.stripe.rgb, stripe(at, 0.0, 0.17, blur));
  color = mix(color, fabric.accent.rgb, stripe(at, 0.0, 0.017, blur));
  color = mix(color, fabric.stripe.rgb, stripe(at, 0.27, 0.022, blur));
  return mix(color, fabric.accent.rgb, stripe(at, 0.5, 0.025, blur));
}

// A thread's brightness over its width and over the arc between two crossings; both in [-0.5, 0.5]. Mean: 1.
fn thread_relief(across : f32, along : f32) -> f32 {
  let round = 1.0 - 2.4 * across * across;  // mean 0.8
  let arc = 1.0 - 0.9 * along * along;      // mean 0.925
  return round * arc / 0.74;
}

fn hash(cell : vec2i) -> f32 {
  return scrambled((bitcast<u32>(cell.x) * 0x9e3779b9u) ^ (bitcast<u32>(cell.y) * 0x85ebca6bu + 0x27d4eb2fu));
}
// Smooth, from -0.5 to 0.5, mean 0.
fn noise(at : vec2f) -> f32 {
  let cell = vec2i(floor(at));
  let f = fract(at);
  let s = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(cell), hash(cell + vec2i(1, 0)), s.x),
             mix(hash(cell + vec2i(0, 1)), hash(cell + vec2i(1, 1)), s.x), s.y);
}
// How yarns are thicker here and thinner there: streaks along them, of several threads' width. `at` [m]: along and
// across.
fn streaks(at : vec2f, pitch : f32, width : f32) -> f32 {
  let thin = vec2f(70.0, 3.0) * pitch;
  let broad = vec2f(420.0, 18.0) * pitch;
  return noise(at / thin) * (1.0 - smoothstep(0.25, 0.5, width / thin.y)) +
      noise(at / broad + 17.0) * (1.0 - smoothstep(0.25, 0.5, width / broad.y));
}

// `width` is fwidth(uv), taken by the caller where control flow is uniform.
fn threads_at(fabric : Fabric, uv : vec2f, width : vec2f, front : bool) -> Threads {
  let blur = max(width / fabric.weft.w, vec2f(1e-4));
  let pitch = fabric.warp.w;
  var warp_color = thread_color(fabric, fabric.warp.rgb, uv.y / fabric.weft.w, blur.y);
  var weft_color = thread_color(fabric, fabric.weft.rgb, uv.x / fabric.weft.w, blur.x);
  if (fabric.pattern == kStripes) { weft_color = mix(fabric.weft.rgb, warp_color, 0.75); }  // they stay crisp
  let uneven = fabric.gloss.w;
  warp_color *= 1.0 + uneven * streaks(uv, pitch, width.y);
  weft_color *= 1.0 + uneven * streaks(uv.yx + 3.7, pitch, width.x);
  let legs = select(1.0, 2.0, fabric.weave == kKnit);  // a column of loops has two
  let fade = 1.0 - smoothstep(kFadeFrom, kFadeTo, legs * max(width.x, width.y) / pitch);
  let on_front = 1.0 - 1.0 / f32(fabric.period);
  let share = select(1.0 - on_front, on_front, front);
  let blend = mix(weft_color, warp_color, share);
  var result = Threads(blend, vec2f(0.0), share, fabric.accent.w);
  let threads = uv / pitch;
  if (fabric.weave == kKnit) {
    let column = fract(threads.x) - 0.5;
    let across = (abs(column) - 0.25) * 2.0;  // of a leg of a loop
    let along = fract(threads.y / kCourse - 1.3 * abs(column)) - 0.5;
    let relief = (1.0 - 2.8 * across * across) * (1.0 - 0.8 * along * along) / 0.7156;
    result.color = blend * mix(1.0, relief, 0.6 * fade);
    result.slope = fade * vec2f(-1.1 * across * select(-2.0, 2.0, column > 0.0), -0.7 * along);
  } else if (fabric.weave != kNone) {
    let cell = vec2i(floor(threads));
    let local = fract(threads) - 0.5;
    let period = i32(fabric.period);
    let phase = ((cell.x + i32(fabric.shift) * cell.y) % period + period) % period;
    let warp_above = (phase < period - 1) == front;
    // Of floats, the longer ones go over period - 1 crossings.
    let long = (f32(phase) + local.x + 0.5) / f32(period - 1) - 0.5;
    let along = select(local.y, select(local.x, long, front), warp_above);
    let across = select(local.x, local.y, warp_above);
    let above = select(weft_color, warp_color, warp_above);
    let relief = thread_relief(across, clamp(along, -0.5, 0.5));
    result.color = mix(blend, mix(blend * relief, above * relief, fabric.rim.w), fade);
    let rise = fade * vec2f(-0.5 * along, -1.3 * across);
    result.slope = select(rise.yx, rise, warp_above);
    result.warp = mix(share, select(0.0, 1.0, warp_above), fade);
  }
  if (fabric.rim.z > 0.0) {  // a hem: folded over, and sewn
    let inward = min(uv, fabric.rim.xy - uv);
    let nearest = min(inward.x, inward.y);
    let line = select(uv.x, uv.y, inward.x < inward.y) / fabric.rim.z;
    let thin = max(max(width.x, width.y) / fabric.rim.z, 1e-4);
    let at = nearest / fabric.rim.z;
    let doubled = saturate((1.0 - at) / thin + 0.5);
    let stitch = stripe(at, 0.82, 0.035, thin) * mix(0.6, select(0.0, 1.0, fract(line * 2.5) < 0.6),
                                                    1.0 - smoothstep(0.1, 0.3, thin));
    result.color *= 1.0 - 0.30 * stripe(at, 1.0, 0.05, thin) - 0.22 * stitch;
    result.translucency *= 1.0 - 0.5 * doubled;
  }
  if (!front) { result.color = mix(result.color, fabric.back.rgb, fabric.back.w); }
  return result;
}
