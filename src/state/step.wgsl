// What a substep's kernels read: one block a substep, 512 bytes apart (gpu/command_list.hpp, kStepStride). Each part
// has an owner that fills it, and room to grow up to its @size. Mirror: src/state/step_block.hpp.
//
// one a step: StepBlock
//
// That line is for the loader (gpu/shader_source.cpp): a uniform of this type is the block of the dispatch's substep.
const kDetectNo = 0u;
const kDetectIfDue = 1u;   // look for pairs if a vertex is about to leave its reach
const kDetectAlways = 2u;
// Substeps from one that may search to the next: Method::search_interval in src/method/method.hpp.
override kDetectInterval : f32 = 4.0;
const kReachMargin = 1.25;    // an approaching feature may speed up until then

struct StepTime {
  dt : f32,            // s
  step_ratio : f32,    // this substep's length by that of the one before; 0: without history
}
struct StepNodes {
  count : u32,
  first_motion : u32,  // where this substep's block of `motions` begins, in vec4f
}
struct StepContact {
  thickness : f32,        // m
  self_thickness : f32,   // m; 0: cloth does not meet cloth
  push_scale : f32,       // fixed-point units per metre, a power of two
  max_push : f32,         // m; a single push is cut to this, so that no sum can overflow
  most_reach : f32,       // m: a fast one, unless that is too little until the next detection
  restitution : f32,
  collider_travel : f32,  // m: how far a collider may go in the substep
  detect : u32,           // kDetectNo, kDetectIfDue or kDetectAlways
  point_count : u32,      // of colliders
  first_place : u32,      // where this substep's block of `places` begins
  most_delay : u32,       // µs, of the frame's substeps together: docs/contact.md, equation (6h)
}
struct StepAir {
  acceleration : vec4f,  // m/s²: gravity and the external force, xyz
  wind : vec4f,          // m/s: the mean, xyz; w: 1 where wind blows, else 0: the air is still
  wind_wave_a : vec4f,   // 1/m: how a wave's phase grows along xyz, in turns; w: what time has taken off it, in [0, 1)
  wind_wave_b : vec4f,
  gust_a : vec4f,        // m/s: the amplitude of a wave of the wind, xyz
  gust_b : vec4f,
  drag : f32,            // 1/s
  pressure : f32,        // kg/m³: half the air's density times each of its coefficients (method/air.wgsl)
  lift : f32,
  friction : f32,
}
struct StepHands {
  first : u32,         // of the nodes that include all grabbed ones
  count : u32,         // of them; 0: none is grabbed
  still : u32,         // slots below have a goal for all substeps of the frame, the others one for each
  first_still : u32,   // where in `motions` the goal of slot 0 is
  first_moving : u32,  // where this substep's goal of slot 0 would be, if that were not still
  rate : f32,          // 1/s; at most 1 / dt
  speed : f32,         // m/s
}
// A method's own numbers (Solver::fill).
struct StepMethod {
  spring_count : u32,
  force_scale : f32,   // fixed-point units per newton, a power of two
  force_limit : f32,   // N; a spring's tension is cut to this, so that no sum can overflow
}

struct StepBlock {
  @size(32) time : StepTime,
  @size(32) nodes : StepNodes,
  @size(64) contact : StepContact,
  @size(128) air : StepAir,
  @size(128) hands : StepHands,
  @size(128) method : StepMethod,
}
