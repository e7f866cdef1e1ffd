// The elements of one colour: a run of a list that has them colour after colour.
struct ElementsOfColor {  // mirror: src/method/projection/color.hpp
  first : u32,
  count : u32,
}
