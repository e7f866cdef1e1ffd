// The operand of a level's matrix: one of its vectors. The including kernel binds `vectors` and has the Level.
// Kernels that take it from elsewhere, or add something to it, have an operand of their own.
fn operand(level : Level, x : u32, node : u32) -> vec3f { return vectors[vector_at(level, x, node)].xyz; }
