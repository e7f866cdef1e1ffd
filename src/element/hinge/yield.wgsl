// When a bend stays. The same as creases.hpp in f32. Source: docs/elements.md, Creases.
struct YieldLaw {  // mirror: src/method/creases.hpp
  curvature : f32,  // 1/m
  hardening : f32,
  first : u32,      // of the cloth's facets among all that keep bends
  padding : u32,
}
// What a facet keeps of an elastic curvature, 1/m; spent: all that it has kept.
fn kept_curvature(law : YieldLaw, elastic : f32, spent : f32) -> f32 {
  return max(0.0, elastic - (law.curvature + law.hardening * spent)) / (1.0 + law.hardening);
}
