// A cloth's surface in the textured view, straight from the state's buffers. One vertex per index of the triangle list.
#include "render/lit.wgsl"
#include "render/reflection.wgsl"
#include "render/weave.wgsl"
//                                                                            elements      unit
@group(0) @binding(0) var<uniform>       frame     : Frame;                // 1
@group(0) @binding(1) var<uniform>       light     : Light;                // 1
@group(0) @binding(2) var                depth_map : texture_depth_2d;     // as the eye sees it
@group(0) @binding(3) var                arriving  : texture_2d<f32>;      // red: sky, green: sun
@group(0) @binding(4) var<uniform>       fabric    : Fabric;               // 1
@group(0) @binding(5) var<storage, read> position  : array<vec4f>;         // vertex_count  m
@group(0) @binding(6) var<storage, read> normal    : array<vec4f>;         // vertex_count  unit
@group(0) @binding(7) var<storage, read> uv        : array<vec2f>;         // vertex_count  m
const kPi = 3.14159265;

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) normal : vec3f,
  @location(2) uv : vec2f,
}

@vertex
fn vertex_main(@builtin(vertex_index) i : u32) -> Vertex {
  let p = position[i].xyz;
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, normal[i].xyz, uv[i]);
}

// The threads' directions on a surface, from how places and uv change over the picture.
fn sheet_of(n : vec3f, across : array<vec3f, 2>, turned : array<vec2f, 2>) -> Sheet {
  let warp = across[0] * turned[1].y - across[1] * turned[0].y;
  let side = turned[0].x * turned[1].y - turned[1].x * turned[0].y;
  let flat = select(-1.0, 1.0, side >= 0.0) * warp;
  let helper = select(vec3f(0.0, 0.0, 1.0), vec3f(1.0, 0.0, 0.0), abs(n.x) < 0.6);
  let t = unit_or(flat - n * dot(n, flat), normalize(cross(n, helper)));
  let b = cross(n, t);
  let weft = select(-1.0, 1.0, side >= 0.0) * (across[1] * turned[0].x - across[0] * turned[1].x);
  return Sheet(n, t, select(-b, b, dot(b, weft) >= 0.0));
}

@fragment
fn fragment_main(in : Vertex, @builtin(front_facing) front : bool) -> @location(0) vec4f {
  let across = array(dpdx(in.position), dpdy(in.position));
  let turned = array(dpdx(in.uv), dpdy(in.uv));
  let here = arriving_at(in.clip, vec2f(dpdx(in.clip.z), dpdy(in.clip.z)));
  let threads = threads_at(fabric, in.uv, abs(turned[0]) + abs(turned[1]), front);
  let to_eye = normalize(frame.eye.xyz - in.position);
  let smooth_normal = unit_or(in.normal, to_eye) * select(-1.0, 1.0, front);
  var sheet = sheet_of(smooth_normal, across, turned);
  sheet.normal = normalize(sheet.normal - threads.slope.x * sheet.warp - threads.slope.y * sheet.weft);
  let yarn = Yarn(threads.color, fabric.stripe.w, fabric.tint.w, fabric.gloss.z, threads.translucency, threads.warp,
                  fabric.gloss.xy);
  let sun = kPi * here.sun * light.sun.rgb * reflected(yarn, sheet, frame.to_light.xyz, to_eye);
  let open = lit_by(here.sky, threads.color);
  let mirrored = here.sky * surroundings(reflect(-to_eye, sheet.normal), sqrt(fabric.gloss.x * fabric.gloss.y));
  let around = reflected_around(yarn, dot(sheet.normal, to_eye), open * irradiance(sheet.normal),
                                open * irradiance(-sheet.normal), mirrored);
  return vec4f(tone_map(sun + around), 1.0);
}
