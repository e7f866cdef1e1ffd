// The GLSL of the WebGL 2 baseline (webgl2.ts). One texel a node; texel (i, j) is node (i, j).

/** A triangle that covers the whole target. */
export const COVER = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`;

/**
 * One step of a node: gathers the forces of its up to twelve springs and integrates it. The same step, and the same
 * order of neighbours, as src/method/mass_spring/advance_grid.wgsl.
 */
export const ADVANCE = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D position;  // m
uniform sampler2D velocity;  // m/s
uniform ivec2 size;          // nodes
uniform vec3 stiffness;      // N/m: structural, shear, bend
uniform vec3 rest_length;    // m: along i, along j, diagonal
uniform float damping;       // N·s/m
uniform float inverse_mass;  // 1/kg
uniform vec3 gravity;        // m/s²
uniform float dt;            // s
layout(location = 0) out vec4 next_position;
layout(location = 1) out vec4 next_velocity;
const float kMinLength = 1e-9;  // m; a shorter spring has no direction, and pulls nowhere

vec3 pull(ivec2 node, ivec2 offset, vec3 x, vec3 v, float rest, float k) {
  ivec2 other = node + offset;
  if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, size))) { return vec3(0.0); }
  vec3 span = texelFetch(position, other, 0).xyz - x;
  float len = length(span);
  if (len < kMinLength) { return vec3(0.0); }
  vec3 direction = span / len;
  float rate = dot(texelFetch(velocity, other, 0).xyz - v, direction);  // m/s
  return (k * (len - rest) + damping * rate) * direction;
}

void main() {
  ivec2 node = ivec2(gl_FragCoord.xy);
  vec3 x = texelFetch(position, node, 0).xyz;
  vec3 v = texelFetch(velocity, node, 0).xyz;
  if (node.y == 0 && (node.x == 0 || node.x == size.x - 1)) {  // pinned
    next_position = vec4(x, 0.0);
    next_velocity = vec4(0.0);
    return;
  }
  vec3 force = pull(node, ivec2(-1, 0), x, v, rest_length.x, stiffness.x);
  force += pull(node, ivec2(1, 0), x, v, rest_length.x, stiffness.x);
  force += pull(node, ivec2(0, -1), x, v, rest_length.y, stiffness.x);
  force += pull(node, ivec2(0, 1), x, v, rest_length.y, stiffness.x);
  force += pull(node, ivec2(-1, -1), x, v, rest_length.z, stiffness.y);
  force += pull(node, ivec2(1, -1), x, v, rest_length.z, stiffness.y);
  force += pull(node, ivec2(-1, 1), x, v, rest_length.z, stiffness.y);
  force += pull(node, ivec2(1, 1), x, v, rest_length.z, stiffness.y);
  force += pull(node, ivec2(-2, 0), x, v, 2.0 * rest_length.x, stiffness.z);
  force += pull(node, ivec2(2, 0), x, v, 2.0 * rest_length.x, stiffness.z);
  force += pull(node, ivec2(0, -2), x, v, 2.0 * rest_length.y, stiffness.z);
  force += pull(node, ivec2(0, 2), x, v, 2.0 * rest_length.y, stiffness.z);
  vec3 next = v + dt * (gravity + inverse_mass * force);
  next_velocity = vec4(next, 0.0);
  next_position = vec4(x + dt * next, 0.0);
}`;

/** The cloth's vertices, from the texture where they lie; the normal is that of the grid (paths/cpu.ts). */
export const CLOTH_VERTEX = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D position;
uniform ivec2 size;
uniform mat4 view_projection;
out vec3 n;
vec3 at(ivec2 node) { return texelFetch(position, clamp(node, ivec2(0), size - 1), 0).xyz; }
void main() {
  ivec2 node = ivec2(gl_VertexID % size.x, gl_VertexID / size.x);
  n = cross(at(node + ivec2(1, 0)) - at(node - ivec2(1, 0)), at(node - ivec2(0, 1)) - at(node + ivec2(0, 1)));
  gl_Position = view_projection * vec4(at(node), 1.0);
}`;

/** weft's view "normals": byte = 255 (½ + ½ n) of the normal that faces the eye. */
export const CLOTH_FRAGMENT = `#version 300 es
precision highp float;
in vec3 n;
out vec4 color;
void main() { vec3 m = normalize(n); color = vec4(0.5 + 0.5 * (gl_FrontFacing ? m : -m), 1.0); }`;
