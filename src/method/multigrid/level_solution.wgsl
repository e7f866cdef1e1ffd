// The solution that a level hands up, where a dispatch has stored it. The including kernel binds `vectors` and has the
// Level.
fn solution_at(level : Level, node : u32) -> vec3f { return vectors[vector_at(level, kFirst, node)].xyz; }
