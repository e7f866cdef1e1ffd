// A number from -0.5 to 0.5 that looks like chance, from 32 bits.
fn scrambled(bits : u32) -> f32 {
  var h = (bits ^ (bits >> 15u)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12u)) * 0x297a2d39u;
  return f32((h ^ (h >> 15u)) & 0xffffu) / 65535.0 - 0.5;
}
