// The nodes of one cloth: where they begin among the vertices, and their number.
struct ClothNodes {  // mirror: src/method/multigrid/cloth_nodes.hpp
  first_vertex : u32,
  count : u32,
}
