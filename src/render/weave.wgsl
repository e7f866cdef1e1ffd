// A woven check, as colours over the sheet: each thread has the colour of its place in the sett (the stripes' sequence,
// the same along and across), and a plain weave shows warp and weft in turn. Stripes are filtered by their own slope;
// threads fade into the mean of warp and weft before they get so thin that they would beat with the pixels.
struct Weave {  // mirror: WeaveParams in src/render/cloth_surface.hpp
  base : vec4f,    // linear colour; w: thread pitch, m
  dark : vec4f,    // linear colour of the broad stripe; w: sett, m
  accent : vec4f,  // linear colour of the thin lines
  back : vec4f,    // linear colour that the back is blended with; w: how far
}
const kFadeFrom = 0.25;  // threads a pixel
const kFadeTo = 0.50;
const kThreadContrast = 0.45;  // of single threads against the blend of warp and weft; 1 looks like a mosaic from afar

fn stripe(x : f32, middle : f32, half_width : f32, blur : f32) -> f32 {
  return saturate((half_width - abs(x - middle)) / blur + 0.5) * saturate(2.0 * half_width / blur);
}

// The colour of the thread at x [sett], blurred over `blur` [sett].
fn thread_color(weave : Weave, x : f32, blur : f32) -> vec3f {
  let at = abs(fract(x) - 0.5);  // mirrored: 0 in the middle of the sett, 0.5 at its ends
  var color = mix(weave.base.rgb, weave.dark.rgb, stripe(at, 0.0, 0.17, blur));
  color = mix(color, weave.accent.rgb, stripe(at, 0.0, 0.017, blur));
  color = mix(color, weave.dark.rgb, stripe(at, 0.27, 0.022, blur));
  return mix(color, weave.accent.rgb, stripe(at, 0.5, 0.025, blur));
}

// A thread's brightness over its width and over the arc between two crossings; `local` in [-0.5, 0.5]. Mean: 1.
fn thread_relief(across : f32, along : f32) -> f32 {
  let round = 1.0 - 2.4 * across * across;  // mean 0.8
  let arc = 1.0 - 0.9 * along * along;      // mean 0.925
  return round * arc / 0.74;
}

// `slope` is fwidth(uv), taken by the caller where control flow is uniform.
fn weave_color(weave : Weave, uv : vec2f, slope : vec2f) -> vec3f {
  let blur = max(slope / weave.dark.w, vec2f(1e-4));
  let warp = thread_color(weave, uv.x / weave.dark.w, blur.x);
  let weft = thread_color(weave, uv.y / weave.dark.w, blur.y);
  let threads = uv / weave.base.w;
  let local = fract(threads) - 0.5;
  let cell = vec2i(floor(threads));
  let warp_above = ((cell.x + cell.y) & 1) == 0;
  let above = select(weft, warp, warp_above);
  let relief = select(thread_relief(local.y, local.x), thread_relief(local.x, local.y), warp_above);
  let fade = 1.0 - smoothstep(kFadeFrom, kFadeTo, max(slope.x, slope.y) / weave.base.w);
  let blend = 0.5 * (warp + weft);
  return mix(blend, mix(blend * relief, above * relief, kThreadContrast), fade);
}
