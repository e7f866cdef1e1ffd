// Of a matrix whose rows one invocation takes: what mesh_operator.wgsl has for several.
const kLanes = 1u;
fn share_product(level : Level, x : u32, node : u32, local : u32, is_idle : bool) {}
