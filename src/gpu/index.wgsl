// The element or the block of elements that an invocation or a workgroup works on. Past 65,535 workgroups a dispatch
// has rows of 32,768 (gpu/kernel.hpp).
override kWorkgroupSize : u32 = 256;
const kGroupsPerRow = 32768u;

fn flat_index(id : vec3u) -> u32 { return id.y * (kGroupsPerRow * kWorkgroupSize) + id.x; }
fn flat_group(id : vec3u) -> u32 { return id.y * kGroupsPerRow + id.x; }
