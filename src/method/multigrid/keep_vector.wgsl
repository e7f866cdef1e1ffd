// Stores an entry of one of a level's vectors. The including kernel binds `vectors` and has the Level. A kernel that
// keeps it elsewhere too has a function of its own.
fn keep_vector(level : Level, x : u32, node : u32, value : vec3f) {
  vectors[vector_at(level, x, node)] = vec4f(value, 0.0);
}
