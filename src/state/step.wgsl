// The parameters of a substep. One block a substep, 256 bytes apart (gpu/command_list.hpp, kStepStride).
// Mirror: src/state/step_params.hpp.
const kMaxGrabs = 4u;
const kDetectIfDue = 1u;   // look for pairs if a vertex is about to leave its reach
const kDetectAlways = 2u;
// Substeps from one that may search to the next: Method::search_interval in src/method/method.hpp.
override kDetectInterval : f32 = 4.0;
const kReachMargin = 1.25;    // an approaching feature may speed up until then

struct StepParams {
  acceleration : vec4f,  // m/s²: gravity and the external force, xyz; w: how far a collider may go in the substep, m
  dt : f32,              // s
  drag : f32,            // 1/s
  vertex_count : u32,
  spring_count : u32,
  force_scale : f32,     // fixed-point units per newton, a power of two
  force_limit : f32,     // N; a spring's tension is cut to this, so that no sum can overflow
  push_scale : f32,      // fixed-point units per metre, a power of two
  thickness : f32,       // m
  max_push : f32,        // m; a single push is cut to this, so that no sum can overflow
  first_motion : u32,    // where this substep's block of `motions` begins, in vec4f
  grab_rate : f32,       // 1/s; at most 1 / dt
  grab_speed : f32,      // m/s
  wind : vec4f,          // m/s: the mean, xyz; w: 1 where wind blows, else 0 and the four below are not read
  wind_wave_a : vec4f,   // 1/m: how a wave's phase grows along xyz, in turns; w: what time has taken off it, in [0, 1)
  wind_wave_b : vec4f,
  gust_a : vec4f,        // m/s: the amplitude of a wave of the wind, xyz
  gust_b : vec4f,
  grab_node : vec4u,     // the grabbed nodes; 0xffffffff where a place is free
  grab_target : array<vec4f, kMaxGrabs>,  // m: where they are pulled, xyz
  self_thickness : f32,    // m; 0: cloth does not meet cloth
  least_reach : f32,       // m: how far a slow vertex may go between two detections
  most_reach : f32,        // m: a fast one, unless that is too little until the next detection
  contact_damping : f32,   // ζ of equation (3) of docs/contact.md
  detect : u32,            // kDetectIfDue or kDetectAlways; 0: not in this substep
  step_ratio : f32,        // this substep's length by that of the one before; 0: without history
  point_count : u32,       // of colliders
  first_place : u32,       // where this substep's block of `places` begins
}
