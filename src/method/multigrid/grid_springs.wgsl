// The matrix of a grid's finest level, as the poses of its springs: kept in 8 bytes each at the spring's first end, all
// of one number after the other. The including kernel binds `springs`.
#include "element/spring/spring_grid.wgsl"
#include "method/multigrid/grid_level.wgsl"
#include "method/multigrid/spring.wgsl"

fn spring_at(level : Level, node : u32, number : u32) -> u32 {
  return (cloth * select(4u, 6u, kBend) + number) * node_count(level) + node;
}

// A direction as a point of the octahedron |x| + |y| + |z| = 1, unfolded into a square (Meyer et al. 2010, "On
// Floating-Point Normal Vectors"), of 24 bits a side: as exact as f32. The stretch is a float of 5 bits of exponent and
// 10 of mantissa, since the least of it is what holds a stiff spring across; the largest says that there is no
// direction. The last bit: it is long.
const kSide = 8388607.0;            // 2²³ - 1
const kLeastExponent = 95u << 10u;  // of 2⁻³², to 10 bits of mantissa
const kNoDirection = 0x7fffu;
fn unfolded(at : vec2f) -> vec2f { return (1.0 - abs(at.yx)) * select(vec2f(-1.0), vec2f(1.0), at >= vec2f(0.0)); }

fn packed_pose(pose : SpringPose) -> vec2u {
  let n = pose.direction;
  let sum = abs(n.x) + abs(n.y) + abs(n.z);
  let rounded = (bitcast<u32>(pose.stretch) + 0x1000u) >> 13u;
  let kept = min(max(rounded, kLeastExponent) - kLeastExponent, kNoDirection - 1u);
  let word = select(kept, kNoDirection, sum == 0.0) | select(0u, 0x8000u, pose.is_long);
  let at = n.xy / max(sum, kMinLength);
  let bits = vec2u(vec2i(floor(select(unfolded(at), at, n.z >= 0.0) * kSide + 0.5))) << vec2u(8u);
  return bits | vec2u(word >> 8u, word & 0xffu);
}
fn unpacked_pose(bits : vec2u) -> SpringPose {
  let word = ((bits.x & 0xffu) << 8u) | (bits.y & 0xffu);
  let stretch = word & 0x7fffu;
  let at = vec2f(vec2i(bits) >> vec2u(8u)) / kSide;
  let height = 1.0 - abs(at.x) - abs(at.y);
  let n = vec3f(select(unfolded(at), at, height >= 0.0), height);
  let has_stretch = stretch > 0u && stretch < kNoDirection;
  return SpringPose(select(n / length(n), vec3f(0.0), stretch == kNoDirection),
                    select(0.0, bitcast<f32>((stretch + kLeastExponent) << 13u), has_stretch), word > 0x7fffu);
}
