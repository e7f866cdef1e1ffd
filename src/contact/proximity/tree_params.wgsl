// Which tree is refitted. Mirror: TreeParams in src/contact/proximity/tree_refit.hpp.
struct TreeParams {
  tree : u32,            // the tree's first word
  top : u32,             // its highest level
  first_triangle : u32,  // of `triangles`
  triangle_count : u32,
}
