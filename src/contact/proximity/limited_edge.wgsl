// An edge of cloth with a strain limit. Mirror: src/model/limited_edges.hpp.
struct LimitedEdge {
  a : u32,
  b : u32,
  longest : f32,  // m
}
