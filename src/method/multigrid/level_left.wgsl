// The residual that a level hands down, where a dispatch has stored it. The including kernel binds
// `vectors` and has the Level.
fn left_at(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kDirection, node)].xyz; }
