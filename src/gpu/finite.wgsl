// Found on the bits: a compiler may take NaN and infinity to be absent.
fn is_finite(v : vec3f) -> bool {
  return all((bitcast<vec3u>(v) & vec3u(0x7f800000u)) != vec3u(0x7f800000u));
}
