// Sums of numbers in any order: as integers of 64 bits in two words, what is less than 0 as its two's complement.
struct Wide {
  low : vec3u,
  high : vec3u,
}

// Of three numbers in units, no farther from 0 than `most`.
fn wide_of(value : vec3f, units : f32, most : f32) -> Wide {
  let size = round(units * min(abs(value), vec3f(most)));
  let size_high = vec3u(floor(size / 0x1p32));
  let size_low = vec3u(size - vec3f(size_high) * 0x1p32);
  let negative = value < vec3f(0.0);
  let ones = select(vec3u(0u), vec3u(0xffffffffu), negative);
  return Wide(select(size_low, ~size_low + 1u, negative),
              (size_high ^ ones) + select(vec3u(0u), vec3u(1u), negative & (size_low == vec3u(0u))));
}

fn number_of(low : u32, high : u32, units : f32) -> f32 {
  let negative = (high & 0x80000000u) != 0u;
  let size_low = select(low, ~low + 1u, negative);
  let size_high = select(high, ~high + select(0u, 1u, low == 0u), negative);
  let size = (f32(size_high) * 0x1p32 + f32(size_low)) / units;
  return select(size, -size, negative);
}
