// The triangles around each vertex. The including kernel binds `corners`, and has corner_place(vertex), m.

// corners: vertex_count + 1 rows, then the triangles around each vertex, three words each (method/corners.hpp): as long
// as twice the vertex's share of the triangle's area, m².
fn normal_of(own : vec3f, entry : u32) -> vec3f {
  let share = bitcast<f32>(corners[entry + 2u]);
  return share * cross(corner_place(corners[entry]) - own, corner_place(corners[entry + 1u]) - own);
}
