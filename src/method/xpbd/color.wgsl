// The elements of one colour: a run of a list that has them colour after colour.
struct ElementsOfColor {  // mirror: src/method/xpbd/color.hpp
  first : u32,
  count : u32,
}
