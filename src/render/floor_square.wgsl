// The square that is drawn of a plane. The includer declares `frame` and `plane`.
struct Plane {  // mirror: PlaneParams in src/render/floor.hpp
  center : vec4f,  // m, the point below the middle of the picture; w: half the side, m
  along : vec4f,   // unit; w: a checker square's side, m
  across : vec4f,  // unit; w: 1 + scene::Material, 0 for a plane seen only by the shadows on it
}

struct Vertex {
  @builtin(position) clip : vec4f,
  @location(0) position : vec3f,
  @location(1) at : vec2f,  // m from the center
}

fn floor_vertex(i : u32) -> Vertex {
  var corners = array(vec2f(-1, -1), vec2f(1, -1), vec2f(1, 1), vec2f(-1, -1), vec2f(1, 1), vec2f(-1, 1));
  let at = plane.center.w * corners[i];
  let p = plane.center.xyz + at.x * plane.along.xyz + at.y * plane.across.xyz;
  return Vertex(frame.view_projection * vec4f(p, 1.0), p, at);
}

// A checker board filtered over a box of `width`: Quilez, iquilezles.org/articles/checkerfiltering.
fn checker(at : vec2f, width : vec2f) -> f32 {
  let w = max(width, vec2f(1e-4));
  let i = 2.0 * (abs(fract((at - 0.5 * w) * 0.5) - 0.5) - abs(fract((at + 0.5 * w) * 0.5) - 0.5)) / w;
  return 0.5 - 0.5 * i.x * i.y;
}
